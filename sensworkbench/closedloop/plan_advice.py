# SPDX-License-Identifier: LGPL-2.1-or-later
"""Advice on a measuring plan, each with the number that it would improve, and a better plan of as many readings.

Every change is made to the plan, and the changed plan is evaluated as the given one was.  Conditions that nobody can
plan (temperatures) are replaced by those of a usual session.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

import numpy as np

from ..core.driver import DIRECTIONS, POSITIONS
from ..core.machine import Machine
from ..messages import Message
from .design import tool_labels
from .plan import LEADS, Plan, as_readings
from .readings import Readings
from .settings import DEFAULT

SECONDS = 10.0  # from one reading to the next, where no time is planned
SIDE_MM = 80.0  # the probe to the side
LOAD_KG = 200.0  # on the table, where no load is planned
DRAWS = 8
REPEATED, VISITS = 6, 4  # places visited again in a suggested plan, and how often each is visited
CLEAR_MM = 0.01  # places of a file are written to this digit


@dataclass(frozen=True)
class Advice:
    """do : what to change.  improves : the number.  before, after : its values (None: not at all), in `unit`."""

    do: Message
    improves: Message
    before: float | None
    after: float | None
    unit: str
    why: Message | None = None


def advise(plan: Plan, seed: int = 0) -> list[Advice]:
    """What would make the plan better, the change with the largest gain first; [] where nothing would."""
    found = [a for a in _tried(plan, np.random.default_rng(seed)) if _worth(a)]
    return sorted(found, key=_gain, reverse=True)


def _worth(a: Advice) -> bool:
    if a.after is None:
        return False
    if a.unit == "count_up":
        return a.after > (a.before or 0)
    return a.before is None or a.after < DEFAULT.plan_worth * a.before


def _gain(a: Advice) -> float:
    if a.before is None:
        return float("inf")
    if a.unit == "count_up":
        return (a.after + 1) / (a.before + 1)
    return (a.before + 1e-9) / (a.after + 1e-9)


# -- changes -----------------------------------------------------------------------------------------------------------
def _tried(plan: Plan, rng) -> Iterator[Advice]:
    readings, machine = plan.readings, plan.machine
    again = lambda changed: Plan(machine, changed)  # noqa: E731
    if len(tool_labels(readings)) < 2:
        tools = again(with_tools(machine, readings, rng))
        length = tool_length(machine)
        yield Advice(
            Message("plan-do-tools", length=length, side=SIDE_MM),
            Message("plan-improves-undetermined"),
            plan.parameters - plan.rank,
            tools.parameters - tools.rank,
            "count",
            Message("plan-why-tools"),
        )
    reversal = plan.smallest_um("reversal")
    mixed = again(with_directions(readings, rng))
    yield Advice(
        Message("plan-do-directions"),
        Message("plan-improves-reversal"),
        reversal,
        mixed.smallest_um("reversal"),
        "um",
        Message("plan-why-directions"),
    )
    timed = "t" in plan.names
    base = plan if timed else again(with_time(readings))
    if not timed:
        yield Advice(
            Message("plan-do-time"),
            Message("plan-improves-drift"),
            plan.smallest_um("drift", "spindle-growth"),
            base.smallest_um("drift", "spindle-growth"),
            "um",
            Message("plan-why-time"),
        )
    shuffled = again(in_random_order(base.readings, rng))
    yield Advice(
        Message("plan-do-random-order") if timed else Message("plan-do-random-order-time"),
        Message("plan-improves-drift"),
        base.smallest_um("drift", "spindle-growth"),
        shuffled.smallest_um("drift", "spindle-growth"),
        "um",
        Message("plan-why-random-order"),
    )
    if plan.aliased:
        irregular = again(with_irregular_pitch(machine, readings, rng))
        yield Advice(
            Message("plan-do-irregular"),
            Message("plan-improves-aliases"),
            len(plan.aliased),
            len(irregular.aliased),
            "count",
            Message("plan-why-irregular"),
        )
    if not any(n.startswith("temp_") for n in plan.names):
        warm = again(with_temperatures(base.readings))
        yield Advice(
            Message("plan-do-temperatures"),
            Message("plan-improves-thermal"),
            plan.smallest_um("thermal-scale", "thermal-bend"),
            warm.smallest_um("thermal-scale", "thermal-bend"),
            "um",
            Message("plan-why-temperatures"),
        )
    yield from _conditions(plan, again, rng)
    _, freedom = plan.repeats
    repeated = again(with_repeats(readings, rng))
    if freedom < repeated.repeats[1]:
        yield Advice(
            Message("plan-do-repeats", places=REPEATED, visits=VISITS),
            Message("plan-improves-repeats"),
            freedom,
            repeated.repeats[1],
            "count_up",
            Message("plan-why-repeats"),
        )


def _conditions(plan: Plan, again: Callable[[Readings], Plan], rng) -> Iterator[Advice]:
    readings = plan.readings
    count = readings.points
    if "feed" not in plan.names:
        feed = rng.choice([500.0, 2000.0, 6000.0], count)
        changed = again(_with(readings if "dir_x" in plan.names else with_directions(readings, rng), feed=feed))
        yield Advice(
            Message("plan-do-feeds"),
            Message("plan-improves-feed"),
            plan.smallest_um("feed", "following"),
            changed.smallest_um("feed", "following"),
            "um",
        )
    if not any(n.startswith("load_") for n in plan.names):
        load = np.where(np.arange(count) < count // 2, 0.0, LOAD_KG)
        changed = again(_with(in_random_order(readings, rng), load_table=load))
        yield Advice(
            Message("plan-do-load"),
            Message("plan-improves-load"),
            plan.smallest_um("mass"),
            changed.smallest_um("mass"),
            "um",
            Message("plan-why-load", mass=LOAD_KG),
        )


def _with(readings: Readings, **columns) -> Readings:
    return replace(readings, columns={**readings.columns, **columns})


def tool_length(machine: Machine) -> float:
    """A second tool length that fits the machine: a third of Z's travel, 50 to 150 mm."""
    low, high = machine.axes["Z"].travel
    return float(np.clip(10 * round((high - low) / 30), 50, 150))


