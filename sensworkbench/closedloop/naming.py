# SPDX-License-Identifier: LGPL-2.1-or-later
"""Accept a name only if a free form of the same component and columns does not fit significantly better.

An odd shape can be imitated by several plausible terms, slow columns can replace each other and time, and short-wave
roughness looks periodic almost everywhere; each case has its own test here.
"""

from __future__ import annotations

import numpy as np

from ..core.driver import DIRECTIONS, POSITIONS, TIME
from ..core.errors import component
from ..messages import Message
from .freeform import free_form, normal_score, subspace_gain
from .scan import Rows, Scanner
from .search import ScoredTerm
from .settings import DEFAULT, TraceSettings


def _fourier(v, harmonics: int) -> np.ndarray:
    span = float(np.ptp(v)) * 1.02
    phase = 2 * np.pi * (v - v.min()) / span
    k = np.arange(1, harmonics + 1)
    return np.concatenate([np.sin(phase[:, None] * k), np.cos(phase[:, None] * k)], axis=1)


def slow_columns(columns, names, settings: TraceSettings = DEFAULT) -> list[str]:
    """Return the columns that vary smoothly along the order of the readings, so that time could replace them."""
    slow = []
    for name in names:
        v = np.asarray(columns[name], dtype=float)
        if name in POSITIONS or name in DIRECTIONS or name == TIME:
            continue
        step = np.diff(v)
        if len(v) > settings.slow_least and float(np.mean(step**2)) < settings.slow * float(np.var(v)):
            slow.append(name)
    return slow


def free_forms(
    candidate: ScoredTerm, columns, names, settings: TraceSettings = DEFAULT
) -> list[tuple[Message, np.ndarray]]:
    """Free forms that must gain nothing beyond the candidate: (what it is a form of, vectors (P, m))."""
    driver, out, s = candidate.driver, [], settings
    if candidate.shape.wave:
        v = driver.values(columns)
        harmonics = int(min(s.harmonics, len(np.unique(v)) // s.levels_per_wave, len(v) // s.points_per_wave))
        if harmonics > 1:
            out.append((Message("form-waves", driver=str(driver)), _fourier(v, harmonics)))
        return out
    slow = [p for p in driver.names if p in slow_columns(columns, names, s)]
    parts = candidate.regressor.columns
    degree = {1: s.free_line, 2: s.free_plane}.get(len(parts), s.free_more)
    out.append((Message("form-columns", columns=list(parts)), free_form(columns, parts, degree).vectors))
    if slow and TIME in names:
        others = tuple(p for p in parts if p not in (*slow, TIME))
        if not others:
            out.append((Message("form-time"), free_form(columns, (TIME,), s.free_time).vectors))
        else:
            # the other factors as they stand, times any smooth function of time
            scale = np.ones(len(columns[TIME]))
            for name in driver.columns:
                if name in others:
                    scale = scale * columns[name]
            form = free_form(columns, (TIME,), s.free_time_factor).vectors
            smooth = np.concatenate([np.ones((len(scale), 1)), form], axis=1)
            out.append((Message("form-columns-time", columns=list(others)), scale[:, None] * smooth))
    return out


def beyond(
    rows: Rows,
    candidate: ScoredTerm,
    columns,
    names,
    readings_used: int,
    settings: TraceSettings = DEFAULT,
    inflation: float = 1.0,
) -> Message | None:
    """What a free form finds beyond the candidate, or None; rows: of the model that holds the candidate.

    inflation : of the variance by memory of the noise that is not whitened.
    """
    for what, vectors in free_forms(candidate, columns, names, settings):
        gain, dims = subspace_gain(rows, candidate.index, vectors)
        gain = gain / inflation
        size = np.sqrt(max(gain - dims, 0.0) / max(readings_used, 1))
        if normal_score(gain, dims) > settings.beyond_score and size > settings.beyond_size:
            return Message("refused-free-form", form=what, component=candidate.symbol)
    return None


def stand_in(candidate: ScoredTerm, others, columns, names, settings: TraceSettings = DEFAULT) -> Message | None:
    """Return why an effect of temperatures and time may only replace a column that was not logged; None if it does not.

    A combination of slow curves can imitate any slow curve: two terms on one motion are not named, unless each is
    proportional, a warm-up or a step.  Nor is a polynomial of one temperature named (expansion is proportional), nor
    the temperature of another axis if that of the moving axis was not logged.
    """
    slow = {n for n in slow_columns(columns, names, settings) if n.startswith("temp_")} | {TIME}

    def parts(c: ScoredTerm) -> tuple[set[str], set[str]]:
        factors = set(c.driver.columns)
        return factors & slow, factors - slow

    def bent(c: ScoredTerm) -> bool:
        if TIME in parts(c)[0]:
            return not (c.shape.warm_up or c.shape.sudden)
        return not c.shape.proportional or c.driver.repeats

    def motion(c: ScoredTerm):
        at = component(c.symbol)
        return c.symbol if at.angular else at.axis

    mine, rest = parts(candidate)
    if candidate.shape.series and mine and TIME not in mine:
        return Message("refused-bent", driver=str(candidate.driver))
    own = component(candidate.symbol).body.lower()
    for name in sorted(mine) if own in POSITIONS else ():
        stem, _, axis = name.rpartition("_")
        if axis in POSITIONS and axis != own and f"{stem}_{own}" not in columns:
            return Message("refused-other-axis", column=name, missing=f"{stem}_{own}")
    for o in others if mine else ():
        theirs, same = parts(o)
        if candidate.shape.sudden or o.shape.sudden:
            continue  # nothing slow looks like an instant
        if theirs and same == rest and motion(o) == motion(candidate) and (bent(o) or bent(candidate)):
            return Message("refused-pieces", columns=sorted(mine | theirs))
    return None


def stands_out(rows: Rows, candidate: ScoredTerm, scanner: Scanner, columns, settings: TraceSettings = DEFAULT) -> bool:
    """Whether a period explains much more than any other wave that is left: roughness is many waves, a screw is one.

    What the travel cannot tell from it is no other wave: the height of a screw's error may change along it.
    """
    gains = scanner.scores(rows.residual).gain
    span = float(np.ptp(candidate.driver.values(columns)))
    own = [
        s.driver == candidate.driver and not s.shape.resolved(candidate.shape, span)
        for s in scanner.shapes
        if s.shape.wave
    ]
    lines = np.flatnonzero([s.shape.wave for s in scanner.shapes])[~np.array(own, dtype=bool)]
    return not len(lines) or candidate.gain > settings.line_ratio * float(gains[lines].max())
