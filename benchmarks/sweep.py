# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sweeps: the cost of one variant, of handing out a chunk, and what two processes gain over one.

    python -m benchmarks.sweep [--variants N]

Processor times do not depend much on what else the machine does; the efficiency of two workers does: run it on a quiet
machine.
"""

from __future__ import annotations

import argparse
import multiprocessing
import pickle
import statistics
import time
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from pathlib import Path

from sensworkbench.formats import machine_json, sweep_files
from sensworkbench.studies.sweep import CHUNK, FileJudge, Parameter, Sweep, run_sweep

EXAMPLE = Path(__file__).resolve().parents[1] / "resources" / "examples" / "vertical_machining_centre.json"


def sweep_of(count: int) -> Sweep:
    machine = machine_json.load(EXAMPLE)
    data = machine_json.to_dict(replace(machine, version=2, tolerances=machine.all_tolerances))
    parameters = tuple(Parameter(f"joints.{n}.point.2", (), -200.0, 900.0) for n in "XYZ")
    return Sweep(data, parameters, "lhs", count, 1, ("rms", "worst_rms", "share.X"))


def judge_of(sweep: Sweep) -> FileJudge:
    return FileJudge(sweep_files.machine_of, sweep.data, sweep.paths, sweep.outputs)


def wall(sweep: Sweep, executor=None, workers: int = 1) -> float:
    start = time.perf_counter()
    for _ in run_sweep(sweep, judge_of(sweep), executor, workers):
        pass
    return time.perf_counter() - start


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--variants", type=int, default=2000)
    count = parser.parse_args().variants
    sweep = sweep_of(count)
    judge = judge_of(sweep)
    rows = list(sweep.variants())[:200]
    start = time.process_time()
    judge(rows)
    each = (time.process_time() - start) / len(rows)
    print(f"one variant: {1e3 * each:.2f} ms of processor time")
    task = len(pickle.dumps((judge, rows[:CHUNK])))
    answer = len(pickle.dumps(judge(rows[:CHUNK])))
    print(f"a chunk of {CHUNK} variants: {task:,} bytes out, {answer:,} bytes back")
    start = time.process_time()
    for _ in range(200):
        pickle.loads(pickle.dumps((judge, rows[:CHUNK])))
    print(f"packing and unpacking a chunk: {1e3 * (time.process_time() - start) / 200:.2f} ms")
    context = multiprocessing.get_context("spawn")
    ratios = []
    for _ in range(3):
        with ProcessPoolExecutor(2, mp_context=context) as pool:
            wall(sweep_of(200), pool, 2)  # the workers have started and imported
            two = wall(sweep, pool, 2)
        with ProcessPoolExecutor(1, mp_context=context) as pool:
            wall(sweep_of(200), pool, 1)
            one = wall(sweep, pool, 1)
        ratios.append(one / two / 2)
        print(f"{count} variants: one worker {one:.1f} s, two {two:.1f} s, efficiency {ratios[-1]:.0%}")
    print(f"median efficiency of two workers: {statistics.median(ratios):.0%}")
    try:
        from distributed import Client, LocalCluster
    except ImportError:
        return
    with LocalCluster(1, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
        client.gather(client.map(abs, range(2000), pure=False))
        start = time.perf_counter()
        client.gather(client.map(abs, range(2000, 4000), pure=False))
        print(
            f"Dask: {1e3 * (time.perf_counter() - start) / 2000:.2f} ms per empty task, scheduler and worker together"
        )


if __name__ == "__main__":
    main()
