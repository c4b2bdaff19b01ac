# SPDX-License-Identifier: LGPL-2.1-or-later
"""The verbs plan, convert, import-errors and import-machine: their files, their words, their exit status."""

from __future__ import annotations

import argparse
import csv
import json
import re
import shlex
import xml.etree.ElementTree as ElementTree

import numpy as np
import pytest

from sensworkbench import cli
from sensworkbench.closedloop.plan import Plan
from sensworkbench.formats import machine_json, plan_json
from sensworkbench.messages import Message

from .support import ROOT, command, golden, write

FITTED = {
    "EXX": {"basis": "legendre", "domain": [-300, 300], "coefficients": [0, 4, -1.5, 0.5], "unit": "um"},
    "EBX": {"basis": "legendre", "domain": [-300, 300], "coefficients": [0, 6, 2, 0], "unit": "urad"},
    "EZY": {"basis": "legendre", "domain": [-200, 200], "coefficients": [0, 0, 2.0, -0.7], "unit": "um"},
    "C0Y": {"value": 12.0, "unit": "urad"},
}


def table(path, rows, names="x_mm,y_mm,z_mm"):
    text = names + "\n" + "\n".join(",".join(f"{v:.10g}" for v in row) for row in rows) + "\n"
    path.write_text(text, encoding="utf-8")
    return path


def nodes(side=5):
    lines = (np.linspace(-300, 300, side), np.linspace(-200, 200, side), np.linspace(-250, 50, side))
    return np.stack(np.meshgrid(*lines, indexing="ij"), axis=-1).reshape(-1, 3)


@pytest.fixture
def place(tmp_path):
    write(tmp_path / "m.json", golden())
    write(tmp_path / "fitted.json", golden(fitted=FITTED))
    table(tmp_path / "grid.csv", nodes())
    return tmp_path


def run(place, *words) -> int:
    return cli.main([str(place / w) if (place / str(w)).exists() or "." in str(w) else str(w) for w in words])


def checked(folder) -> dict:
    return json.loads((folder / "plan.json").read_text(encoding="utf-8"))


def test_a_plan_is_checked_by_a_process_of_its_own_without_freecad(place):
    (place / "block").mkdir()
    words = ("plan", "m.json", "grid.csv", "--out", "out", "--noise", "0.5", "--suggest", "125")
    done = command(*words, cwd=place, block=place / "block")
    assert (done.returncode, done.stderr) == (0, "")
    names = {"plan.json", "report.html", "candidates.csv", "positions_suggested.csv", "manifest.json"}
    assert {p.name for p in (place / "out").iterdir()} == names
    data = checked(place / "out")
    assert (data["format"], data["version"], data["noise_um"]) == ("sens-plan", 1, 0.5)
    assert data["numbers"]["places"] == 125 and data["numbers"]["readings"] == 375
    assert len(data["identifiability"]["null_space"]) == data["numbers"]["parameters"] - data["numbers"]["rank"] > 0
    assert data["suggested"]["numbers"]["rank"] == data["suggested"]["numbers"]["parameters"]
    assert any("mm longer" in line for line in done.stdout.splitlines())


def test_the_suggested_table_is_a_plan_whose_numbers_are_those_stated(place):
    assert run(place, "plan", "m.json", "grid.csv", "--out", place / "out", "--suggest", "125") == 0
    stated = checked(place / "out")["suggested"]["numbers"]
    readings = plan_json.load(place / "out" / "positions_suggested.csv", 1.0)
    again = Plan(machine_json.load(place / "m.json"), readings).numbers()
    assert again == {k: pytest.approx(v, rel=1e-6) if isinstance(v, float) else v for k, v in stated.items()}


def test_a_plan_can_be_suggested_where_none_is_given(place):
    assert run(place, "plan", "m.json", "--out", place / "out", "--suggest", "90") == 0
    data = checked(place / "out")
    assert data["judged"] == "suggested" and data["numbers"]["places"] == 90
    with open(place / "out" / "positions_suggested.csv", encoding="utf-8") as stream:
        assert len(list(csv.DictReader(stream))) == 90


