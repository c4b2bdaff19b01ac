# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sweeps: the cost of one variant, of handing out a chunk, and what two processes gain over one.

    python -m benchmarks.sweep [--variants N] [--cheap]

Processor times do not depend much on what else the machine does; the efficiency of two workers does: it needs two
processor cores that nothing else uses, and about a minute and a half.  --cheap leaves it and Dask out.
"""

from __future__ import annotations

import argparse
import multiprocessing
import pickle
import statistics
import tempfile
import time
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from pathlib import Path

from sensworkbench.formats import machine_json, sweep_files, sweep_run
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
    chunk = sweep_run.chunk_of(sweep.size(), workers)
    for _ in run_sweep(sweep, judge_of(sweep), executor, workers, chunk=chunk):
        pass
    return time.perf_counter() - start


def kept(judged, count: int) -> None:
    """What one row costs the program that started the sweep: written as it comes back, read again for the page."""
    sweep = sweep_of(count)
    with tempfile.TemporaryDirectory() as place:
        path = Path(place, sweep_files.PARTIAL)
        start = time.process_time()
        with path.open("w", encoding="utf-8", newline="\n") as stream:
            stream.write("#\n")
            for number in range(count):
                values, (outputs, words) = judged[number % len(judged)]
                stream.write(sweep_files.line(sweep, number, values, outputs, words))
                stream.flush()
        written = time.process_time() - start
        size = path.stat().st_size
        start = time.process_time()
        sweep_files.summary(sweep, path)
        read = time.process_time() - start
    each = [1e6 * t / count for t in (written, read)]
    print(f"one row: {each[0]:.0f} us to write, {size / count:.0f} bytes, {each[1]:.0f} us to read for front and page")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--variants", type=int, default=2000)
    parser.add_argument("--cheap", action="store_true", help="processor times only")
    arguments = parser.parse_args()
    count = arguments.variants
    sweep = sweep_of(count)
    judge = judge_of(sweep)
    rows = list(sweep.variants())[:200]
    start = time.process_time()
    judge(rows)
    each = (time.process_time() - start) / len(rows)
    print(f"one variant: {1e3 * each:.2f} ms of processor time")
    answers = judge(rows)
    for size in (CHUNK, 125):
        task, answer = (judge, rows[:size]), answers[:size]
        sizes = [len(pickle.dumps(data)) for data in (task, answer)]
        start = time.process_time()
        for _ in range(200):
            pickle.loads(pickle.dumps(task))
            pickle.loads(pickle.dumps(answer))
        each = 1e3 * (time.process_time() - start) / 200
        print(
            f"a chunk of {size} variants: {sizes[0]:,} bytes out, {sizes[1]:,} bytes back; {each:.2f} ms to pack both"
        )
    kept(list(zip(rows, answers)), 20_000)
    if arguments.cheap:
        return
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
