# SPDX-License-Identifier: LGPL-2.1-or-later
"""From the final state of a trace to its result: numbers with their uncertainty, rivals, before and after, advice.

Nothing is decided here: names and verdict come from the trace.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from ..core.errors import component
from ..core.machine import Machine
from ..core.synthesis import omega
from ..core.units import um
from ..core.workspace import Cancelled, sensitivity
from ..messages import Message, Refused
from . import checks, scores
from .catalogue import describe, physical
from .catalogue import not_testable as lacking
from .design import ALL_SYMBOLS
from .effects import to_effect
from .estimates import Estimates
from .fit import Fit, null_space
from .input_remarks import input_remarks
from .problem import State, Step
from .remainder import Rest
from .result import (
    STAGES,
    HiddenMotion,
    Identifiability,
    IndexShift,
    Leftover,
    NamedEffect,
    NextMeasurement,
    Outlier,
    ParameterShift,
    Refusal,
    StageError,
    TraceEvidence,
    TraceResult,
)
from .rivals import aliases, driven_by, rivals, separating_measurement
from .scan import exact_gain
from .search import ScoredTerm, surface_candidate
from .signs import flipped_remark
from .sources import budget
from .uncertainty import settled


def result(state: State, declared: Fit, full: Fit, left: Rest, verdict: str, flipped, tell) -> TraceResult:
    """The result of a trace whose final state and verdict are known.

    declared, full : the fits without effects and of the final model.
    """
    final = _Final(state, declared, full, left)
    problem = state.problem
    effects = final.effects
    found = [rivals(state, step, final.others(step)) for step in final.named]
    uncertainty = final.estimates.stored(effects, found)
    u = final.estimates.term_u(uncertainty)
    machine = scores.fitted_machine(problem.machine, final.full, problem.readings, effects, u, uncertainty)
    if not tell(0.85, "rivals are compared"):
        raise Cancelled("cancelled")
    error, residuals = final.before_and_after
    outcome = TraceResult(
        verdict=verdict,
        floor=state.settings.floor,
        seed=problem.seed,
        permutations=problem.permutations,
        effects=tuple(_named(final, i, *item) for i, item in enumerate(zip(final.named, effects, found))),
        hidden=None if left.hidden is None else _hidden(state, left.hidden),
        error=error,
        noise=checks.noise_summary(final.full, problem.readings, residuals["augmented"], state.settings),
        identifiability=Identifiability(
            len(declared.design.terms),
            int(declared.basis.rank),
            declared.basis.condition,
            tuple(null_space(declared, problem.readings, state.settings)),
        ),
        depends_on=final.depends_on,
        not_testable=lacking(problem.names),
        not_identifiable=final.not_identifiable,
        next_measurements=final.advice(found),
        parameter_shifts=final.shifts,
        sensitivity_shift=_sensitivity_shift(problem.machine, machine),
        refused=tuple(
            Refusal(s.candidate.symbol, str(s.candidate.driver), s.candidate.shape.name, s.p, s.refused)
            for s in (*state.steps, *final.dropped)
            if s.refused is not None
        ),
        left=final.leftover,
        outliers=final.outliers,
        remarks=(*(flipped_remark(kind) for kind in flipped), *input_remarks(problem.readings, state.settings)),
        alignment=problem.readings.alignment,
        guarantee=checks.guarantee(state),
        evidence=TraceEvidence(machine, problem.readings, residuals, scores.covariance_table(uncertainty)),
        budget=budget(machine, problem.readings, final.estimates.parts(effects, uncertainty.others)),
        log=state.log,
    )
    tell(1.0, "done")
    return outcome


@dataclass(frozen=True)
class _Final:
    """The final model: its fit, and what follows from it."""

    state: State
    declared: Fit
    found: Fit
    left: Rest

    @cached_property
    def full(self) -> Fit:
        """The fit of the model; what the readings leave open is as the tolerances make most probable."""
        problem = self.state.problem
        return settled(self.found, problem.machine, problem.readings, problem.columns_of(self.model))

    @cached_property
    def estimates(self) -> Estimates:
        """Coefficients and parameters of the model with their uncertainty."""
        return Estimates(self.state, self.full, tuple(self.fitted))

    @cached_property
    def model(self) -> list[ScoredTerm]:
        return [*[s.candidate for s in self.state.named], *self.left.smooth]

    @cached_property
    def blocks(self) -> list[slice]:
        """The coefficients of each member of the model."""
        at, out = len(self.full.design.terms), []
        for c in self.model:
            width = c.vectors(self.state.problem.readings.columns).shape[1]
            out.append(slice(at, at + width))
            at += width
        return out

    @cached_property
    def fitted(self) -> list[ScoredTerm]:
        """The members of the model with their final coefficients."""
        return [replace(c, coefficients=self.full.coefficients[b]) for c, b in zip(self.model, self.blocks)]

    @cached_property
    def named(self) -> list[Step]:
        return [replace(s, candidate=c) for s, c in zip(self.state.named, self.fitted)]

    @property
    def smooth(self) -> list[ScoredTerm]:
        return self.fitted[len(self.named) :]

    def others(self, step: Step) -> list[ScoredTerm]:
        return [s.candidate for s in self.named if s is not step] + self.smooth

    # -- effects ---------------------------------------------------------------------------------------------------
    @cached_property
    def effects(self) -> list:
        """The model as effects of the machine, each under its own name."""
        out, names = [], set()
        readings = self.state.problem.readings
        for i, c in enumerate(self.fitted):
            motion = c.vectors(readings.columns) @ c.coefficients
            if i < len(self.named):
                name = str(describe(c.symbol, c.driver, c.shape))
            else:
                name = f"unnamed remainder: {c.symbol} by {c.driver.words('and')}"
            while name in names:
                name += " (again)"
            names.add(name)
            reach = (float(motion.min()), float(motion.max()))
            driven = c.driver.values(readings.columns)
            extent = (float(driven.min()), float(driven.max()))
            covariance, u = self.estimates.coefficient_covariance(i), self.estimates.parameter_u(i)
            out.append(to_effect(name, c, covariance, u, readings.units, reach, extent))
        return out

    # -- before and after ------------------------------------------------------------------------------------------
    @cached_property
    def before_and_after(self):
        """({stage: StageError}, {name: residuals (R,) um})."""
        state, full = self.state, self.full
        readings, used = state.problem.readings, full.weight > 0
        terms = full.design.terms
        extra = state.problem.columns_of(self.model)
        x = full.design.matrix if extra is None else np.concatenate([full.design.matrix, extra], axis=1)
        columns = (
            [i for i, t in enumerate(terms) if t.group != "declared"],
            list(range(len(terms))),
            list(range(x.shape[1])),
        )
        y = readings.value
        residuals, table = {}, {}
        for name, own in zip(STAGES, columns):
            inside = um(_residual(x[:, own], y, full))
            outside = um(scores.held_out_rows(own, full, state.row_block, y, x))
            residuals[name], residuals[name + "_held_out"] = inside, outside
            runs = scores.left_out_runs(own, full, readings, y, x)
            table[name] = StageError(
                scores.metrics(inside, readings, used),
                scores.metrics(outside, readings, used),
                tuple(scores.interval(outside, readings, state.block, used, state.problem.seed)),
                tuple(runs or scores.left_out_blocks(outside, readings, state.block, used)),
                "runs" if runs else "blocks",
            )
        residuals["used"] = used
        return table, residuals

    @property
    def dropped(self) -> list[Step]:
        """What was beyond chance and yet not accepted, unless its column is in the model now."""
        known = {c.driver for c in self.model} | {s.candidate.driver for s in self.state.steps}
        return [s for s in self.state.dropped if s.candidate.driver not in known]

    # -- what is left ----------------------------------------------------------------------------------------------
    @property
    def depends_on(self) -> tuple[tuple[str, float], ...]:
        """(column, p), smallest p first."""
        found: dict[str, float] = {}

        def note(columns, p: float):
            for name in columns:
                found[name] = min(p, found.get(name, 1.0))

        for step in self.named:
            note(step.candidate.driver.columns, step.p)
        if self.left.structured:
            first = self.left.first
            places = [first.structure.columns] if first.structure is not None else []
            places += [c.driver.columns for c in self.smooth]
            for columns in places:
                note(columns, first.p)
            if not places:
                for step in self.state.steps:
                    note(step.candidate.driver.columns, step.p)
        return tuple(sorted(found.items(), key=lambda item: item[1]))

    @property
    def not_identifiable(self) -> tuple[Message, ...]:
        """Tilts of one axis by the place along another that this plan cannot show beside the declared model."""
        problem = self.state.problem
        rows = self.state.rows(self.full)
        bodies = problem.machine.workpiece_chain + problem.machine.tool_chain
        out = []
        for body in sorted(bodies):
            for along in sorted(set(bodies) - {body}):
                name = along.lower()
                for symbol in (f"E{letter}{body}" for letter in "ABC"):
                    if name not in problem.names or symbol not in ALL_SYMBOLS:
                        continue
                    vectors = problem.readings.columns[name][:, None]
                    share = max(exact_gain(rows, ALL_SYMBOLS.index(symbol), vectors)[2], 0.0)
                    if share < self.state.settings.visible:
                        out.append(Message("not-identifiable", component=symbol, driver=name, share=share))
        return tuple(out)

    def advice(self, found_rivals) -> tuple[NextMeasurement, ...]:
        """What to measure next."""
        out = []
        for step, around in zip(self.named, found_rivals):
            seen: set[str] = set()
            for rival, candidate in around:
                if len(out) < self.state.settings.advice and rival.driver not in seen:
                    seen.add(rival.driver)
                    out.append(separating_measurement(self.state, step.candidate, candidate, self.others(step)))
        structure = self.left.first.structure
        if self.left.structured and structure is not None:
            columns = list(structure.columns)
            size = self.left.first.size * float(np.mean(list(self.full.noise.values())))
            through, vary = Message("next-through", columns=columns), Message("next-vary", columns=columns)
            out.append(NextMeasurement((through,), vary, size))
        return tuple(out)

    @property
    def shifts(self) -> tuple[ParameterShift, ...]:
        """Declared parameters that moved by more than their uncertainty when the effects joined."""
        full, declared, out = self.full, self.declared, []
        for i, term in enumerate(full.design.terms):
            if term.group != "declared" or not (full.determined[i] and declared.determined[i]):
                continue
            u = float(self.estimates.spread.u[i])
            before, after = float(declared.coefficients[i]), float(full.coefficients[i])
            if u > 0 and abs(after - before) > u:
                out.append(ParameterShift(term.title, before, after, u, component(term.symbol).angular))
        return tuple(sorted(out, key=lambda s: -abs(s.after - s.before) / s.u))

    @property
    def leftover(self) -> Leftover:
        """What is left, in words and numbers."""
        r, alpha = self.left.first, self.state.settings.alpha
        drift = [] if self.left.drift is None else [Message("left-drift", readings=self.left.drift)]
        drift += [Message("left-dropped", dropped=driven_by(s.candidate), p=s.p) for s in self.left.dropped]
        if drift and (r.p >= alpha or r.structure is None):
            words = drift
        elif self.left.structured:
            words = [Message("left-structure"), *drift]
        elif r.p < alpha:
            words = [Message("left-below-floor")]
        else:
            words = [Message("left-noise")]
        if self.state.roughness and not self.left.structured:
            words.append(Message("left-roughness"))
        if r.structure is None or r.p >= alpha:
            return Leftover(tuple(words), r.p, r.size)
        return Leftover(tuple(words), r.p, r.size, surface_candidate(r.structure).symbol, tuple(r.structure.columns))

    @property
    def outliers(self) -> tuple[Outlier, ...]:
        readings = self.state.problem.readings
        points = np.unique(readings.point[self.full.weight == 0])
        lines = np.zeros(readings.points, dtype=int) if readings.line is None else readings.line
        return tuple(Outlier(int(lines[p]), tuple(readings.q[p].tolist())) for p in points)


def _named(final: _Final, number: int, step: Step, effect, around) -> NamedEffect:
    c = step.candidate
    amplitude, amplitude_u = final.estimates.amplitude(number)
    match = physical(c.symbol, c.driver, c.shape)
    periods = tuple(aliases(final.state, c, final.others(step))) if c.shape.wave else ()
    far = [driven_by(term) for rival, term in around if rival.why.code == "rival-far"]
    if periods:
        note = Message("finding-aliased", periods=[c.shape.period, *periods])
    else:
        note = Message("finding-by-tolerances", rivals=far[: final.state.settings.tries]) if far else None
    return NamedEffect(
        effect=effect,
        title=describe(c.symbol, c.driver, c.shape),
        amplitude=amplitude,
        amplitude_u=amplitude_u,
        p=step.p,
        selection=step.selection,
        gain=step.gain,
        visible=c.visible,
        size=step.size,
        rivals=tuple(rival for rival, _ in around),
        catalogue="" if match is None else match.key,
        usual=match and match.size,
        check=match and match.check,
        aliases=periods,
        note=note,
    )


def _hidden(state: State, motion) -> HiddenMotion:
    """A motion that nobody logged, with its 3-D rms over the points."""
    readings = state.problem.readings
    column = omega(state.problem.machine, [motion.symbol], readings.q, readings.tool_offset)[:, :, 0]
    place = readings.columns[motion.place] if motion.place else np.ones(readings.points)
    amplitude = motion.rms * float(np.sqrt(((column * place[:, None]) ** 2).sum(axis=1).mean()))
    code = "hidden-motion-along" if motion.place else "hidden-motion"
    fields = {"place": motion.place} if motion.place else {}
    return HiddenMotion(motion, Message(code, component=motion.symbol, **fields), amplitude)


def _residual(x, y, fitted: Fit) -> np.ndarray:
    """(R,) residual of a fit of columns x (R, n) under the weights and the memory of `fitted`; mm."""
    white = fitted.white(x)
    size = np.linalg.norm(white, axis=0)
    size = np.where(size > 0, size, 1.0)
    white /= size
    solution, *_ = np.linalg.lstsq(white, fitted.white(y), rcond=1e-9)
    return y - x @ (solution / size)


def _sensitivity_shift(before: Machine, after: Machine) -> tuple[IndexShift, ...]:
    """Total indices before and after the effects joined, largest first; () where nothing varies."""
    try:
        old, new = sensitivity(before, estimate=False), sensitivity(after, estimate=False)
    except Refused:
        return ()
    table = dict(zip(old.symbols, old.total.tolist()))
    rows = [IndexShift(s, table.get(s), float(t)) for s, t in zip(new.symbols, new.total.tolist())]
    return tuple(sorted(rows, key=lambda r: -r.after))
