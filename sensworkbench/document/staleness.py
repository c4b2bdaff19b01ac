# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether stored results still belong to the machine: what they were computed from, as JSON, compared with tolerance.

Inputs are stated in the machine's own frame with all joints at 0, so that jogging, moving or turning the whole machine
leaves results valid.
"""

from __future__ import annotations

import json
import math

from ..core.machine import Machine
from .base import members, numbers, put
from .tree import added_effects, traces_of

TOLERANCE = 1e-6  # mm, and relative: smaller differences count as none


def result_inputs(machine, core: Machine, arms=None) -> str:
    """JSON of all that the indices of a machine object depend on.

    core : the machine that is computed.  arms : its lever arms with all joints at 0, where the caller has them.
    """
    words = [core.structure, core.squareness, machine.Output, bool(machine.Signed), machine.Aggregate]
    values = [*numbers(machine.Weights), *_geometry(core, arms)]
    values += {"quadrature": [machine.Order], "grid": [machine.Grid], "at": list(machine.At)}.get(machine.Aggregate, [])
    for symbol, t in core.all_tolerances.items():
        words += [symbol, t.distribution]
        values += [t.lower * 1e3, t.upper * 1e3, (t.sigma or 0.0) * 1e3]
    words += [_effect(e) for e in core.effects if e.enabled]
    return json.dumps([words, values], sort_keys=True)


def trace_inputs(core: Machine, without=(), arms=None) -> str:
    """JSON of all of a machine that a trace depends on.

    without : names of effects that are left out.  arms : lever arms with all joints at 0, where the caller has them.
    """
    words = [core.structure, core.squareness, sorted((s, int(d)) for s, d in core.declared.items())]
    words += [_effect(e) for e in core.effects if e.enabled and e.name not in without]
    return json.dumps([words, _geometry(core, arms, sorted)], sort_keys=True)


def _effect(effect) -> list:
    return [effect.name, effect.component, effect.driver, effect.shape, dict(effect.parameters)]


def _geometry(core: Machine, arms, order=list) -> list[float]:
    """Lever arms at home, directions and travels, in the machine frame.  order : of the names, `list` or `sorted`."""
    arms = core.lever_arms([[0.0] * len(core.joints)]) if arms is None else arms
    values = [v for body in order(arms) for v in arms[body][0].tolist()]
    for name in order(core.axes):
        values += [*core.directions[name].tolist(), *core.axes[name].span]
    return values


def same(one: str, other: str) -> bool:
    """Whether two texts of inputs describe the same machine, rounding apart; False where one is empty."""
    if not one or not other:
        return False
    (words, values), (words_, values_) = json.loads(one), json.loads(other)
    return (
        words == words_
        and len(values) == len(values_)
        and all(math.isclose(a, b, rel_tol=1e-9, abs_tol=1e-9 if abs(a) < 1e-3 else TOLERANCE)
                for a, b in zip(values, values_))
    )  # fmt: skip


def mark_results(machine, inputs: str) -> None:
    """Set `Stale` of the machine's results.  inputs : `result_inputs` of the machine as it is, "" where it has none."""
    for obj in members(machine, "Sensitivity"):
        put(obj, "Stale", not same(obj.Inputs, inputs))


def mark_traces(machine, core: Machine, arms=None) -> None:
    """Set `Stale` of the machine's traces; effects that were added from a trace do not count as changes for it.

    arms : as in `trace_inputs`.
    """
    for obj in traces_of(machine):
        labels = {o.Label for o in added_effects(obj)}
        put(obj, "Stale", not same(obj.Inputs, trace_inputs(core, labels, arms)))