def test_conditions_of_a_given_plan_come_back_in_their_own_units(place):
    q = nodes()
    rows = np.column_stack([q, 20.0 * np.arange(len(q)), 20 + np.linspace(0, 3, len(q)), np.full(len(q), 2000.0)])
    table(place / "p.csv", rows, "x_mm,y_mm,z_mm,t_s,temp_column_C,feed_mm_min")
    assert run(place, "plan", "m.json", "p.csv", "--out", place / "out", "--suggest", "125") == 0
    with open(place / "out" / "positions_suggested.csv", encoding="utf-8") as stream:
        found = list(csv.DictReader(stream))
    assert [float(r["temp_column_C"]) for r in found] == pytest.approx(list(rows[:, 4]))
    assert {float(r["feed_mm_min"]) for r in found} == {2000.0}
    assert float(found[-1]["t_s"]) == pytest.approx(2480.0)


def test_names_of_readings_say_which_directions_are_planned(place):
    q = nodes()
    table(place / "z.csv", np.column_stack([q, np.zeros(len(q))]), "x_mm,y_mm,z_mm,ez_um")
    readings = plan_json.load(place / "z.csv", 1.0)
    assert readings.rows == len(q) and (readings.sense == [0, 0, 1]).all()
    n = np.random.default_rng(1).normal(size=q.shape)
    n /= np.linalg.norm(n, axis=1)[:, None]
    t = np.arange(len(q))[::-1]
    rows = np.column_stack([q, n, t])
    (place / "n.csv").write_text(
        "x_mm,y_mm,z_mm,nx,ny,nz,t_s\n" + "\n".join(",".join(repr(float(v)) for v in r) for r in rows), encoding="utf-8"
    )
    readings = plan_json.load(place / "n.csv", 1.0)  # taken in the order of time: the file's from its end
    assert np.allclose(readings.sense, n[::-1]) and np.allclose(readings.q, q[::-1])


def test_directions_of_approach_are_derived_from_the_order_and_that_is_said(place):
    readings = plan_json.load(place / "grid.csv", 1.0)
    assert [f.code for f in readings.remarks] == ["direction-derived"]
    assert (readings.columns["dir_z"][1:5] == 1).all() and readings.columns["dir_z"][5] == -1


def test_places_out_of_reach_are_a_warning(place, capsys):
    table(place / "far.csv", nodes() * 1.2)
    assert run(place, "plan", "m.json", "far.csv", "--out", place / "out") == 0
    finding = next(f for f in checked(place / "out")["findings"] if f["code"] == "outside-travel")
    assert finding["line"] == 2 and finding["message"].startswith("98 places")
    assert "outside the travel" in capsys.readouterr().out


def test_the_report_is_one_well_formed_page_that_says_what_the_data_say(place):
    write(place / "odd.json", golden(name="<b>&odd"))
    assert run(place, "plan", "odd.json", "grid.csv", "--out", place / "out", "--suggest", "125") == 0
    text = (place / "out" / "report.html").read_text(encoding="utf-8")
    root = ElementTree.fromstring(text.removeprefix("<!DOCTYPE html>\n"))
    words = " ".join("".join(root.itertext()).split())
    data = checked(place / "out")
    assert "<b>&odd" in words and "<b>&odd" not in text
    assert f"Of {data['numbers']['parameters']} parameters" in words
    for entry in data["identifiability"]["null_space"]:
        assert entry in words
    for advice in data["advice"]:
        assert advice["improves"] in words
    assert "http" not in text


SENTENCE = re.compile(r"[a-z]{3,} [a-z]{3,}")


def leaves(page: str, *tags: str) -> list[str]:
    """The text of every element of these kinds, as it is read."""
    root = ElementTree.fromstring(page.removeprefix("<!DOCTYPE html>\n"))
    return [" ".join("".join(e.itertext()).split()) for tag in tags for e in root.iter(tag)]


def test_the_report_has_no_english_left_in_another_language(place):
    pages, data = {}, {}
    for language in ("en", "de", "ko"):
        out = place / language
        words = ("m.json", "grid.csv", "--out", out, "--suggest", "125", "--language", language)
        assert run(place, "plan", *words) == 0
        pages[language], data[language] = (out / "report.html").read_text(encoding="utf-8"), checked(out)
        assert f'<html lang="{language}">' in pages[language]
    assert data["en"] == data["de"] == data["ko"]
    headings = {k: [t for t in leaves(p, "h1", "h2", "h3", "th") if t] for k, p in pages.items()}
    assert len(headings["en"]) > 30 and len({len(h) for h in headings.values()}) == 1
    said = {k: leaves(p, "h1", "p", "li", "td", "span", "b", "figcaption", "footer") for k, p in pages.items()}
    for one, other in (("en", "de"), ("en", "ko"), ("de", "ko")):
        assert not set(headings[one]) & set(headings[other])
        assert not [t for t in set(said[one]) & set(said[other]) if SENTENCE.search(t)]
    assert any(SENTENCE.search(t) for t in said["en"])


