# SPDX-License-Identifier: LGPL-2.1-or-later
"""Coverage of the standard uncertainties: how often the truth lies within two of them, given the right name.

Run `python benchmarks/coverage.py --machines 500 --seed 700000`.  Each machine has declared errors and one effect whose
sizes come from its tolerances (the paper's).  It is measured by the linear product of tests/simulator, and fitted
with the right component, driver and shape; parameters of shapes are searched for from the grid of the program.  Noise
is white, or remembers (first-order autoregressive).  Values are pooled per kind; the band is 93 to 97 %.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
import time
from dataclasses import dataclass, replace
from pathlib import Path

for _name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ.setdefault(_name, "1")

import numpy as np  # noqa: E402

ROOT = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT), str(ROOT / "tests")]

from simulator import kinematics, plans  # noqa: E402

from sensworkbench.closedloop import scores  # noqa: E402
from sensworkbench.closedloop.effects import to_effect  # noqa: E402
from sensworkbench.closedloop.estimates import Estimates  # noqa: E402
from sensworkbench.closedloop.predict import predict, uncertainty  # noqa: E402
from sensworkbench.closedloop.problem import Problem, State  # noqa: E402
from sensworkbench.closedloop.readings import Readings  # noqa: E402
from sensworkbench.closedloop.search import ScoredTerm, refine, scored  # noqa: E402
from sensworkbench.closedloop.uncertainty import settled  # noqa: E402
from sensworkbench.core.shapes import Regressor  # noqa: E402
from sensworkbench.formats import machine_json  # noqa: E402

KINDS = ("linear", "lag", "approach", "periodic")
CODES = ("FXYZ", "XYFZ", "YFXZ", "XFYZ", "XFZY")
SIGMA = 0.4e-3  # mm
SEEN = 6.0  # of chi: an effect that shows less beside the declared model is drawn again
LENGTH, ANGLE = {True: 1e-3, False: 5e-3}, 20e-6  # the paper's limits: along the own axis, across it; rotations
FRESH = 20


def remembered(rng, count: int, phi: float) -> np.ndarray:
    """(count, 3) noise of variance 1, correlated by phi from reading to reading."""
    out = rng.normal(size=(count, 3))
    for i in range(1, count):
        out[i] = phi * out[i - 1] + np.sqrt(1 - phi**2) * out[i]
    return out


def limit(symbol: str) -> float:
    """The paper's tolerance of a component of a carriage, mm or rad."""
    return LENGTH[symbol[1] == symbol[2]] if symbol[1] in "XYZ" else ANGLE


def conditions(rng, q) -> dict:
    """Columns of a session in internal units."""
    count = len(q)
    t = np.cumsum(rng.uniform(5, 15, count))
    end = t[-1]
    moved = np.sign(np.diff(q[:, 0], prepend=q[0, 0] - 1))
    return {
        **{k: q[:, i] for i, k in enumerate("xyz")},
        "t": t,
        "dir_x": np.where(moved == 0, 1.0, moved),
        "temp_column": 4 * (1 - np.exp(-3 * t / end)) + rng.uniform(0.5, 1.5) * np.sin(rng.uniform(9, 25) * t / end),
        "temp_scale": rng.uniform(1, 3) * np.sin(rng.uniform(3, 8) * t / end + rng.uniform(0, 6)),
        "load_table": rng.choice([0.0, 250.0, 500.0], count),
    }


@dataclass(frozen=True)
class Truth:
    """A simulated machine: its error functions, and one effect `gain * wave(columns)` on a component."""

    machine: kinematics.Machine
    functions: dict
    square: dict
    symbol: str
    regressor: Regressor
    exact: tuple[float, ...]  # coefficients of the effect

    def motion(self, columns) -> np.ndarray:
        """(P,) the effect, mm or rad, by formulas of its own."""
        driver, shape = self.regressor.key
        v = np.prod([columns[n] for n in driver.split("*")], axis=0)
        values = self.regressor.shape.values
        if shape == "periodic":
            phase = 2 * np.pi * v / values["period"]
            return self.exact[0] * np.sin(phase) + self.exact[1] * np.cos(phase)
        if shape == "lag":
            v = lag(v, columns["t"], values["tau"])
        elif shape == "approach":
            v = 1 - np.exp(-v / values["tau"])
        return self.exact[0] * v

    def error(self, columns) -> np.ndarray:
        """(P, 3) mm: declared errors and the effect, linear in them (the exact product differs by nanometres)."""
        q = np.stack([columns[k] for k in "xyz"], axis=1)
        values = dict(self.square)
        for symbol, coefficients in self.functions.items():
            low, high = self.machine.travel[symbol[2]]
            u = (2 * columns[symbol[2].lower()] - low - high) / (high - low)
            values[symbol] = np.polynomial.legendre.legval(u, coefficients)
        values[self.symbol] = values[self.symbol] + self.motion(columns)
        return kinematics.linear_error(self.machine, q, values)


