# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document objects: Machine, Axis, Body, Tolerances, Sensitivity and Effect.

Module and class names are stored in users' files and stay as they are.  A proxy declares properties and hands the rest
to `refresh` (recompute) and `jog` (moving parts); docs/document-model.md lists what each property means.
"""

from __future__ import annotations

from ..core.distributions import DISTRIBUTIONS  # noqa: F401 - the values that `Distributions` takes
from ..core.joints import KINDS, LINEAR
from ..core.machine import SQUARENESS_CONVENTIONS
from ..core.objectives import MeanSquare, objective
from ..core.shapes import SHAPES
from ..core.workspace import DEFAULT_GRID, DEFAULT_ORDER
from . import told
from .base import INVISIBLE, OUTPUT, Property, SensObject, coded, internal, numbers, put, quiet, result
from .staleness import with_objective

AUTOMATIC = "Automatic"
DIRECTION_CHOICES = (AUTOMATIC, "Local X", "Local Y", "Local Z")
REFERENCE_CHOICES = (AUTOMATIC, "Placement", "Centre of mass")

_REFERENCE = (
    Property("XLinkSub", "ReferenceSource", "Reference",
             "Where the reference point is taken from: a coordinate system, datum, vertex, edge, face or part. "
             "Empty: the parts themselves"),
    Property("Enumeration", "ReferenceAt", "Reference",
             "Automatic: the origin of a coordinate system or datum, the centre of an edge or face, the centre of mass "
             "of a part", AUTOMATIC),
)  # fmt: skip
_OFFSETS = (
    result("Vector", "ReferencePoint", "Reference point with all axes at 0, mm, document coordinates"),
    coded("ReferenceFrom", "What the reference point was taken from"),
    result("Vector", "AbbeOffset", "Functional point minus reference point at the current position, mm, document "
                                   "coordinates"),
    result("Distance", "AbbeOffsetX", "Abbe offset along the machine's X"),
    result("Distance", "AbbeOffsetY", "Abbe offset along the machine's Y"),
    result("Distance", "AbbeOffsetZ", "Abbe offset along the machine's Z"),
)  # fmt: skip


def _take_objective(obj) -> None:
    """Output, weights and sign of schema 2 become one objective, in what indices were computed from too."""
    old = [getattr(obj, name, None) for name in ("Output", "Weights", "Signed")]
    if None not in old:
        put(obj, "Objective", told.objective_text(objective(old[0], numbers(old[1]), bool(old[2]))))
        put(obj, "Inputs", with_objective(obj.Inputs, told.objective(obj.Objective)))
    for name in ("Output", "Weights", "Signed"):
        if hasattr(obj, name):
            obj.removeProperty(name)


class MachineObject(SensObject):
    """A machine of one to six joints; axes, spindle, workpiece, tolerances and results are in its Group."""

    kind = "Machine"
    schema = 3
    choices = {
        "Squareness": SQUARENESS_CONVENTIONS,
        "Aggregate": ("quadrature", "grid", "at", "low_discrepancy"),
    }
    properties = (
        Property("StringList", "WorkpieceChain", "Machine", "Axes that carry the workpiece, from the bed outwards"),
        Property("StringList", "ToolChain", "Machine", "Axes that carry the tool, from the bed outwards"),
        Property("XLinkSubList", "Bed", "Machine", "Parts that never move"),
        Property("XLinkSub", "ToolPoint", "Machine",
                 "The functional point: a coordinate system, datum, vertex, edge, face or part at the tool's tip"),
        Property("Enumeration", "Squareness", "Machine",
                 "direction: a squareness error tilts the direction of motion only (ISO 230-1); carried: it also turns "
                 "what the guide carries", "direction"),
        Property("Map", "Declared", "Machine", "Degree of the declared error functions that differ from 3"),
        Property("String", "Objective", "Objective", "What is judged: name and fields of the objective, as JSON",
                 told.objective_text(MeanSquare()), 0, INVISIBLE),
        Property("Enumeration", "Aggregate", "Objective",
                 "Positions: quadrature over the travel, regular grid, one, or a low-discrepancy set", "quadrature"),
        Property("Integer", "Order", "Objective", "Quadrature positions per axis", DEFAULT_ORDER),
        Property("Integer", "Grid", "Objective", "Grid positions per axis", DEFAULT_GRID),
        Property("FloatList", "At", "Objective", "The one position: a value for each axis, X, Y, Z first; empty: 0"),
        result("String", "Structure", "Structure code from workpiece to tool, F for the bed"),
        result("Vector", "FunctionalPoint", "Functional point with all axes at 0, mm, document coordinates"),
        result("Map", "Skew", "Angle between two axes minus 90 degrees, for each pair of X, Y, Z"),
        result("String", "Problem", "Why the machine cannot be computed, and what to do; empty when it can"),
        internal("String", "Inputs", "All that the indices depend on, as JSON"),
        internal("String", "Fitted", "Fitted errors as JSON"),
        internal("String", "Sources", "Causes that several errors follow, as in machine.json"),
        internal("String", "Extra", "Further keys of machine.json as JSON"),
        internal("StringList", "HomeObjects", "Parts away from home"),
        internal("PlacementList", "HomePlacements", "Where they stand with all axes at 0"),
        internal("Map", "PartColours", "Colours for parts made without a window: object name, #rrggbb"),
        internal("Bool", "ViewPending", "Saved without a window: visibility and colours are to be set on opening",
                 False),
        internal("StringList", "Unseen", "Our objects that were added without a window: to be shown on opening"),
    )  # fmt: skip

    survey = refusal = None  # what the last recompute found, or why it could not (see `refresh`); never stored

    def execute(self, obj):
        from .refresh import refresh

        refresh(obj)

    def migrate(self, obj, step):
        if step == 1:  # positions by joint instead of a vector; one map for the angles between the axes
            self.renew(obj, "At", "At", lambda at: [at.x, at.y, at.z])
            pairs = {k: getattr(obj, f"Skew{k}") for k in ("XY", "XZ", "YZ") if hasattr(obj, f"Skew{k}")}
            for pair in pairs:
                obj.removeProperty(f"Skew{pair}")
            put(obj, "Skew", pairs)
            self.renew(obj, "Fingerprint", "Inputs")
            chosen = obj.Aggregate
            obj.Aggregate = list(self.choices["Aggregate"])
            obj.Aggregate = chosen
        if step == 2:
            _take_objective(obj)


class AxisObject(SensObject):
    """A joint of the machine with its carriage; effects of this body are in its Group."""

    kind = "Axis"
    schema = 2
    choices = {"Kind": tuple(KINDS), "DirectionAlong": DIRECTION_CHOICES, "ReferenceAt": REFERENCE_CHOICES}
    properties = (
        Property("String", "Axis", "Axis", "Name of the axis: a capital letter and at most one digit", "X", 0, 1),
        Property("Enumeration", "Kind", "Axis", "How it moves", LINEAR.name, 0, 1),
        Property("XLinkSubList", "Parts", "Axis", "The carriage: one or several parts that move as one"),
        Property("XLinkSub", "DirectionSource", "Direction",
                 "Where the direction is taken from: a coordinate system, datum, edge, face or part. Empty: the "
                 "placement of the first part"),
        Property("Enumeration", "DirectionAlong", "Direction",
                 "Automatic: along a line or edge, normal to a plane or face, otherwise the local axis of this axis' "
                 "name", AUTOMATIC),
        Property("Bool", "Reverse", "Direction", "Count the other way", False),
        *_REFERENCE,
        Property("Vector", "ReferenceOffset", "Reference",
                 "The scale stands elsewhere: added to the reference point, mm along the machine's X, Y, Z",
                 (0.0, 0.0, 0.0)),
        Property("Distance", "TravelLower", "Travel", "Lowest position", -100.0),
        Property("Distance", "TravelUpper", "Travel", "Highest position", 100.0),
        Property("Distance", "Position", "Travel", "Programmed position: moves the carriage and all that it carries",
                 0.0),
        internal("Float", "StandsAt", "The position at which the parts stand, mm", 0.0),
        result("Vector", "Direction", "Unit vector of positive motion, document coordinates"),
        coded("DirectionFrom", "What the direction was taken from"),
        *_OFFSETS,
    )  # fmt: skip

    def migrate(self, obj, step):
        if step == 1:  # the name of an axis is no longer one of three
            self.renew(obj, "Axis", "Axis")

    def onChanged(self, obj, name):
        if name == "Position" and not quiet(obj):
            from .jog import position_edited

            position_edited(obj)


class BodyObject(SensObject):
    """The spindle with its tool (T) or the workpiece with its fixture (W)."""

    kind = "Body"
    choices = {"Body": ("T", "W"), "ReferenceAt": REFERENCE_CHOICES}
    properties = (
        Property("Enumeration", "Body", "Body", "T: spindle and tool; W: workpiece and fixture", "T", 0, 1),
        Property("XLinkSubList", "Parts", "Body", "The parts"),
        *_REFERENCE,
        *_OFFSETS,
    )


class TolerancesObject(SensObject):
    """Limits and distribution of every error, in mm and rad; errors that are not listed have the paper's."""

    kind = "Tolerances"
    properties = (
        Property("StringList", "Symbols", "Tolerances", "ISO 230-1 names", None, 0, 1),
        Property("FloatList", "Lower", "Tolerances", "Lower limits, mm or rad", None, 0, 1),
        Property("FloatList", "Upper", "Tolerances", "Upper limits, mm or rad", None, 0, 1),
        Property("StringList", "Units", "Tolerances", "Units they are shown in: um, urad, arcsec ...", None, 0, 1),
        Property("StringList", "Distributions", "Tolerances", "Distributions", None, 0, 1),
        Property("FloatList", "Sigmas", "Tolerances", "Standard deviations of normal ones; 0: default", None, 0, 1),
    )