def test_a_sentence_of_the_data_has_its_code_and_fields_beside_it(place):
    assert run(place, "plan", "m.json", "grid.csv", "--out", place / "out") == 0
    data = checked(place / "out")
    entries = [(a, k) for a in data["advice"] for k in ("do", "improves", "why") if a[k]]
    entries += [(t, "effect") for t in data["not_testable"]] + [(f, "message") for f in data["findings"]]
    entries += [(e, k) for e in data["effects"] for k in ("name", "usual_size")] + [(h, "name") for h in data["hidden"]]
    assert len(entries) > 60
    for entry, key in entries:
        assert str(Message.from_dict(entry[f"{key}_message"])) == entry[key]
    for entry, key in [(data["identifiability"], "null_space"), *((p, "effects") for p in data["confused"])]:
        assert [str(Message.from_dict(m)) for m in entry[f"{key}_messages"]] == entry[key] != []


def test_every_candidate_stands_in_the_table(place):
    assert run(place, "plan", "m.json", "grid.csv", "--out", place / "out") == 0
    with open(place / "out" / "candidates.csv", encoding="utf-8") as stream:
        rows = list(csv.DictReader(stream))
    assert len(rows) == checked(place / "out")["threshold"]["candidates"]
    assert {"EAX", "EBW", "EZZ"} <= {r["component"] for r in rows}  # what moves alike stands under its plainest name
    hidden = [r for r in rows if float(r["visible_share"]) < 0.05]
    assert hidden and all(r["smallest_um"] == "" for r in hidden)


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("plan", "m.json", "--out", "out"), "--suggest"),
        (("plan", "m.json", "grid.csv", "--out", "out", "--noise", "0"), "above zero"),
        (("plan", "m.json", "grid.csv", "--out", "out", "--noise", "-1"), "above zero"),
        (("plan", "m.json", "none.csv", "--out", "out"), "none.csv"),
        (("plan", "m.json", "--out", "out", "--suggest", "5"), "5 places"),
        (("plan", "m.json", "few.csv", "--out", "out"), "few.csv"),
        (("plan", "m.json", "bent.csv", "--out", "out"), "line 3"),
        (("convert", "m.json", "--to", "isg", "--out", "out"), "golden"),
        (("convert", "fitted.json", "--to", "word", "--out", "out"), "word"),
        (("convert", "fitted.json", "--to", "isg", "--through", "1,2,3", "--out", "out"), "--through"),
        (("convert", "fitted.json", "--to", "fcm", "--positions", "grid.csv", "--out", "out"), "--positions"),
        (("convert", "fitted.json", "--to", "isg", "--positions", "none.csv", "--out", "out"), "none.csv"),
        (("import-errors", "m.json", "grid.csv", "--from", "isg", "--out", "out"), "grid.csv"),
        (("import-errors", "m.json", "grid.csv", "--from", "word", "--out", "out"), "word"),
        (("import-machine", "m.json", "--out", "out"), "m.json"),
    ],
)
def test_what_cannot_be_done_is_refused_in_one_line_and_nothing_is_written(place, monkeypatch, capsys, words, said):
    monkeypatch.chdir(place)
    table(place / "few.csv", nodes()[:3])
    table(place / "bent.csv", [(0, 0, 0, 1, 0, 0), (10, 0, 0, 2, 0, 0)] * 10, "x_mm,y_mm,z_mm,nx,ny,nz")
    assert cli.main(list(words)) == 2
    out, err = capsys.readouterr()
    assert out == "" and said in err and "Traceback" not in err and not (place / "out").exists()


def test_a_suggestion_never_overwrites_the_given_plan(place, capsys):
    (place / "grid.csv").rename(place / "positions_suggested.csv")
    before = (place / "positions_suggested.csv").read_bytes()
    assert run(place, "plan", "m.json", "positions_suggested.csv", "--out", place, "--suggest", "60") == 2
    assert (place / "positions_suggested.csv").read_bytes() == before and "overwritten" in capsys.readouterr().err