def lag(v, t, tau: float) -> np.ndarray:
    """(P,) y' = (v - y)/tau, y = 0 at the first row."""
    y = np.zeros(len(v))
    for i in range(1, len(v)):
        y[i] = v[i] + (y[i - 1] - v[i]) * np.exp(-(t[i] - t[i - 1]) / tau)
    return y


def drawn(rng, kind: str) -> tuple[Truth, dict]:
    """A machine with one effect of a kind, sizes from the tolerances, and the columns of a session on it."""
    travel = {k: (-h, h) for k, h in zip("XYZ", rng.choice([150.0, 200.0, 300.0], 3).tolist())}
    reference = {k: rng.uniform(-250, 250, 3).round(1).tolist() for k in "XYZ"}
    tool = tuple(np.round([*rng.uniform(-80, 80, 2), -rng.uniform(100, 250)], 1).tolist())
    machine = kinematics.Machine(str(rng.choice(CODES)), reference, travel, tool)
    q = plans.places(str(rng.choice(["random", "lines", "grid"])), travel, rng, int(rng.integers(150, 280)))
    columns = conditions(rng, q)
    session = float(np.ptp(columns["t"]))
    symbols = [f"E{m}{k}" for k in "XYZ" for m in "XYZABC"]
    if kind == "linear":
        driver = str(rng.choice(["temp_column", "temp_scale*x", "dir_x", "load_table"]))
        regressor = Regressor.make(driver, "reversal" if driver == "dir_x" else "linear")
    elif kind == "lag":
        regressor = Regressor.make("temp_column", "lag", tau=session * float(np.exp(rng.uniform(*np.log([0.03, 0.3])))))
    elif kind == "approach":
        regressor = Regressor.make("t", "approach", tau=session * float(np.exp(rng.uniform(*np.log([0.08, 0.5])))))
    else:
        axis = str(rng.choice(["x", "y", "z"]))
        regressor = Regressor.make(axis, "periodic", period=float(rng.uniform(8, 40)))
        symbols = [s for s in symbols if s[2] == axis.upper()]
    symbol = str(rng.choice(symbols))
    functions = {}
    for s in (f"E{m}{k}" for k in "XYZ" for m in "XYZABC"):
        orders = [k for k in (1, 2, 3) if k > 1 or s[1] in "ABC" or s[1] == s[2]]
        functions[s] = np.zeros(4)  # in equal parts by each order; together they vary as a uniform law does
        functions[s][orders] = rng.normal(size=len(orders)) * limit(s) / np.sqrt(3 * len(orders))
        functions[s] *= np.sqrt([1, 3, 5, 7])
    square = {s: float(rng.uniform(-1, 1) * ANGLE) for s in kinematics.SQUARENESS}
    if kind == "periodic":
        phase, size = rng.uniform(0, 2 * np.pi), rng.uniform(0.3, 1.0) * limit(symbol)
        exact = (float(size * np.cos(phase)), float(size * np.sin(phase)))
        return Truth(machine, functions, square, symbol, regressor, exact), columns
    unit = Truth(machine, functions, square, symbol, regressor, (1.0,))
    size = float(rng.uniform(0.3, 1.0) * limit(symbol) * rng.choice([-1.0, 1.0]) / np.abs(unit.motion(columns)).max())
    return replace(unit, exact=(size,)), columns


# -- one machine -------------------------------------------------------------------------------------------------------
def visible(state: State, truth: Truth, columns) -> tuple[float, float]:
    """(share that shows beside the declared model, its chi) of the true effect."""
    there = scored(state.rows(state.fit_with([])), truth.symbol, truth.regressor, columns)
    readings, lever = state.problem.readings, state.problem.design.lever[:, there.index]
    size = np.sqrt(((lever * truth.motion(columns)[readings.point]) ** 2).sum()) / SIGMA
    return there.visible, float(np.sqrt(max(there.visible, 0.0)) * size)


def best_of(state: State, truth: Truth) -> ScoredTerm:
    """The right name with its parameters at their best, from every start of the program's grid."""
    rows, columns = state.rows(state.fit_with([])), state.problem.readings.columns
    starts = [r for r in state.problem.bank if r.key == truth.regressor.key] or [truth.regressor]
    return polished(state, max((scored(rows, truth.symbol, r, columns) for r in starts), key=lambda c: c.gain))


def polished(state: State, term: ScoredTerm) -> ScoredTerm:
    for _ in range(2):
        term = refine(state.rows_with(state.fit_with([term]), []), term, state.problem.readings.columns)
    return term


