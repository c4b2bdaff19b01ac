# SPDX-License-Identifier: LGPL-2.1-or-later
"""The benchmark of the indices measures what it says: right numbers, on few positions."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

SCRIPT = Path(__file__).resolve().parents[2] / "benchmarks" / "indices.py"


def part(name, *more):
    command = [sys.executable, str(SCRIPT), "--part", name, *more]
    return json.loads(subprocess.run(command, capture_output=True, text=True, check=True, timeout=120).stdout)


def test_indices_agree_with_fractions_to_rounding_on_the_machine_of_the_benchmark():
    assert 0 < part("rounding")["error"] < 1e-14


def test_million_positions_part_states_times_memory_and_a_check_of_the_sums():
    found = part("million", "--positions", "20000", "--repetitions", "1")
    assert found["positions"] == 20000 and abs(found["check"]) < 1e-12
    assert found["floor_seconds"] > 0 and found["seconds"] > 0
    assert 0 < found["omega_peak_mib"] <= found["peak_mib"]  # a child starts with its parent's peak: no upper bound


def test_openturns_part_is_exact():
    found = part("openturns", "--repetitions", "1")
    assert max(found["advised"]["error"], found["fewest"]["error"]) < 1e-10
    assert found["advised"]["seconds"] > 0
