# SPDX-License-Identifier: LGPL-2.1-or-later
"""Error tables as ISG, Beckhoff and Etalon exchange them: parameters over axis positions, and constants; mm and rad.

`sampled` makes them from a machine, `converted` answers the sign questions of a file, and `to_machine` turns tables
into fitted functions and effects, and says how well they follow the table.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from ..closedloop.readings import Remark
from ..core.driver import Driver
from ..core.effects import Effect
from ..core.errors import AXES, SQUARENESS, component
from ..core.fitted import Series
from ..core.machine import Machine
from ..core.shapes import Linear, to_domain
from ..messages import Message, Refused
from .coverage import Coverage, drive
from .fitted_errors import as_direction, carried_as, line_error, series, squareness_symbols, with_fitted

GOAL = {False: 2e-5, True: 2e-8}  # interpolation error of a table: mm, rad
MAX_DEGREE = 30
BEYOND, WITHIN = 5.0, 0.005  # travels beyond which, and of the travel within which, positions are in another unit
IMPLAUSIBLE = {False: 1.0, True: 1e-2}  # mm, rad: errors from which a table is likely in another unit
MAX_POINTS = {1: 1025, 2: 65, 3: 17}  # per axis, by the number of axes


@dataclass(frozen=True)
class ErrorTable:
    """One parameter: symbol over `arguments` (axis names); points (N, a) mm; values (N,) mm or rad.

    interpolation : largest error of multilinear interpolation, mm or rad, where the function behind it is known.
    """

    symbol: str
    arguments: tuple[str, ...]
    points: np.ndarray
    values: np.ndarray
    interpolation: float = 0.0


@dataclass(frozen=True)
class ErrorTables:
    """tables : the functions.  constants : squareness by symbol, rad.  remarks : what reading noticed."""

    tables: tuple[ErrorTable, ...] = ()
    constants: Mapping[str, float] = field(default_factory=dict)
    remarks: tuple[Remark, ...] = ()


def merged(parts) -> ErrorTables:
    """The tables of several files as one; a parameter that two of them state is refused."""
    tables: list[ErrorTable] = []
    constants: dict[str, float] = {}
    remarks: list[Remark] = []
    for part in parts:
        names = [t.symbol for t in part.tables] + list(part.constants)
        twice = {t.symbol for t in tables}.union(constants).intersection(names)
        if twice:
            raise Refused("tables-stated-twice", "error tables", symbols=sorted(twice))
        tables += part.tables
        constants |= part.constants
        remarks += part.remarks
    return ErrorTables(tuple(tables), constants, tuple(remarks))


# -- from a machine --------------------------------------------------------------------------------------------------
def sampled(machine: Machine, coverage: Coverage) -> ErrorTables:
    """Tables of everything that `coverage` lists, fine enough for multilinear interpolation."""
    machine = as_direction(machine)
    constants = {s: line_error(machine, s) for s in coverage.symbols if machine.component(s).line}
    effects: dict[str, list[tuple[Effect, tuple[str, ...]]]] = {}
    for effect in machine.effects:
        if effect.enabled and effect.name in coverage.effects:
            effects.setdefault(effect.component, []).append((effect, drive(machine, effect).axes))
    symbols = [s for s in coverage.symbols if s not in constants] + [s for s in effects if s not in coverage.symbols]
    symbols += [s for s in effects if s in constants]
    tables = []
    for symbol in symbols:
        c = machine.component(symbol)
        own = c.body
        used = set() if c.line else {own}
        for _, axes in effects.get(symbol, ()):
            used |= set(axes)
        others = [k for k in machine.names if k in used and k != own]
        arguments = (*others, own) if own in used else tuple(others)
        constant = constants.pop(symbol, 0.0) if symbol in effects else 0.0
        tables.append(_sampled(machine, symbol, arguments, effects.get(symbol, ()), constant))
    return ErrorTables(tuple(tables), constants)


def _sampled(machine, symbol, arguments, effects, constant) -> ErrorTable:
    c = machine.component(symbol)
    own = series(machine, symbol) if not c.line else Series((-1.0, 1.0), (constant,))

    def value(points):
        columns = {machine.joint(k).column: points[:, i] for i, k in enumerate(arguments)}
        out = np.full(len(points), own.coefficients[0])
        if c.body in arguments:
            out = own(columns[machine.joint(c.body).column])
        for effect, _ in effects:
            out = out + effect.values(columns)
        return out

    travel = [machine.joint(k).span for k in arguments]
    counts = [3] * len(arguments)
    limit = MAX_POINTS[len(arguments)]
    while True:
        worst = [_interpolation(value, travel, counts, i) for i in range(len(arguments))]
        coarse = [i for i, w in enumerate(worst) if w > GOAL[c.angular] / len(counts) and counts[i] < limit]
        if not coarse:
            break
        for i in coarse:
            counts[i] = min(2 * counts[i] - 1, limit)
    points = _grid([np.linspace(*t, n) for t, n in zip(travel, counts, strict=True)])
    return ErrorTable(symbol, arguments, points, value(points), float(sum(worst)))


def _grid(axes) -> np.ndarray:
    return np.stack([g.ravel() for g in np.meshgrid(*axes, indexing="ij")], axis=1)


def _interpolation(value, travel, counts, i: int) -> float:
    """Largest error of linear interpolation along argument i."""
    axes = [np.linspace(*t, 5) for t in travel]
    axes[i] = np.linspace(*travel[i], counts[i])
    fine = list(axes)
    fine[i] = np.linspace(*travel[i], 8 * (counts[i] - 1) + 1)
    shape = [len(a) for a in axes]
    table = np.moveaxis(value(_grid(axes)).reshape(shape), i, -1).reshape(-1, len(axes[i]))
    shape[i] = len(fine[i])
    true = np.moveaxis(value(_grid(fine)).reshape(shape), i, -1).reshape(-1, len(fine[i]))
    return max(float(np.abs(np.interp(fine[i], axes[i], t) - f).max()) for t, f in zip(table, true, strict=True))


def remark(code: str, line: int = 0, severity: str = "info", **fields) -> Remark:
    """A remark on a file that was read.  code : of its message."""
    return Remark(severity, code, Message(code, **fields), line)


# -- conventions -----------------------------------------------------------------------------------------------------
@dataclass(frozen=True)
class Convention:
    """How a file states its errors; the defaults are ISO 230-1 and ours.

    sign : "error" (actual - nominal) or "compensation".  own_motion : axes whose errors are the table's own motion
    instead of the tool's relative to the table.  table_positions : axes whose argument is the table's position.
    angles : "active" or "passive" rotations.  squareness : "direction" or "carried".
    squareness_sign : "right_handed", or "larger_than_90" (positive where the angle between the axes is larger).
    """

    sign: str = "error"
    own_motion: tuple[str, ...] = ()
    table_positions: tuple[str, ...] = ()
    angles: str = "active"
    squareness: str = "direction"
    squareness_sign: str = "right_handed"

    def __post_init__(self):
        for name, answers in (
            ("sign", ("error", "compensation")),
            ("angles", ("active", "passive")),
            ("squareness", ("direction", "carried")),
            ("squareness_sign", ("right_handed", "larger_than_90")),
        ):
            if getattr(self, name) not in answers:
                raise Refused("convention-answer", name, value=repr(getattr(self, name))[:60], known=list(answers))
        for name in ("own_motion", "table_positions"):
            if not set(getattr(self, name)) <= set(AXES):
                raise Refused("convention-axes", name, value=repr(getattr(self, name))[:60])


def converted(tables: ErrorTables, convention: Convention) -> ErrorTables:
    """The tables in our convention, except `squareness`, which `to_machine` settles; every change is a finding."""
    remarks = list(tables.remarks)
    whole = -1.0 if convention.sign == "compensation" else 1.0
    if whole < 0:
        remarks.append(remark("sign-converted"))
    for name, what in (("own_motion", "frame-converted"), ("table_positions", "positions-converted")):
        axes = getattr(convention, name)
        if axes:
            remarks.append(remark(what, axes=list(axes)))
    if convention.angles == "passive":
        remarks.append(remark("angles-converted"))
    if convention.squareness_sign == "larger_than_90":
        remarks.append(remark("squareness-sign-converted"))

    def sign(symbol):
        c = component(symbol)
        s = whole
        if c.body in convention.own_motion and c.kind != SQUARENESS:
            s = -s
        if convention.angles == "passive" and c.angular and c.kind != SQUARENESS:
            s = -s
        # Z turned about +Y closes the angle to X; Y about +Z and Z about +X open theirs
        if convention.squareness_sign == "larger_than_90" and symbol == "B0Z":
            s = -s
        return s

    def turned(table):
        flip = np.array([-1.0 if k in convention.table_positions else 1.0 for k in table.arguments])
        return replace(table, points=table.points * flip, values=table.values * sign(table.symbol))

    constants = {s: v * sign(s) for s, v in tables.constants.items()}
    return ErrorTables(tuple(turned(t) for t in tables.tables), constants, tuple(remarks))


# -- to a machine ----------------------------------------------------------------------------------------------------
@dataclass(frozen=True)
class Approximation:
    """How well the fitted function follows a table: rms and largest difference, um or urad; degree used."""

    symbol: str
    degree: int
    rms: float
    largest: float
    unit: str


def to_machine(
    machine: Machine, tables: ErrorTables, degree: int = 3, convention: Convention | None = None
) -> tuple[Machine, tuple[Approximation, ...], tuple[Remark, ...]]:
    """The machine with the tables as fitted errors, how well they are followed, and remarks.

    degree : of the Legendre functions of the axis's own position.  A parameter that also depends on other axes gets
    effects linear in each of them and in its product with the own position.
    """
    if not 1 <= degree <= MAX_DEGREE:
        raise Refused("degree-out-of-range", "--degree", degree=degree, most=MAX_DEGREE)
    tables = converted(tables, convention or Convention())
    stated = (convention or Convention()).squareness
    remarks, quality = [*tables.remarks, *_implausible(tables), *_elsewhere(machine, tables)], []
    changes: dict = dict(tables.constants)
    effects = list(machine.effects)
    for table in tables.tables:
        value, added, approximation = _approximated(machine, table, degree)
        changes[table.symbol] = value
        effects += _renamed(added, effects)
        quality.append(approximation)
    if stated != machine.squareness:
        factor = 1 if stated == "carried" else -1
        for symbol in squareness_symbols(machine):
            rotation, s = carried_as(machine, symbol), changes.get(symbol, 0.0)
            if s:
                old = changes.get(rotation) or series(machine, rotation)
                changes[rotation] = old.plus(factor * machine.side(machine.component(symbol).body) * s)
        remarks.append(remark("squareness-converted", stated=stated, taken=machine.squareness))
    return with_fitted(machine, changes, effects), tuple(quality), tuple(remarks)


def _implausible(tables: ErrorTables) -> list[Remark]:
    """A warning for each parameter that no machine tool reaches: um stand where mm are meant, or arcsec for rad."""
    sizes = {t.symbol: float(np.abs(t.values).max(initial=0.0)) for t in tables.tables}
    sizes |= {s: abs(v) for s, v in tables.constants.items()}
    found = []
    for symbol, size in sizes.items():
        angular = component(symbol).angular
        if size >= IMPLAUSIBLE[angular]:
            unit = "rad" if angular else "mm"
            found.append(remark("table-size-implausible", severity="warning", symbol=symbol, size=size, unit=unit))
    return found


def _elsewhere(machine: Machine, tables: ErrorTables) -> list[Remark]:
    """A warning for each axis whose positions in the tables are not those of the machine: um or m in place of mm."""
    found, reach = [], {}
    for table in tables.tables:
        for name, q in zip(table.arguments, table.points.T, strict=True):
            low, high = reach.get(name, (np.inf, -np.inf))
            reach[name] = min(low, float(q.min())), max(high, float(q.max()))
    for name, (low, high) in reach.items():
        first, last = machine.joint(name).span
        length = last - first
        beyond = max(first - low, high - last) > BEYOND * length
        if beyond or high - low < WITHIN * length:
            travel = {"first": first, "last": last}
            found.append(
                remark("table-places-implausible", severity="warning", joint=name, low=low, high=high, **travel)
            )
    return found


def _renamed(added, effects):
    names = {e.name for e in effects}
    out = []
    for effect in added:
        name, number = effect.name, 2
        while name in names:
            name, number = f"{effect.name} ({number})", number + 1
        names.add(name)
        out.append(replace(effect, name=name))
    return out


def _approximated(machine: Machine, table: ErrorTable, degree: int):
    """(Series or constant, effects, Approximation) by least squares."""
    c = machine.component(table.symbol)
    scale = c.to_shown(1.0)
    function = c.kind != SQUARENESS and c.body in table.arguments
    own = table.arguments.index(c.body) if function else None
    others = [i for i in range(len(table.arguments)) if i != own]
    domain, used = (-1.0, 1.0), 0
    if own is not None:
        q = table.points[:, own]
        used = min(degree, len(np.unique(q)) - 1)
        domain = (float(q.min()), float(q.max()))
    if domain[0] >= domain[1]:
        raise Refused("table-one-position", table.symbol, symbol=table.symbol)
    blocks = [np.ones((len(table.values), 1))]
    if own is not None:
        blocks = [np.polynomial.legendre.legvander(to_domain(q, domain), used)]
    drivers = []
    for i in others:
        v = table.points[:, i]
        if np.ptp(v) == 0:
            continue
        drivers.append(Driver((table.arguments[i].lower(),)))
        blocks.append(v[:, None])
        if own is not None and used:
            drivers.append(Driver((table.arguments[i].lower(), c.body.lower())))
            blocks.append((v * q)[:, None])
    matrix = np.concatenate(blocks, axis=1)
    size = np.abs(matrix).max(axis=0)
    size[size == 0] = 1.0
    solution = np.linalg.lstsq(matrix / size, table.values, rcond=None)[0] / size
    rest = (table.values - matrix @ solution) * scale
    approximation = Approximation(
        table.symbol, used, float(np.sqrt((rest**2).mean())), float(np.abs(rest).max()), c.unit
    )
    effects = []
    for driver, value, column in zip(drivers, solution[used + 1 :], matrix.T[used + 1 :], strict=True):
        if np.abs(value * column).max() * scale > 1e-6:
            extent = (float(column.min()), float(column.max()))
            name = f"{table.symbol} over {driver}"
            effects.append(Effect(name, table.symbol, driver, Linear(), (float(value),), extent=extent))
    if c.kind == SQUARENESS:
        return float(solution[0]), effects, approximation
    return Series(domain, tuple(float(v) for v in solution[: used + 1])), effects, approximation