def with_tools(machine: Machine, readings: Readings, rng) -> Readings:
    """A quarter of the places with a longer tool, and a quarter with the probe to the side, drawn at random."""
    tools = np.array([[0.0, 0.0, 0.0], [0.0, 0.0, -tool_length(machine)], [SIDE_MM, 0.0, 0.0]])
    which = rng.permutation(np.resize([0, 1, 0, 2], readings.points))
    return replace(readings, tool_offset=tools[which])


def with_directions(readings: Readings, rng) -> Readings:
    """Return the plan with random directions of approach."""
    return _with(readings, **{n: rng.choice([-1.0, 1.0], readings.points) for n in DIRECTIONS})


def with_time(readings: Readings) -> Readings:
    """Return the plan with a time for every reading, at equal intervals."""
    return _with(readings, t=SECONDS * np.arange(readings.points))


def with_temperatures(readings: Readings) -> Readings:
    """Two temperatures of a usual session: a scale that warms up and a column that follows the hall."""
    s = np.linspace(0, 1, readings.points)
    return _with(readings, temp_scale=3 * (1 - np.exp(-3 * s)), temp_column=2 * np.sin(2 * np.pi * 1.3 * s))


def in_random_order(readings: Readings, rng) -> Readings:
    """The same places, directions and tools in another order; time and conditions stay with the order."""
    order = rng.permutation(readings.points)
    counts = np.bincount(readings.point, minlength=readings.points)
    first = np.cumsum(counts) - counts
    rows = np.concatenate([np.arange(first[i], first[i] + counts[i]) for i in order])
    moved = {n: readings.columns[n][order] for n in (*POSITIONS, *DIRECTIONS) if n in readings.columns}
    return replace(
        readings,
        q=readings.q[order],
        columns={**readings.columns, **moved},
        tool_offset=None if readings.tool_offset is None else readings.tool_offset[order],
        point=np.repeat(np.arange(readings.points), counts[order]),
        sense=readings.sense[rows],
        kind=readings.kind[rows],
    )


