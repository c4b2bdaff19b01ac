# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether stored results still belong to the machine: what they were computed from, as JSON, compared with tolerance.

Inputs are stated in the machine's own frame with all joints at 0, so that jogging, moving or turning the whole machine
leaves results valid.
"""

from __future__ import annotations

import json
import math

from ..core.effects import Effect
from ..core.machine import Machine
from ..core.objectives import Objective
from ..core.sources import Source
from ..formats import effects_json
from . import told
from .base import members, put
from .tree import added_effects, traces_of

TOLERANCE = 1e-6  # mm, and relative: smaller differences count as none


def result_inputs(machine, core: Machine, arms=None) -> str:
    """JSON of all that the indices of a machine object depend on.

    core : the machine that is computed.  arms : its lever arms with all joints at 0, where the caller has them.
    """
    words = [core.structure, core.squareness, told.objective_data(machine.Objective), machine.Aggregate]
    values = _geometry(core, arms)
    values += {"quadrature": [machine.Order], "grid": [machine.Grid], "at": list(machine.At)}.get(machine.Aggregate, [])
    more = _varying(core)
    return json.dumps([words + more[0], values + more[1]], sort_keys=True)


def study_inputs(core: Machine, arms=None) -> str:
    """JSON of all of a machine that a study of its errors depends on; its points are in the frame of the document.

    arms : lever arms with all joints at 0, where the caller has them.
    """
    more = _varying(core)
    values = [*_geometry(core, arms), *core.frame.ravel().tolist(), *more[1]]
    return json.dumps([[core.structure, core.squareness, *more[0]], values], sort_keys=True)


def _varying(core: Machine) -> tuple[list, list[float]]:
    """(words, values) of all that varies: tolerances, effects, sources."""
    words, values = [], []
    for symbol, t in core.all_tolerances.items():
        words += [symbol, t.distribution]
        values += [t.lower * 1e3, t.upper * 1e3, (t.sigma or 0.0) * 1e3]
    words += [_effect(e, core) for e in core.effects if e.enabled]
    return words + [_source(s) for s in core.sources], values


def _source(source: Source) -> list:
    law = source.law
    return [source.name, law.distribution, law.lower, law.upper, law.sigma, *map(list, source.factors.items())]


def with_objective(inputs: str, objective: Objective) -> str:
    """`result_inputs` as schema 2 wrote it (output, sign, and first of the numbers the weights) with the objective."""
    if not inputs:
        return ""
    (structure, squareness, _output, _signed, *words), values = json.loads(inputs)
    return json.dumps([[structure, squareness, objective.to_json(), *words], values[3:]], sort_keys=True)


def trace_inputs(core: Machine, without=(), arms=None) -> str:
    """JSON of all of a machine that a trace depends on.

    without : names of effects that are left out.  arms : lever arms with all joints at 0, where the caller has them.
    """
    words = [core.structure, core.squareness, sorted((s, int(d)) for s, d in core.declared.items())]
    words += [_effect(e, core) for e in core.effects if e.enabled and e.name not in without]
    return json.dumps([words, _geometry(core, arms, sorted)], sort_keys=True)


def _effect(effect: Effect, core: Machine) -> list:
    words = effects_json.parameters(effect, core.component(effect.component))
    more = [] if effect.extent is None else [list(effect.extent)]
    return [effect.name, effect.component, str(effect.driver), effect.shape.name, words, *more]


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
        _same_words(words, words_)
        and len(values) == len(values_)
        and all(math.isclose(a, b, rel_tol=1e-9, abs_tol=1e-9 if abs(a) < 1e-3 else TOLERANCE)
                for a, b in zip(values, values_))
    )  # fmt: skip


def _same_words(one, other) -> bool:
    """Whether two values from JSON are equal, the rounding of numbers and how a parameter is written apart."""
    if isinstance(one, dict) and isinstance(other, dict):
        one, other = ({k: _bare(v) for k, v in d.items()} for d in (one, other))
        return one.keys() == other.keys() and all(_same_words(one[k], other[k]) for k in one)
    if isinstance(one, list) and isinstance(other, list):
        return len(one) == len(other) and all(map(_same_words, one, other))
    numbers = all(isinstance(v, (int, float)) and not isinstance(v, bool) for v in (one, other))
    return math.isclose(one, other, rel_tol=1e-9) if numbers else one == other


def _bare(parameter):
    """The numbers of a parameter without the spelling of its unit."""
    if not isinstance(parameter, dict):
        return [parameter, None]
    return [parameter.get("value"), parameter.get("u")]


def mark_results(machine, inputs: str) -> None:
    """Set `Stale` of the machine's results.  inputs : `result_inputs` of the machine as it is, "" where it has none."""
    for obj in members(machine, "Sensitivity"):
        put(obj, "Stale", not same(obj.Inputs, inputs))


def mark_studies(machine, core: Machine | None, arms=None) -> None:
    """Set `Stale` of the machine's further studies.  core : None where the machine cannot be computed."""
    found = members(machine, "Study")
    inputs = study_inputs(core, arms) if found and core is not None else ""
    for obj in found:
        put(obj, "Stale", not same(obj.Inputs, inputs))


def mark_traces(machine, core: Machine, arms=None) -> None:
    """Set `Stale` of the machine's traces; effects that were added from a trace do not count as changes for it.

    arms : as in `trace_inputs`.
    """
    for obj in traces_of(machine):
        labels = {o.Label for o in added_effects(obj)}
        put(obj, "Stale", not same(obj.Inputs, trace_inputs(core, labels, arms)))
