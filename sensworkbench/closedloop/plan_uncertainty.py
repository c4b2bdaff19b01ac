# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a plan will know of each declared error: its standard uncertainty, and what more readings would buy.

The readings have no values yet; the covariance of a weighted least-squares fit does not depend on them.  The
uncertainty of an error is that of its function, rms over its travel, with correlations between its coefficients.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ..core.machine import Machine
from .design import declared_columns, declared_terms, design, run_labels
from .fit import Basis, basis
from .plan_advice import tool_length
from .readings import Readings

TOLD = 1e-6  # of a parameter that may lie in directions that no reading sees
STATIONS = 21  # over the travel, at which a function is looked at
CHANGES = ("tool", "run", "sensor")
OBLIQUE = 3  # kind of a reading along its own vector


@dataclass(frozen=True)
class PlannedError:
    """One declared error.

    u : standard uncertainty of its function, rms over the travel, mm or rad; None where the plan does not determine it.
    more : change (of CHANGES) -> the same with the places measured once more: with another tool length, in another run,
    or with the directions of sensing that the plan lacks (missing where it has all three).
    """

    symbol: str
    u: float | None
    more: dict[str, float | None]


def planned_errors(machine: Machine, readings: Readings) -> list[PlannedError]:
    """Every declared error, in the order of the machine.  readings : of a plan, with their noise as u."""
    present = _uncertainties(machine, readings)
    more = {name: _uncertainties(machine, changed) for name, changed in _more(machine, readings).items()}
    return [PlannedError(s, u, {name: table.get(s) for name, table in more.items()}) for s, u in present.items()]


def _more(machine: Machine, readings: Readings) -> dict[str, Readings]:
    tools = readings.tool_offset if readings.tool_offset is not None else np.zeros((readings.points, 3))
    longer = replace(readings, tool_offset=tools + [0.0, 0.0, -tool_length(machine)])
    found = {"tool": joined(replace(readings, tool_offset=tools), longer)}
    labels = readings.run if readings.run is not None else np.full(readings.points, "1")
    another = np.full(readings.points, "another")
    if len(run_labels(readings)) > 1:  # as many runs again
        another = np.array([f"{label} again" for label in labels])
    found["run"] = joined(replace(readings, run=np.asarray(labels).astype(str)), replace(readings, run=another))
    sensed = set(readings.kind.tolist())
    lacking = [] if OBLIQUE in sensed else sorted(set(range(OBLIQUE)) - sensed)
    if lacking:
        count = readings.points
        further = replace(
            readings,
            point=np.repeat(np.arange(count), len(lacking)),
            sense=np.eye(3)[np.tile(lacking, count)],
            kind=np.tile(np.array(lacking), count),
            value=np.zeros(count * len(lacking)),
            u=np.full(count * len(lacking), float(readings.u[0])),
        )
        found["sensor"] = joined(readings, further)
    return found


def joined(one: Readings, other: Readings) -> Readings:
    """The readings of both tables, which have the same columns."""

    def both(a, b):
        return None if a is None else np.concatenate([a, b])

    return replace(
        one,
        q=np.concatenate([one.q, other.q]),
        point=np.concatenate([one.point, other.point + one.points]),
        sense=np.concatenate([one.sense, other.sense]),
        value=np.concatenate([one.value, other.value]),
        u=np.concatenate([one.u, other.u]),
        kind=np.concatenate([one.kind, other.kind]),
        columns={n: np.concatenate([v, other.columns[n]]) for n, v in one.columns.items()},
        categories={n: np.concatenate([v, other.categories[n]]) for n, v in one.categories.items()},
        run=both(one.run, other.run),
        tool_offset=both(one.tool_offset, other.tool_offset),
        line=both(one.line, other.line),
    )


def _uncertainties(machine: Machine, readings: Readings) -> dict[str, float | None]:
    """symbol -> standard uncertainty of its function."""
    made = design(machine, readings)
    found = basis(made.matrix, 1 / readings.u)
    declared = declared_terms(machine)
    stations = np.linspace(*machine.travel.T, STATIONS)
    functions = declared_columns(machine, declared, stations)
    out = {}
    for symbol in dict.fromkeys(t.symbol for t in declared):
        at = [
            i for i, t in enumerate(declared) if t.symbol == symbol
        ]  # the first terms of a design are the declared ones
        out[symbol] = _of_function(found, at, functions[:, at])
    return out


def _of_function(b: Basis, at: list[int], functions: np.ndarray) -> float | None:
    """rms of the standard uncertainty of functions (S, k) of the parameters `at`."""
    missing = 1 - (b.v[at] ** 2).sum(axis=1)
    if (missing > TOLD).any() or not np.isfinite(b.scale[at]).all():
        return None
    root = (b.v[at] / b.s) / b.scale[at][:, None]
    return float(np.sqrt(np.square(functions @ root).sum(axis=1).mean()))