def one(seed: int, kind: str, phi: float) -> dict | str:
    """What it is -> z, the errors over their uncertainties; or why the machine does not count."""
    rng = np.random.default_rng([seed, KINDS.index(kind), int(100 * phi)])
    truth, columns = drawn(rng, kind)
    q = np.stack([columns[k] for k in "xyz"], axis=1)
    error = truth.error(columns) + SIGMA * remembered(rng, len(q), phi)
    machine = machine_json.loads(json.dumps(truth.machine.as_dict()))
    problem = Problem(machine, Readings.from_vectors(q, error, columns), permutations=9)
    state = State(problem)
    share, chi = visible(state, truth, columns)
    if share < 0.05 or chi < SEEN:
        return "hidden"
    term = best_of(state, truth)
    for _ in range(2):  # as a trace does: memory is heard beside the effect, then all is fitted under it
        state = state.heard(state.fit_with([term]))
        term = polished(state, term)
    if kind == "periodic":
        off = abs(1 / term.shape.period - 1 / truth.regressor.shape.period)
        if off > 0.7 / np.ptp(columns[str(term.driver)]):
            return "alias"  # another maximum, which is told apart and not claimed
    full = settled(state.fit_with([term]), machine, problem.readings, problem.columns_of([term]))
    term = replace(term, coefficients=full.coefficients[len(full.design.terms) :])
    estimates = Estimates(state, full, (term,))
    effect = to_effect("effect", term, estimates.coefficient_covariance(0), estimates.parameter_u(0))
    stored = estimates.stored([effect], [])
    u = estimates.term_u(stored)
    found = scores.fitted_machine(machine, full, problem.readings, [effect], u, stored)
    out = {"coefficient": ((np.array(effect.coefficients) - truth.exact) / effect.u).tolist()}
    known = truth.regressor.shape.values
    out["parameter"] = [(effect.shape.values[k] - known[k]) / v for k, v in effect.shape_u.items()]
    size, size_u = estimates.amplitude(0)
    true = replace(term, regressor=truth.regressor, coefficients=np.array(truth.exact))
    out["amplitude"] = [(size - problem.amplitude(true)) / size_u]
    out["declared"] = []
    for t, value, spread in zip(full.design.terms, full.coefficients, u):
        if t.group == "declared" and spread > 0:
            exact = truth.square[t.symbol] if t.symbol in truth.square else truth.functions[t.symbol][t.order]
            out["declared"].append((value - exact) / spread)
    ahead = np.stack([rng.uniform(*truth.machine.travel[k], len(q)) for k in "XYZ"], axis=1)
    fresh = columns | {k: ahead[:, i] for i, k in enumerate("xyz")}
    places = Readings.from_vectors(ahead, np.full_like(ahead, np.nan), fresh)
    z = (predict(found, places) - truth.error(fresh)) / uncertainty(found, places)
    out["prediction"] = z[rng.choice(len(z), FRESH, replace=False)].ravel().tolist()
    return out


# -- the study ---------------------------------------------------------------------------------------------------------
def study(machines: int, seed: int, phis, kinds, tell=print) -> dict:
    """(kind, phi) -> {what: [z], and how many did not count}."""
    found = {}
    for kind in kinds:
        for phi in phis:
            table: dict = {"hidden": 0, "alias": 0, "machines": 0}
            number = seed
            while table["machines"] < machines:
                row = one(number, kind, phi)
                number += 1
                if isinstance(row, str):
                    table[row] += 1
                    continue
                table["machines"] += 1
                for key, z in row.items():
                    table.setdefault(key, []).extend(z)
            found[kind, phi] = table
            tell(line(kind, f"{phi:g}", table))
    return found


WHAT = ("coefficient", "parameter", "amplitude", "declared", "prediction")


def line(kind: str, noise: str, table: dict) -> str:
    """One row of the table: number of values and share within two standard uncertainties."""
    cells = []
    for what in WHAT:
        z = np.abs(np.array(table.get(what, [])))
        cells.append(f"{len(z):6d} {(z < 2).mean():.3f}" if len(z) else " " * 12)
    return f"{kind:10s} {noise:>5s} {table['machines']:6d} {table['hidden']:6d} {table['alias']:5d}  " + "  ".join(
        cells
    )


def pooled(found: dict, kind: str) -> dict:
    """The tables of one kind over all noises, together."""
    out: dict = {}
    for (k, _), table in found.items():
        if k == kind:
            for key, value in table.items():
                out[key] = out.get(key, 0 if isinstance(value, int) else []) + value
    return out


def main(arguments=None) -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--machines", type=int, default=250, help="of each kind and noise")
    parser.add_argument("--seed", type=int, default=700000)
    parser.add_argument("--phi", type=float, nargs="+", default=[0.0, 0.5], help="correlation of successive readings")
    parser.add_argument("--kinds", nargs="+", default=list(KINDS), choices=KINDS)
    given = parser.parse_args(arguments)
    begin = time.process_time()
    heads = "  ".join(f"{w:>12s}" for w in WHAT)
    print(f"{'kind':10s} {'phi':>5s} {'n':>6s} {'hidden':>6s} {'alias':>5s}  {heads}", flush=True)
    found = study(given.machines, given.seed, given.phi, given.kinds, lambda text: print(text, flush=True))
    for kind in given.kinds:
        print(line(kind, "all", pooled(found, kind)))
    print(f"{time.process_time() - begin:.0f} s of processor time; seed {given.seed}, {given.machines} machines each")
    return 0


if __name__ == "__main__":
    sys.exit(main())
