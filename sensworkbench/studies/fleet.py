# SPDX-License-Identifier: LGPL-2.1-or-later
"""The fleet study: the records of many machines traced by the same road, and which effect recurs on which machine.

Every record is tested on its own.  Over a fleet some small p occurs by chance, so the names are held at a false
discovery rate over all records (Benjamini & Hochberg 1995): of m sorted p, those up to the last p_(k) <= k rate / m
stand.  The number of permutations grows with the fleet, since p cannot be smaller than one in that number.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, replace

from ..closedloop.readings import Readings
from ..closedloop.result import TraceResult
from ..core.machine import Machine
from ..core.refusal import Refused
from ..core.units import um
from ..core.workspace import Cancelled
from ..messages import Message
from .trace import FEWEST, MOST, TraceRequest, trace_study

Read = Callable[[str], tuple[Machine, Readings]]
Progress = Callable[[float], bool]
RATE = 0.05


@dataclass(frozen=True)
class FleetEffect:
    """An effect that was named on one machine.

    p : family-wise, of its record.  amplitude : 3-D rms over the points, mm.  held : within the false discovery rate.
    """

    component: str
    driver: str
    shape: str
    title: Message
    p: float
    amplitude: float
    held: bool = False

    @property
    def key(self) -> tuple[str, str, str]:
        """What makes effects of two machines the same one."""
        return self.component, self.driver, self.shape


@dataclass(frozen=True)
class Member:
    """One machine of the fleet.  refused : why its record could not be traced ("" where it was).  declared, augmented :
    3-D rms on readings left out, um, by the declared and by the augmented model."""

    name: str
    verdict: str = ""
    effects: tuple[FleetEffect, ...] = ()
    declared: float | None = None
    augmented: float | None = None
    refused: str = ""

    @property
    def p(self) -> float:
        """The smallest p of its names; 1 without one."""
        return min((e.p for e in self.effects), default=1.0)


@dataclass(frozen=True)
class Recurring:
    """An effect and the machines on which it stands.  amplitudes : of the same machines, mm."""

    component: str
    driver: str
    shape: str
    title: Message
    machines: tuple[str, ...]
    amplitudes: tuple[float, ...]


@dataclass(frozen=True)
class FleetResult:
    """members : in the order of the request.  recurring : most frequent first.  rate : of false discoveries.
    limit : the p up to which names stand.  permutations, seed : of every trace."""

    members: tuple[Member, ...]
    recurring: tuple[Recurring, ...]
    rate: float
    limit: float
    permutations: int
    seed: int


def permutations_for(count: int, rate: float = RATE) -> int:
    """Permutations with which one record in `count` can stand within the rate; at least the usual number."""
    return min(MOST, max(FEWEST, math.ceil(count / rate) - 1))


def judge_member(read: Read, name: str, seed: int, permutations: int, progress: Progress | None = None) -> Member:
    """Trace one record.  A plain function of plain data, for any worker; what is refused is said in the result.

    progress : called with the part of this record that is done; a false answer cancels.
    """
    try:
        machine, readings = read(name)
        found = trace_study(machine, readings, TraceRequest(seed, permutations), progress)
    except Refused as refused:
        return Member(name, refused=refused.message)
    return _member(name, found)


def _member(name: str, found: TraceResult) -> Member:
    effects = tuple(
        FleetEffect(
            e.effect.component, str(e.effect.driver), e.effect.shape.name, e.title, float(e.p), float(e.amplitude)
        )
        for e in found.effects
    )
    return Member(
        name,
        found.verdict,
        effects,
        found.error["declared"].held_out["rms_um"],
        found.error["augmented"].held_out["rms_um"],
    )


def fleet_study(
    names: Sequence[str],
    read: Read,
    executor: Executor | None = None,
    rate: float = RATE,
    seed: int = 0,
    permutations: int | None = None,
    progress: Progress | None = None,
) -> FleetResult:
    """Trace every record and hold the names at the false discovery rate.

    names : of the records, each of which `read` turns into a machine and its readings; it must be importable by
    workers.  executor : None traces here.  permutations : None lets it grow with the fleet.  progress : called with the
    part done; a false answer cancels.  Refuses no names, and a rate outside 0 … 0.5.
    """
    if not names:
        raise Refused("fleet-empty", "fleet")
    if not 0 < rate <= 0.5:
        raise Refused("fleet-rate", "--rate", rate=rate)
    count = permutations_for(len(names), rate) if permutations is None else permutations
    members = []
    for member in _judged(names, read, executor, seed, count, progress):
        members.append(member)
        if progress is not None and not progress(len(members) / len(names)):
            raise Cancelled("cancelled")
    limit = discovery_limit([m.p for m in members if not m.refused], rate)
    held = tuple(replace(m, effects=tuple(replace(e, held=e.p <= limit) for e in m.effects)) for m in members)
    return FleetResult(held, recurring(held), rate, limit, count, seed)


def _judged(names, read, executor, seed, count, progress) -> Iterator[Member]:
    def inside(k: int) -> Progress | None:
        return None if progress is None else lambda part, *words: progress((k + min(part, 0.99)) / len(names))

    work = [None] * len(names) if executor is None else [_submit(executor, read, n, seed, count) for n in names]
    for k, (name, waiting) in enumerate(zip(names, work)):
        member = None
        if waiting is not None:
            try:
                member = waiting.result()
            except Exception:  # noqa: BLE001 - a worker was lost, whatever its library calls that
                member = None
        yield judge_member(read, name, seed, count, inside(k)) if member is None else member


def _submit(executor: Executor, read: Read, name: str, seed: int, count: int):
    try:
        return executor.submit(judge_member, read, name, seed, count)
    except RuntimeError:  # the executor broke: this record is traced here
        return None


def discovery_limit(p: Sequence[float], rate: float) -> float:
    """The p up to which tests stand at a false discovery rate (Benjamini & Hochberg 1995); 0 where none does."""
    ordered = sorted(p)
    return max((v for k, v in enumerate(ordered, start=1) if v <= k * rate / len(ordered)), default=0.0)


def recurring(members: Sequence[Member]) -> tuple[Recurring, ...]:
    """The effects that stand, most frequent first; equals by their largest amplitude."""
    found: dict[tuple, list[tuple[str, FleetEffect]]] = {}
    for member in members:
        for effect in member.effects:
            if effect.held:
                found.setdefault(effect.key, []).append((member.name, effect))
    rows = [
        Recurring(*key, cases[0][1].title, tuple(n for n, _ in cases), tuple(e.amplitude for _, e in cases))
        for key, cases in found.items()
    ]
    return tuple(sorted(rows, key=lambda r: (-len(r.machines), -max(r.amplitudes), r.component, r.driver)))


def median_um(effect: Recurring) -> float:
    """Median amplitude over the machines, um."""
    ordered = sorted(effect.amplitudes)
    middle = len(ordered) // 2
    return um(ordered[middle] if len(ordered) % 2 else (ordered[middle - 1] + ordered[middle]) / 2)
