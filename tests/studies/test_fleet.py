# SPDX-License-Identifier: LGPL-2.1-or-later
"""A fleet: the same cause is found on the machines that have it, by any number of workers, within the rate."""

from __future__ import annotations

import csv
import json

import numpy as np
import pytest

from sensworkbench import cli
from sensworkbench.studies.fleet import discovery_limit, permutations_for
from tests.formats.test_schemas import faults
from tests.simulator import make_case, write_case

WITH, WITHOUT = (12, 17), (13,)


@pytest.fixture(scope="module")
def fleet(tmp_path_factory):
    """Two machines whose column bends with its temperature, one that is as declared, and a record that is broken."""
    folder = tmp_path_factory.mktemp("fleet")
    for seed in WITH:
        write_case(folder / f"bent{seed}", make_case(seed, "column_bend", structure="FYXZ", plan="grid", extras=False))
    for seed in WITHOUT:
        write_case(folder / f"plain{seed}", make_case(seed, "none", plan="grid", extras=False))
    write_case(folder / "broken", make_case(14, "none", plan="grid", extras=False))
    path = folder / "broken" / "measured.csv"
    path.write_text(path.read_text(encoding="utf-8").replace("e", "x"), encoding="utf-8")
    return folder


def test_what_recurs_is_found_and_a_bad_record_stops_nothing(fleet, tmp_path, capsys):
    assert cli.main(["fleet", str(fleet), "--out", str(tmp_path / "one")]) == 0
    assert "1 of 4 records were refused" in capsys.readouterr().out
    data = json.loads((tmp_path / "one" / "fleet.json").read_text(encoding="utf-8"))
    assert faults("fleet", data) == []
    machines = {m["name"]: m for m in data["machines"]}
    assert machines["broken"]["status"] == "refused" and "measured.csv" in machines["broken"]["message"]
    assert machines["plain13"]["verdict"] == "nothing_to_explain" and not machines["plain13"]["effects"]
    first = data["recurring"][0]
    truth = {s: json.loads((fleet / f"bent{s}" / "truth.json").read_text(encoding="utf-8")) for s in WITH}
    assert first["machines"] == [f"bent{s}" for s in WITH], truth
    for seed in WITH:
        errors = machines[f"bent{seed}"]["held_out_rms_um"]
        assert errors["augmented"] < 0.8 * errors["declared"]
    with open(tmp_path / "one" / "fleet.csv", encoding="utf-8") as stream:
        rows = list(csv.DictReader(stream))
    assert {r["machine"] for r in rows} == set(machines)
    page = (tmp_path / "one" / "report.html").read_text(encoding="utf-8")
    assert all(name in page for name in machines)

    assert cli.main(["fleet", str(fleet), "--out", str(tmp_path / "two"), "--workers", "2"]) == 0
    for name in ("fleet.json", "fleet.csv"):
        assert (tmp_path / "two" / name).read_bytes() == (tmp_path / "one" / name).read_bytes()


def test_the_limit_is_that_of_benjamini_and_hochberg():
    p = [
        0.0001,
        0.0004,
        0.0019,
        0.0095,
        0.0201,
        0.0278,
        0.0298,
        0.0344,
        0.0459,
        0.3240,
        0.4262,
        0.5719,
        0.6528,
        0.7590,
        1.0,
    ]  # fmt: skip  the example of their paper: four stand at .05
    assert discovery_limit(p, 0.05) == 0.0095
    assert discovery_limit([0.2, 0.9], 0.05) == 0.0 and discovery_limit([], 0.05) == 0.0


def test_false_names_stay_within_the_rate():
    rng, false, named = np.random.default_rng(5), [], []
    for _ in range(400):
        null = rng.random(40)
        true = rng.random(10) * 1e-3
        limit = discovery_limit([*null, *true], 0.05)
        standing = int((null <= limit).sum()), int((true <= limit).sum())
        false.append(standing[0] / max(1, sum(standing)))
        named.append(standing[1])
    assert np.mean(false) < 0.05 and np.mean(named) > 9


def test_one_record_in_many_can_stand():
    for count in (1, 20, 200):
        assert 1 / (permutations_for(count) + 1) <= 0.05 / count
    assert permutations_for(10) == 199


def test_bad_input_is_refused(tmp_path, capsys):
    assert cli.main(["fleet", str(tmp_path / "none"), "--out", str(tmp_path / "out")]) == 2
    assert cli.main(["fleet", str(tmp_path), "--out", str(tmp_path / "out")]) == 2
    (tmp_path / "a").mkdir()
    (tmp_path / "a" / "machine.json").write_text("{}", encoding="utf-8")
    assert cli.main(["fleet", str(tmp_path), "--out", str(tmp_path / "out"), "--rate", "0.9"]) == 2
    assert not (tmp_path / "out").exists()
    assert (
        cli.main(["fleet", str(tmp_path), "--out", str(tmp_path / "out")]) == 0
    )  # the record is refused, not the fleet
    assert "machine.json" in json.loads((tmp_path / "out" / "fleet.json").read_text())["machines"][0]["message"]
