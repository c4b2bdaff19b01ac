# SPDX-License-Identifier: LGPL-2.1-or-later
"""Result of a trace, as values: verdict, effects with their evidence and rivals, error before and after, remainder.

Lengths are mm, angles rad, wherever a name does not say um.  Sentences are messages.  `formats.trace_json` writes it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from ..core.effects import Effect
from ..core.machine import Machine
from ..messages import Message
from .readings import Readings
from .sources import BudgetLine
from .unlogged import Unlogged

NOTHING, EXPLAINED, PARTLY, UNEXPLAINED = "nothing_to_explain", "explained", "partly_explained", "unexplained"
STAGES = ("uncorrected", "declared", "augmented")


@dataclass(frozen=True)
class Rival:
    """An explanation that the readings cannot distinguish from a named effect.

    loss : of chi-square against the effect.  same : its column is identical in these readings.
    """

    component: str
    driver: str
    shape: str
    loss: float
    why: Message
    same: bool


@dataclass(frozen=True)
class NamedEffect:
    """An effect that keeps its name.

    effect : as stored in the machine.  title : what it is.  amplitude, amplitude_u : 3-D rms over the points and its
    standard uncertainty, mm.  p : family-wise.
    selection : share of half-samples that choose it.  gain : held out (total, standard error), chi-square.  visible :
    share that the declared model cannot imitate.  size : rms per reading over its noise.  catalogue : key of the named
    effect that it is, or "".  usual, check : its usual size and what to look at on the machine, or None.
    aliases : periods (mm) that the places cannot tell from its own.
    """

    effect: Effect
    title: Message
    amplitude: float
    p: float
    selection: float
    gain: tuple[float, float]
    visible: float
    size: float
    rivals: tuple[Rival, ...] = ()
    catalogue: str = ""
    usual: Message | None = None
    check: Message | None = None
    aliases: tuple[float, ...] = ()
    note: Message | None = None
    amplitude_u: float | None = None


@dataclass(frozen=True)
class HiddenMotion:
    """A body that moves from reading to reading by a driver that nobody logged.  amplitude : 3-D rms, mm."""

    motion: Unlogged
    title: Message
    amplitude: float


@dataclass(frozen=True)
class Refusal:
    """An effect that is significant but carries no name, and why."""

    component: str
    driver: str
    shape: str
    p: float
    why: Message


@dataclass(frozen=True)
class StageError:
    """3-D error of the points at one stage, um: metrics in sample and held out, and a 95 % interval of the second.

    left_out : the rms of each run, or block of readings, by a fit of all others.  by : "runs" or "blocks".  Of n that
    are alike, a further one stays below the largest in n of n + 1 cases.
    """

    in_sample: Mapping[str, float]
    held_out: Mapping[str, float]
    interval: tuple[float, float]
    left_out: tuple[float, ...] = ()
    by: str = "blocks"


@dataclass(frozen=True)
class NoiseSummary:
    """Noise of one reading, mm: as stated, from repeats, as the residuals show it, and per direction of sensing.

    memory : direction -> correlation of successive residuals.  modelled : direction -> the part that the fit models.
    ratio : direction -> chi-square per degree of freedom against the stated uncertainty, empty where none is stated.
    remarks : what the checks say.
    """

    stated: float | None
    pure: float | None
    residual: float
    direction: Mapping[str, float]
    memory: Mapping[str, float]
    modelled: Mapping[str, float]
    ratio: Mapping[str, float]
    remarks: tuple[Message, ...] = ()


@dataclass(frozen=True)
class Identifiability:
    """Number of parameters of the declared model, how many are determined, condition, and what is not."""

    columns: int
    rank: int
    condition: float
    null_space: tuple[Message, ...]


@dataclass(frozen=True)
class Leftover:
    """The remainder after the named effects: words, p of the test for structure, rms over noise, where it is."""

    words: tuple[Message, ...]
    p: float
    size: float
    component: str = ""
    columns: tuple[str, ...] = ()


@dataclass(frozen=True)
class NextMeasurement:
    """A measurement that separates explanations, and the difference (mm) that they predict for it."""

    separates: tuple[Message, ...]
    do: Message
    difference: float


@dataclass(frozen=True)
class ParameterShift:
    """A declared parameter that moved when the effects joined: its name, values before and after and u (mm or rad)."""

    title: str | Message
    before: float
    after: float
    u: float
    angular: bool


@dataclass(frozen=True)
class IndexShift:
    """Total sensitivity index of an error (or effect) before (None: new) and after the effects joined."""

    symbol: str
    before: float | None
    after: float


@dataclass(frozen=True)
class Outlier:
    """A point of which a reading was left out: line of the file (0: unknown), programmed position, mm."""

    line: int
    position: tuple[float, ...]


@dataclass(frozen=True)
class Guarantee:
    """What the probability of a false name rests on.

    rate : of false names.  by : ("runs" | "rows", number of exchanges, exact) each.  conditions : under which it holds.
    """

    rate: float
    by: tuple[tuple[str, int, bool], ...]
    conditions: tuple[Message, ...]


@dataclass(frozen=True)
class TraceEvidence:
    """What pictures of a trace are drawn from.

    machine : augmented.  residuals : name -> (R,) um.  covariance : (names, matrix) of the fitted parameters, um and
    urad.
    """

    machine: Machine
    readings: Readings
    residuals: Mapping[str, np.ndarray]
    covariance: tuple[list[str], np.ndarray]


@dataclass(frozen=True)
class TraceResult:
    """Everything that a trace found."""

    verdict: str
    floor: float
    seed: int
    permutations: int
    effects: tuple[NamedEffect, ...]
    hidden: HiddenMotion | None
    error: Mapping[str, StageError]
    noise: NoiseSummary
    identifiability: Identifiability
    depends_on: tuple[tuple[str, float], ...]
    not_testable: tuple[tuple[Message, str], ...]
    not_identifiable: tuple[Message, ...]
    next_measurements: tuple[NextMeasurement, ...]
    parameter_shifts: tuple[ParameterShift, ...]
    sensitivity_shift: tuple[IndexShift, ...]
    refused: tuple[Refusal, ...]
    left: Leftover
    outliers: tuple[Outlier, ...]
    remarks: tuple[Message, ...]
    alignment: str
    guarantee: Guarantee
    evidence: TraceEvidence
    budget: tuple[BudgetLine, ...] = ()
    log: tuple[str, ...] = ()

    @property
    def machine(self) -> Machine:
        """The machine with fitted errors and traced effects."""
        return self.evidence.machine

    @property
    def readings(self) -> Readings:
        """The readings that were traced."""
        return self.evidence.readings

    @property
    def residuals(self) -> Mapping[str, np.ndarray]:
        """Residuals (R,), mm, by stage of the correction."""
        return self.evidence.residuals

    @property
    def covariance(self) -> tuple[list[str], np.ndarray]:
        """Names of the parameters and their covariance matrix."""
        return self.evidence.covariance
