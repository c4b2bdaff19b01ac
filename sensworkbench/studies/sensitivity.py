# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sensitivity study: indices of every error and component, of every kind of error, and under both conventions for
squareness, with eq. (18) of the paper as printed for comparison.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from ..core import workspace
from ..core.distributions import Tolerance, moments
from ..core.errors import ENDS, TRANSLATION
from ..core.machine import SQUARENESS_CONVENTIONS, Machine
from ..core.objectives import MeanSquare, Objective, from_json
from ..core.refusal import Refused
from ..core.sobol import paper_eq18
from ..core.synthesis import POSITION, omega
from ..core.workspace import CHUNK, Positions, Sensitivity, error_table
from ..messages import Message

Progress = Callable[[float], bool]

KINDS = (
    "straightness", "linear displacement", "angular", "squareness", "radial and axial", "axis position",
    "axis orientation", "spindle", "workpiece", "traced effects", "common sources",
)  # fmt: skip
MOST_JOINTS = 4  # of which a quadrature with the order of an objective is taken
SMALL = 0.1  # total index below which Park & Yang's "hardly matter" is taken to hold


@dataclass(frozen=True)
class SensitivityRequest:
    """What a sensitivity study is asked for; None: the machine's own, or the default.

    at : one value per joint, mm (deg of a rotary joint).  grid, quadrature : positions per joint, an int or one each.
    low_discrepancy : number of positions of such a set.  objective : fields of the objective, of which "name" is one;
    those that are missing are the default's.  squareness : convention.  tolerances : symbol -> Tolerance in place of
    the machine's.
    """

    at: tuple[float, ...] | None = None
    grid: int | tuple[int, ...] | None = None
    quadrature: int | tuple[int, ...] | None = None
    low_discrepancy: int | None = None
    objective: Mapping = field(default_factory=dict)
    squareness: str | None = None
    tolerances: Mapping[str, Tolerance] | None = None

    def machine(self, machine: Machine) -> Machine:
        """`machine` with the squareness convention and the tolerances that are asked for."""
        if self.squareness:
            machine = replace(machine, squareness=self.squareness)
        if self.tolerances:
            machine = replace(machine, tolerances=dict(machine.tolerances) | dict(self.tolerances))
        return machine

    def judged(self, default: Objective | None = None) -> Objective:
        """The objective that is asked for; what is left open is that of `default`."""
        given = (default or MeanSquare()).to_json()
        if self.objective.get("name", given["name"]) != given["name"]:  # only what all objectives have
            given = {k: given[k] for k in ("output", "weights")}
        return from_json(given | dict(self.objective))

    def positions(
        self, machine: Machine, default: Positions | None = None, objective: Objective | None = None
    ) -> Positions:
        """The positions that are asked for; where none are, `default` or the usual ones of the machine and the
        objective."""
        if self.at is not None:
            position = [j.from_shown(v) for j, v in zip(machine.joints, self.at)]
            return workspace.at(machine, position if len(self.at) == len(machine.joints) else self.at)
        if self.grid is not None:
            return workspace.grid(machine, self.grid)
        if self.quadrature is not None:
            return workspace.quadrature(machine, self.quadrature)
        if self.low_discrepancy is not None:
            return workspace.low_discrepancy(machine, self.low_discrepancy)
        if default is not None:
            return default
        if objective is not None and objective.order and len(machine.joints) <= MOST_JOINTS:
            return workspace.quadrature(machine, objective.order)
        return workspace.default_positions(machine)


@dataclass(frozen=True)
class KindIndices:
    """First-order and total index of a group of errors, mean over the positions."""

    first: float
    total: float


@dataclass(frozen=True)
class Convention:
    """The indices under one convention for squareness: those of the errors, and of each kind of error together."""

    sensitivity: Sensitivity
    kinds: Mapping[str, KindIndices]

    @property
    def finding(self) -> tuple[Message, ...]:
        """What comes first, and whether what Park & Yang found holds."""
        return paper_finding(self.sensitivity, self.kinds)


@dataclass(frozen=True)
class AsPrinted:
    """Eq. (18) as printed in the paper and the exact total index, at one position.

    position (n,) mm or rad.  as_printed, total (errors,).  variance_15a, variance : V(Y) by eq. (15a) and exact, mm^4.
    """

    position: np.ndarray
    symbols: tuple[str, ...]
    as_printed: np.ndarray
    total: np.ndarray
    variance_15a: float
    variance: float


@dataclass(frozen=True)
class SensitivityResult:
    """Result of a sensitivity study.

    machine : the machine that was analysed.  sensitivity : its indices.  conventions : convention for squareness -> the
    same under it.  as_printed : eq. (18) of the paper, where it applies.
    """

    machine: Machine
    sensitivity: Sensitivity
    conventions: Mapping[str, Convention]
    as_printed: AsPrinted | None

    @property
    def position(self) -> np.ndarray:
        """(n,) the position asked for, or the middle of the travel; mm or rad."""
        return mean_position(self.machine, self.sensitivity.positions)

    @property
    def remarks(self) -> tuple[Message, ...]:
        """What the reader of the indices must know of the machine."""
        means = moments(error_table(self.machine).laws).mean
        if self.machine.left_handed and means.any():
            return (Message("frame-left-handed"),)
        return ()


def sensitivity_study(
    machine: Machine,
    request: SensitivityRequest = SensitivityRequest(),
    progress: Progress | None = None,
    objective: Objective | None = None,
    positions: Positions | None = None,
) -> SensitivityResult:
    """Return the indices that `request` asks for, with everything that is reported with them.

    progress : called with the finished share, 0 to 1; a false answer cancels (raises `workspace.Cancelled`).
    objective, positions : used where `request` leaves them open.  Refuses if nothing varies.
    """
    machine = request.machine(machine)
    judged = request.judged(objective)
    where = request.positions(machine, positions, judged)
    found = workspace.sensitivity(machine, where, judged, progress)
    return completed(machine, found)


