# SPDX-License-Identifier: LGPL-2.1-or-later
"""What does not change during a trace - readings, design, bank - and the state that its stages hand on.

A `State` is a value: a stage returns another one.  Fits, weighted rows and scanners are made here for any set of
effects under the noise that the state knows.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np

from ..core.driver import DIRECTIONS, POSITIONS
from ..core.machine import Machine
from ..core.shapes import Regressor
from ..core.synthesis import omega
from . import evidence
from .bank import bank, useful_columns
from .design import Design, alike, design
from .fit import Fit, basis, correlation, fit
from .kept import Kept
from .noise import duration
from .readings import Readings
from .scan import Rows, Scanner
from .search import ScoredTerm
from .settings import DEFAULT, TraceSettings


def _key(candidates) -> tuple | None:
    """What tells the columns of candidates from others; None beside a free form, of which that is its numbers."""
    if any(c.shape.free for c in candidates):
        return None
    return tuple((c.symbol, c.regressor) for c in candidates)


@dataclass(frozen=True)
class Problem:
    """Machine and readings of one trace, with everything that follows from them alone.

    seed, permutations : of the sign flips behind each p.  design : declared model, or None to build it here.
    """

    machine: Machine
    readings: Readings
    settings: TraceSettings = DEFAULT
    seed: int = 0
    permutations: int = 199

    @cached_property
    def design(self) -> Design:
        """The design of the declared model and the alignment for these readings."""
        return design(self.machine, self.readings)

    @cached_property
    def names(self) -> list[str]:
        """Driver columns that vary."""
        return useful_columns(self.readings)

    @cached_property
    def bank(self) -> list[Regressor]:
        """The regressors that are scanned."""
        return bank(self.readings)

    @cached_property
    def groups(self) -> list[list[int]]:
        """Components (indices) that show alike in these readings."""
        return alike(self.design.lever)

    @property
    def component_indices(self) -> list[int]:
        """One component of each group."""
        return [g[0] for g in self.groups]

    @cached_property
    def start(self) -> np.ndarray:
        """(P,) first row of each point."""
        return np.flatnonzero(np.r_[True, np.diff(self.readings.point) > 0])

    @cached_property
    def thin(self) -> np.ndarray | None:
        """The points that a scan looks at, where there are more than it needs."""
        count = self.readings.points
        if count <= self.settings.scanned:
            return None
        return np.sort(np.random.default_rng(self.seed).choice(count, self.settings.scanned, replace=False))

    @cached_property
    def scan_readings(self) -> Readings:
        """The readings that the scan uses: all, or a subset of a large table."""
        return self.readings if self.thin is None else self.readings.select(self.thin)

    @cached_property
    def scan_rows(self) -> np.ndarray:
        """(R,) bool: the rows that a scan looks at."""
        if self.thin is None:
            return np.ones(self.readings.rows, dtype=bool)
        return np.isin(self.readings.point, self.thin)

    @cached_property
    def regressors(self) -> np.ndarray:
        """(columns of the bank, scanned points) of every entry, at rms 1; computed once."""
        return Scanner.regressors(self.bank, self.readings.columns, self.thin)

    @cached_property
    def middle(self) -> dict[str, float]:
        """Column whose zero is a convention -> its middle: of the travel, mm, or of a temperature in the readings, K.

        Those of which it is 0 are left out.
        """
        found = {n.lower(): float(np.mean(t)) for n, t in zip(self.machine.names, self.machine.travel)}
        for name in self.names:
            if name.startswith("temp_"):
                values = self.readings.columns[name]
                found[name] = 0.5 * float(values.min() + values.max())
        return {n: m for n, m in found.items() if np.isfinite(m) and abs(m) > 1e-9 and n in self.readings.columns}

    @cached_property
    def wholes(self) -> np.ndarray | None:
        """(K,) see `Scanner.wholes`."""
        return Scanner.wholes(self.bank, self.readings.columns, self.middle, self.thin)

    @cached_property
    def stands(self) -> bool:
        """Is every reading taken at the same place?  Then only what is logged over time drives anything."""
        return not set(self.names) & {*POSITIONS, *DIRECTIONS}

    @cached_property
    def blocks(self) -> dict[bool, np.ndarray]:
        """(P,) block of each point: short ones, and long ones (True) for noise that remembers."""
        s = self.settings
        return {long: evidence.blocks(self.readings, s.long_blocks if long else s.short_blocks) for long in (0, 1)}

    @cached_property
    def kept(self) -> Kept:
        """Fits and weighted rows that a later stage may ask for again."""
        return Kept()

    @cached_property
    def _signs(self) -> dict[bool, np.ndarray]:
        return {}

    def signs(self, long: bool) -> np.ndarray:
        """(permutations, rows of a scan) signs that turn whole blocks, short or long ones; made once."""
        if long not in self._signs:
            block = self.blocks[long]
            table = evidence.flips(block, self.permutations, self.seed)
            self._signs[long] = table[:, block[self.readings.point][self.scan_rows]].astype(np.float32)
        return self._signs[long]

    def columns_of(self, candidates) -> np.ndarray | None:
        """(R, m) design columns of candidates."""
        if not candidates:
            return None
        point, lever = self.readings.point, self.design.lever
        return np.concatenate(
            [lever[:, [c.index]] * c.vectors(self.readings.columns)[point] for c in candidates], axis=1
        )

    def amplitude(self, c: ScoredTerm) -> float:
        """3-D rms of an effect over the points, mm."""
        column = omega(self.machine, [c.symbol], self.readings.q, self.readings.tool_offset)[:, :, 0]
        motion = c.vectors(self.readings.columns) @ c.coefficients
        return float(np.sqrt((column**2).sum(axis=1) @ motion**2 / len(motion)))


@dataclass(frozen=True)
class Step:
    """One effect and its evidence.

    p : family-wise.  size : rms per reading over its noise.  gain : held out (total, standard error), chi-square.
    selection : share of half-samples.  refused : why it may not carry a name, or None.  pool : what it was chosen from.
    clear : above the largest of the null by a margin.
    runs : (number, all of them) exchanges of whole runs behind p, or None where rows were turned only.
    """

    candidate: ScoredTerm
    p: float = 1.0
    size: float = 0.0
    gain: tuple[float, float] = (0.0, 0.0)
    selection: float = 0.0
    refused: object = None
    pool: tuple[ScoredTerm, ...] = ()
    runs: tuple[int, bool] | None = None
    clear: bool = True


@dataclass(frozen=True)
class State:
    """What a trace knows: the effects so far with their evidence, the memory of the noise, roughness, and its log.

    memory : direction of sensing -> correlation of successive residuals (0 where they do not remember).
    whitened : whether fits whiten drifts too.
    dropped : what was beyond chance when it was judged and yet not accepted, with the reason.
    """

    problem: Problem
    steps: tuple[Step, ...] = ()
    memory: dict = field(default_factory=dict)
    whitened: bool = False
    roughness: tuple[ScoredTerm, ...] = ()
    dropped: tuple[Step, ...] = ()
    log: tuple[str, ...] = ()

    @property
    def settings(self) -> TraceSettings:
        """The thresholds of the trace."""
        return self.problem.settings

    @property
    def candidates(self) -> list[ScoredTerm]:
        """The candidates of the accepted steps."""
        return [s.candidate for s in self.steps]

    @property
    def named(self) -> list[Step]:
        """Return the steps that keep their names."""
        return [s for s in self.steps if s.refused is None]

    def significant(self, step: Step) -> bool:
        """Whether a step is below the family-wise limit and predicts readings left out better."""
        s = self.settings
        return step.p < s.alpha and step.gain[0] > s.held_out * step.gain[1]

    def passes(self, step: Step) -> bool:
        """Whether a step is significant and larger than the floor."""
        return self.significant(step) and step.size > self.settings.floor

    def logged(self, line: str) -> State:
        """Return the state with one more line in its log."""
        return replace(self, log=(*self.log, line))

    # -- noise -----------------------------------------------------------------------------------------------------
    @property
    def remembers(self) -> bool:
        """Is the noise correlated from reading to reading, in any direction?"""
        return max(self.memory.values(), default=0.0) > self.settings.remembers

    @property
    def modelled(self) -> dict:
        """The memory that fits whiten: direction -> correlation of successive residuals, 0 where it is too long.

        What long blocks do not forget is a drift.  Whitened it would all but be differenced: slow effects would be
        lost, and columns preferred that follow it from reading to reading and predict no other block.  Where the
        machine moves from reading to reading, its effects do too: there whitening loses nothing.
        """
        if self.whitened or not self.problem.stands:
            return self.memory
        s, p = self.settings, self.problem
        block = p.readings.points / (int(p.blocks[True].max()) + 1)
        longest = max(s.block_memory * block, duration(s.differencing))
        return {k: phi if duration(phi) <= longest else 0.0 for k, phi in self.memory.items()}

    @property
    def drifts(self) -> bool:
        """Does what is left remember for too long to be whitened, in any direction?"""
        return self.modelled != self.memory

    def inflation(self, fitted: Fit, c: ScoredTerm, margin: float = 2.0) -> float:
        """Variance inflation of the coefficient of a slow term by drifts that the fits do not model.

        The correlations are those that `fitted` leaves, at their upper limit (`margin` standard errors; of a drift
        without end all readings count as one); each direction of sensing counts by its share of what the term does to
        the readings.
        """
        p, modelled = self.problem, self.modelled
        size = (fitted.white(p.columns_of([c]) @ c.coefficients)) ** 2
        drifting = {}
        for k, phi in correlation(fitted, p.readings, self.settings).items():
            if modelled.get(k) != self.memory.get(k):
                count = max(int(np.count_nonzero((p.readings.kind == k) & (fitted.weight > 0))), 1)
                short = margin * np.sqrt((1 - phi**2) / count)
                longest = 1 - 2 / (count + 1)  # of which all readings together count as one
                drifting[k] = duration(min(phi + short, longest)) - 1
        total = max(float(size.sum()), 1e-300)
        return 1 + sum(more * float(size[p.readings.kind == k].sum()) / total for k, more in drifting.items())

    def heard(self, fitted: Fit) -> State:
        """The state with the memory of the noise taken from what a fit leaves."""
        return replace(self, memory=correlation(fitted, self.problem.readings, self.settings))

    @property
    def block(self) -> np.ndarray:
        """(points,) number of the block of consecutive readings that each point belongs to."""
        return self.problem.blocks[self.remembers]

    @property
    def row_block(self) -> np.ndarray:
        """(rows,) number of the block that each row belongs to."""
        return self.block[self.problem.readings.point]

    @property
    def signs(self) -> np.ndarray:
        """(permutations, rows of a scan) signs that turn whole blocks: short ones, as whitened rows do not remember,
        and long ones where what is left drifts.
        """
        return self.problem.signs(self.drifts)

    # -- fits ------------------------------------------------------------------------------------------------------
    def fit_with(self, candidates) -> Fit:
        """Robust fit of the declared model and candidates, under the memory of the noise that is modelled."""
        p, modelled = self.problem, self.modelled
        own = _key(candidates)
        key = None if own is None else ("fit", own, tuple(sorted(modelled.items())))
        return p.kept.get(
            key,
            lambda: fit(p.design, p.readings, p.columns_of(candidates), memory=modelled, settings=p.settings),
            lambda found: found.basis.ortho.nbytes + 4 * found.residual.nbytes,
        )

    def rows(self, fitted: Fit) -> Rows:
        """The weighted rows of a fit and of its model."""
        return self._rows(fitted, "own", lambda: fitted.basis.ortho)

    def rows_with(self, fitted: Fit, candidates) -> Rows:
        """Rows of the model that holds just `candidates`, under the weights of `fitted`."""

        def ortho() -> np.ndarray:
            extra, matrix = self.problem.columns_of(candidates), self.problem.design.matrix
            whole = matrix if extra is None else np.concatenate([matrix, extra], axis=1)
            return basis(fitted.white(whole)).ortho

        return self._rows(fitted, _key(candidates), ortho)

    def _rows(self, fitted: Fit, key, make) -> Rows:
        p = self.problem

        def rows() -> Rows:
            y, ortho = fitted.white(p.readings.value), make()
            lever = p.design.lever * fitted.weight[:, None]
            return Rows(lever, y - ortho @ (ortho.T @ y), p.start, ortho, fitted.memory, p.middle, p.settings)

        key = None if key is None else ("rows", fitted, key)
        return p.kept.get(key, rows, lambda found: found.lever.nbytes + found.ortho.nbytes)

    def scanned(self, rows: Rows) -> Rows:
        """Return the rows that the scan uses."""
        if self.problem.thin is None:
            return rows
        return rows.once("thinned", lambda: rows.thinned(self.problem.thin))

    def scanner(self, rows: Rows) -> Scanner:
        """Return a scanner of all candidates on these rows."""
        p = self.problem
        return rows.once(
            "scanner",
            lambda: Scanner(self.scanned(rows), p.bank, p.component_indices, p.regressors, wholes=p.wholes),
        )

    def grams(self, fitted: Fit, others, candidates, within: bool = False, block=None):
        """Block Grams of [declared basis, others, candidates]: (grams, base columns, columns of each candidate).

        within : for held-out errors with a shift of each block taken out, too.  block (rows,) : other blocks.
        """
        p = self.problem
        parts = [self.rows_with(fitted, []).ortho]
        extra = p.columns_of(others)
        if extra is not None:
            parts.append(fitted.white(extra))
        at = sum(part.shape[1] for part in parts)
        base, mine = list(range(at)), []
        for c in candidates:
            x = fitted.white(p.columns_of([c]))
            parts.append(x)
            mine.append(list(range(at, at + x.shape[1])))
            at += x.shape[1]
        y = fitted.white(p.readings.value)
        offsets = fitted.white(p.readings.sense) if within else None
        block = self.row_block if block is None else block
        return evidence.BlockGrams(np.concatenate(parts, axis=1), y, block, offsets), base, mine
