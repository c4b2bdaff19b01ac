# SPDX-License-Identifier: LGPL-2.1-or-later
"""`sweep`: the same bytes whoever judges the variants, also after a kill; failures stand in their place."""

from __future__ import annotations

import csv
import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from sensworkbench import cli
from sensworkbench.core import workspace
from sensworkbench.core.refusal import Refused
from sensworkbench.formats import machine_json, sweep_files

ROOT = Path(__file__).resolve().parents[2]
MACHINE = ROOT / "resources" / "examples" / "vertical_machining_centre.json"
PARAMETERS = [
    {"path": "joints.Z.point.2", "range": [100, 900, 5]},
    {"path": "axes.Y.travel.1", "values": [-1e6, 200.0, 260.0]},  # the first is no travel: these variants are refused
    {"path": "tolerances.EAX.upper", "values": [20, 30]},
]
OUTPUTS = ["mean_square", "rms", "worst_rms", "share.X", "total.EAX", "first.W"]


def spec(tmp_path, **changes) -> Path:
    data = {"machine": str(MACHINE), "parameters": PARAMETERS, "design": "full", "outputs": OUTPUTS} | changes
    path = tmp_path / "spec.json"
    path.write_text(json.dumps({k: v for k, v in data.items() if v is not None}), encoding="utf-8")
    return path


def swept(path, out, *options) -> bytes:
    assert cli.main(["sweep", str(path), "--out", str(out), *options]) == 0
    assert not (out / "results.partial.csv").exists()
    return (out / "results.csv").read_bytes()


def rows(content: bytes) -> list[dict]:
    return list(csv.DictReader(content.decode().splitlines()))


def test_every_variant_is_a_row_in_order_and_says_what_a_sensitivity_of_it_says(tmp_path):
    found = rows(swept(spec(tmp_path), tmp_path / "out"))
    assert [int(r["variant"]) for r in found] == list(range(30))
    assert sum(bool(r["refused"]) for r in found) == 10 and "travel" in found[0]["refused"]
    row = next(r for r in found if not r["refused"])
    data = machine_json.to_dict(machine_json.load(MACHINE))
    data["axes"]["Z"]["reference"][2] = float(row["joints.Z.point.2"])
    data["axes"]["Y"]["travel"][1] = float(row["joints.Y.travel.1"])
    data["tolerances"]["EAX"]["upper"] = float(row["tolerances.EAX.upper"])
    alone = workspace.sensitivity(machine_json.loads(json.dumps(data)), estimate=False)
    assert float(row["mean_square"]) == pytest.approx(alone.mean_square * 1e6, rel=1e-12)
    assert float(row["share.X"]) == pytest.approx(alone.component_share[alone.bodies.index("X")], rel=1e-12)
    assert float(row["total.EAX"]) == pytest.approx(alone.total[alone.symbols.index("EAX")], rel=1e-12)


def test_two_workers_write_the_same_bytes(tmp_path):
    path = spec(tmp_path)
    assert swept(path, tmp_path / "two", "--workers", "2") == swept(path, tmp_path / "one")


@pytest.mark.parametrize("design", ["lhs", "sobol"])
def test_sampled_designs_fill_their_ranges_and_repeat(tmp_path, design):
    parameters = [{"path": "joints.Z.point.2", "range": [0, 800]}, {"path": "tool_point.2", "range": [-100, 100]}]
    path = spec(tmp_path, design=design, n=32, seed=5, parameters=parameters, outputs=["rms"])
    content = swept(path, tmp_path / "a")
    assert content == swept(path, tmp_path / "b")
    values = sorted(float(r["joints.Z.point.2"]) for r in rows(content))
    assert [int(v / 25) for v in values] == list(range(32))  # one in every thirty-second part of the range


