# SPDX-License-Identifier: LGPL-2.1-or-later
"""How our objects appear in the tree and in the 3D view: icon, double click, context menu, legend, arrows, error map.

Module and class names are stored in users' files and stay as they are.  A view provider keeps nothing but scene nodes;
what must survive is in view properties.  Nothing is read in `attach`: properties are not restored yet at that time.
"""

from __future__ import annotations

from pivy import coin

from ..document import tree
from ..document.base import kind_of
from . import settings
from .arrows import Arrows
from .colormap import MAPS
from .colours import restore
from .command import REGISTRY
from .display import sliding_axes, update
from .errormap import ErrorMap
from .legend import Legend
from .looks import COLOUR_BY, CORNERS, MAP_SHOWS, POINTS, VIEW_PROPERTIES, map_forms
from .qt import later, soon
from .residuals import dress as dress_readings
from .viewprovider_base import ViewProviderSens


class ViewProviderMachine(ViewProviderSens):
    """The machine: edits it on double click; its arrows show axes, reference points and Abbe offsets."""

    icon = "SensWorkbench"

    def attach(self, vobj):
        super().attach(vobj)
        self.arrows = Arrows()
        vobj.RootNode.addChild(self.arrows.root)


class ViewProviderAxis(ViewProviderSens):
    """An axis with its carriage."""

    icon = "Sens_Axis"


class ViewProviderBody(ViewProviderSens):
    """The spindle or the workpiece."""

    icon = "Sens_Body"


class ViewProviderTolerances(ViewProviderSens):
    """View of a tolerance table."""

    icon = "Sens_Tolerances"


class ViewProviderEffect(ViewProviderSens):
    """A traced effect; its eye in the tree is open while it takes part."""

    icon = "Sens_Effect"

    def updateData(self, obj, prop):
        if prop == "Enabled" and obj.ViewObject is not None and obj.ViewObject.Visibility != obj.Enabled:
            obj.ViewObject.Visibility = obj.Enabled


class ViewProviderSensitivity(ViewProviderSens):
    """View of a result: colours of the parts, the legend, the error map, according to its view properties."""

    icon = "Sens_Sensitivity"

    def __init__(self, vobj):
        super().__init__(vobj)
        self._declare(vobj)

    def _declare(self, vobj):
        def add(kind, name, tip, value, choices=None):
            if hasattr(vobj, name):
                if name == "ColourBy" and vobj.getEnumerationsOfProperty(name) != list(
                    choices
                ):  # of an earlier version
                    setattr(vobj, name, list(choices))  # keeps what is chosen
                return
            vobj.addProperty(f"App::Property{kind}", name, "Sensitivity", tip)
            if choices:
                setattr(vobj, name, list(choices))
            setattr(vobj, name, value)

        add("Enumeration", "ColourBy", "Which index of a component its parts show", settings.get("ColourBy"), COLOUR_BY)
        add("Enumeration", "ColourMap", "Colours from low to high", settings.get("ColourMap"), MAPS)
        add("Bool", "AutomaticRange", "From 0 to just above the largest index", settings.get("AutomaticRange"))
        add("Float", "RangeLower", "Value of the lowest colour", settings.get("RangeLower"))
        add("Float", "RangeUpper", "Value of the highest colour", settings.get("RangeUpper"))
        add("Bool", "ShowLegend", "Show the legend in the view and in saved images", True)
        add("Enumeration", "LegendCorner", "Where the legend stands", settings.get("LegendCorner"), CORNERS)
        add("Vector", "LegendPlace", "How far the legend was dragged from its corner, in halves of the view", (0, 0, 0))
        add("Bool", "ShowErrorMap", "Show the volumetric error over the workspace", False)
        add("Enumeration", "ErrorMapShows", "Root of the mean square, or two standard deviations of Y above the mean",
            MAP_SHOWS[0], MAP_SHOWS)  # fmt: skip
        add("Enumeration", "ErrorMapAs", "Points over the workspace, or a slice with one axis held", POINTS,
            map_forms(sliding_axes(tree.owner_machine(vobj.Object))))  # fmt: skip
        add("Distance", "ErrorMapAt", "Position of the sliced axis", 0.0)

    def attach(self, vobj):
        super().attach(vobj)
        self.legend, self.map = Legend(), ErrorMap()
        self.legend.placed = self._legend_dragged
        self._waiting = False
        group = coin.SoGroup()
        group.addChild(self.map.root)
        group.addChild(self.legend.root)
        vobj.addDisplayMode(group, "Legend")
        self.schedule(later)  # an opened document is adopted first

    def _legend_dragged(self, offset):
        view = self.object.ViewObject if self.object is not None else None
        if hasattr(view, "LegendPlace"):
            view.LegendPlace = (*offset, 0)

    def getDisplayModes(self, vobj):
        return ["Legend"]

    def getDefaultDisplayMode(self):
        return "Legend"

    def setDisplayMode(self, mode):
        return mode

    def updateData(self, obj, prop):
        if prop in _SHOWN:
            self.schedule()

    def onChanged(self, vobj, prop):
        if prop == "Visibility":
            show_late(vobj)
        if prop in _VIEW:
            self.schedule()

    def onDelete(self, vobj, subelements):
        if vobj.Object.Coloured:
            restore(vobj.Object)
        return True

    def schedule(self, when=soon):
        """Bring colours and legend up to date once the present change is over, in the frame that shows it."""
        if not getattr(self, "_waiting", False):
            self._waiting = True
            when(self._update)

    def _update(self):
        try:
            obj = self.object
            if obj is not None and obj.ViewObject is not None:
                update(obj, fresh=True)
        finally:
            self._waiting = False  # what the update itself has stored asks for no second one


