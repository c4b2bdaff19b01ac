# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures of the test codes for machine tools, where readings allow them.

ISO 230-2:2014 positioning along a line (A, R, E, B, M) and, by the same formulas, ISO 230-6 diagonals; ISO 230-3 drift
at a fixed place; ISO 230-4 circular tests (G, F).  Deviations are actual minus commanded.  Lengths are mm.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..closedloop.readings import Readings

NEAR = 1e-3  # mm: places so near are the same
AGREES = 0.999  # cosine between a line and the direction of sensing
FEWEST_TARGETS, FEWEST_RUNS = 5, 2  # the standard asks for five of each direction; fewer are said
STANDARD_RUNS = 5


# -- formulas ----------------------------------------------------------------------------------------------------------
@dataclass(frozen=True)
class Positioning:
    """Positioning along a line by ISO 230-2, mm.  None: the readings hold one direction only, or are not repeated.

    targets : number of places.  runs : fewest approaches of a target from one side.  accuracy : A, of both sides (or of
    the one there is).  repeatability : R.  systematic : E.  reversal : B.  mean_reversal : mean of B_i.
    mean_systematic : M.
    """

    targets: int
    runs: int
    bidirectional: bool
    accuracy: float | None
    repeatability: float | None
    systematic: float
    reversal: float | None
    mean_reversal: float | None
    mean_systematic: float | None


def positioning(target, deviation, direction) -> Positioning | None:
    """`Positioning` of approaches (N,): target position, deviation, and side of approach (+1 or -1); mm.

    Targets that were not approached from all sides that occur are left out.  None: fewer than `FEWEST_TARGETS`.
    """
    target, deviation, direction = (np.asarray(v, dtype=float) for v in (target, deviation, direction))
    sides = [s for s in (1.0, -1.0) if (direction == s).any()]
    places = np.unique(np.round(target / NEAR))
    groups = []
    for place in places:
        here = np.round(target / NEAR) == place
        own = [deviation[here & (direction == s)] for s in sides]
        if all(len(v) for v in own):
            groups.append(own)
    if len(groups) < FEWEST_TARGETS or not sides:
        return None
    mean = np.array([[v.mean() for v in own] for own in groups])
    runs = min(len(v) for own in groups for v in own)
    both = len(sides) == 2
    low, high = float(mean.min()), float(mean.max())
    accuracy = repeatability = None
    if runs >= FEWEST_RUNS:
        spread = 2 * np.array([[v.std(ddof=1) for v in own] for own in groups])
        accuracy = float((mean + spread).max() - (mean - spread).min())
        each = 2 * spread
        if both:
            each = np.column_stack([each, spread.sum(axis=1) + np.abs(mean[:, 0] - mean[:, 1])])
        repeatability = float(each.max())
    lag = mean[:, 0] - mean[:, 1] if both else None
    middle = mean.mean(axis=1)
    return Positioning(
        targets=len(groups),
        runs=runs,
        bidirectional=both,
        accuracy=accuracy,
        repeatability=repeatability,
        systematic=high - low,
        reversal=None if lag is None else float(np.abs(lag).max()),
        mean_reversal=None if lag is None else float(lag.mean()),
        mean_systematic=float(np.ptp(middle)) if both else None,
    )


@dataclass(frozen=True)
class Circular:
    """Circular test by ISO 230-4, mm: radius; deviation G of each sense of travel (+1 counter-clockwise); F of both."""

    radius: float
    deviation: dict[int, float]
    least: float
    most: float


def circular(angle, radial, sense, radius: float) -> Circular:
    """`Circular` of radial deviations (N,) at angles (N,) rad, with the sense of travel +1 or -1 of each.

    G is the range of the deviations about the least-squares centre; F_min and F_max are the extremes as programmed.
    """
    angle, radial, sense = (np.asarray(v, dtype=float) for v in (angle, radial, sense))
    found = {}
    for s in (1, -1):
        own = sense == s
        if own.sum() >= 8:
            design = np.column_stack([np.ones(own.sum()), np.cos(angle[own]), np.sin(angle[own])])
            centre = np.linalg.lstsq(design, radial[own], rcond=None)[0]
            found[s] = float(np.ptp(radial[own] - design[:, 1:] @ centre[1:]))
    return Circular(float(radius), found, float(radial.min()), float(radial.max()))


@dataclass(frozen=True)
class Drift:
    """Drift at a fixed place by ISO 230-3, mm: range of each direction over the session, and over its first hour."""

    hours: float
    whole: dict[str, float]
    first_hour: dict[str, float]


def drift(t, value, kind) -> Drift:
    """`Drift` of readings (N,) mm at times (N,) s; kind (N,): "x", "y", "z" or "*" of each."""
    t, value, kind = np.asarray(t, dtype=float), np.asarray(value, dtype=float), np.asarray(kind)
    names = list(dict.fromkeys(kind.tolist()))
    early = t - t.min() <= 3600.0
    ranges = [{n: float(np.ptp(value[(kind == n) & use])) for n in names} for use in (np.ones(len(t), bool), early)]
    return Drift(float(np.ptp(t)) / 3600.0, ranges[0], ranges[1])


