# SPDX-License-Identifier: LGPL-2.1-or-later
"""Readings of a machine that bends with temperature, traced and predicted: files, report and exit status."""

from __future__ import annotations

import csv
import hashlib
import html
import json
import re
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

from sensworkbench import cli, demo
from sensworkbench.closedloop.trace import trace
from sensworkbench.core.shapes import SHAPES
from sensworkbench.core.synthesis import exact_error
from sensworkbench.formats import machine_json, readings_csv, study_files, trace_html, trace_json
from sensworkbench.messages import LANGUAGES, Message
from sensworkbench.studies.trace import component_values

from .support import ROOT, command

MACHINE = ROOT / "resources" / "examples" / "vertical_machining_centre.json"
BEND = 6.0  # urad per kelvin of the column
NOISE = 0.3  # um, one reading


def readings_of(machine, folder: Path, seed: int) -> dict:
    """measured.csv and positions.csv of a machine with constant squareness, one cubic error and a bending column."""
    rng = np.random.default_rng(seed)
    low, high = machine.travel.T

    def rows(count):
        q = low + (high - low) * rng.random((count, 3))
        t = 10.0 * np.arange(count)
        return q, t, 3 * np.sin(t / 900) + 0.3 * np.sin(t / 130)

    def error(q, temperature):
        v = (2 * q[:, 0] - low[0] - high[0]) / (high[0] - low[0])
        values = {"C0Y": 15e-6, "A0Z": -9e-6, "B0Z": 6e-6, "EYX": 2e-3 * (1.5 * v**2 - 0.5), "EBX": 8e-6 * v}
        return 1e3 * exact_error(machine, values | {"EAZ": BEND * 1e-6 * temperature}, q)[0]

    def table(name, q, t, temperature, errors=None):
        head = ["x_mm", "y_mm", "z_mm", "t_s", "temp_column_C"] + (
            [] if errors is None else ["ex_um", "ey_um", "ez_um"]
        )
        cells = np.column_stack([q, t, 20 + temperature] + ([] if errors is None else [errors]))
        lines = ["# sign: error", "# frame: tool_relative_to_workpiece", ",".join(head)]
        lines += [",".join(f"{v:.5f}" for v in row) for row in cells]
        (folder / name).write_text("\n".join(lines) + "\n", encoding="utf-8")

    q, t, temperature = rows(300)
    table("measured.csv", q, t, temperature, error(q, temperature) + NOISE * rng.normal(size=q.shape))
    q, t, temperature = rows(60)
    table("positions.csv", q, t, temperature)
    return {"truth_um": error(q, temperature)}


@pytest.fixture(scope="module")
def traced(tmp_path_factory):
    folder = tmp_path_factory.mktemp("traced")
    machine = machine_json.load(MACHINE)
    known = readings_of(machine, folder, 11)
    status = cli.main(["trace", str(MACHINE), str(folder / "measured.csv"), "--out", str(folder / "out")])
    assert status == 0
    return folder, known


def predicted(path) -> tuple[list[str], np.ndarray]:
    with open(path, encoding="utf-8", newline="") as stream:
        rows = list(csv.DictReader(line for line in stream if not line.startswith("#")))
    return list(rows[0]), np.array([[float(r[c]) for c in ("ex_um", "ey_um", "ez_um")] for r in rows])


def test_all_files_of_a_trace_are_there(traced):
    folder, _ = traced
    names = {p.name for p in (folder / "out").iterdir()}
    assert names >= {"trace.json", "report.html", "machine_augmented.json", "covariance.npz"}
    assert not any(p.name.startswith(".") for p in folder.iterdir())


def test_the_bending_column_is_found_and_the_error_falls(traced):
    folder, _ = traced
    data = json.loads((folder / "out" / "trace.json").read_text(encoding="utf-8"))
    assert (data["format"], data["version"], data["verdict"]) == ("sens-trace", 1, "explained")
    [effect] = data["effects"]
    assert (effect["component"], effect["driver"]) == ("EAZ", "temp_column")
    coefficient = effect["parameters"]["coefficient"]
    assert coefficient["unit"] == "urad/K"
    assert abs(coefficient["value"] - BEND) < 5 * coefficient["u"] < 1
    held = {k: data["error"][k]["held_out"]["rms_um"] for k in ("uncorrected", "declared", "augmented")}
    assert held["augmented"] < 0.5 * held["declared"] < held["uncorrected"]


