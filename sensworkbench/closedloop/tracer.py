# SPDX-License-Identifier: LGPL-2.1-or-later
"""The loop of a trace: fit, scan, accept or abstain, add, again - until nothing is left that can be defended.

An effect is accepted on a family-wise p over everything scanned, a size above the floor and a gain on whole blocks left
out; it keeps its name only if half-samples choose it again and no free form of its own columns does better.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from ..core.driver import Driver
from ..core.errors import component
from ..core.machine import Machine
from ..core.synthesis import omega
from ..core.workspace import Cancelled
from . import evidence
from .bank import bank, log_tail, useful_columns
from .design import ALL_SYMBOLS, Design, alike, design
from .fit import Fit, basis, fit
from .freeform import FreeScan, normal_tail
from .naming import beyond, stand_in, stands_out
from .readings import Readings
from .scan import Rows, Scanner, exact_gain
from .search import Candidate, merged, refine, same_place, search, surface_candidate, tried_beside
from .surface import Surface, locate

FLOOR = 0.2  # of one reading's noise: structure below it is never named
ALPHA = 0.01
SELECTION = 0.8
RIVAL = 9.0
SHORT_BLOCKS, LONG_BLOCKS = 30, 10
COLOURED = 0.3  # correlation of successive residuals from which the noise is taken to remember
CLASS = 25.0  # in chi-square: within reach of a held-out comparison
MOST_EFFECTS = 4
OF_A_SHAPE = 3  # leaders of each shape that are tried as the first of two
MOST_SCANNED = 4000  # points: more are thinned for the scan; every fit takes all
LARGEST_UM = 500.0  # a plausible effect is smaller
DETECTABLE = 6.0  # nats of evidence: less is no structure
CERTAIN = 25.0  # nats: beyond the choice among some thousand surfaces by far


@dataclass
class Step:
    """One effect and its evidence: family-wise p, size (rms per reading over its noise), held-out gain (total, SE) in
    chi-square, selection frequency, and `refused`: why it may not carry a name ("" if it may)."""

    candidate: Candidate
    p: float = 1.0
    size: float = 0.0
    gain: tuple[float, float] = (0.0, 0.0)
    selection: float = 0.0
    refused: str = ""
    pool: list[Candidate] = field(default_factory=list)

    @property
    def significant(self) -> bool:
        return self.p < ALPHA and self.gain[0] > 2 * self.gain[1]


@dataclass
class Remainder:
    """What free forms still find: p, size over the floor or not, the strongest structures."""

    p: float = 1.0
    size: float = 0.0
    structure: Surface | None = None
    gain: tuple[float, float] = (0.0, 0.0)


class Tracer:
    """The state of one trace: readings, design, the effects so far and the fit with them."""

    def __init__(
        self, machine: Machine, readings: Readings, *, seed: int = 0, permutations: int = 199, floor: float = FLOOR
    ):
        self.machine, self.readings, self.floor = machine, readings, floor
        self.seed, self.permutations = seed, permutations
        self.design: Design = design(machine, readings)
        self.names = useful_columns(readings)
        self.bank = bank(readings)
        self.groups = alike(self.design.lever)
        self.places = [g[0] for g in self.groups]
        self.start = np.flatnonzero(np.r_[True, np.diff(readings.point) > 0])
        self.thin = None  # the points that a scan looks at, where there are more than it needs
        if readings.points > MOST_SCANNED:
            pick = np.random.default_rng(seed).choice(readings.points, MOST_SCANNED, replace=False)
            self.thin = np.sort(pick)
        self.scan_readings = readings if self.thin is None else readings.select(self.thin)
        self.colour = 0.0
        self._blocks = {n: evidence.blocks(readings, n) for n in (SHORT_BLOCKS, LONG_BLOCKS)}
        self._signs = {n: evidence.flips(b, permutations, seed) for n, b in self._blocks.items()}
        self.steps, self.log, self.roughness = [], [], []

    # -- noise that remembers -----------------------------------------------------------------------------------
    @property
    def coloured(self) -> bool:
        """Is what is left correlated from reading to reading?  Then smooth columns look better than they are."""
        return self.colour > COLOURED

    @property
    def inflation(self) -> float:
        """Variance inflation of a slow column's coefficient under such noise (first-order autoregressive)."""
        return (1 + self.colour) / (1 - self.colour) if self.coloured else 1.0

    @property
    def block(self) -> np.ndarray:
        return self._blocks[LONG_BLOCKS if self.coloured else SHORT_BLOCKS]

    @property
    def row_block(self) -> np.ndarray:
        return self.block[self.readings.point]

    @property
    def signs(self) -> np.ndarray:
        """(permutations, rows of a scan) signs that turn whole blocks."""
        table = self._signs[LONG_BLOCKS if self.coloured else SHORT_BLOCKS]
        rows = self.row_block if self.thin is None else self.row_block[np.isin(self.readings.point, self.thin)]
        return table[:, rows].astype(np.float32)

    def listen(self, fitted: Fit) -> None:
        """Take the colour of the noise from what a fit leaves: correlation of each reading with the one before."""
        r = fitted.residual * fitted.weight
        above = below = 0.0
        for kind in np.unique(self.readings.kind):
            part = r[self.readings.kind == kind]
            above += float(part[1:] @ part[:-1])
            below += float(part @ part)
        self.colour = float(np.clip(above / below if below > 0 else 0.0, 0.0, 0.999))

    # -- fits ----------------------------------------------------------------------------------------------------
    def columns_of(self, candidates) -> np.ndarray | None:
        """(R, m) design columns of candidates."""
        if not candidates:
            return None
        point, lever = self.readings.point, self.design.lever
        return np.concatenate(
            [lever[:, [c.index]] * c.vectors(self.readings.columns)[point] for c in candidates], axis=1
        )

    def fit_with(self, candidates) -> Fit:
        return fit(self.design, self.readings, self.columns_of(candidates))

    def rows(self, fitted: Fit) -> Rows:
        return Rows(
            self.design.lever * fitted.weight[:, None], fitted.residual * fitted.weight, self.start, fitted.basis.q
        )

    def rows_with(self, fitted: Fit, candidates) -> Rows:
        """Rows of the model that holds just `candidates`, under the weights of `fitted`."""
        extra = self.columns_of(candidates)
        matrix = self.design.matrix if extra is None else np.concatenate([self.design.matrix, extra], axis=1)
        b = basis(matrix, fitted.weight)
        y = self.readings.value * fitted.weight
        return Rows(self.design.lever * fitted.weight[:, None], y - b.q @ (b.q.T @ y), self.start, b.q)

    def scanned(self, rows: Rows) -> Rows:
        return rows if self.thin is None else rows.thinned(self.thin)

    def scanner(self, rows: Rows) -> Scanner:
        return Scanner(self.scanned(rows), self.bank, self.readings.columns, self.places, self.thin)

    def grams(self, fitted: Fit, others, candidates):
        """Block Grams of [declared basis, others, candidates]: (grams, base columns, columns of each candidate)."""
        parts = [basis(self.design.matrix, fitted.weight).q]
        extra = self.columns_of(others)
        if extra is not None:
            parts.append(extra * fitted.weight[:, None])
        at = sum(p.shape[1] for p in parts)
        base, mine = list(range(at)), []
        for c in candidates:
            x = self.columns_of([c]) * fitted.weight[:, None]
            parts.append(x)
            mine.append(list(range(at, at + x.shape[1])))
            at += x.shape[1]
        grams = evidence.BlockGrams(np.concatenate(parts, axis=1), self.readings.value * fitted.weight, self.row_block)
        return grams, base, mine

    candidates = property(lambda self: [s.candidate for s in self.steps])

    # -- evidence for one candidate ------------------------------------------------------------------------------
    def judge(self, others, best: Candidate) -> Step:
        """Family-wise p, size and held-out gain of `best` beside `others`."""
        full = self.fit_with([*others, best])
        gain, coefficients, visible = exact_gain(
            self.rows_with(full, others), best.index, best.vectors(self.readings.columns)
        )
        after = self.rows(full)
        null = self.scanner(after).null_maxima(self.signs)
        tail = float(log_tail(np.array(gain), 1)) if len(coefficients) == 1 else normal_tail(gain, len(coefficients))
        used = max(int(np.count_nonzero(full.weight)), 1)
        grams, base, mine = self.grams(full, others, [best])
        held = evidence.gain_statistics(grams.held_out(base), grams.held_out(base + mine[0]))
        found = Candidate(best.symbol, best.regressor, gain, coefficients, visible, best.handicap)
        return Step(found, evidence.p_value(tail, null), float(np.sqrt(gain / used)), held)

    def passes(self, step: Step) -> bool:
        return step.significant and step.size > self.floor

    def selection(self, others, best: Candidate, pool, halves: int = 100) -> float:
        """Share of half-samples of blocks that choose `best`, or one of the class that all readings together hardly
        tell from it (what is tested is that half the machine tells the same story, not that it tells rivals apart)."""
        full = self.fit_with([*others, best])
        pool = [best] + [c for c in pool if c.key != best.key][:40]
        grams, base, mine = self.grams(full, others, pool)
        cost = np.array([c.handicap for c in pool])
        everything = grams.gains(base, mine, np.arange(grams.count))
        alike = (everything - cost > everything[0] - cost[0] - CLASS) | (everything > everything[0] - RIVAL)
        rng = np.random.default_rng(self.seed + 1)
        hits = 0
        for _ in range(halves):
            use = rng.permutation(grams.count)[: grams.count // 2]
            if self.coloured:  # chi-square counts correlated readings as independent: it must predict the other half
                hits += grams.half_gain(base, mine[0], use) > 0
                continue
            score = grams.gains(base, mine, use) - cost
            hits += bool(score[0] > 0 and (alike[int(np.argmax(score))] or score[0] > score.max() - RIVAL))
        return hits / halves

    # -- the loop ------------------------------------------------------------------------------------------------
    def add_effects(self, tell: Callable[[float, str], bool]):
        """Add effects one after another, each judged, all settled together."""
        for number in range(len(self.steps), MOST_EFFECTS):
            if not tell(0.1 + 0.15 * number, f"scanning for effect {number + 1}"):
                raise Cancelled("cancelled")
            step = self._next(self.candidates)
            if step is None:
                return
            self.steps.append(step)
            self.settle()
            if self._merge():
                self.settle()

    def _next(self, others) -> Step | None:
        fitted = self.fit_with(others)
        rows = self.rows(fitted)
        scanner = self.scanner(rows)
        found = search(rows, self.readings, scanner, self.names, self.groups)
        if found:
            self.listen(self.fit_with([*others, found[0]]))
        if self.coloured:
            found = self._by_left_out_blocks(others, found)
        tried: set[Driver] = set()
        lines = True
        for best in found:
            if (best.shape.wave and not lines) or best.driver in tried:
                continue
            if len(tried) == 3:
                return None
            step = self.judge(others, best)
            self.log.append(
                f"{' '.join(best.key)} {best.shape.values}: gain {step.candidate.gain:.1f}, p {step.p:.4f}, "
                f"size {step.size:.2f}, held out {step.gain[0]:.1f} +- {step.gain[1]:.1f}"
            )
            if best.shape.wave and step.p < ALPHA and not self._line(others, step.candidate):
                self.roughness.append(step.candidate)
                lines = False
                continue
            tried.add(best.driver)
            if self.passes(step):
                step.pool = found
                return step
            if not step.p < ALPHA:
                return None
        return None

    def _by_left_out_blocks(self, others, found) -> list[Candidate]:
        """In noise that remembers, chi-square flatters every slow column: order by long blocks left out instead, and
        among those within a standard error of the best take the plainest."""
        plain = [c for c in found if len(c.driver.names) == 1][:40]
        if not plain:
            return found
        grams, base, mine = self.grams(self.fit_with(others), others, plain)
        errors = [grams.held_out(base + m) for m in mine]
        totals = np.array([e.sum() for e in errors])
        best = int(np.argmin(totals))
        near = [i for i in range(len(plain)) if evidence.no_worse(errors[i], errors[best])]
        near.sort(key=lambda i: (plain[i].handicap, totals[i]))
        rest = [i for i in np.argsort(totals) if i not in near]
        return [plain[i] for i in [*near, *rest]]

    def _line(self, others, candidate: Candidate) -> bool:
        full = self.fit_with([*others, candidate])
        rows = self.rows(full)
        if not stands_out(self.scanned(rows), candidate, self.scanner(rows)):
            return False
        return not beyond(rows, candidate, self.readings.columns, self.names, int(np.count_nonzero(full.weight)))

    def settle(self, rounds: int = 3):
        """Look again at each effect with the others in the model; exchange it where another explains more."""
        for _ in range(rounds):
            changed = False
            for i, step in enumerate(self.steps):
                others = [s.candidate for j, s in enumerate(self.steps) if j != i]
                full = self.fit_with(self.candidates)
                rows = self.rows_with(full, others)
                if self.coloured:  # chosen by left-out blocks; only its parameters settle
                    better = refine(rows, step.candidate, self.readings.columns)
                    changed |= better.gain > step.candidate.gain + 1.0
                    step.candidate = better
                    continue
                scanner = self.scanner(rows)
                found = search(rows, self.readings, scanner, self.names, self.groups)
                if not step.candidate.shape.wave:
                    found = [c for c in found if not c.shape.wave or not self.roughness]
                if not found:
                    continue
                changed |= found[0].key != step.candidate.key
                step.candidate, step.pool = found[0], found
            if not changed:
                return

    def _merge(self) -> bool:
        """One effect for two that are parts of one."""
        for i, a in enumerate(self.steps):
            for b in self.steps[i + 1 :]:
                one = merged(a.candidate, b.candidate, self.readings.columns)
                if one is not None:
                    a.candidate = one
                    self.steps.remove(b)
                    return True
        return False

    def rescue(self, tell) -> bool:
        """A refused leader may be a compromise between two effects, or one term of a polynomial: try the pairs that the
        leaders open and all polynomials, and keep what stands.  Else everything is as it was."""
        refused = self.steps
        full = self.fit_with(self.candidates)
        rows = self.rows_with(full, [])
        leaders: list[Candidate] = []
        for c in search(rows, self.readings, self.scanner(rows), self.names, self.groups):
            alike = [o for o in leaders if o.shape.name == c.shape.name]
            if len(alike) < OF_A_SHAPE and all(o.driver != c.driver for o in alike):
                leaders.append(c)
        own = {c.key for c in self.candidates}
        left = self.rows_with(full, self.candidates).residual
        now = float(rows.residual @ rows.residual - left @ left) - sum(c.handicap for c in self.candidates)
        best: tuple[float, list[Candidate]] = (now + CERTAIN, [])
        shaped = tried_beside(rows, [ALL_SYMBOLS[c] for c in self.places], self.readings.columns, self.names)
        for c in [*leaders, *shaped]:
            if c.key not in own and c.score > best[0]:
                best = (c.score, [c])
        least = best[0] + CERTAIN if best[1] else now + (CERTAIN if len(refused) < 2 else RIVAL)
        for first in leaders:
            beside = self.rows_with(full, [first])
            found = search(beside, self.readings, self.scanner(beside), self.names, self.groups, keep=10)
            if found and first.score + found[0].score > least:
                least, best = first.score + found[0].score, (least, [first, found[0]])
        if not best[1]:
            return False
        self.steps = [Step(c) for c in best[1]]
        self.settle()
        self.add_effects(tell)
        self.review()
        if any(s.refused for s in self.steps):
            self.steps = refused
            return False
        return True

    def review(self):
        """Judge every effect beside all the others, and test whether it may carry its name."""
        self.listen(self.fit_with(self.candidates))
        for i, step in enumerate(self.steps):
            others = [s.candidate for j, s in enumerate(self.steps) if j != i]
            again = self.judge(others, step.candidate)
            step.candidate, step.p, step.size, step.gain = again.candidate, again.p, again.size, again.gain
            step.selection = self.selection(others, step.candidate, step.pool)
            step.refused = self._refusal(step, others)

    def polish(self, named):
        """Parameters of the named effects at their best beside each other alone, as the final model holds them."""
        for _ in range(3):
            moved = False
            for step in named:
                others = [s.candidate for s in named if s is not step]
                rows = self.rows_with(self.fit_with([*others, step.candidate]), others)
                better = refine(rows, step.candidate, self.readings.columns)
                moved |= better.gain > step.candidate.gain + 0.5
                step.candidate = better
            if not moved:
                return

    def _refusal(self, step: Step, others) -> str:
        c = step.candidate
        if not self.passes(step):
            return "it does not hold beside the other effects"
        if step.selection < SELECTION:
            return f"only {step.selection:.0%} of the half-samples choose it"
        apart = [o for o in others if not same_place(o, c)]
        full = self.fit_with(self.candidates)
        rows = self.rows_with(full, [*apart, c])
        used = int(np.count_nonzero(full.weight))
        table, names = self.readings.columns, self.names
        reason = "" if self.coloured else stand_in(c, others, table, names)
        reason = reason or beyond(rows, c, table, names, used, self.inflation)
        if not reason and self.amplitude_um(c) > LARGEST_UM:
            return f"{self.amplitude_um(c):.0f} um is no plausible size"
        return reason

    def amplitude_um(self, c: Candidate) -> float:
        """3-D rms over the points, um."""
        column = omega(self.machine, [c.symbol], self.readings.q, self.readings.tool_offset)[:, :, 0]
        motion = c.vectors(self.readings.columns) @ c.coefficients
        return 1e3 * float(np.sqrt((column**2).sum(axis=1) @ motion**2 / len(motion)))

    # -- what is left ----------------------------------------------------------------------------------------------
    def remainder(self, model) -> Remainder:
        """Is there structure beside `model`?  Free forms of any two columns test it, a surface locates and sizes it."""
        fitted = self.fit_with(model)
        rows = self.scanned(self.rows(fitted))
        used = max(int(rows.lever.any(axis=1).sum()), 1)
        places = [c for c in self.places if component(ALL_SYMBOLS[c]).kind != "squareness"]
        found, null = FreeScan(rows, self.scan_readings, self.names, places).best(self.signs)
        if not found:
            return Remainder()
        p, score = found[0].p, found[0].score
        self.listen(fitted)
        shifts = [c for c in places if not component(ALL_SYMBOLS[c]).angular]
        leading = list(dict.fromkeys([*shifts, *[s.component for s in found[:10]]]))[:6]
        best = locate(rows, self.scan_readings, self.names, leading if p < 0.05 or score > 4 else shifts)
        if not best or best[0].evidence < DETECTABLE:
            return Remainder(p, found[0].size(used), None)
        top = best[0]
        if p >= ALPHA:  # sign flips of a strong structure hide it: take it out of the null first
            clean = self.scanned(self.rows(self.fit_with([*model, surface_candidate(top)])))
            _, null = FreeScan(clean, self.scan_readings, self.names, places).best(self.signs)
            p = min(p, evidence.p_value(score, null))
            if top.evidence > CERTAIN:
                p = min(p, 1.0 / (len(null) + 1))
        size = float(np.sqrt(max(top.gain / self.inflation - top.freedom, 0.0) / used))
        grams, base, mine = self.grams(fitted, model, [surface_candidate(top)])
        held = evidence.gain_statistics(grams.held_out(base), grams.held_out(base + mine[0]))
        return Remainder(p, size, top, held)
