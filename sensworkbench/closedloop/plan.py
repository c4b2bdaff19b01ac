# SPDX-License-Identifier: LGPL-2.1-or-later
"""Design check before measuring: what a table of places and conditions could show, with no reading taken yet.

Every candidate effect is projected off the declared model on these places, as a trace does with readings.  The rest is
its visible share, from which follow the smallest amplitude that the plan would detect and the candidates that it could
not distinguish.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from statistics import NormalDist

import numpy as np

from ..core.driver import POSITIONS, Driver
from ..core.errors import COMPONENTS
from ..core.machine import Machine
from ..core.shapes import Periodic, Regressor, Shape
from ..core.synthesis import omega
from ..core.units import um
from ..messages import Message, Refused
from . import catalogue
from .bank import bank, useful_columns
from .catalogue import Physical
from .design import ALIGNMENT, ALL_SYMBOLS, Design, alike, declared_columns, design
from .effects import coefficient_unit
from .fit import Basis, basis, fit, null_space
from .readings import Readings
from .scan import Rows, Scanner
from .search import handicap
from .settings import DEFAULT, TraceSettings

LEADS = (4.0, 5.0, 6.0, 8.0, 10.0, 12.0, 16.0, 20.0, 25.0, 32.0, 40.0)  # mm, of the usual ball screws
LONGER_MM = 100.0


@dataclass(frozen=True)
class PlannedTerm:
    """One component x driver x shape in a plan.

    symbol : the simplest of the components that move alike here (`alike` names the others).  visible : share of its
    square that the declared model cannot imitate (the median over unknown parameters; `least`: the smallest).
    amplitude_um : the smallest rms over the readings that is detected, um; None if hidden.  coefficient, unit : the
    same as a coefficient.  entry : the named physical effect that it matches, or None.
    """

    symbol: str
    alike: tuple[str, ...]
    regressor: Regressor  # with a middle value of its unknown parameters
    visible: float
    least: float
    amplitude_um: float | None
    coefficient: float | None
    unit: str
    entry: Physical | None
    place: int  # of its component among the plan's groups
    handicap: float

    @property
    def hidden(self) -> bool:
        """Whether the plan cannot show it: the declared model imitates it."""
        return self.amplitude_um is None

    @property
    def driver(self) -> Driver:
        """Its driver."""
        return self.regressor.driver

    @property
    def shape(self) -> Shape:
        """Its shape."""
        return self.regressor.shape


@dataclass(frozen=True)
class Lead:
    """A screw lead on one axis (mm).  visible : share of its cyclic error.  alias : the period that looks the same, mm;
    inf where it looks like a constant, None where nothing does."""

    axis: str
    lead: float
    visible: float
    alias: float | None


def as_readings(positions: Readings, noise_mm: float, normals=None, directions=(0, 1, 2)) -> Readings:
    """A plan as readings of value 0: full vectors, some `directions` of them, or one reading along `normals` (P, 3).

    noise_mm : standard uncertainty of each reading.
    """
    count = positions.points
    if normals is not None:
        point, sense, kind = np.arange(count), np.asarray(normals, dtype=float), np.full(count, 3)
    else:
        kind = np.tile(np.asarray(directions, dtype=int), count)
        point = np.repeat(np.arange(count), len(directions))
        sense = np.eye(3)[kind]
    rows = len(point)
    return replace(
        positions, point=point, sense=sense, kind=kind, value=np.zeros(rows), u=np.full(rows, float(noise_mm))
    )


class Plan:
    """A machine, the planned readings (values 0, uncertainty stated) and what they could show; computed when asked."""

    def __init__(self, machine: Machine, readings: Readings, settings: TraceSettings = DEFAULT):
        if readings.rows < settings.least_readings:
            raise Refused("plan-few-readings", "plan", count=readings.rows, least=settings.least_readings)
        self.machine, self.readings, self.settings = machine, readings, settings
        self.noise = float(readings.u[0])
        self.design: Design = design(machine, readings)
        weight = np.full(readings.rows, 1 / self.noise)
        self.basis: Basis = basis(self.design.matrix, weight)
        self.names = useful_columns(readings)
        start = np.flatnonzero(np.r_[True, np.diff(readings.point) > 0])
        self.rows = Rows(
            self.design.lever / self.noise, np.zeros(readings.rows), start, self.basis.ortho, settings=self.settings
        )
        self.groups = alike(self.design.lever)
        self.bank = bank(readings)

    # -- the declared model --------------------------------------------------------------------------------------
    @property
    def parameters(self) -> int:
        """Number of parameters of the declared model and the alignment."""
        return len(self.design.terms)

    @property
    def rank(self) -> int:
        """Number of parameters that the plan determines."""
        return self.basis.rank

    @cached_property
    def null_space(self) -> list[Message]:
        """Return in words the combinations of parameters that the plan does not determine."""
        return null_space(fit(self.design, self.readings), self.readings)

    def prediction_um(self, longer: float = 0.0, side: int = 4) -> tuple[float | None, float]:
        """(rms standard uncertainty, um, 3-D, of the declared error over the workspace; share of it not determined).

        longer : of the tool, mm.  The first is None where a direction of some place is not determined at all.
        """
        low, high = self.machine.travel.T
        line = np.linspace(0, 1, side)
        q = low + (high - low) * np.stack(np.meshgrid(line, line, line), axis=-1).reshape(-1, 3)
        keep = [i for i, t in enumerate(self.design.terms) if t.group in ("declared", "alignment")]
        terms = [self.design.terms[i] for i in keep]
        values = declared_columns(self.machine, [t if t.group == "declared" else replace(t, order=0) for t in terms], q)
        matrix = omega(self.machine, [t.symbol for t in terms], q, np.array([0.0, 0.0, -longer]))
        shown = (matrix * values[:, None, :]).reshape(-1, len(keep))
        scale = self.basis.scale[keep]
        dark = shown[:, ~np.isfinite(scale)]
        shown = np.where(np.isfinite(scale), shown / np.where(np.isfinite(scale), scale, 1.0), 0.0)
        inside = shown @ self.basis.v[keep]
        lost = (shown**2).sum(axis=1) - (inside**2).sum(axis=1) > 1e-9 * (shown**2).sum(axis=1)
        if dark.size:
            lost |= np.abs(dark).max(axis=1) > 1e-12
        variance = ((inside / self.basis.s) ** 2).sum(axis=1)
        if lost.any():
            return None, float(lost.mean())
        return um(float(np.sqrt(3 * variance.mean()))), 0.0

    @cached_property
    def repeats(self) -> tuple[int, int]:
        """(places visited again with the same tool, degrees of freedom of pure error that they give)."""
        tool = np.zeros_like(self.readings.q) if self.readings.tool_offset is None else self.readings.tool_offset
        place, number = np.unique(np.round(np.hstack([self.readings.q, tool]), 3), axis=0, return_counts=True)
        return int((number > 1).sum()), int((len(self.readings.q) - len(place)) * self.readings.rows / len(tool))

    # -- candidates ----------------------------------------------------------------------------------------------
    @cached_property
    def threshold(self) -> float:
        """Drop of chi-square that an effect must give: past the family-wise limit with 90 % chance, above the floor."""
        tried = max(1, len(self.bank) * len(self.groups))
        normal, s = NormalDist(), self.settings
        found = (normal.inv_cdf(1 - s.alpha / (2 * tried)) + normal.inv_cdf(s.power)) ** 2
        return max(found, s.floor**2 * self.readings.rows)

    @cached_property
    def candidates(self) -> list[PlannedTerm]:
        """Return every component x driver x shape over the columns present, the simplest first."""
        return self._scored(self.bank)

    @cached_property
    def named(self) -> list[PlannedTerm]:
        """The candidates that match a named physical effect."""
        if "candidates" in self.__dict__:
            return [c for c in self.candidates if c.entry]
        return [c for c in self._scored([r for r in self.bank if not r.shape.wave]) if c.entry] + [
            c for c in self._scored(self._screws()) if c.entry
        ]

    def _screws(self) -> list[Regressor]:
        return [
            Regressor(Driver((a,)), Periodic(period=p))
            for a in POSITIONS
            if a in self.names and len(np.unique(self.readings.columns[a])) >= self.settings.plan_periods
            for p in LEADS
        ]

    def _scored(self, regressors: list[Regressor]) -> list[PlannedTerm]:
        if not regressors or not self.groups:
            return []
        columns = self.readings.columns
        scanner = Scanner(self.rows, regressors, [g[0] for g in self.groups], columns=columns)
        alone: dict[tuple, list[int]] = {}
        for k, regressor in enumerate(regressors):
            alone.setdefault(regressor.key, []).append(k)
        out = []
        for members in alone.values():
            for place, group in enumerate(self.groups):
                if _declared(regressors[members[0]], group):
                    continue
                share = np.sort(scanner.visible[members, place])
                middle = members[int(np.argsort(scanner.visible[members, place], kind="stable")[len(members) // 2])]
                out.append(self._candidate(regressors[middle], place, group, scanner, middle, share))
        return sorted(out, key=lambda c: (c.handicap, c.symbol, *c.regressor.key))

    def _candidate(self, regressor, place, group, scanner, k, share) -> PlannedTerm:
        symbols = sorted((ALL_SYMBOLS[i] for i in group), key=lambda s: handicap(s, regressor))
        symbol, shape = symbols[0], regressor.shape
        visible = float(share[len(share) // 2])
        amplitude = coefficient = None
        if visible >= self.settings.visible:
            one = scanner.first[k]
            amplitude = um(self.noise) * float(np.sqrt(self.threshold / (self.readings.points * visible)))
            motion = float(np.sqrt(self.threshold / scanner.shown[one, place]))  # rms over the points
            size = float(np.sqrt((regressor.vectors(self.readings.columns)[:, 0] ** 2).mean()))
            coefficient = COMPONENTS[symbol].to_shown(motion / size)
        unit = coefficient_unit(symbol, shape, regressor.driver, self.readings.units)
        if shape.saturation is not None:  # its size is what it saturates at
            unit = COMPONENTS[symbol].unit
            coefficient = None if coefficient is None else coefficient * shape.saturation
        return PlannedTerm(
            symbol=symbol,
            alike=tuple(symbols[1:]),
            regressor=regressor,
            visible=visible,
            least=float(share[0]),
            amplitude_um=amplitude,
            coefficient=coefficient,
            unit=unit,
            entry=catalogue.physical(symbol, regressor.driver, shape),
            place=place,
            handicap=handicap(symbol, regressor),
        )

    def physical(self) -> Iterator[tuple[Physical, list[PlannedTerm]]]:
        """Return every named physical effect with its candidates in this plan, the simplest first; [] if none is
        testable.
        """
        by_name: dict[str, list[PlannedTerm]] = {}
        for c in self.named:
            by_name.setdefault(c.entry.key, []).append(c)
        for entry in catalogue.CATALOGUE.values():
            yield entry, by_name.get(entry.key, [])

    def smallest_um(self, *keys: str) -> float | None:
        """Return the smallest detectable rms (um) of the simple, visible candidates of these catalogue entries, or
        None.
        """
        best = plain([c for c in self.named if c.entry.key in keys])
        return min((c.amplitude_um for c in best if not c.hidden), default=None)

    # -- what looks alike ----------------------------------------------------------------------------------------
    def confused(self, limit: int = 900) -> list[tuple[PlannedTerm, PlannedTerm, float]]:
        """Return pairs of named, visible candidates of at most two factors whose projected columns have |cosine| >
        0.95.

        Different shapes of the same motion and columns are no pair.  The simplest `limit` candidates are compared.
        """
        shown = [c for c in self.named if not c.hidden and c.driver.factors <= 2 and c.shape.compared][:limit]
        if not shown:
            return []
        columns = self.readings.columns
        point = self.readings.point
        levers = self.rows.lever[:, [self.groups[c.place][0] for c in shown]]
        x = levers * np.stack([c.regressor.vectors(columns)[:, 0] for c in shown], axis=1)[point]
        x -= self.rows.ortho @ (self.rows.ortho.T @ x)
        size = np.linalg.norm(x, axis=0)
        x /= np.where(size > 0, size, 1.0)
        cosine = x.T @ x
        out = []
        for i, j in zip(*np.nonzero(np.triu(np.abs(cosine) > self.settings.same, 1))):
            a, b = shown[i], shown[j]
            if not (a.place == b.place and a.driver.names == b.driver.names):
                out.append((a, b, float(cosine[i, j])))
        return sorted(out, key=lambda p: p[0].handicap + p[1].handicap)

    # -- periods -------------------------------------------------------------------------------------------------
    @cached_property
    def leads(self) -> list[Lead]:
        """The usual screw leads on every axis whose position varies."""
        out = []
        for axis in POSITIONS:
            v = self.readings.columns[axis]
            if np.ptp(v) < 1e-6 or len(np.unique(np.round(v, 4))) < self.settings.plan_levels:
                continue
            symbol = f"E{axis.upper()}{axis.upper()}"
            place = next((i for i, g in enumerate(self.groups) if ALL_SYMBOLS.index(symbol) in g), None)
            shapes = [Regressor(Driver((axis,)), Periodic(period=p)) for p in LEADS]
            seen = None if place is None else self._shares(shapes, place)
            strong = alias_frequencies(v)
            for k, lead in enumerate(LEADS):
                out.append(Lead(axis, lead, 0.0 if seen is None else float(seen[k]), _alias(lead, strong, np.ptp(v))))
        return out

    def _shares(self, shapes, place) -> np.ndarray:
        scanner = Scanner(self.rows, shapes, [self.groups[place][0]], columns=self.readings.columns)
        return scanner.visible[:, 0]

    @property
    def aliased(self) -> list[Lead]:
        """Return the usual screw leads that have an alias at these places."""
        return [lead for lead in self.leads if lead.alias is not None]

    # -- words ---------------------------------------------------------------------------------------------------
    @property
    def not_testable(self) -> tuple[tuple[Message, str], ...]:
        """Return (effect, columns that it needs) of every named effect for which a column is missing."""
        return catalogue.not_testable(self.names)

    def numbers(self) -> dict:
        """The numbers by which plans are compared."""
        visible = [c for c in self.named if not c.hidden]
        sizes = sorted(c.amplitude_um for c in visible)
        predicted, _ = self.prediction_um()
        longer, _ = self.prediction_um(LONGER_MM)
        return {
            "readings": self.readings.rows,
            "places": self.readings.points,
            "parameters": self.parameters,
            "rank": self.rank,
            "physical_effects_testable": sum(any(not c.hidden for c in plain(cs)) for _, cs in self.physical()),
            "candidates_named": len(self.named),
            "candidates_named_visible": len(visible),
            "median_detectable_um": sizes[len(sizes) // 2] if sizes else None,
            "prediction_um": predicted,
            "prediction_longer_tool_um": longer,
            "aliased_leads": len(self.aliased),
            "pure_error_dof": self.repeats[1],
        }


def plain(found: list[PlannedTerm]) -> list[PlannedTerm]:
    """Return the candidates of an effect whose complexity is close to that of its simplest one, the simplest first."""
    return [c for c in found if c.handicap <= found[0].handicap + DEFAULT.plan_simple]


def alias_frequencies(v) -> np.ndarray:
    """Frequencies (1/mm) at which all places v (P,) mm have nearly one phase: what differs by them looks the same."""
    v = np.asarray(v, dtype=float)
    span = float(np.ptp(v))
    places = v - v.min()
    if len(places) > 4000:
        places = places[:: len(places) // 4000 + 1]
    f = np.arange(1.0 / span, 2 / min(LEADS) + 0.5 / span, 1 / (8 * span))
    window = np.concatenate(
        [_window(part, places) for part in np.array_split(f, max(1, len(f) * len(places) // 10**6))]
    )
    found = []
    for i in np.flatnonzero(window > DEFAULT.same):
        if window[i] >= window[max(i - 1, 0)] and window[i] >= window[min(i + 1, len(f) - 1)]:
            near = f[i] + np.linspace(-1, 1, 81) / (8 * span)
            found.append(float(near[int(np.argmax(_window(near, places)))]))
    return np.array(found)


def _window(f, places) -> np.ndarray:
    return np.abs(np.exp(2j * np.pi * np.outer(f, places)).mean(axis=1))


def _alias(lead: float, strong, span: float) -> float | None:
    """The longest period that looks like `lead` (inf: a constant), or None."""
    if not len(strong):
        return None
    difference = np.abs(1 / lead - strong)
    slowest = float(difference.min())
    if slowest < DEFAULT.plan_constant / span:
        return float("inf")
    return 1 / slowest


def _declared(regressor: Regressor, group) -> bool:
    """Is this an axis error in proportion to its own position: what the declared model is made of?"""
    own = {COMPONENTS[ALL_SYMBOLS[i]].body.lower() for i in group}
    return regressor.shape.proportional and len(regressor.driver.names) == 1 and regressor.driver.names[0] in own


def pairs_in_words(pairs) -> list[dict]:
    """Return confused pairs, those of the same two drivers (or of one driver on the same two components) as one entry.

    Each: {"drivers", "shapes", "components", "effects" (messages), "cosine" (the smallest |cosine|), "count"}; the
    simplest first.
    """
    kept: dict[tuple, dict] = {}
    for a, b, cosine in pairs:
        drivers = tuple(sorted({str(a.driver), str(b.driver)}))
        symbols = tuple(dict.fromkeys((a.symbol, b.symbol)))
        key = drivers if len(drivers) > 1 else symbols
        entry = kept.setdefault(
            key, {"drivers": [], "shapes": [], "components": [], "effects": [], "cosine": 1.0, "count": 0}
        )
        entry["count"] += 1
        entry["cosine"] = min(entry["cosine"], abs(cosine))
        words = " / ".join(symbols)
        for name, values in (
            ("drivers", (str(a.driver), str(b.driver))),
            ("shapes", (a.shape.name, b.shape.name)),
            ("components", (words,)),
            ("effects", (a.entry.name, b.entry.name)),
        ):
            entry[name] += [v for v in dict.fromkeys(values) if v not in entry[name]]
    return list(kept.values())


def bodies_alike(plan: Plan) -> list[list[str]]:
    """Return groups of components that move the tool alike in every planned reading: no driver distinguishes them."""
    return [[ALL_SYMBOLS[i] for i in g] for g in plan.groups if len(g) > 1]


def unseen(plan: Plan) -> list[str]:
    """Components that show in no planned reading."""
    shown = set(itertools.chain.from_iterable(plan.groups))
    return [s for i, s in enumerate(ALL_SYMBOLS) if i not in shown and s not in ALIGNMENT]
