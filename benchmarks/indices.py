# SPDX-License-Identifier: LGPL-2.1-or-later
"""How fast the exact indices are: against OpenTURNS and SALib at their own accuracy, and against the memory floor.

Run `python benchmarks/indices.py` (or `python -m benchmarks.indices`).  Each part runs in its own process on one
thread, so that peak memory and import costs do not mix.  Times are medians over repetitions.

million: 24 errors at 10^6 positions (float64 Omega of 10^6 x 3 x 24, laid out as `synthesis.omega` makes it).  The
floor, measured in turn with it, reads all of Omega once (a sum) and writes two new arrays of 10^6 x 24.
openturns: degree-2 polynomial chaos by least squares, exact for a quadratic form up to rounding;
with two points for each of its 325 terms (the usual advice is two to three; the aim is judged there) and, shown beside
it, with hardly more points than terms, the least that can work.
salib: Saltelli's scheme with first and total indices; its error is sampling error.
"""

from __future__ import annotations

import argparse
import json
import os
import resource
import statistics
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))
ONE_THREAD = {f"{k}_NUM_THREADS": "1" for k in ("OMP", "OPENBLAS", "MKL", "VECLIB_MAXIMUM")} | {
    "OPENTURNS_NUM_THREADS": "1"
}
AIMS = {"times OpenTURNS, per position": 200_000, "times the floor": 6.0, "peak MiB": 1024.0}


def machine():
    """The C-frame machining centre of `paper_comparison`, with the paper's tolerances: 24 errors."""
    from benchmarks.paper_comparison import machine as built

    return built("direction")


def problem():
    """(Omega (3, 24) at one position, its 24 tolerances)."""
    from sensworkbench.core import synthesis

    m = machine()
    table = m.all_tolerances
    return synthesis.omega(m, list(table), (120.0, -90.0, 60.0))[0], list(table.values())


def timed(function, repetitions: int):
    """(median seconds, last result) after one call that warms caches."""
    result, seconds = function(), []
    for _ in range(repetitions):
        start = time.perf_counter()
        result = function()
        seconds.append(time.perf_counter() - start)
    return statistics.median(seconds), result


# -- parts ----------------------------------------------------------------------------------------------------------
def million(positions: int, repetitions: int) -> dict:
    import numpy as np

    from sensworkbench.core import sobol, synthesis
    from sensworkbench.core.distributions import moments

    m = machine()
    symbols = list(m.all_tolerances)
    law = moments(m.all_tolerances.values())
    storage = np.empty((3, len(symbols), positions))
    rng = np.random.default_rng(1)
    low, high = m.travel.T
    for start in range(0, positions, 10_000):
        q = rng.uniform(low, high, (min(10_000, positions - start), 3))
        storage[:, :, start : start + len(q)] = synthesis.omega(m, symbols, q).transpose(1, 2, 0)
    omega = storage.transpose(2, 0, 1)
    before = peak_mib()

    def floor():
        total = storage.sum()
        first, second = np.empty(storage.shape[1:]), np.empty(storage.shape[1:])
        first.fill(total)
        second.fill(total)

    floors, ours = [], []
    for repetition in range(repetitions + 1):
        start = time.perf_counter()
        floor()
        between = time.perf_counter()
        found = sobol.indices(omega, law)
        end = time.perf_counter()
        if repetition:  # the first of each pays for memory that the process never had
            floors.append(between - start)
            ours.append(end - between)
        checked = float(found.first.sum() + found.total.sum()) / positions  # each position: 2, exactly
        del found
    return {
        "seconds": statistics.median(ours),
        "floor_seconds": statistics.median(floors),
        "ratio": statistics.median([a / b for a, b in zip(ours, floors)]),
        "peak_mib": peak_mib(),
        "omega_peak_mib": before,
        "positions": positions,
        "check": checked - 2,
    }


def peak_mib() -> float:
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return peak / (2**20 if sys.platform == "darwin" else 2**10)


def exact_values():
    from sensworkbench.core import sobol
    from sensworkbench.core.distributions import moments

    omega, tolerances = problem()
    found = sobol.indices(omega, moments(tolerances))
    return found.first[0], found.total[0]


def scaled_problem():
    """The same problem with unit inputs and the error in um, which suits the samplers best."""
    import numpy as np

    omega, tolerances = problem()
    return omega * np.array([t.upper for t in tolerances]) * 1e3


def openturns(repetitions: int) -> dict:
    import numpy as np
    import openturns as ot

    omega = scaled_problem()
    n = omega.shape[1]
    ot.Log.Show(ot.Log.NONE)
    ot.TBB.SetThreadsNumber(1)
    law = ot.JointDistribution([ot.Uniform(-1.0, 1.0)] * n)
    enumerate_ = ot.LinearEnumerateFunction(n)
    terms = enumerate_.getStrataCumulatedCardinal(2)

    def run(points):
        basis = ot.OrthogonalProductPolynomialFactory([ot.LegendreFactory()] * n, enumerate_)
        x = law.getSample(points)
        y = ot.Sample(((np.array(x) @ omega.T) ** 2).sum(axis=1)[:, None])
        fixed, least_squares = ot.FixedStrategy(basis, terms), ot.LeastSquaresStrategy()
        chaos = ot.FunctionalChaosAlgorithm(x, y, law, fixed, least_squares)
        chaos.run()
        indices = ot.FunctionalChaosSobolIndices(chaos.getResult())
        first = [indices.getSobolIndex(i) for i in range(n)]
        return np.array([first, [indices.getSobolTotalIndex(i) for i in range(n)]])

    found = {}
    for key, points in (("advised", 2 * terms), ("fewest", terms + 25)):
        seconds, values = timed(lambda points=points: run(points), repetitions)
        found[key] = {"seconds": seconds, "error": float(np.abs(values - np.array(exact_values())).max())}
    return found


