# SPDX-License-Identifier: LGPL-2.1-or-later
"""What this package answers to the reference set (docs/reference-set.md), through the functions that everybody uses."""

from __future__ import annotations

import json
from pathlib import Path

from sensworkbench.core import workspace
from sensworkbench.core.machine import Machine
from sensworkbench.core.objectives import from_json
from sensworkbench.core.synthesis import ORIENTATION, POSITION, volumetric_error
from sensworkbench.formats import machine_json


def answers(folder: Path) -> dict[str, dict]:
    """Machine file -> its answer."""
    found = {}
    for path in sorted(folder.glob("*.reference.json")):
        asked = json.loads(path.read_text(encoding="utf-8"))
        machine = machine_json.load(folder / asked["machine"])
        found[asked["machine"]] = answer(machine, asked)
    return found


def answer(machine: Machine, asked: dict) -> dict:
    """Inputs, cases and volumetric errors of one machine."""
    inputs = {}
    labels, columns, _, laws = workspace.error_table(machine)
    for label, symbol, law in zip(labels, columns, laws):
        scale = machine.component(symbol).to_shown(1.0) if symbol else 1.0  # a source is a pure number
        mean, variance, third, fourth = law.moments
        inputs[label] = {"mean": mean * scale, "variance": variance * scale**2, "third": third * scale**3,
                          "fourth": fourth * scale**4}  # fmt: skip
    return {
        "inputs": inputs,
        "cases": [_case(machine, case) for case in asked["cases"]],
        "volumetric": [_volumetric(machine, one) for one in asked["volumetric"]],
    }


def _internal(machine: Machine, position) -> list[float]:
    return [j.from_shown(v) for j, v in zip(machine.joints, position)]


def _case(machine: Machine, case: dict) -> dict:
    where, judged = case["positions"], from_json(case["objective"])
    if where["kind"] == "at":
        positions = workspace.at(machine, _internal(machine, where["position"]))
    else:
        positions = workspace.grid(machine, where["counts"])
    found = workspace.sensitivity(machine, positions, judged, estimate=False)
    scale = (1e3 if judged.output == POSITION else 1e6) ** judged.power
    errors = zip(found.symbols, found.first, found.total, found.total_max)
    components = zip(found.bodies, found.component_first, found.component_total)
    return {
        "mean": found.mean_square * scale,
        "variance": found.variance * scale**2,
        "errors": {s: {"first": float(f), "total": float(t), "total_max": float(m)} for s, f, t, m in errors},
        "components": {b: {"first": float(f), "total": float(t)} for b, f, t in components},
    }


def _volumetric(machine: Machine, one: dict) -> dict:
    values = {s: machine.component(s).from_shown(v) for s, v in one["errors"].items()}
    q = _internal(machine, one["position"])
    position = volumetric_error(machine, values, q)[0] * 1e3
    turn = volumetric_error(machine, values, q, output=ORIENTATION)[0] * 1e6
    return {"error_um": position.tolist(), "rotation_urad": turn.tolist()}
