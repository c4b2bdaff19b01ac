# SPDX-License-Identifier: LGPL-2.1-or-later
"""How fast a trace is: the scan against refitting every candidate, a whole trace, and 100,000 readings in memory.

Run `python benchmarks/scan.py` (or `python -m benchmarks.scan`); `--parts scan trace sizes`, `--sizes 500 5000`.  Each
part and size runs in its own process on `--threads` threads (default 2), so that peak memory does not mix.  A reading
is a vector of three displacements: 1,000 readings are 3,000 rows.

scan: all candidates scored beside the declared model, then again under 999 sign flips of whole blocks.  The refit is
`numpy.linalg.lstsq` of the declared model with and without the candidate, on a sample of the same candidates in the
same run, times their number; both give the same gains, which is checked.  The ratio is without sign flips on either
side; with them, every flip would be a refit too.
trace: the whole of `closedloop.trace`, 199 and 999 sign flips.
sizes: the whole trace of 500, 5,000, 50,000 and 100,000 readings: wall and processor time, time per reading, peak
memory, and the ratio to one `numpy.linalg.lstsq` of the declared model on the same readings in the same process, which
finds no noise, no outlier and no effect.
"""

from __future__ import annotations

import argparse
import json
import os
import resource
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))
AIMS = {
    "scan with 999 flips, s": ("scan", "with_flips_s", 10.0),
    "times refitting": ("scan", "ratio", 200.0),
    "candidates": ("scan", "candidates", 10_000),
    "whole trace, s": ("trace", "seconds", 60.0),
    "500 readings, s": ("500", "seconds", 5.0),
    "100,000 readings, s": ("100000", "seconds", 60.0),
    "100,000: peak MiB": ("100000", "peak_mib", 1536.0),
}
NOISE = 0.4e-3  # mm


def measured(count: int, seed: int = 7):
    """Machine and readings at random places of a session: declared errors, a bending column and noise."""
    import numpy as np

    from sensworkbench.closedloop.readings import Readings
    from sensworkbench.formats import machine_json
    from tests.simulator import kinematics, plans
    from tests.simulator.effects import driver_table

    rng = np.random.default_rng(seed)
    travel = {k: (-300.0, 300.0) for k in "XYZ"}
    reference = {"X": (30.0, -180.0, 200.0), "Y": (-60.0, -200.0, 100.0), "Z": (15.0, 100.0, 600.0)}
    simulated = kinematics.Machine("XYFZ", reference, travel, (10.0, -20.0, 400.0))
    machine = machine_json.loads(json.dumps(simulated.as_dict()))
    q = plans.places("random", travel, rng, count)
    columns = driver_table(plans.conditions(count, rng, spindle=True) | plans.vary(count, rng, True))
    columns |= {f"dir_{k}": v for k, v in zip("xyz", plans.directions(q).T)}
    heights = {f"E{m}{k}": rng.normal(size=4) * (1.2e-3 if m in "XYZ" else 6e-6) for k in "XYZ" for m in "XYZABC"}
    error = np.empty_like(q)
    for begin in range(0, count, 5000):
        part = slice(begin, begin + 5000)
        values = {"C0Y": 12e-6, "B0Z": -9e-6, "A0Z": 7e-6}
        for name, h in heights.items():
            values[name] = np.polynomial.legendre.legval(q[part, "XYZ".index(name[2])] / 300, h)
        values["EAZ"] = values["EAZ"] + 5e-6 * columns["temp_column"][part]
        error[part] = kinematics.exact_error(simulated, q[part], values)
    return machine, Readings.from_vectors(q, error + NOISE * rng.normal(size=q.shape), columns)


def peak_mib() -> float:
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return peak / (2**20 if sys.platform == "darwin" else 2**10)