def test_the_augmented_machine_is_a_machine_with_the_effect(traced):
    folder, _ = traced
    machine = machine_json.load(folder / "out" / "machine_augmented.json")
    assert [e.component for e in machine.effects] == ["EAZ"]
    assert machine.fitted.covariance == "covariance.npz"
    again = machine_json.loads(machine_json.dumps(machine))
    assert again == machine
    assert cli.main(["sensitivity", str(folder / "out" / "machine_augmented.json"), "--out", str(folder / "s")]) == 0
    errors = json.loads((folder / "s" / "sensitivity.json").read_text(encoding="utf-8"))["errors"]
    [effect] = [e for e in errors if e["symbol"] == machine.effects[0].name]
    assert effect["owner"] == "Z" and effect["total"] > 0


def test_the_covariance_belongs_to_the_named_parameters(traced):
    folder, _ = traced
    with np.load(folder / "out" / "covariance.npz", allow_pickle=False) as stored:
        names, matrix = stored["parameters"], stored["covariance"]
    assert matrix.shape == (len(names), len(names))
    np.testing.assert_allclose(matrix, matrix.T, atol=1e-12 * np.abs(matrix).max())
    assert np.linalg.eigvalsh(matrix).min() > -1e-9 * np.abs(matrix).max()


def test_prediction_comes_within_the_noise_of_the_truth(traced):
    folder, known = traced
    out = folder / "predicted.csv"
    words = [
        "predict",
        str(folder / "out" / "machine_augmented.json"),
        str(folder / "positions.csv"),
        "--out",
        str(out),
    ]
    assert cli.main(words) == 0
    names, error = predicted(out)
    assert names[:5] == ["x_mm", "y_mm", "z_mm", "t_s", "temp_column_C"] and names[-1] == "extrapolated"
    off = np.sqrt(((error - known["truth_um"]) ** 2).sum(axis=1).mean())
    assert off < NOISE
    without = np.sqrt((known["truth_um"] ** 2).sum(axis=1).mean())
    assert off < 0.1 * without


def test_the_alignment_can_be_left_out(traced):
    folder, _ = traced
    machine = str(folder / "out" / "machine_augmented.json")
    for name, more in (("with.csv", []), ("without.csv", ["--no-alignment"])):
        words = ["predict", machine, str(folder / "positions.csv"), "--out", str(folder / name), *more]
        assert cli.main(words) == 0
    difference = predicted(folder / "with.csv")[1] - predicted(folder / "without.csv")[1]
    assert np.abs(difference).max() > 0.01


def test_a_missing_column_is_refused_by_name_and_nothing_is_written(traced, tmp_path, capsys):
    folder, _ = traced
    rows = (folder / "positions.csv").read_text(encoding="utf-8").splitlines()
    kept = [r if r.startswith("#") else r.rpartition(",")[0] for r in rows]
    (tmp_path / "p.csv").write_text("\n".join(kept) + "\n", encoding="utf-8")
    machine = str(folder / "out" / "machine_augmented.json")
    assert cli.main(["predict", machine, str(tmp_path / "p.csv"), "--out", str(tmp_path / "o.csv")]) == 2
    message = capsys.readouterr().err
    assert "temp_column" in message and "p.csv" in message and message.count("\n") == 1
    assert not (tmp_path / "o.csv").exists()


def test_inputs_are_never_overwritten(traced, capsys):
    folder, _ = traced
    machine, positions = folder / "out" / "machine_augmented.json", folder / "positions.csv"
    before = machine.read_bytes(), positions.read_bytes()
    for out in (machine, positions):
        assert cli.main(["predict", str(machine), str(positions), "--out", str(out)]) == 2
        assert "overwritten" in capsys.readouterr().err
    assert (machine.read_bytes(), positions.read_bytes()) == before


def test_a_machine_that_was_never_fitted_predicts_nothing(traced, tmp_path, capsys):
    folder, _ = traced
    words = ["predict", str(MACHINE), str(folder / "positions.csv"), "--out", str(tmp_path / "o.csv")]
    assert cli.main(words) == 2
    assert MACHINE.name in capsys.readouterr().err


@pytest.mark.parametrize(
    ("table", "word"),
    [("x_mm,y_mm\n0,0\n", "z_mm"), ("x_mm,y_mm,z_mm,ex_um,ey_um,ez_um\n0,0,0,1,1,1\n", "readings"), ("", "names")],
)
def test_bad_readings_are_refused_and_nothing_is_written(table, word, tmp_path, capsys):
    (tmp_path / "m.csv").write_text(table, encoding="utf-8")
    words = ["trace", str(MACHINE), str(tmp_path / "m.csv"), "--out", str(tmp_path / "out")]
    assert cli.main(words) == 2
    message = capsys.readouterr().err
    assert word in message and "Traceback" not in message
    assert not (tmp_path / "out").exists()


