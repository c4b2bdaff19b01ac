# SPDX-License-Identifier: LGPL-2.1-or-later
"""Errors that vary together: without correlation the shares are those of the sensitivity, with it those of a source."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest

from sensworkbench import cli
from sensworkbench.core import workspace
from sensworkbench.core.distributions import Tolerance
from sensworkbench.core.refusal import Refused
from sensworkbench.formats import correlated_files, machine_json
from sensworkbench.studies.correlated import correlated_study, independent_blocks, share_of
from tests.formats.support import ROOT
from tests.formats.test_schemas import faults

EXAMPLES = ROOT / "resources" / "examples"
MACHINE, COVARIANCE = EXAMPLES / "vertical_machining_centre.json", EXAMPLES / "covariance.csv"
VMC = machine_json.load(MACHINE)


def normal(machine):
    """The machine with normal laws of the same variances."""
    laws = {}
    for symbol, law in machine.all_tolerances.items():
        sigma = law.moments[1] ** 0.5
        laws[symbol] = Tolerance(law.lower, law.upper, "normal", sigma) if sigma > 0 else law
    return replace(machine, tolerances=laws)


def test_without_correlation_the_shares_are_those_of_the_sensitivity():
    machine = normal(VMC)
    variance = machine.all_tolerances["EAY"].moments[1]
    found = correlated_study(machine, (("EAY",), np.array([[variance]])))
    where = workspace.quadrature(machine, 4)
    plain = workspace.sensitivity(machine, where, estimate=False)
    assert share_of(found.components) == pytest.approx(dict(zip(plain.bodies, plain.component_share)), abs=1e-9)
    single = dict(zip(plain.symbols, plain.share))
    assert all(s.share == pytest.approx(single[s.name], abs=1e-9) for s in found.errors) and len(found.errors) > 15
    assert found.mean_square == pytest.approx(plain.mean_square) and found.variance == pytest.approx(plain.variance)


def test_errors_that_follow_each_other_exactly_have_the_share_of_a_source():
    machine = normal(VMC)
    row = np.array([2e-3, 8e-6])  # mm and rad per unit of the cause
    found = correlated_study(machine, (("EZY", "EAY"), np.outer(row, row)))
    block = next(share for names, share in found.blocks if set(names) == {"EZY", "EAY"})
    data = machine_json.to_dict(replace(machine, version=2))
    for symbol in ("EZY", "EAY"):
        del data["tolerances"][symbol]
    factors = {"EZY": {"value": 2.0, "unit": "um"}, "EAY": {"value": 8.0, "unit": "urad"}}
    data["sources"] = [{"name": "rail", "distribution": "normal", "sigma": 1.0, "factors": factors}]
    other = machine_json.loads(json.dumps(data))
    plain = workspace.sensitivity(other, workspace.quadrature(other, 4), estimate=False)
    assert block == pytest.approx(plain.share[plain.symbols.index("rail")], abs=1e-7)
    assert sum(share_of(found.components).values()) == pytest.approx(1)
    assert sum(share for _, share in found.blocks) == pytest.approx(1)
    assert sum(s.share for s in found.errors if s.name in ("EZY", "EAY")) == pytest.approx(block, abs=1e-9)


def test_blocks_are_what_varies_together():
    covariance = np.diag([1.0, 2, 0, 3, 4])
    covariance[0, 3] = covariance[3, 0] = 0.5
    assert independent_blocks(covariance) == [[0, 3], [1], [4]]


def test_the_verb_reads_a_covariance_and_writes_what_follows_the_schema(tmp_path):
    words = ["correlated", str(MACHINE), "--covariance", str(COVARIANCE), "--language", "de"]
    assert cli.main([*words, "--out", str(tmp_path / "out")]) == 0
    data = json.loads((tmp_path / "out" / "correlated.json").read_text(encoding="utf-8"))
    assert faults("correlated", data) == []
    assert sum(c["share"] for c in data["components"]) == pytest.approx(1)
    together = [b["errors"] for b in data["blocks"] if len(b["errors"]) > 1]
    assert sorted(map(sorted, together)) == [["EAY", "EZY"], ["EBY", "ECY"]]


def test_the_remaining_uncertainty_of_a_fit_is_divided_among_components(tmp_path):
    from tests.simulator import make_case, write_case

    write_case(tmp_path / "case", make_case(13, "none", structure="FYXZ", plan="random", extras=False))
    case = tmp_path / "case"
    words = ["trace", str(case / "machine.json"), str(case / "measured.csv"), "--out", str(tmp_path / "traced")]
    assert cli.main(words) == 0
    machine = str(tmp_path / "traced" / "machine_augmented.json")
    assert cli.main(["correlated", machine, "--out", str(tmp_path / "out")]) == 0
    data = json.loads((tmp_path / "out" / "correlated.json").read_text(encoding="utf-8"))
    assert data["inputs"] == "fit" and faults("correlated", data) == []
    assert sum(c["share"] for c in data["components"]) == pytest.approx(1, abs=1e-6)
    assert {c["body"] for c in data["components"]} <= {"X", "Y", "Z"}


BAD = {
    "no head": ("EZY,EAY\n1,2\n", "covariance-head"),
    "another row": ("symbol,EZY,EAY\nEZY,1,0\nEXX,0,1\n", "covariance-rows"),
    "twice": ("symbol,EZY,EZY\nEZY,1,0\nEZY,0,1\n", "covariance-twice"),
    "not symmetric": ("symbol,EZY,EAY\nEZY,1,0.5\nEAY,0,1\n", "covariance-not-symmetric"),
    "too much correlation": ("symbol,EZY,EAY\nEZY,1,2\nEAY,2,1\n", "covariance-correlation"),
    "a word": ("symbol,EZY\nEZY,x\n", None),
    "unknown": ("symbol,EQQ\nEQQ,1\n", None),
}


@pytest.mark.parametrize("case", BAD)
def test_a_matrix_that_is_no_covariance_is_refused(tmp_path, case, capsys):
    text, code = BAD[case]
    path = tmp_path / "c.csv"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(Refused) as refused:
        correlated_files.load(path, VMC)
    assert code is None or refused.value.code == code
    assert cli.main(["correlated", str(MACHINE), "--covariance", str(path), "--out", str(tmp_path / "out")]) == 2
    assert not (tmp_path / "out").exists()


def test_a_machine_without_a_fit_is_refused(tmp_path, capsys):
    assert cli.main(["correlated", str(MACHINE), "--out", str(tmp_path / "out")]) == 2
    assert "covariance" in capsys.readouterr().err