def test_a_list_pairs_its_values(tmp_path):
    parameters = [{"path": "tool_point.2", "values": [0, 1]}, {"path": "joints.X.point.0", "values": [5, 6]}]
    found = rows(swept(spec(tmp_path, design="list", parameters=parameters, outputs=["rms"]), tmp_path / "out"))
    assert [(r["tool_point.2"], r["joints.X.point.0"]) for r in found] == [("0.0", "5.0"), ("1.0", "6.0")]


def test_a_killed_sweep_goes_on_and_nothing_is_lost_or_doubled(tmp_path):
    path = spec(
        tmp_path, parameters=[{"path": "joints.Z.point.2", "range": [100, 900, 400]}], outputs=["rms", "share.Z"]
    )
    whole, out = swept(path, tmp_path / "whole"), tmp_path / "cut"
    command = [sys.executable, "-m", "sensworkbench", "sweep", str(path), "--out", str(out)]
    process = subprocess.Popen(command, cwd=ROOT, stdout=subprocess.DEVNULL)
    partial = out / "results.partial.csv"
    deadline = time.monotonic() + 60
    while not (partial.is_file() and partial.stat().st_size > 1500) and time.monotonic() < deadline:
        time.sleep(0.01)
    process.send_signal(signal.SIGKILL)
    process.wait()
    if partial.exists():  # unless it was faster
        text = partial.read_text(encoding="utf-8")
        partial.write_text(text[:-7], encoding="utf-8")  # the last line half written
        assert not (out / "results.csv").exists()
    assert swept(path, out, "--resume") == whole


def test_what_another_sweep_left_is_not_taken_for_ones_own(tmp_path):
    first = sweep_files.load(spec(tmp_path))
    out = tmp_path / "out"
    out.mkdir()
    (out / "results.partial.csv").write_text(f"# {sweep_files.identity(first)}\n0,1\n", encoding="utf-8")
    with pytest.raises(Refused) as refused:
        sweep_files.kept(out, sweep_files.load(spec(tmp_path, outputs=["rms"])))
    assert refused.value.code == "sweep-other"


BAD = {
    "a path that is not there": ({"parameters": [{"path": "joints.Q.point.2", "values": [1]}]}, "sweep-path"),
    "a path to a text": ({"parameters": [{"path": "name", "values": [1]}]}, "sweep-no-number"),
    "values and a range": ({"parameters": [{"path": "tool_point.0", "values": [1], "range": [0, 1, 2]}]},
                           "sweep-values-or-range"),
    "an empty range": ({"parameters": [{"path": "tool_point.0", "range": [1, 1, 2]}]}, "sweep-range"),
    "values of a sampled design": ({"parameters": [{"path": "tool_point.0", "values": [1]}], "design": "lhs", "n": 4},
                                   "sweep-range-wanted"),
    "a sampled design without a number": ({"parameters": [{"path": "tool_point.0", "range": [0, 1]}], "design": "lhs"},
                                          "sweep-without-count"),
    "lists of unequal length": ({"parameters": [{"path": "tool_point.0", "values": [1]},
                                                {"path": "tool_point.1", "values": [1, 2]}], "design": "list"},
                                "sweep-list-lengths"),
    "one path twice": ({"parameters": [{"path": "tool_point.0", "values": [1]}] * 2}, "sweep-parameters"),
    "an unknown output": ({"outputs": ["speed"]}, "sweep-output"),
    "an output of no component": ({"outputs": ["share.Q"]}, "sweep-output"),
    "too many": ({"parameters": [{"path": f"joints.{k}.point.0", "range": [0, 1, 300]} for k in "XYZ"]}, "sweep-size"),
    "a document that is not there": ({"machine": "m.FCStd"}, "input-missing"),
}  # fmt: skip


@pytest.mark.parametrize("case", BAD)
def test_bad_specifications_are_refused_with_their_place(tmp_path, case):
    change, code = BAD[case]
    with pytest.raises(Refused) as refused:
        sweep_files.load(spec(tmp_path, **change))
    assert refused.value.code == code