def test_too_few_permutations_for_a_p_of_one_in_a_hundred_are_refused(traced, tmp_path, capsys):
    folder, _ = traced
    words = [
        "trace",
        str(MACHINE),
        str(folder / "measured.csv"),
        "--out",
        str(tmp_path / "out"),
        "--permutations",
        "99",
    ]
    assert cli.main(words) == 2
    assert "199" in capsys.readouterr().err


def test_the_report_of_a_trace_is_one_well_formed_page_that_says_what_the_data_say(traced):
    folder, _ = traced
    data = json.loads((folder / "out" / "trace.json").read_text(encoding="utf-8"))
    page = (folder / "out" / "report.html").read_text(encoding="utf-8")
    root = ElementTree.fromstring(page.removeprefix("<!DOCTYPE html>\n"))
    text = " ".join("".join(root.itertext()).split())
    assert "Explained" in text and "temp_column" in text and "µrad/K" in text
    assert trace_html.um(data["error"]["augmented"]["held_out"]["rms_um"]) in text
    assert "http" not in page and root.find(".//script") is None
    ids = [e.attrib["id"] for e in root.iter() if "id" in e.attrib]
    assert len(ids) == len(set(ids))


@pytest.mark.parametrize("verdict", list(trace_html.VERDICTS))
def test_every_verdict_has_its_words_and_hostile_names_stay_text(traced, verdict):
    folder, _ = traced
    data = json.loads((folder / "out" / "trace.json").read_text(encoding="utf-8"))
    data["verdict"] = verdict
    data["effects"][0]["name"] = "<script>x</script>"
    data["effects"][0]["rivals"] = [{"component": "EXX", "driver": "a*b", "shape": "linear", "why": "<b>why</b>"}]
    data["next_measurements"] = [{"separates": ["a", "<i>"], "do": "<u>", "predicted_difference_um": 1.25}]
    root = ElementTree.fromstring(trace_html.trace_report(data).removeprefix("<!DOCTYPE html>\n"))
    assert root.find(".//script") is None and root.find(".//u") is None
    assert str(trace_html.VERDICTS[verdict][1]) in "".join(root.itertext())


EVERY_PARAMETER = ["coefficient", "rms", "extent", *dict.fromkeys(p for s in SHAPES.values() for p in s.parameters)]
SAME_WORD = {"Amplitude", "Exponent", "Parameter", "rms", "rms x", "rms y", "rms z"}  # in English and another language
SAME_WORD |= {"u, µm", "u², µm²"}
SPOKEN = ("h1", "h2", "h3", "p", "th", "dt", "caption", "figcaption", "footer", "li")


def with_everything(data: dict) -> dict:
    """The data of a trace with an entry in each part of the page, sentences with their messages."""
    said = trace_json.said
    data["effects"][0]["rivals"] = [
        {
            "component": "EXX",
            "driver": "temp_column*y",
            "shape": "lag",
            **said("why", Message("rival-as-much", loss=1.5)),
        }
    ]
    hidden = {
        **said("name", Message("hidden-motion-along", component="EXX", place="y")),
        "component": "EXX",
        "driver": "unlogged*y",
        "shape": "random",
        "parameters": {"rms": {"value": 1.0, "unit": "um/mm"}},
        **said("note", Message("finding-aliased", periods=[10.0, 20.0])),
        "rivals": [],
    }
    data["effects"].append(data["effects"][0] | hidden)
    data["effects"][0]["parameters"] |= {k: {"value": [1.0] * 7, "unit": ""} for k in EVERY_PARAMETER}
    data["refused_names"] = [
        {
            "component": "EYY",
            "driver": "t",
            "shape": "step",
            **said("why", Message("refused-beside-others")),
        }
    ]
    columns = ["temp_column", "t"]
    data["next_measurements"] = [
        {
            **trace_json.said_all("separates", [Message("next-through", columns=columns)]),
            **said("do", Message("next-vary", columns=columns)),
            "predicted_difference_um": 2.0,
        }
    ]
    data["outliers"] = [{"line": 7, "position_mm": [0.0, 0.0, 0.0]}]
    data["findings"][0]["line"] = 3
    return data


def spoken(page: str) -> set[str]:
    """Headings, captions and sentences of a page that have a word in them, other than names from files."""
    root = ElementTree.fromstring(page.removeprefix("<!DOCTYPE html>\n"))
    found = {" ".join("".join(e.itertext()).split()) for tag in SPOKEN for e in root.iter(tag)}
    return {t for t in found if any(c.isalpha() for c in t)}