# -- parts -----------------------------------------------------------------------------------------------------------
def scan(count: int, flips: int, sample: int) -> dict:
    """Times of the scan and of refitting a sample of its candidates, s."""
    import numpy as np

    from sensworkbench.closedloop.problem import Problem, State
    from sensworkbench.closedloop.scan import exact_gain
    from sensworkbench.closedloop.settings import DEFAULT

    machine, readings = measured(count)
    problem = Problem(machine, readings, permutations=flips)
    state = State(problem)
    fitted = state.fit_with([])
    rows = state.rows(fitted)
    seconds = []
    for _ in range(3):
        begin = time.perf_counter()
        scanner = state.scanner(rows)
        scores = scanner.scores()
        seconds.append(time.perf_counter() - begin)
    begin = time.perf_counter()
    scanner.null_maxima(state.signs)
    flipping = time.perf_counter() - begin
    candidates = scores.gain.size

    weighted = problem.design.matrix * fitted.weight[:, None]
    weighted = weighted / np.maximum(np.linalg.norm(weighted, axis=0), 1e-300)
    y = readings.value * fitted.weight

    def left(x) -> float:
        return float(((y - x @ np.linalg.lstsq(x, y, rcond=1e-9)[0]) ** 2).sum())

    without = left(weighted)
    rng = np.random.default_rng(1)
    drawn, refit, worst = 0, 0.0, 0.0
    while drawn < sample:
        k, g = int(rng.integers(len(problem.bank))), int(rng.integers(len(problem.component_indices)))
        if scores.visible[k, g] <= DEFAULT.scan_visible:
            continue
        begin = time.perf_counter()
        vectors = problem.bank[k].vectors(readings.columns)
        column = (
            problem.design.lever[:, [problem.component_indices[g]]] * vectors[readings.point] * fitted.weight[:, None]
        )
        gain = without - left(np.hstack([weighted, column / np.linalg.norm(column, axis=0)]))
        refit += time.perf_counter() - begin
        scored = exact_gain(rows, problem.component_indices[g], vectors)[0]
        worst = max(worst, abs(gain - scored) / max(gain, 1.0))
        drawn += 1
    once = sorted(seconds)[1]
    return {
        "readings": count,
        "rows": readings.rows,
        "candidates": candidates,
        "components": len(problem.component_indices),
        "drivers_and_shapes": len(problem.bank),
        "scan_s": once,
        "flips": flips,
        "with_flips_s": once + flipping,
        "refit_each_s": refit / sample,
        "ratio": refit / sample * candidates / once,
        "ratio_with_flips": refit / sample * candidates * (1 + flips) / (once + flipping),
        "largest_difference": worst,
    }


def traced(count: int, flips: int) -> dict:
    """Time and peak memory of a whole trace."""
    from sensworkbench.closedloop.trace import trace

    machine, readings = measured(count)
    before = peak_mib()
    stages = []
    begin, worked = time.perf_counter(), time.process_time()

    def tell(fraction, words):
        stages.append([round(time.perf_counter() - begin, 2), words])
        return True

    outcome = trace(machine, readings, seed=1, permutations=flips, progress=tell)
    return {
        "readings": count,
        "flips": flips,
        "seconds": time.perf_counter() - begin,
        "processor_s": time.process_time() - worked,
        "before_mib": before,
        "peak_mib": peak_mib(),
        "stages": stages,
        "verdict": outcome.verdict,
        "effects": [[e.effect.component, str(e.effect.driver), e.effect.shape.name] for e in outcome.effects],
    }


def beside_lstsq(count: int) -> dict:
    """A whole trace, and then one least squares fit of the declared model by numpy on the same readings."""
    import numpy as np

    from sensworkbench.closedloop.design import design

    found = traced(count, 199)
    machine, readings = measured(count)
    matrix = design(machine, readings).matrix
    size = np.maximum(np.linalg.norm(matrix, axis=0), 1e-300)
    begin = time.perf_counter()
    np.linalg.lstsq(matrix / size, readings.value, rcond=1e-9)
    return found | {"lstsq_s": time.perf_counter() - begin}


def run_part(name: str, options) -> dict:
    if name == "scan":
        return scan(options.readings, options.flips, options.sample)
    if name == "trace":
        found = traced(options.readings, 199)
        return found | {"with_999_flips_s": traced(options.readings, 999)["seconds"]}
    return beside_lstsq(options.sizes[0])