class ViewProviderStudy(ViewProviderSens):
    """A further study; a double click shows what it found in its panel."""

    @property
    def icon(self):
        """The icon of the command whose panel shows the study."""
        names = self.entries(self.object) if self.object is not None else []
        return names[0] if names else "Sens_Sensitivity"

    def entries(self, obj):
        return [c.name for c in REGISTRY.values() if getattr(c, "study", None) == obj.Study] or super().entries(obj)


_SHOWN = {
    "Coloured",
    "Stale",
    "Bodies",
    "Variance",
    "MeanSquare",
    *(name for names in COLOUR_BY.values() for name in names),
}
_VIEW = {*VIEW_PROPERTIES, "LegendPlace", "Visibility"}

PROVIDERS = {
    "Machine": ViewProviderMachine,
    "Axis": ViewProviderAxis,
    "Body": ViewProviderBody,
    "Tolerances": ViewProviderTolerances,
    "Sensitivity": ViewProviderSensitivity,
    "Effect": ViewProviderEffect,
    "Study": ViewProviderStudy,
}


def dress(obj) -> None:
    """Give an object its view provider where it has none, or a property that an older file lacks."""
    if kind_of(obj) in ("Readings", "Trace") and getattr(obj, "ViewObject", None) is not None:
        dress_readings(obj, kind_of(obj))
        attach_late(obj.ViewObject)
        return
    kind, view = PROVIDERS.get(kind_of(obj)), getattr(obj, "ViewObject", None)
    if kind is None or view is None:
        return
    if not isinstance(getattr(view, "Proxy", None), ViewProviderSens):
        kind(view)
    elif kind is ViewProviderSensitivity:
        view.Proxy._declare(view)
    attach_late(view)
    if hasattr(view, "signalChangeIcon"):
        view.signalChangeIcon()  # the tree may have asked before the view provider stood


def attach_late(view) -> None:
    """FreeCAD attaches a view provider once, when its object is made or opened: what a repair gives it comes later.

    Then there is no display mode for its nodes until the document is opened again; they get a switch of their own.
    """
    if hasattr(view.Proxy, "name"):
        return
    view.Proxy.attach(view)
    modes = view.SwitchNode
    if modes.getNumChildren() and not view.DisplayMode:
        view.Proxy.late = coin.SoSwitch()
        view.Proxy.late.addChild(modes.getChild(0))
        view.RootNode.addChild(view.Proxy.late)
        show_late(view)


def show_late(view) -> None:
    """Show or hide what was added to the scene after the view provider was attached."""
    late = getattr(view.Proxy, "late", None)
    if late is not None:
        late.whichChild.setValue(0 if view.Visibility else -1)
