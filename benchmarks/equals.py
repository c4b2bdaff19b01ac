# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which of several equal explanations gets the name: straightness that depends on the place along two axes.

Run `python benchmarks/equals.py --machines 16 --seed 800000`.  Each machine has declared errors drawn from its
tolerances, and one translation of a carriage driven by the product of its own place and that of another axis.  Several
rotations by the same product explain the readings as well, with declared errors far outside their tolerances.  Printed:
the name, its rank among what is listed, and how far the declared errors then lie from the truth.
"""

from __future__ import annotations

import argparse
import json
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT), str(ROOT / "tests")]

import numpy as np  # noqa: E402

from benchmarks import coverage  # noqa: E402
from sensworkbench.closedloop.problem import Problem, State  # noqa: E402
from sensworkbench.closedloop.readings import Readings  # noqa: E402
from sensworkbench.closedloop.trace import trace  # noqa: E402
from sensworkbench.core.shapes import Regressor  # noqa: E402
from sensworkbench.formats import machine_json  # noqa: E402

VISIBLE = 0.05  # share of an effect beside the declared model, below which the machine is drawn again


def crossed(rng) -> tuple[coverage.Truth, dict]:
    """A machine whose carriage moves by k * other, 4 to 10 um at the corners, and the columns of a session on it."""
    truth, columns = coverage.drawn(rng, "linear")
    own = str(rng.choice(list("XYZ")))
    other = str(rng.choice([k for k in "XYZ" if k != own]))
    symbol = f"E{rng.choice(list('XYZ'))}{own}"
    regressor = Regressor.make("*".join(sorted([own.lower(), other.lower()])), "linear")
    corner = truth.machine.travel[own][1] * truth.machine.travel[other][1]
    size = rng.uniform(4e-3, 10e-3) * rng.choice([-1.0, 1.0]) / corner
    return coverage.Truth(truth.machine, truth.functions, truth.square, symbol, regressor, (float(size),)), columns


def alike(name: tuple) -> tuple:
    """A name without its body where the body makes no difference: translations along one axis."""
    symbol, driver, shape = name
    return (symbol[:2] if symbol[1] in "XYZ" else symbol), driver, shape


def one(seed: int) -> dict | None:
    """Name, rivals, and the distance of the declared errors from the truth, of one machine; None: hidden."""
    rng = np.random.default_rng(seed)
    truth, columns = crossed(rng)
    q = np.stack([columns[k] for k in "xyz"], axis=1)
    error = truth.error(columns) + coverage.SIGMA * rng.normal(size=q.shape)
    machine = machine_json.loads(json.dumps(truth.machine.as_dict()))
    readings = Readings.from_vectors(q, error, columns)
    if coverage.visible(State(Problem(machine, readings)), truth, columns)[0] < VISIBLE:
        return None
    result = trace(machine, readings, seed=1)
    far = {}
    for symbol, series in result.machine.fitted.series.items():
        for order, (value, u) in enumerate(zip(series.coefficients, series.u)):
            if u is not None and u > 0:
                off = value - truth.functions[symbol][order]
                far[f"{symbol} P{order}"] = (off / coverage.limit(symbol), off)
    worst = max(far, key=lambda k: abs(far[k][0]), default="")
    own = (truth.symbol, *truth.regressor.key)
    names = [(e.effect.component, str(e.effect.driver), e.effect.shape.name) for e in result.effects]
    rivals = [(r.component, r.driver, r.shape) for e in result.effects for r in e.rivals]
    return {
        "truth": " ".join(own),
        "verdict": result.verdict,
        "names": [" ".join(n) for n in names],
        "right": [alike(n) for n in names] == [alike(own)],
        "worst": worst,
        "worst_limits": far[worst][0] if worst else 0.0,
        "off": 1e6 * far[worst][1] * (1e-3 if worst[1:2] in "XYZ" else 1.0) if worst else 0.0,
        "listed": own in [*names, *rivals],
    }


def main(arguments=None) -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--machines", type=int, default=16)
    parser.add_argument("--seed", type=int, default=800000)
    given = parser.parse_args(arguments)
    begin, found, seed = time.process_time(), [], given.seed
    while len(found) < given.machines:
        row, seed = one(seed), seed + 1
        if row is None:
            continue
        found.append(row)
        kind = "right" if row["right"] else "rival" if row["listed"] else "wrong"
        print(
            f"{row['truth']:17s} {row['verdict']:18s} {kind:5s}  {row['worst']:7s} off by {row['off']:7.2f} "
            f"({row['worst_limits']:6.2f} limits)  {'; '.join(row['names'])}",
            flush=True,
        )
    far = np.array([abs(r["worst_limits"]) for r in found])
    print(
        f"{sum(r['right'] for r in found)} of {len(found)} right; largest error of a declared coefficient, in limits: "
        f"median {np.median(far):.2f}, largest {far.max():.2f}"
    )
    print(f"{time.process_time() - begin:.0f} s of processor time; seed {given.seed}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
