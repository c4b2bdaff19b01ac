# SPDX-License-Identifier: LGPL-2.1-or-later
"""The worked examples of docs/what-to-change.md are what the studies give."""

from __future__ import annotations

import json
import re
from dataclasses import replace

import pytest

from sensworkbench.core import workspace
from sensworkbench.core.distributions import Tolerance
from sensworkbench.core.sources import Source
from sensworkbench.formats import correlated_files, costs_csv, machine_json
from sensworkbench.studies.correlated import correlated_study
from sensworkbench.studies.limits import limits_study
from sensworkbench.studies.moves import moves_study, per_mm_percent, per_um2
from tests.formats.support import ROOT

EXAMPLES = ROOT / "resources" / "examples"
PAGE = (ROOT / "docs" / "what-to-change.md").read_text(encoding="utf-8")
VMC = machine_json.load(EXAMPLES / "vertical_machining_centre.json")


def row(name: str) -> str:
    """The line of a table that begins with a name."""
    return next(line for line in PAGE.splitlines() if line.startswith(f"| {name}"))


def test_the_example_of_limits():
    found = limits_study(VMC, 0.95, (35.0,))
    figures = {f.name: f for f in found.figures}
    assert f"| {found.quantile:.1f} | passes |" in row("all errors")
    assert f"| {found.worst:.1f} | fails |" in row("worst place") and "X −250, Y 200, Z 200 mm" in row("worst place")
    for name in ("V_XYZ", "E_D"):
        assert f"| {figures[name].median:.1f} | {figures[name].upper:.1f} |" in row(name)
    assert f"{100 * found.beyond[0][1]:.1f} % of all errors exceed 35 µm" in PAGE
    assert f"standard error of the {found.quantile:.1f} µm is {found.error:.2f} µm" in PAGE
    parts = {c.name: f"{100 * c.value:.0f} %" for c in found.components}
    assert f"The Y carriage makes {parts['Y']} of the quantile, Z {parts['Z']}, X {parts['X']}" in PAGE
    assert f"The first error is {found.errors[0].name} with {100 * found.errors[0].value:.0f} %" in PAGE


def test_the_example_of_moves():
    found = moves_study(VMC, (0, 50, 50), costs_csv.load(EXAMPLES / "costs.csv", VMC))
    points = {p.name: p for p in found.points}
    for name, letter, axis in (("Y", "+z", 2), ("X", "+z", 2), ("Z", "−y", 1)):
        point = points[name]
        free = [abs(c.mean_square) for c in point.changes][1:]
        assert max(free) == abs(point.changes[axis].mean_square)
        slope = per_mm_percent(found, point.changes[axis])
        line = row(f"scale and guide of {name}")
        assert f"| {letter} | −{abs(slope):.3f} % | {point.worth[axis]:.2f} |" in line
        assert f"| {1e3 * point.rms_best:.2f} |" in line and (slope > 0) == letter.startswith("−")
        for at, text in zip("yz", (f"{v:+.0f}".replace("-", "−") for v in point.best[1:])):
            assert (f"{at} {text}" in line) == (text not in ("+0", "−0"))
    assert f"The rms is {1e3 * found.mean_square**0.5:.2f} µm now" in PAGE
    assert f"it is {1e3 * found.rms_together:.2f} µm" in PAGE
    assert f"{1e3 * found.orders[0].rms:.2f} µm for {found.orders[0].structure}" in PAGE
    assert found.step.symbol == "EBY" and f"{per_um2(found.step.price):.2f} per µm²" in PAGE


def test_the_example_of_a_source():
    text = re.search(r'"sources": (\[.*?\}\}\}\])', PAGE, re.S)[1]
    (given,) = json.loads(text)
    tolerances = {s: t for s, t in VMC.tolerances.items() if s not in given["factors"]}
    assert given["factors"] == {"EZY": {"value": 5, "unit": "um"}, "EAY": {"value": 20, "unit": "urad"}}

    def ranked(machine):
        result = workspace.sensitivity(machine, estimate=False)
        shares = sorted(zip(result.symbols, result.share), key=lambda p: -p[1])
        return result.mean_square, dict(shares), shares[0][0], f"{100 * shares[0][1]:.0f} %"

    square, shares, first, part = ranked(VMC)
    assert f"| {100 * (shares['EZY'] + shares['EAY']):.0f} % | {first} {part} |" in row("independent")
    for sign, name in ((1, "same"), (-1, "opposite")):
        source = Source(given["name"], Tolerance(-1, 1), {"EZY": 5e-3, "EAY": sign * 20e-6})
        same, shares, first, part = ranked(replace(VMC, sources=(source,), tolerances=tolerances))
        assert same == pytest.approx(square, rel=1e-4)
        assert f"| {100 * shares['rail of Y']:.0f} % | {first} {part} |" in row(f"one source, {name} sign")


def test_the_example_of_a_covariance():
    found = correlated_study(VMC, correlated_files.load(EXAMPLES / "covariance.csv", VMC))
    blocks = {frozenset(names): f"{100 * share:.0f} %" for names, share in found.blocks}
    components = {c.name: f"{100 * c.share:.0f} %" for c in found.components}
    rails = blocks[frozenset(("EZY", "EAY"))], blocks[frozenset(("EBY", "ECY"))]
    plain = " ".join(PAGE.split())
    assert f"EZY and EAY share {rails[0]}, EBY and ECY {rails[1]}" in plain
    assert f"Y {components['Y']}, Z {components['Z']}, X {components['X']}" in plain