@pytest.mark.parametrize("language", [x for x in LANGUAGES if x != "en"])
def test_no_heading_and_no_sentence_of_the_report_stays_english(traced, language):
    folder, _ = traced
    data = with_everything(json.loads((folder / "out" / "trace.json").read_text(encoding="utf-8")))
    english, other = (trace_html.trace_report(data, language=x) for x in ("en", language))
    assert f'<html lang="{language}">' in other
    one, two = spoken(english), spoken(other)
    assert len(one) > 70 and len(two) > 70
    assert one & two <= SAME_WORD
    for word in ("Component", "unlogged", ">lag<", ">random<", "order 1", "7 in all", "thermal bending", "held out"):
        assert word in english and word not in other


def test_every_parameter_that_a_shape_can_have_has_a_name():
    assert all(trace_html.parameter_title(key) for key in EVERY_PARAMETER)


@pytest.mark.parametrize("language", [x for x in LANGUAGES if x != "en"])
def test_the_language_is_that_of_the_report_alone(traced, tmp_path, language):
    folder, _ = traced
    words = ["trace", str(MACHINE), str(folder / "measured.csv"), "--out", str(tmp_path), "--language", language]
    assert cli.main(words) == 0
    for name in ("trace.json", "machine_augmented.json"):
        assert (tmp_path / name).read_bytes() == (folder / "out" / name).read_bytes()
    page = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert f'<html lang="{language}">' in page
    words = [trace_html.VERDICTS["explained"][1], *trace_html.STAGES.values(), Message("tr-chart-points")]
    assert all(w.text(language) in page and str(w) not in page for w in words)  # in the charts too


def test_a_language_that_is_not_known_is_refused(traced, tmp_path, capsys):
    folder, _ = traced
    words = ["trace", str(MACHINE), str(folder / "measured.csv"), "--out", str(tmp_path / "o"), "--language", "xx"]
    assert cli.main(words) == 2
    assert "--language" in capsys.readouterr().err
    assert not (tmp_path / "o").exists()


def without_messages(data):
    """The data as version 0.1.0 wrote them: texts alone."""
    if isinstance(data, list):
        return [without_messages(v) for v in data]
    if not isinstance(data, dict):
        return data
    return {k: without_messages(v) for k, v in data.items() if not k.endswith(("_message", "_messages"))}


def texts_without_code(data, path=""):
    """The paths of the sentences (texts of more than two words) that no code stands beside."""
    if isinstance(data, list):
        return [p for i, v in enumerate(data) for p in texts_without_code(v, f"{path}[{i}]")]
    found = []
    for key, value in data.items() if isinstance(data, dict) else ():
        at = f"{path}.{key}"
        if key.endswith(("_message", "_messages")):
            continue
        texts = [v for v in (value if isinstance(value, list) else [value]) if isinstance(v, str) and v.count(" ") > 1]
        if texts and f"{key}_message" not in data and f"{key}_messages" not in data:
            found.append(at)
        found += texts_without_code(value, at)
    return found


def test_a_code_with_its_fields_is_beside_every_sentence_of_trace_json(traced):
    folder, _ = traced
    data = json.loads((folder / "out" / "trace.json").read_text(encoding="utf-8"))
    assert {p.rpartition(".")[2] for p in texts_without_code(data)} <= {"needs", "symbol"}  # names
    assert str(Message.from_dict(data["verdict_message"])) == str(trace_html.VERDICTS[data["verdict"]][1])
    effect = data["effects"][0]
    assert effect["name_message"]["code"] == "effect-named" and effect["name_message"]["text"] == effect["name"]
    assert Message.from_dict(effect["check_message"]).text("de") != effect["check"] == effect["check_message"]["text"]
    conditions = data["guarantee"]["conditions_messages"]
    assert [m["text"] for m in conditions] == data["guarantee"]["conditions"]
    assert next(m for m in conditions if m["code"] == "guarantee-blocks")["count"] > 1