@pytest.mark.parametrize("fmt", ["isg", "etalon"])
def test_errors_go_to_a_controller_and_come_back(place, fmt):
    assert run(place, "convert", "fitted.json", "--to", fmt, "--out", place / "tables") == 0
    files = [p for p in (place / "tables").iterdir() if p.name not in ("statement.txt", "manifest.json")]
    assert len(files) == 1 and (place / "tables" / "statement.txt").exists()
    back = place / "back.json"
    assert cli.main(["import-errors", str(place / "m.json"), str(files[0]), "--from", fmt, "--out", str(back)]) == 0
    fitted = machine_json.load(back).fitted
    for symbol, entry in FITTED.items():
        if "coefficients" in entry:
            scale = 1e6 if entry["unit"] == "urad" else 1e3
            found = scale * np.array(fitted.series[symbol].coefficients)
            assert found == pytest.approx(entry["coefficients"], abs=0.05), symbol
        else:
            assert 1e6 * fitted.constants[symbol].value == pytest.approx(entry["value"], abs=0.05)


@pytest.mark.parametrize("fmt", ["linuxcnc", "heidenhain", "siemens"])
def test_axis_tables_are_written_with_a_statement(place, capsys, fmt):
    words = ["convert", str(place / "fitted.json"), "--to", fmt, "--through", "-100,0,0", "--out", str(place / fmt)]
    assert cli.main(words) == 0
    assert "after compensation" in (place / fmt / "statement.txt").read_text(encoding="utf-8")
    assert str(place / fmt / "statement.txt") in capsys.readouterr().out


def test_a_machine_goes_to_freecad_cam_and_comes_back(place):
    assert run(place, "convert", "m.json", "--to", "fcm", "--out", place / "cam") == 0
    back = place / "back.json"
    words = ["import-machine", str(place / "cam" / "machine.fcm"), "--tool-point", "0,0,-150", "--out", str(back)]
    assert cli.main(words) == 0
    one, other = machine_json.load(place / "m.json"), machine_json.load(back)
    assert (one.structure, one.travel.tolist(), one.tool_point) == (
        other.structure,
        other.travel.tolist(),
        other.tool_point,
    )


def test_an_imported_machine_never_overwrites_its_input(place, capsys):
    words = ["import-errors", str(place / "m.json"), str(place / "t.csv"), "--from", "isg", "--out"]
    assert run(place, "convert", "fitted.json", "--to", "isg", "--out", place / "tables") == 0
    (place / "tables" / "errors_isg.csv").rename(place / "t.csv")
    for name in ("m.json", "t.csv"):
        before = (place / name).read_bytes()
        assert cli.main([*words, str(place / name)]) == 2
        assert (place / name).read_bytes() == before and "overwritten" in capsys.readouterr().err


COMMAND = re.compile(r"^ {4}python3 -m sensworkbench (.+?)(?: +#.*)?$", re.MULTILINE)


@pytest.mark.parametrize("page", ["README.md", "docs/command-line.md"])
def test_every_command_of_the_documentation_is_one(page):
    found = COMMAND.findall((ROOT / page).read_text(encoding="utf-8"))
    assert len(found) > 7
    for line in found:
        if not line.startswith("VERB"):
            words = cli.parser().parse_args(shlex.split(line))
            for name in ("machine", "positions", "tolerances"):
                given = getattr(words, name, None)
                if given and given.startswith("resources/"):
                    assert (ROOT / given).exists(), line


def test_every_verb_and_option_stands_on_its_page():
    sections = re.split(r"^## ", (ROOT / "docs" / "command-line.md").read_text(encoding="utf-8"), flags=re.MULTILINE)
    text = {s.split("\n", 1)[0]: s for s in sections}
    verbs = next(a for a in cli.parser()._actions if a.dest == "verb").choices
    assert set(verbs) == set(text) - {sections[0].split("\n", 1)[0]}
    for verb, grammar in verbs.items():
        for action in grammar._actions:
            for option in action.option_strings:
                inner = action.help is argparse.SUPPRESS  # between the program's own processes, in --help neither
                if option.startswith("--") and option != "--help" and not inner:
                    assert option in text[verb], (verb, option)
