# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a trace found, as the entries of trace.json, the augmented machine and the residuals before and after.

Nothing is decided here: names and verdict come from the trace, and this puts numbers, units, rivals and words to them.
"""

from __future__ import annotations

import numpy as np

from ..core.driver import Driver
from ..core.effects import shown
from ..core.errors import component
from ..core.machine import Machine
from ..core.parameters import Levels
from ..core.refusal import Refused
from ..core.synthesis import omega
from ..core.workspace import Cancelled, sensitivity
from . import outcome
from .catalogue import describe, not_testable, physical
from .design import ALL_SYMBOLS, tool_labels
from .effects import to_effect
from .fit import Fit, null_space_words
from .outcome import Outcome
from .rivals import Rival, aliases, rivals, separating_measurement
from .scan import exact_gain
from .search import Candidate, surface_candidate
from .signs import flipped_findings
from .tracer import ALPHA, Remainder, Step, Tracer
from .unlogged import Unlogged


class TraceReport:
    """Assembles trace.json and the augmented machine."""

    def __init__(self, tracer, declared, named, smooth, remainder, structured, hidden, verdict, flipped=()):
        self.flipped = flipped
        self.tracer: Tracer = tracer
        self.declared: Fit = declared
        self.named: list[Step] = named
        self.smooth: list[Candidate] = smooth
        self.remainder: Remainder = remainder
        self.structured, self.hidden, self.verdict = structured, hidden, verdict
        self.model = [*[s.candidate for s in named], *smooth]
        self.full: Fit = tracer.fit_with(self.model)

    def outcome(self, tell) -> Outcome:
        tracer, readings, machine = self.tracer, self.tracer.readings, self.tracer.machine
        effects = self._effects()
        augmented = outcome.fitted_machine(machine, self.full, readings, effects)
        found_rivals = [rivals(tracer, s, self._others(s)) for s in self.named]
        if not tell(0.85, "rivals are compared"):
            raise Cancelled("cancelled")
        report = {
            "format": "sens-trace",
            "version": 1,
            "verdict": self.verdict,
            "floor": tracer.floor,
            "seed": tracer.seed,
            "permutations": tracer.permutations,
            "effects": self._findings(effects, found_rivals),
        }
        errors, residuals = self._before_and_after()
        report |= {
            "error": errors,
            "noise": self._noise(residuals),
            "identifiability": {
                "columns": len(self.declared.design.terms),
                "rank": int(self.declared.basis.rank),
                "condition": self.declared.basis.condition,
                "null_space": null_space_words(self.declared, max(1, len(tool_labels(readings)))),
            },
            "depends_on": self._depends_on(),
            "not_testable": not_testable(tracer.names),
            "not_identifiable": self._not_identifiable(),
            "next_measurements": self._next(found_rivals),
            "parameter_shifts": self._shifts(),
            "sensitivity_shift": _sensitivity_shift(machine, augmented),
            "refused_names": self._refused(),
            "remainder": self._remainder_words(),
            "outliers": self._outliers(),
            "findings": [
                {"severity": f.severity, "code": f.code, "message": f.message, "line": f.line}
                for f in readings.findings
            ]
            + flipped_findings(self.flipped),
        }
        tell(1.0, "done")
        return Outcome(report, augmented, readings, residuals, outcome.covariance_table(self.full), tracer.log)

    def _others(self, step: Step) -> list[Candidate]:
        return [s.candidate for s in self.named if s is not step] + self.smooth

    # -- effects ---------------------------------------------------------------------------------------------------
    def _effects(self):
        tracer = self.tracer
        at = len(tracer.design.terms)
        out = []
        names: set[str] = set()
        for i, c in enumerate(self.model):
            vectors = c.vectors(tracer.readings.columns)
            block = slice(at, at + vectors.shape[1])
            at += vectors.shape[1]
            coefficients = self.full.coefficients[block]
            final = Candidate(c.symbol, c.regressor, c.gain, coefficients, c.visible, c.handicap)
            motion = vectors @ coefficients
            if i < len(self.named):
                name = str(describe(c.symbol, c.driver, c.shape))
                self.named[i].candidate = final
            else:
                name = f"unnamed remainder: {c.symbol} by {c.driver.words('and')}"
                self.smooth[i - len(self.named)] = final
            while name in names:
                name += " (again)"
            names.add(name)
            uncertainty = self._parameter_uncertainty(final, i) if i < len(self.named) else {}
            reach = (float(motion.min()), float(motion.max()))
            units = tracer.readings.units
            out.append(to_effect(name, final, self.full.covariance[block, block], uncertainty, units, reach))
        return out

    def _parameter_uncertainty(self, c: Candidate, i: int) -> dict[str, float]:
        """Standard uncertainty of a profiled parameter from the curvature of chi-square."""
        tracer = self.tracer
        others = [m for j, m in enumerate(self.model) if j != i]
        rows = tracer.rows_with(self.full, others)
        out = {}
        driven = c.driver.values(tracer.readings.columns)
        for key in c.shape.fitted:
            value, search = c.shape.values[key], c.shape.parameters[key].search
            if isinstance(search, Levels):
                times = np.unique(driven)
                k = int(np.searchsorted(times, value))
                out[key] = float((times[min(k, len(times) - 1)] - times[max(k - 1, 0)]) / np.sqrt(12))
                continue

            def gain(v, key=key):
                vectors = c.regressor.having(**{key: v}).vectors(tracer.readings.columns)
                return exact_gain(rows, c.index, vectors)[0]

            step = search.step(value, float(np.ptp(driven)))
            curve = (2 * gain(value) - gain(value + step) - gain(value - step)) / step**2
            out[key] = float(np.sqrt(2 / curve)) if curve > 0 else float(value)
        return out

    def _findings(self, effects, found_rivals) -> list[dict]:
        out = []
        for step, effect, around in zip(self.named, effects, found_rivals):
            c = step.candidate
            entry = {
                "name": effect.name,
                "component": effect.component,
                "driver": str(effect.driver),
                "shape": effect.shape.name,
                "parameters": {k: v.to_dict() for k, v in shown(effect, component(c.symbol)).items()},
                "amplitude_um": self.tracer.amplitude_um(c),
                "p_familywise": step.p,
                "selection_frequency": step.selection,
                "held_out_gain_chi2": {"value": step.gain[0], "u": step.gain[1]},
                "visible_share": c.visible,
                "size_over_noise": step.size,
                "rivals": [_rival_entry(r) for r in around],
            }
            match = physical(c.symbol, c.driver, c.shape)
            if match:
                entry |= {"catalogue": match.key, "usual_size": str(match.size), "check": str(match.check)}
            if c.shape.wave:
                alias = aliases(self.tracer, c, self._others(step))
                if alias:
                    listed = ", ".join(f"{p:.4g}" for p in [c.shape.period, *alias])
                    entry["alias_periods"] = alias
                    entry["note"] = (
                        f"aliased: the spacing of the places cannot tell the periods {listed} mm apart; "
                        "measure at a finer, irregular pitch"
                    )
            out.append(entry)
        if self.hidden:
            h = self.hidden
            unit = "urad" if h.symbol[1] in "ABC" else "um"
            out.append(
                {
                    "name": f"unlogged driver: {h.symbol} moves from reading to reading"
                    + (f", in proportion to {h.place}" if h.place else ""),
                    "component": h.symbol,
                    "driver": f"unlogged*{h.place}" if h.place else "unlogged",
                    "shape": "random",
                    "parameters": {
                        "rms": {
                            "value": h.rms * (1e6 if unit == "urad" else 1e3),
                            "unit": f"{unit}/mm" if h.place else unit,
                        }
                    },
                    "amplitude_um": self._unlogged_amplitude(h),
                    "p_familywise": h.p,
                    "selection_frequency": 1.0,
                    "rivals": [],
                }
            )
        return out

    def _unlogged_amplitude(self, h: Unlogged) -> float:
        """3-D rms over the points, um, of a component that moves by h.rms from reading to reading."""
        readings = self.tracer.readings
        column = omega(self.tracer.machine, [h.symbol], readings.q, readings.tool_offset)[:, :, 0]
        place = readings.columns[h.place] if h.place else np.ones(readings.points)
        return 1e3 * h.rms * float(np.sqrt(((column * place[:, None]) ** 2).sum(axis=1).mean()))

    # -- before and after ------------------------------------------------------------------------------------------
    def _before_and_after(self):
        tracer, readings = self.tracer, self.tracer.readings
        used = self.full.weight > 0
        rows = tracer.row_block
        nuisance = [i for i, t in enumerate(self.full.design.terms) if t.group != "declared"]
        declared = list(range(len(self.full.design.terms)))
        extra = tracer.columns_of(self.model)
        x = self.full.design.matrix if extra is None else np.concatenate([self.full.design.matrix, extra], axis=1)
        every = list(range(x.shape[1]))
        y = readings.value
        residuals, table = {}, {}
        for name, columns in (("uncorrected", nuisance), ("declared", declared), ("augmented", every)):
            inside = _weighted_residual(x[:, columns], y, self.full.weight)
            outside = outcome.held_out_rows(columns, self.full, rows, y, x)
            residuals[name], residuals[name + "_held_out"] = inside * 1e3, outside * 1e3
            table[name] = {
                "in_sample": outcome.metrics(inside * 1e3, readings, used),
                "held_out": outcome.metrics(outside * 1e3, readings, used)
                | {"rms_interval_um": outcome.interval(outside * 1e3, readings, tracer.block, used, tracer.seed)},
            }
        table["note"] = (
            "alignment of the set-up is fitted in all three; outliers are left out of all three; held out: whole "
            "blocks of consecutive readings, predicted by a fit of the others with the shapes as found"
        )
        residuals["used"] = used
        return table, residuals

    def _noise(self, residuals) -> dict:
        readings, used = self.tracer.readings, self.full.weight > 0
        stated = readings.u[used & np.isfinite(readings.u)]
        pure = outcome.replicates(readings, residuals["augmented"], used)
        return {
            "stated_um": float(np.sqrt((stated**2).mean()) * 1e3) if len(stated) else None,
            "pure_error_um": pure,
            "residual_um": float(np.sqrt(np.mean([v**2 for v in self.full.noise.values()])) * 1e3),
            "per_direction_um": {"xyz*"[k]: v * 1e3 for k, v in self.full.noise.items()},
        }

    # -- words -----------------------------------------------------------------------------------------------------
    def _depends_on(self) -> list[dict]:
        found: dict[str, float] = {}
        for step in self.named:
            for name in step.candidate.driver.columns:
                found[name] = min(step.p, found.get(name, 1.0))
        if self.structured:
            places = [s.columns for s in [self.remainder.structure] if s is not None]
            places += [c.driver.columns for c in self.smooth]
            for columns in places:
                for name in columns:
                    found[name] = min(self.remainder.p, found.get(name, 1.0))
            if not places:
                for step in self.tracer.steps:
                    for name in step.candidate.driver.columns:
                        found[name] = min(step.p, found.get(name, 1.0))
        return [{"column": k, "p": v} for k, v in sorted(found.items(), key=lambda item: item[1])]

    def _not_identifiable(self) -> list[str]:
        """Catalogue-like candidates that this plan could not see beside the declared model, by name."""
        tracer = self.tracer
        rows = tracer.rows(self.full)
        out = []
        for body, along in (("X", "Y"), ("X", "Z"), ("Y", "X"), ("Y", "Z"), ("Z", "X"), ("Z", "Y")):
            name = along.lower()
            if name not in tracer.names:
                continue
            for letter in "ABC":
                symbol = f"E{letter}{body}"
                if symbol not in ALL_SYMBOLS:
                    continue
                v = tracer.readings.columns[name][:, None]
                _, _, share = exact_gain(rows, ALL_SYMBOLS.index(symbol), v)
                if share < 0.05:
                    out.append(
                        f"{symbol} driven by {name}: {max(share, 0.0):.0%} of it would show beside the declared model"
                    )
        return out

    def _next(self, found_rivals) -> list[dict]:
        out = []
        for step, around in zip(self.named, found_rivals):
            seen: set[Driver] = set()
            for rival in around:
                if len(out) >= 6 or rival.candidate.driver in seen:
                    continue
                seen.add(rival.candidate.driver)
                out.append(separating_measurement(self.tracer, step.candidate, rival, self._others(step)))
        if self.structured and self.remainder.structure is not None:
            columns = " and ".join(self.remainder.structure.columns)
            out.append(
                {
                    "separates": [f"effects that act through {columns}"],
                    "do": f"vary {columns} one at a time with everything else held, "
                    "and log what else changes with time",
                    "predicted_difference_um": self.remainder.size
                    * float(np.mean(list(self.full.noise.values())))
                    * 1e3,
                }
            )
        return out

    def _shifts(self) -> list[dict]:
        """Declared parameters that moved by more than their uncertainty when the effects joined."""
        out = []
        for i, term in enumerate(self.full.design.terms):
            if term.group != "declared" or not (self.full.determined[i] and self.declared.determined[i]):
                continue
            scale = 1e6 if term.symbol[1] in "ABC0" or term.symbol in ("A0Z", "B0Z", "C0Y") else 1e3
            u = float(np.sqrt(max(self.full.covariance[i, i], 0.0))) * scale
            before, after = self.declared.coefficients[i] * scale, self.full.coefficients[i] * scale
            if u > 0 and abs(after - before) > u:
                unit = "urad" if scale == 1e6 else "um"
                out.append({"parameter": term.label, "before": before, "after": after, "u": u, "unit": unit})
        return sorted(out, key=lambda e: -abs(e["after"] - e["before"]) / e["u"])

    def _refused(self) -> list[dict]:
        return [
            {
                "component": s.candidate.symbol,
                "driver": str(s.candidate.driver),
                "shape": s.candidate.shape.name,
                "p_familywise": s.p,
                "why": s.refused,
            }
            for s in self.tracer.steps
            if s.refused
        ]

    def _remainder_words(self) -> dict:
        r = self.remainder
        words = "nothing beyond noise" if r.p >= ALPHA else "structure above the floor"
        if r.p < ALPHA and not self.structured:
            words = "structure below the floor: a short-wave remainder, not named"
        elif self.structured:
            words = "structure above the floor that no named effect explains"
        if self.tracer.roughness and not self.structured:
            words += "; short waves along the axes (roughness), not named"
        out = {"words": words, "p": r.p, "rms_over_noise": r.size}
        if r.structure is not None and r.p < ALPHA:
            out |= {"component": surface_candidate(r.structure).symbol, "columns": list(r.structure.columns)}
        return out

    def _outliers(self) -> list[dict]:
        readings = self.tracer.readings
        points = np.unique(readings.point[self.full.weight == 0])
        return [
            {"line": int(readings.line[p]) if readings.line is not None else 0, "position_mm": readings.q[p].tolist()}
            for p in points
        ]


def _rival_entry(r: Rival) -> dict:
    c = r.candidate
    return {"component": c.symbol, "driver": str(c.driver), "shape": c.shape.name, "why": r.why}


def _weighted_residual(x, y, weight) -> np.ndarray:
    w = weight[:, None]
    solution, *_ = np.linalg.lstsq(x * w / _norms(x * w), y * weight, rcond=1e-9)
    return y - (x / _norms(x * w)) @ solution


def _norms(x) -> np.ndarray:
    size = np.linalg.norm(x, axis=0)
    return np.where(size > 0, size, 1.0)


def _sensitivity_shift(before: Machine, after: Machine) -> list[dict]:
    """Total indices before and after the effects joined, by name."""
    try:
        old, new = sensitivity(before, estimate=False), sensitivity(after, estimate=False)
    except Refused:
        return []
    table = dict(zip(old.symbols, old.total.tolist()))
    rows = [{"symbol": s, "before": table.get(s), "after": float(t)} for s, t in zip(new.symbols, new.total.tolist())]
    return sorted(rows, key=lambda r: -r["after"])