def completed(machine: Machine, found: Sensitivity) -> SensitivityResult:
    """The result for indices that are there already."""
    return SensitivityResult(machine, found, conventions(machine, found), as_printed(machine, found))


def mean_position(machine: Machine, positions: Positions) -> np.ndarray:
    """(n,) the position of a single one, or the middle of the travel; mm or rad."""
    return positions.q[0] if positions.kind == "at" else machine.travel.mean(axis=1)


def ranking(found: Sensitivity) -> list[int]:
    """Numbers of the errors by total index, largest first; equals keep their order."""
    return sorted(range(len(found.symbols)), key=lambda i: -round(found.total[i], 12))


# -- kinds of error ----------------------------------------------------------------------------------------------------
def kind_of(machine: Machine, label: str, column: str) -> str:
    """The kind of error as Park & Yang group them, one of KINDS; of a rotary joint as ISO 230-7 names them.

    label : of the entry; column : the component that it moves, another one for a traced effect, "" for a source.
    """
    if not column:
        return "common sources"
    c = machine.component(column)
    if label != column:
        return "traced effects"
    if c.body in ENDS:
        return "spindle" if c.body == "T" else "workpiece"
    if c.line:
        return c.kind
    if c.kind != TRANSLATION:
        return "angular"
    if not machine.joint(c.body).slides:
        return "radial and axial"
    return "linear displacement" if c.axis == c.along else "straightness"


def kind_indices(machine: Machine, found: Sensitivity) -> dict[str, KindIndices]:
    """Indices of all errors of a kind together, mean over the positions of `found`."""
    table = error_table(machine)
    labels, columns, _, laws = table
    kinds = [kind_of(machine, *pair) for pair in zip(labels, columns)]
    present = [k for k in KINDS if k in kinds]
    groups = [[i for i, k in enumerate(kinds) if k == kind] for kind in present]
    law, objective, positions = moments(laws), found.objective, found.positions
    first, total = np.zeros(len(groups)), np.zeros(len(groups))
    for start in range(0, len(positions.q), CHUNK):
        block = slice(start, start + CHUNK)
        matrix = table.mixed(omega(machine, table.symbols, positions.q[block], output=objective.output))
        one = objective.group_indices(matrix, law, groups)
        first += positions.weights[block] @ one.first
        total += positions.weights[block] @ one.total
    return {k: KindIndices(float(f), float(t)) for k, f, t in zip(present, first, total)}


# -- what the paper found ----------------------------------------------------------------------------------------------
def conventions(machine: Machine, found: Sensitivity) -> dict[str, Convention]:
    """Convention for squareness -> the indices under it; one that leaves nothing to vary is missing."""
    out = {}
    for convention in SQUARENESS_CONVENTIONS:
        other, judged = replace(machine, squareness=convention), found
        if convention != machine.squareness:
            try:
                judged = workspace.sensitivity(other, found.positions, found.objective, estimate=False)
            except Refused:  # an objective that only one convention gives a variance
                continue
        out[convention] = Convention(judged, kind_indices(other, judged))
    return out


def paper_finding(found: Sensitivity, kinds: Mapping[str, KindIndices]) -> tuple[Message, ...]:
    """Which error and which kinds come first, and whether what Park & Yang found holds here."""
    ranked = sorted(kinds, key=lambda k: -kinds[k].total)
    first = ranking(found)[0]
    order = [Message("kind-index", kind=kind_message(k), total=kinds[k].total) for k in ranked if kinds[k].total > 0]
    leader = Message("finding-leader", symbol=found.symbols[first], total=float(found.total[first]), kinds=order)
    if not {"squareness", "angular", "linear displacement", "spindle", "straightness"} <= set(kinds):
        return (leader,)
    small = max(kinds["linear displacement"].total, kinds["spindle"].total) < SMALL
    leading = {"squareness", "angular"} == set(ranked[:2])
    return leader, Message("finding-holds" if leading and small else "finding-half" if small else "finding-fails")


def kind_message(kind: str) -> Message:
    """The name of a kind of error."""
    return Message("kind-" + kind.replace(" ", "-"))


def as_printed(machine: Machine, found: Sensitivity) -> AsPrinted | None:
    """Return eq. (18) as printed and the correct S^T at one position; None where the equation does not apply.

    It is defined for uniform errors and the unweighted sum of squares of the position only.
    """
    table = error_table(machine)
    labels, laws = table.labels, table.laws
    objective = found.objective
    if not isinstance(objective, MeanSquare) or objective.output != POSITION:
        return None
    if any(w not in (0, 1) for w in objective.weights):
        return None
    if any(law.distribution != "uniform" for law in laws):
        return None
    q = mean_position(machine, found.positions)
    rows = [a for a, w in enumerate(objective.weights) if w]
    matrix = table.mixed(omega(machine, table.symbols, q))[0][rows]
    lower, upper = np.array([law.lower for law in laws]), np.array([law.upper for law in laws])
    here = found
    if found.positions.kind != "at":
        one = Positions(q[None], np.ones(1), (1,) * len(q), "at")
        here = workspace.sensitivity(machine, one, objective)
    if not any((matrix**2).sum(axis=1) > 0):
        return None
    printed, variance = paper_eq18(matrix, lower, upper)
    printed = np.where(np.isfinite(printed), printed, 0.0)
    return AsPrinted(q, tuple(labels), printed, here.total, variance, here.variance)