class SensitivityObject(SensObject):
    """Indices of a machine: what they were computed from, and whether that has changed since."""

    kind = "Sensitivity"
    schema = 3
    properties = (
        result("Bool", "Stale", "The machine has changed since", True),
        result("StringList", "Symbols", "Errors"),
        result("StringList", "Owners", "Body of each error: the name of a joint, T or W"),
        result("FloatList", "First", "First-order indices S, mean over the positions"),
        result("FloatList", "Total", "Total indices, mean over the positions"),
        result("FloatList", "TotalMax", "Largest total index over the positions"),
        result("FloatList", "FirstWeighted", "S weighted by the variance"),
        result("FloatList", "TotalWeighted", "Total indices weighted by the variance"),
        result("StringList", "Bodies", "Components"),
        result("FloatList", "ComponentFirst", "Group first-order index of each component"),
        result("FloatList", "ComponentTotal", "Group total index of each component"),
        result("FloatList", "ComponentTotalMax", "Its largest value over the positions"),
        result("FloatList", "ComponentTotalWeighted", "Its mean weighted by the variance"),
        result("Float", "MeanSquare", "E[Y], mm² (rad², or mm for a signed component)"),
        result("Float", "Variance", "V(Y), mm⁴ (rad⁴, or mm²)"),
        result("Float", "EstimatedError", "Estimated error of the total indices; negative: none is stated", -1.0),
        Property(
            "String",
            "Objective",
            "Results",
            "What was judged: name and fields of the objective, as JSON",
            None,
            OUTPUT,
            INVISIBLE,
        ),
        result("String", "Aggregate", "quadrature, grid or at"),
        result("FloatList", "Points", "Positions per axis, or the one position"),
        result("String", "Squareness", "Convention for squareness"),
        result("FloatList", "Lower", "Lower limit of each error, mm or rad"),
        result("FloatList", "Upper", "Upper limit of each error, mm or rad"),
        result("StringList", "Units", "Unit each is shown in"),
        result("StringList", "Distributions", "Distribution of each error"),
        result("StringList", "WithoutExtent", "Enabled effects that are not in the ranking: they have no extent"),
        internal("String", "Inputs", "What the indices were computed from, as JSON"),
        internal(
            "FloatList",
            "Moments",
            "MeanSquare, Variance and EstimatedError in full (files keep 16 decimals of a "
            "single number, all digits of a list)",
        ),
        internal("Bool", "Coloured", "The parts carry the colours of this result", False),
        internal("String", "OriginalColours", "How the parts looked before, as the window wrote it"),
    )

    def execute(self, obj):
        """Nothing: indices are computed on command, never by a recompute."""

    def migrate(self, obj, step):
        if step == 1:
            self.renew(obj, "Fingerprint", "Inputs")
        if step == 2:
            _take_objective(obj)

    def onDocumentRestored(self, obj):
        super().onDocumentRestored(obj)
        for name, value in zip(("MeanSquare", "Variance", "EstimatedError"), obj.Moments):
            put(obj, name, value)


class EffectObject(SensObject):
    """One component with a driver that the declared model lacks; takes part in Omega while it is enabled."""

    kind = "Effect"
    schema = 2
    choices = {"Shape": tuple(SHAPES)}
    properties = (
        Property("String", "Component", "Effect", "ISO 230-1 name of the error component"),
        Property("String", "Driver", "Effect", "Column that drives it; a product is joined by *"),
        Property("Enumeration", "Shape", "Effect", "How it depends on the driver", "linear"),
        Property("String", "Parameters", "Effect", "Parameters with unit and standard uncertainty, as JSON", "{}",
                 0, INVISIBLE),
        Property("FloatList", "Extent", "Effect",
                 "Lowest and highest value of the driver, in its unit (K, mm, s ...); without it, and without one in "
                 "Parameters, the effect is not in the ranking"),
        Property("Bool", "Enabled", "Effect", "Takes part in the error of the machine", True),
    )  # fmt: skip
