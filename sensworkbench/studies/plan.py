# SPDX-License-Identifier: LGPL-2.1-or-later
"""The plan study: what a measuring plan could find, what would improve it, and a suggested plan."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from ..closedloop import plan_advice
from ..closedloop.design import check_three_axes
from ..closedloop.plan import Plan
from ..closedloop.plan_uncertainty import PlannedError, planned_errors
from ..closedloop.readings import Readings
from ..core.machine import Machine
from ..core.refusal import Refused
from ..core.units import mm
from .places import within_travel

FEWEST, MOST = 30, 100_000  # readings of a suggested plan


@dataclass(frozen=True)
class PlanRequest:
    """noise_um : standard uncertainty of one reading.  suggest, seed : places of a suggested plan (None: none)."""

    noise_um: float = 1.0
    suggest: int | None = None
    seed: int = 0


@dataclass(frozen=True)
class PlanResult:
    """plan : as given (None: only a suggestion was asked for), its advice, and the suggested plan (or None)."""

    machine: Machine
    noise_um: float
    plan: Plan | None
    advice: list[plan_advice.Advice]
    suggested: Plan | None

    @property
    def shown(self) -> Plan:
        """Return the plan that was evaluated: the given one, otherwise the suggested one."""
        return self.plan or self.suggested

    @cached_property
    def errors(self) -> list[PlannedError]:
        """The uncertainty that each declared error will have, and what more readings would buy."""
        return planned_errors(self.machine, self.shown.readings)


def plan_study(machine: Machine, readings: Readings | None, request: PlanRequest = PlanRequest()) -> PlanResult:
    """Evaluate a plan (readings of value 0), advise, and suggest another plan.

    Refuses if there is neither a plan nor a number of places to suggest, and a number outside FEWEST to MOST.
    """
    if readings is None and request.suggest is None:
        raise Refused("plan-missing", "plan")
    check_three_axes(machine)
    plan = None if readings is None else Plan(machine, within_travel(machine, readings))
    suggested = None
    if request.suggest is not None:
        if not FEWEST <= request.suggest <= MOST:
            raise Refused("plan-size", "--suggest", count=request.suggest, least=FEWEST, most=MOST)
        noise = mm(request.noise_um)
        suggested = Plan(machine, plan_advice.suggest(machine, request.suggest, noise, readings, request.seed))
    advice = plan_advice.advise(plan or suggested, request.seed)
    return PlanResult(machine, request.noise_um, plan, advice, suggested)