def placed(readings: Readings, q) -> Readings:
    """The plan at other places q (P, 3) mm."""
    return replace(readings, q=q, columns={**readings.columns, **{n: q[:, i] for i, n in enumerate(POSITIONS)}})


def with_irregular_pitch(machine: Machine, readings: Readings, rng) -> Readings:
    """Return the plan with its places moved off their regular pitch."""
    q = readings.q.copy()
    low, high = machine.travel.T
    for i in range(3):
        levels = np.unique(np.round(q[:, i], 3))
        if len(levels) > 1:
            step = max(float(np.median(np.diff(levels))), max(LEADS))
            q[:, i] = np.clip(q[:, i] + step * (rng.random(len(q)) - 0.5), low[i], high[i])
    return placed(readings, q)


def with_repeats(readings: Readings, rng) -> Readings:
    """Some places take the position and the tool of a few others, spread over the session."""
    count = readings.points
    if count < 2 * REPEATED * VISITS:
        return readings
    slots = np.linspace(0, count - 1, REPEATED * VISITS).round().astype(int)
    source = np.arange(count)
    source[slots] = np.tile(slots[:REPEATED], VISITS)
    tool = None if readings.tool_offset is None else readings.tool_offset[source]
    return placed(replace(readings, tool_offset=tool), readings.q[source])


# -- a better plan -----------------------------------------------------------------------------------------------------
def suggest(machine: Machine, count: int, noise_mm: float, given: Readings | None = None, seed: int = 0) -> Readings:
    """A plan of `count` readings of full vectors: random places, mixed directions, random order, two tool lengths and a
    lateral offset, and places visited again through the session.

    given : a plan whose conditions (temperatures, loads, feed, speed) are kept, by their part of the session.  Of some
    draws the one whose declared model predicts best, with both tool lengths, is taken.
    """
    best, score = _drawn(machine, count, noise_mm, given, np.random.default_rng([seed, 0])), np.inf
    for draw in range(DRAWS):
        rng = np.random.default_rng([seed, draw])
        one = _drawn(machine, count, noise_mm, given, rng)
        plan = Plan(machine, one)
        uncertain = [plan.prediction_um(longer)[0] for longer in (0.0, tool_length(machine))]
        value = (plan.parameters - plan.rank) * 1e6 + sum(1e5 if u is None else u for u in uncertain)
        if value < score:
            best, score = one, value
    return best


def _drawn(machine: Machine, count: int, noise_mm: float, given: Readings | None, rng) -> Readings:
    low, high = machine.travel.T
    # each axis in as many strata as there are readings, so that no part of the travel is left out; denser towards the
    # ends, as the zeros of high polynomials are: that is where a fitted polynomial is least certain
    q = np.stack([(rng.permutation(count) + rng.random(count)) / count for _ in range(3)], axis=1)
    q = (1 - np.cos(np.pi * q)) / 2
    q = np.round((low + (high - low) * q) / CLEAR_MM) * CLEAR_MM
    q = np.clip(q, low, high)
    columns = {n: q[:, i] for i, n in enumerate(POSITIONS)}
    units = {n: "mm" for n in POSITIONS} | {"t": "s"}
    part = np.linspace(0, 1, count)
    t = SECONDS * np.arange(count)
    if given is not None and "t" in given.columns:
        t = np.round(np.interp(part, np.linspace(0, 1, given.points), given.columns["t"]), 3)
    columns["t"] = t
    if given is not None:
        place = np.minimum((part * given.points).astype(int), given.points - 1)
        for name, values in given.columns.items():
            if name not in (*POSITIONS, *DIRECTIONS, "t"):
                columns[name] = values[place]
                units[name] = given.units.get(name, "")
    none = np.empty(0)
    positions = Readings(
        q=q,
        point=none.astype(int),
        sense=np.empty((0, 3)),
        value=none,
        u=none,
        kind=none.astype(int),
        columns=columns,
        units=units,
        line=np.arange(2, count + 2),
    )
    readings = with_tools(machine, as_readings(positions, noise_mm), rng)
    return with_directions(with_repeats(readings, rng), rng)