# -- a cluster on this machine -----------------------------------------------------------------------------------------
@pytest.fixture
def scheduler(tmp_path):
    """A Dask scheduler and two worker processes of its own; yields its address and the processes."""
    file = tmp_path / "scheduler.json"
    environment = os.environ | {"PYTHONPATH": str(ROOT), "DASK_DISTRIBUTED__WORKER__DAEMON": "False"}
    options = ["--scheduler-file", str(file)]
    local = ["--host", "127.0.0.1", "--no-dashboard"]
    started = [subprocess.Popen(
        [sys.executable, "-m", "distributed.cli.dask_scheduler", *options, *local, "--port", "0"],
        env=environment, cwd=tmp_path, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
    )]  # fmt: skip
    deadline = time.monotonic() + 60
    while not file.is_file() and time.monotonic() < deadline:
        time.sleep(0.05)
    address = json.loads(file.read_text(encoding="utf-8"))["address"]
    for _ in range(2):
        started.append(subprocess.Popen(
            [sys.executable, "-m", "distributed.cli.dask_worker", address, *local[:2], "--no-nanny", "--nthreads", "1",
             "--no-dashboard"],
            env=environment, cwd=tmp_path, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
        ))  # fmt: skip
    from distributed import Client

    with Client(address, timeout="30s") as client:
        client.wait_for_workers(2, timeout=60)
    yield address, started
    for process in started:
        process.kill()
        process.wait()


def test_a_cluster_writes_the_same_bytes_also_where_a_worker_is_killed(tmp_path, scheduler):
    address, processes = scheduler
    path = spec(tmp_path, parameters=[{"path": "joints.Z.point.2", "range": [100, 900, 600]}], outputs=["rms"])
    whole = swept(path, tmp_path / "one")
    command = [sys.executable, "-m", "sensworkbench", "sweep", str(path), "--out", str(tmp_path / "many"),
               "--scheduler", address]  # fmt: skip
    run = subprocess.Popen(command, cwd=ROOT, stdout=subprocess.DEVNULL)
    partial = tmp_path / "many" / "results.partial.csv"
    deadline = time.monotonic() + 60
    while not (partial.is_file() and partial.stat().st_size > 500) and time.monotonic() < deadline:
        time.sleep(0.01)
    processes[1].kill()
    assert run.wait(timeout=120) == 0
    assert (tmp_path / "many" / "results.csv").read_bytes() == whole


# -- what is shown of all ----------------------------------------------------------------------------------------------
def test_the_front_holds_what_no_variant_beats(tmp_path):
    more = {"minimise": ["rms", "-joints.Z.point.2"]}
    found = rows(swept(spec(tmp_path, **more), tmp_path / "out"))
    judged = [r for r in found if not r["refused"]]
    points = {r["variant"]: (float(r["rms"]), -float(r["joints.Z.point.2"])) for r in judged}
    best = {
        v for v, (a, b) in points.items() if not any(c <= a and d <= b and (c < a or d < b) for c, d in points.values())
    }
    front = list(csv.DictReader((tmp_path / "out" / "pareto.csv").read_text(encoding="utf-8").splitlines()))
    assert {r["variant"] for r in front} == best and 1 < len(best) < len(judged)
    page = (tmp_path / "out" / "report.html").read_text(encoding="utf-8")
    assert "Pareto" in page and "joints.Z.point.2" in page


def test_what_is_minimised_must_be_there(tmp_path):
    path = spec(tmp_path, minimise=["share.Q"])
    with pytest.raises(Refused) as refused:
        sweep_files.load(path)
    assert refused.value.code == "sweep-minimise" and "minimise" in refused.value.where


def test_chunks_grow_with_the_sweep_and_leave_work_for_all():
    from sensworkbench.formats.sweep_run import chunk_of

    assert chunk_of(100, 2) == 16 and chunk_of(10**6, 1000) == 125 and chunk_of(10**6, 4) == 1000
    for variants, workers in ((10**4, 2), (10**6, 1000)):
        assert variants / chunk_of(variants, workers) >= 5 * workers