def report(name: str, found: dict) -> list[str]:
    """What a part measured, as lines of text."""
    if name == "scan":
        return [
            f"scan: {found['readings']:,} readings ({found['rows']:,} rows), {found['candidates']:,} candidates "
            f"({found['drivers_and_shapes']:,} drivers and shapes on {found['components']} motions)",
            f"  all scored once          {found['scan_s']:9.3f} s",
            f"  and under {found['flips']} sign flips {found['with_flips_s']:9.3f} s",
            f"  lstsq, each candidate    {found['refit_each_s'] * 1e3:9.3f} ms (gains agree to "
            f"{found['largest_difference']:.0e})",
            f"  ratio to refitting       {found['ratio']:9.0f}   (with sign flips on both sides "
            f"{found['ratio_with_flips']:,.0f})",
        ]
    names = ", ".join(" ".join(e) for e in found["effects"]) or "nothing named"
    if "lstsq_s" in found:
        return [
            f"{found['readings']:>8,} readings {found['seconds']:8.1f} s ({found['processor_s']:.1f} s of processors) "
            f"{1e3 * found['seconds'] / found['readings']:7.2f} ms each, peak {found['peak_mib']:,.0f} MiB, "
            f"{found['seconds'] / found['lstsq_s']:,.0f} times lstsq ({found['lstsq_s']:.3f} s); "
            f"{found['verdict']}: {names}"
        ]
    lines = [
        f"{name}: {found['readings']:,} readings: {found['seconds']:.1f} s, peak {found['peak_mib']:.0f} MiB "
        f"(before it {found['before_mib']:.0f}), {found['verdict']}: {names}"
    ]
    if "with_999_flips_s" in found:
        lines.append(f"  with 999 sign flips {found['with_999_flips_s']:.1f} s")
    return lines + [f"  {s:8.1f} s  {words}" for s, words in found["stages"]]


def main(argv=None) -> int:
    """Run the parts, each in its own process, and hold them against the aims."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--parts", nargs="*", default=["scan", "trace", "sizes"], choices=["scan", "trace", "sizes"])
    parser.add_argument("--readings", type=int, default=1000)
    parser.add_argument("--sizes", type=int, nargs="*", default=[500, 5000, 50_000, 100_000])
    parser.add_argument("--flips", type=int, default=999)
    parser.add_argument("--sample", type=int, default=60, help="candidates refitted")
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--json", action="store_true", help="one part, as JSON (used by the parent process)")
    options = parser.parse_args(argv)
    if options.json:
        print(json.dumps(run_part(options.parts[0], options)))
        return 0
    numbers = [f"--{n}={getattr(options, n)}" for n in ("readings", "flips", "sample")]
    threads = {f"{k}_NUM_THREADS": str(options.threads) for k in ("OMP", "OPENBLAS", "MKL", "VECLIB_MAXIMUM")}
    results = {}
    jobs = [(p, p, []) for p in options.parts if p != "sizes"]
    jobs += [("sizes", str(s), ["--sizes", str(s)]) for s in options.sizes if "sizes" in options.parts]
    for part, name, more in jobs:
        line = [sys.executable, str(Path(__file__).resolve()), "--json", "--parts", part, *numbers, *more]
        done = subprocess.run(line, env=os.environ | threads, capture_output=True, text=True, check=False)
        if done.returncode:
            print(f"{name}: failed\n{done.stderr.strip().splitlines()[-1] if done.stderr.strip() else done.returncode}")
            continue
        results[name] = json.loads(done.stdout.splitlines()[-1])
        print("\n".join(report(part, results[name])), flush=True)
    print()
    met = len(results) == len(jobs)
    for words, (part, key, aim) in AIMS.items():
        if part in results:
            value = results[part][key]
            good = value >= aim if words in ("times refitting", "candidates") else value <= aim
            met &= good
            print(
                f"{words:26s} {value:12,.1f}   aim {'>=' if aim in (200.0, 10_000) else '<='} {aim:,.0f}   "
                f"{'met' if good else 'missed'}"
            )
    return 0 if met else 1


if __name__ == "__main__":
    sys.exit(main())
