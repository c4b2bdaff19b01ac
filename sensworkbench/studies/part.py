# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part study: a tool path and a machine's errors give the part, its features, and whose fault they are.

The point that cuts is displaced by the volumetric error there (actual less commanded, tool relative to workpiece), and
the surface with it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ..core import elements
from ..core.features import KINDS, USUAL, Feature, Surface, feature, surface
from ..core.machine import Machine
from ..core.refusal import Refused
from ..core.toolpath import ToolPath
from ..core.workspace import Cancelled
from ..messages import Message
from .part_errors import FittedErrors, TolerancedErrors, chunks, normal_levels
from .part_features import FeatureFound, evaluate

Progress = Callable[[float], bool]
FITTED, TOLERANCES = "fitted", "tolerances"
CHECKED, CHECK_DRAWS = 7, 20_000  # places and draws by which the quantiles of matched moments are judged
MOST_OUTSIDE = 1000


@dataclass(frozen=True)
class FeatureRequest:
    """name : of the points (a label of the path).  kind : see `core.features.KINDS`, or None: the form of its
    element.  datum : name of another feature, or None.  limit : mm, or None.  label : of the points, default `name`."""

    name: str
    kind: str | None = None
    datum: str | None = None
    limit: float | None = None
    label: str | None = None

    @property
    def points(self) -> str:
        """The label of its points."""
        return self.label or self.name


@dataclass(frozen=True)
class PartRequest:
    """features : what is judged.  level : of the quantiles.  errors : "fitted", "tolerances", or None: fitted where
    anything is fitted or traced."""

    features: tuple[FeatureRequest, ...] = ()
    level: float = 0.95
    errors: str | None = None


@dataclass(frozen=True)
class Outside:
    """A block that leaves the travel: its line, joint, by how much (mm or deg), and where (J,)."""

    line: int
    joint: str
    by: float
    at: np.ndarray


@dataclass(frozen=True)
class PartResult:
    """error : (P, 3) mm of fitted errors, else None.  expected, quantile : (P,) mm, root of the expected squared error
    and quantile of its length from tolerances, else None.  quantile_error : largest relative error of the quantiles
    found by draws at a few places.  labels, owners : (K,) of the shares.  features : in the order of the request.
    outside : blocks beyond the travel.  remarks : messages."""

    machine: Machine
    path: ToolPath
    model: str
    labels: tuple[str, ...]
    owners: tuple[str, ...]
    features: tuple[FeatureFound, ...]
    outside: tuple[Outside, ...]
    error: np.ndarray | None = None
    expected: np.ndarray | None = None
    quantile: np.ndarray | None = None
    quantile_error: float | None = None
    level: float = 0.95
    remarks: tuple[Message, ...] = ()

    @property
    def size(self) -> np.ndarray:
        """(P,) mm, length of the error at each point, expected where it is not known."""
        return self.expected if self.error is None else np.linalg.norm(self.error, axis=1)


def errors_of(machine: Machine, path: ToolPath, which: str | None = None) -> FittedErrors | TolerancedErrors:
    """The errors of a machine along a path.  which : "fitted", "tolerances" or None, see `PartRequest`.  Refuses
    fitted errors where nothing is fitted, and effects whose columns the path lacks."""
    known = machine.fitted is not None or any(e.enabled and e.coefficients for e in machine.effects)
    if which == FITTED and not known:
        raise Refused("predict-no-fit", machine.name)
    if known and which != TOLERANCES:
        return FittedErrors(machine, path)
    return TolerancedErrors(machine, path)


def part_study(
    machine: Machine, path: ToolPath, request: PartRequest = PartRequest(), progress: Progress | None = None
) -> PartResult:
    """The part that a machine makes along a path.

    progress : called with the part done, 0 to 1; a false answer cancels (raises `Cancelled`).
    """
    tell = progress or (lambda part: True)
    errors = errors_of(machine, path, request.errors)
    at_points = _at_points(errors, path, request.level, lambda part: _tell(tell, 0.5 * part))
    found, remarks = [], []
    for i, made in enumerate(features_on(machine, path, request.features)):
        rows, others = (None if s is None else path.labels[s.name] for s in (made.surface, made.datum))
        found.append(evaluate(made, rows, others, errors))
        _tell(tell, 0.5 + 0.5 * (i + 1) / len(request.features))
    if errors.tolerances and errors.without_extent:
        remarks.append(Message("part-without-extent", names=list(errors.without_extent)))
    return PartResult(
        machine=machine,
        path=path,
        model=TOLERANCES if errors.tolerances else FITTED,
        labels=errors.labels,
        owners=errors.owners,
        features=tuple(found),
        outside=outside_travel(machine, path),
        level=request.level,
        remarks=tuple(remarks),
        **at_points,
    )


def _tell(tell: Progress, part: float) -> None:
    if not tell(part):
        raise Cancelled("cancelled")


def nominal_points(machine: Machine, path: ToolPath, rows) -> np.ndarray:
    """(k, 3) mm, points of the surface over the workpiece, in the machine frame."""
    return machine.tool_position(path.q[rows], path.contact[rows]) @ machine.frame