def test_a_code_that_is_not_known_leaves_the_text_as_it_is():
    data = {"why": "so", "why_message": {"code": "of-a-later-version", "text": "so"}, "all": ["a"],
            "all_messages": [{"code": "of-a-later-version", "text": "a"}]}  # fmt: skip
    assert trace_json.text(data, "why", "de") == "so" and trace_json.texts(data, "all", "ko") == ["a"]


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_report_states_the_guarantee_and_the_remarks_on_noise(traced, language):
    folder, _ = traced
    data = json.loads((folder / "out" / "trace.json").read_text(encoding="utf-8"))
    remark = Message("noise-remembers", direction="x", correlation=0.41)
    data["noise"] |= trace_json.said_all("remarks", [remark])
    data["guarantee"]["by"].append({"exchange": "runs", "number": 6, "exact": True})
    page = " ".join("".join(ElementTree.fromstring(trace_html.trace_report(data, language=language)
                                                   .removeprefix("<!DOCTYPE html>\n")).itertext()).split())  # fmt: skip
    exchanges = Message("tr-guarantee-runs-all", count=6).text(language)
    assert remark.text(language) in page and exchanges in page and "1%" in page
    assert all(Message.from_dict(m).text(language) in page for m in data["guarantee"]["conditions_messages"])


def test_sentences_without_codes_are_shown_as_they_are(traced):
    folder, _ = traced
    data = json.loads((folder / "out" / "trace.json").read_text(encoding="utf-8"))
    data = without_messages(data)  # as version 0.1.0 wrote it
    page = trace_html.trace_report(data, language="de")
    assert data["effects"][0]["name"] in page and data["remainder"]["words"] in page and "Befunde" in page


def test_the_value_that_the_readings_ask_for_lies_on_the_effect(traced):
    folder, _ = traced
    machine = machine_json.load(MACHINE)
    outcome = trace(machine, readings_csv.load(folder / "measured.csv"))
    driver, asked, fitted = component_values(outcome.machine.effects[0], outcome)
    assert len(driver) > 200
    arm = np.linalg.norm(machine.lever_arms(outcome.readings.q)["Z"][:, 1:], axis=1)  # EAZ moves y and z
    arm = arm[arm > arm.max() / 3]
    noise = NOISE * 1e3 * np.sqrt((1 / arm**2).mean())  # of one reading, seen through its lever arm, urad
    assert np.std(asked - fitted) == pytest.approx(noise, rel=0.15)
    slope = np.polyfit(driver, asked, 1)[0]
    assert slope == pytest.approx(BEND, rel=0.03)


def test_a_trace_runs_as_a_process_where_freecad_cannot_be_imported(traced, tmp_path):
    folder, _ = traced
    (tmp_path / "block").mkdir()
    words = ("trace", MACHINE, folder / "measured.csv", "--out", tmp_path / "out", "--seed", 3)
    run = command(*words, cwd=tmp_path, block=tmp_path / "block")
    assert (run.returncode, run.stderr) == (0, "")
    assert run.stdout.splitlines()[0] == "explained"


def test_the_demonstration_loop_finds_what_it_hides(tmp_path):
    machine = machine_json.load(MACHINE)
    words = demo.close_the_loop(machine, tmp_path / "loop", seed=5)
    data = json.loads((tmp_path / "loop" / "trace.json").read_text(encoding="utf-8"))
    assert [(e["component"], e["driver"]) for e in data["effects"]] == [("EAZ", "temp_column")]
    assert {p.name for p in (tmp_path / "loop").iterdir()} >= {"measured.csv", "positions.csv", "predicted.csv"}
    assert any("explained" in w for w in words)
    assert study_files.COVARIANCE in {p.name for p in (tmp_path / "loop").iterdir()}


def test_the_report_states_what_a_laboratory_signs(traced):
    """Sums of the inputs, fields to fill in, coverage factor beside every uncertainty, budget, decisions."""
    folder, _ = traced
    page = html_text((folder / "out" / "report.html").read_text(encoding="utf-8"))
    for path in (MACHINE, folder / "measured.csv"):
        assert path.name in page and hashlib.sha256(path.read_bytes()).hexdigest() in page
    for code in (
        "lab-record-serial",
        "lab-record-certificate",
        "lab-signature",
        "lab-source-noise",
        "lab-decision-open",
    ):
        assert str(Message(code)) in page, code
    data = json.loads((folder / "out" / "trace.json").read_text(encoding="utf-8"))
    total = sum(b["variance_um2"] for b in data["budget"])
    assert f"U = {2 * np.sqrt(total):.3g} µm (k = 2" in page
    [effect] = data["effects"]
    value = effect["parameters"]["coefficient"]
    assert f"± {2 * value['u']:.2g} µrad/K (k = 2)" in page
    assert f"± {2 * effect['amplitude_u_um']:.2g} (k = 2)" in page


def html_text(page: str) -> str:
    return html.unescape(re.sub(r"<[^>]+>", "", page))