def salib(repetitions: int, samples: int = 2**13) -> dict:
    import numpy as np
    from SALib.analyze import sobol as analyze
    from SALib.sample import sobol as sample

    omega = scaled_problem()
    n = omega.shape[1]
    box = {"num_vars": n, "names": [f"X{i}" for i in range(n)], "bounds": [[-1.0, 1.0]] * n}

    def run():
        x = sample.sample(box, samples, calc_second_order=False, seed=1)
        y = ((x @ omega.T) ** 2).sum(axis=1)
        return analyze.analyze(box, y, calc_second_order=False, num_resamples=2, seed=1)

    seconds, found = timed(run, repetitions)
    error = np.abs(np.array([found["S1"], found["ST"]]) - np.array(exact_values())).max()
    return {"seconds": seconds, "error": float(error)}


def rounding() -> float:
    """Largest difference of our indices from the decomposition written out in exact fractions."""
    from fractions import Fraction

    omega, tolerances = problem()
    rows = [[Fraction(float(v)) for v in row] for row in omega]
    half = [Fraction(float(t.upper)) for t in tolerances]
    n = len(half)
    a = [[sum(row[i] * row[j] for row in rows) for j in range(n)] for i in range(n)]
    single = [Fraction(4, 45) * a[i][i] ** 2 * half[i] ** 4 for i in range(n)]
    pair = [
        [Fraction(4, 9) * (a[i][j] * half[i] * half[j]) ** 2 if i != j else Fraction(0) for j in range(n)]
        for i in range(n)
    ]
    v = sum(single) + sum(map(sum, pair)) / 2
    first, total = exact_values()
    return max(
        max(abs(float(single[i] / v) - first[i]), abs(float((single[i] + sum(pair[i])) / v) - total[i]))
        for i in range(n)
    )


# -- the table ------------------------------------------------------------------------------------------------------
def in_a_process(part: str, arguments) -> dict:
    command = [sys.executable, __file__, "--part", part, "--positions", str(arguments.positions)]
    command += ["--repetitions", str(arguments.repetitions)]
    done = subprocess.run(command, env=os.environ | ONE_THREAD, capture_output=True, text=True, check=False)
    if done.returncode:
        return {"missing": done.stderr.strip().splitlines()[-1] if done.stderr.strip() else f"exit {done.returncode}"}
    return json.loads(done.stdout.splitlines()[-1])


def table(parts: dict) -> tuple[str, bool]:
    """(text, whether every aim that could be measured was met)."""
    ours = parts["million"]
    if "missing" in ours:
        return f"the measurement failed: {ours['missing']}", False
    each = ours["seconds"] / ours["positions"]
    lines = [
        "First and total indices of 24 errors, exact; one thread; medians",
        "",
        f"{'':24}{'time per position':>20}{'largest error':>16}{'ours is faster by':>20}",
        f"{'this workbench':24}{each * 1e6:17.3f} us{parts['rounding']['error']:16.1e}{'':>20}",
    ]
    met = []
    chaos, saltelli = parts["openturns"], parts["salib"]
    others = [
        ("OpenTURNS, 650 points", chaos.get("advised", chaos)),
        ("OpenTURNS, 350 points", chaos.get("fewest", chaos)),
        ("SALib, Saltelli 2^13", saltelli),
    ]
    for title, other in others:
        if "missing" in other:
            lines.append(f"{title:24}  not measured: {other['missing']}")
            continue
        ratio = other["seconds"] / each
        lines.append(f"{title:24}{other['seconds'] * 1e3:17.1f} ms{other['error']:16.1e}{ratio:19,.0f}x")
    if "advised" in chaos:
        ratio = chaos["advised"]["seconds"] / each
        met.append(("times OpenTURNS, per position", ratio, ratio >= AIMS["times OpenTURNS, per position"]))
    count = ours["positions"]
    lines += [
        "",
        f"{count:,} positions x 24 errors ({count * 3 * 24 * 8 / 2**20:.0f} MiB of Omega)",
        f"{'indices':24}{ours['seconds']:18.3f} s",
        f"{'floor: read, write':24}{ours['floor_seconds']:18.3f} s",
        f"{'times the floor':24}{ours['ratio']:20.2f}",
        f"{'peak memory':24}{ours['peak_mib']:17.0f} MiB",
        f"{'sum of S + S^T less 2':24}{ours['check']:20.1e}",
        "",
    ]
    met.append(("times the floor", ours["ratio"], ours["ratio"] <= AIMS["times the floor"]))
    met.append(("peak MiB", ours["peak_mib"], ours["peak_mib"] <= AIMS["peak MiB"]))
    for what, value, good in met:
        sign = ">=" if what.startswith("times Open") else "<="
        lines.append(f"aim {sign} {AIMS[what]:>9,.0f} {what}: {value:,.1f}  {'met' if good else 'NOT MET'}")
    return "\n".join(lines), all(good for _, _, good in met)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--positions", type=int, default=1_000_000)
    parser.add_argument("--repetitions", type=int, default=7)
    parser.add_argument("--part", choices=("million", "openturns", "salib", "rounding"), help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.part:
        found = {
            "million": lambda: million(arguments.positions, arguments.repetitions),
            "openturns": lambda: openturns(arguments.repetitions),
            "salib": lambda: salib(min(3, arguments.repetitions)),
            "rounding": lambda: {"error": rounding()},
        }[arguments.part]()
        print(json.dumps(found))
        return 0
    parts = {part: in_a_process(part, arguments) for part in ("million", "openturns", "salib", "rounding")}
    text, met = table(parts)
    print(text)
    return 0 if met else 1


if __name__ == "__main__":
    sys.exit(main())