class _Surfaces:
    """The surfaces of a path's labels, made when asked."""

    def __init__(self, machine: Machine, path: ToolPath):
        self.machine, self.path = machine, path
        self._made: dict[tuple, Surface] = {}

    def get(self, label: str, kind: str | None, name: str) -> Surface:
        """The surface of a label for a kind of feature; None: of whatever its points lie on."""
        wanted = KINDS[kind].elements if kind in KINDS else {}
        element = next(iter(wanted)) if len(wanted) == 1 else None
        if (label, element) not in self._made:
            rows = self.path.labels.get(label)
            if rows is None or len(rows) == 0:
                raise Refused("feature-without-points", f"feature {name!r}")
            normal = self.path.normal[rows]
            known = normal if np.isfinite(normal).all() else None
            points = nominal_points(self.machine, self.path, rows)
            if element is not None:
                count, fewest = len(np.unique(np.round(points, 6), axis=0)), wanted[element]
                if count < fewest:
                    text = f"feature {name!r}"
                    raise Refused("feature-too-few-points", text, kind=kind, count=count, fewest=fewest)
            made = None if element is None else elements.made(element, points, known, f"feature {name!r}", kind)
            self._made[label, element] = surface(label, points, known, made)
        return self._made[label, element]


def features_on(machine: Machine, path: ToolPath, asked: Sequence[FeatureRequest]) -> list[Feature]:
    """The features of a path, with their surfaces."""
    surfaces = _Surfaces(machine, path)
    return [_feature(surfaces, one, asked) for one in asked]


def _feature(surfaces: _Surfaces, asked: FeatureRequest, others: Sequence[FeatureRequest]) -> Feature:
    if asked.kind is not None and asked.kind not in KINDS:
        raise Refused("feature-kind-unknown", f"feature {asked.name!r}", kind=repr(asked.kind)[:60], known=list(KINDS))
    one = surfaces.get(asked.points, asked.kind, asked.name)
    datum = None
    if asked.datum is not None:
        label = next((o.points for o in others if o.name == asked.datum), asked.datum)
        datum = surfaces.get(label, None, asked.datum)
    return feature(asked.name, asked.kind or USUAL[one.element.kind], one, datum, asked.limit)


def _at_points(errors, path: ToolPath, level: float, tell) -> dict:
    count = path.points
    rows = np.arange(count)
    if not errors.tolerances:
        error = np.empty((count, 3))
        with np.errstate(all="ignore"):
            for part in chunks(rows):
                error[part] = errors.error(part)
                tell(part[-1] / count)
        bad = ~np.isfinite(error).all(axis=1)
        if bad.any():
            raise Refused("predicted-not-finite", f"line {int(path.line[np.argmax(bad)])}")
        return {"error": error}
    mean, variance = np.empty(count), np.empty(count)
    for part in chunks(rows):
        mean[part], variance[part] = errors.pointwise(part)
        tell(part[-1] / count)
    quantile = np.sqrt(matched_quantile(mean, variance, level))
    return {"expected": np.sqrt(mean), "quantile": quantile, "quantile_error": _checked(errors, quantile, level)}


def matched_quantile(mean, variance, level: float) -> np.ndarray:
    """Quantile of a squared length with this mean and variance: the gamma law of the same two moments, by Wilson and
    Hilferty's cube."""
    ratio = np.divide(variance, mean**2, out=np.zeros_like(mean), where=mean > 0)
    spread = ratio / 9
    z = float(normal_levels([level])[0])
    return mean * np.maximum(1 - spread + z * np.sqrt(spread), 0.0) ** 3


def _checked(errors: TolerancedErrors, quantile, level: float) -> float:
    """Largest relative error of the quantiles at a few places, against draws."""
    rows = np.unique(np.linspace(0, len(quantile) - 1, CHECKED).astype(int))
    values = errors.values(CHECK_DRAWS)
    worst = 0.0
    for row, matrix in zip(rows, errors._mixed(rows)):
        drawn = float(np.quantile(np.linalg.norm(values @ matrix.T, axis=1), level))
        if drawn > 0:
            worst = max(worst, abs(float(quantile[row]) / drawn - 1))
    return worst


def outside_travel(machine: Machine, path: ToolPath) -> tuple[Outside, ...]:
    """Blocks that leave the travel, with the joint and the largest excess of each, in the order of the path."""
    low, high = machine.travel.T
    beyond = np.maximum(low - path.q, path.q - high)
    beyond[:, [machine.joint(name).travel is None for name in machine.names]] = 0.0
    rows, joints = np.nonzero(beyond > 1e-6)
    worst: dict[tuple[int, int], tuple[float, int]] = {}
    for row, j in zip(rows[:200_000], joints[:200_000]):
        key = int(path.line[row]), int(j)
        if key not in worst or beyond[row, j] > worst[key][0]:
            if key not in worst and len(worst) >= MOST_OUTSIDE:
                continue
            worst[key] = float(beyond[row, j]), int(row)
    return tuple(
        Outside(line, machine.names[j], float(machine.joints[j].to_shown(by)), path.written[row])
        for (line, j), (by, row) in worst.items()
    )


def body_shares(result: PartResult, shares) -> Mapping[str, float]:
    """Shares of the bodies, in the order of the machine: sums of those of their errors and effects."""
    bodies = dict.fromkeys((*result.machine.bodies, *result.owners), 0.0)
    for owner, share in zip(result.owners, shares):
        bodies[owner] += float(share)
    return {b: s for b, s in bodies.items() if b in result.owners}