# -- what readings hold ------------------------------------------------------------------------------------------------
@dataclass(frozen=True)
class Line:
    """Readings along one line of programmed places: start and direction (3,), what is found, and whether it is a
    diagonal (ISO 230-6).
    """

    start: tuple[float, float, float]
    direction: tuple[float, float, float]
    length: float
    diagonal: bool
    figures: Positioning


def lines(readings: Readings) -> list[Line]:
    """The lines along which positioning was read: whole vectors, or a reading along the line itself.

    A line is parallel to an axis or a diagonal of three readings or more in a row; approaches come from the order of
    the places.
    """
    q, found = readings.q[:, :3], {}
    if len(q) < FEWEST_TARGETS or readings.tool_offset is not None and np.ptp(readings.tool_offset, axis=0).any():
        return []
    along = _along(readings)
    move = np.diff(q, axis=0, prepend=q[:1] * np.nan)
    size = np.linalg.norm(move, axis=1)
    unit = move / np.where(size > NEAR, size, np.nan)[:, None]
    for i in range(len(q)):
        here = unit[i] if np.isfinite(unit[i]).all() else None
        nxt = unit[i + 1] if i + 1 < len(q) and np.isfinite(unit[i + 1]).all() else None
        own = here if here is not None and (nxt is None or abs(here @ nxt) > AGREES or i + 1 == len(q)) else nxt
        if own is None:
            continue
        way = own * np.sign(own[np.argmax(np.abs(own) > 0.1)])
        side = 1.0 if here is not None and here @ way > 0 else -1.0
        if here is None or abs(here @ way) < AGREES:
            continue  # the first place of a pass: nobody knows from where it was approached
        value = along(i, way)
        if value is None:
            continue
        foot = q[i] - (q[i] @ way) * way
        key = tuple(np.round(np.r_[way * 1e3, foot / (10 * NEAR)]).astype(int).tolist())
        found.setdefault(key, []).append((q[i] @ way, value, side, way, foot))
    out = []
    for rows in found.values():
        place, value, side = (np.array([r[k] for r in rows]) for k in range(3))
        figures = positioning(place, value, side)
        if figures is not None:
            way, foot = rows[0][3], rows[0][4]
            start = foot + place.min() * way
            out.append(
                Line(
                    tuple(start.tolist()),
                    tuple(way.tolist()),
                    float(np.ptp(place)),
                    bool((np.abs(way) > 0.1).sum() > 1),
                    figures,
                )
            )
    return sorted(out, key=lambda line: (line.diagonal, line.direction, line.start))


def _along(readings: Readings):
    """A function of a point and a direction (3,): the deviation along it, mm, or None where it was not sensed."""
    first = np.searchsorted(readings.point, np.arange(readings.points + 1))

    def value(i: int, way) -> float | None:
        rows = slice(first[i], first[i + 1])
        sense, read = readings.sense[rows], readings.value[rows]
        weight, *_ = np.linalg.lstsq(sense.T, way, rcond=None)
        return float(weight @ read) if len(read) and np.linalg.norm(sense.T @ weight - way) < 1e-3 else None

    return value


def fixed_place(readings: Readings) -> Drift | None:
    """The drift, where all readings were taken at one place and their times are known; else None."""
    if "t" not in readings.columns or readings.points < FEWEST_TARGETS or np.ptp(readings.q, axis=0).max() > NEAR:
        return None
    kinds = np.array(list("xyz*"))[readings.kind]
    return drift(readings.columns["t"][readings.point], readings.value, kinds)


def circles(readings: Readings) -> list[Circular]:
    """The circular test that the places make: all in one plane parallel to two axes, at one distance from a centre."""
    q = readings.q[:, :3]
    flat = [k for k in range(3) if np.ptp(q[:, k]) < NEAR]
    if len(flat) != 1 or readings.points < 16:
        return []
    a, b = (k for k in range(3) if k != flat[0])
    design = np.column_stack([2 * q[:, a], 2 * q[:, b], np.ones(len(q))])
    centre = np.linalg.lstsq(design, q[:, a] ** 2 + q[:, b] ** 2, rcond=None)[0]
    out_from = q[:, [a, b]] - centre[:2]
    radius = np.linalg.norm(out_from, axis=1)
    if np.ptp(radius) > 10 * NEAR or np.ptp(np.arctan2(out_from[:, 1], out_from[:, 0])) < 3.0:
        return []
    angle = np.unwrap(np.arctan2(out_from[:, 1], out_from[:, 0]))
    along = _along(readings)
    radial = []
    for i in range(len(q)):
        way = np.zeros(3)
        way[[a, b]] = out_from[i] / radius[i]
        radial.append(along(i, way))
    if any(v is None for v in radial):
        return []
    turn = np.sign(np.gradient(angle))
    return [circular(angle, radial, turn, radius.mean())]
