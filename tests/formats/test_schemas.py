# SPDX-License-Identifier: LGPL-2.1-or-later
"""resources/schemas: every file that is read or written follows its schema, and a schema is as strict as the reader."""

from __future__ import annotations

import copy
import json
import re

import pytest
from jsonschema import Draft202012Validator
from referencing import Registry, Resource

from sensworkbench import cli
from sensworkbench.core import distributions, objectives, shapes, units
from sensworkbench.core.refusal import Refused
from sensworkbench.formats import (
    file_sets,
    machine_json,
    manifest,
    proposal_json,
    readings_csv,
    study_files,
    sweep_files,
    tolerances,
)
from sensworkbench.messages import Message

from .support import ROOT, golden
from .test_trace_files import readings_of

FOLDER, EXAMPLES = ROOT / "resources" / "schemas", ROOT / "resources" / "examples"
MACHINE = EXAMPLES / "vertical_machining_centre.json"
SCHEMAS = {
    p.name.removesuffix(".schema.json"): json.loads(p.read_text(encoding="utf-8")) for p in FOLDER.glob("*.json")
}
REGISTRY = Registry().with_resources([(f"{n}.schema.json", Resource.from_contents(s)) for n, s in SCHEMAS.items()])


def validator(name: str) -> Draft202012Validator:
    return Draft202012Validator({"$ref": f"{name}.schema.json"}, registry=REGISTRY)


VALIDATORS = {name: validator(name) for name in SCHEMAS}


def faults(name: str, data) -> list[str]:
    """What of a document is not as its schema asks for."""
    return [f"{error.json_path}: {error.message[:200]}" for error in VALIDATORS[name].iter_errors(data)]


def faults_of(path) -> list[str]:
    """The same of a file, whose schema its name tells."""
    kind = "machine" if path.name == "machine_augmented.json" else path.name.rpartition(".json")[0].rpartition(".")[2]
    return faults(kind, json.loads(path.read_text(encoding="utf-8")))


# -- the schemas -------------------------------------------------------------------------------------------------------
def test_the_schemas_are_schemas_and_the_page_lists_them():
    for name, schema in SCHEMAS.items():
        Draft202012Validator.check_schema(schema)
        assert schema["title"] and schema["description"] and "LGPL" in schema["$comment"], name
    page = (ROOT / "docs" / "formats.md").read_text(encoding="utf-8")
    listed = re.search(r"JSON Schema.*?\n\n", page, re.DOTALL).group()
    assert set(re.findall(r"`(\w+)`", listed)) >= set(SCHEMAS)


def test_every_format_of_the_program_has_its_schema():
    formats = {}
    for path in (ROOT / "sensworkbench").rglob("*.py"):
        for name in re.findall(r'"sens-(\w+)"', path.read_text(encoding="utf-8")):
            formats.setdefault(name, path)
    stated = {n for n, s in SCHEMAS.items() if "format" in s.get("properties", ())}
    assert {"machine", "trace", "plan", "manifest"} <= stated <= set(formats)
    assert set(formats) - stated <= {"task", "cell"}  # names of threads and pages, no files


def test_the_words_of_the_schemas_are_those_of_the_program():
    defs = SCHEMAS["machine"]["$defs"]
    assert defs["length_unit"]["enum"] == list(units.LENGTH) and defs["angle_unit"]["enum"] == list(units.ANGLE)
    assert defs["distribution"]["enum"] == list(distributions.DISTRIBUTIONS)
    assert defs["effect_1"]["properties"]["shape"]["enum"] == list(shapes.SHAPES)
    assert SCHEMAS["plan"]["$defs"]["shape"]["enum"] == list(shapes.SHAPES)
    of_shapes = {
        rule["if"]["properties"]["shape"]["const"]: rule["then"]["properties"]["parameters"]["propertyNames"]["enum"]
        for rule in defs["shape_parameters"]["allOf"]
    }
    assert of_shapes == {n: ["coefficient", "extent", *c.parameters] for n, c in shapes.SHAPES.items()}
    outputs = SCHEMAS["sensitivity"]["properties"]["settings"]["properties"]["output"]["enum"]
    assert outputs == [objectives.POSITION, objectives.ORIENTATION]


@pytest.mark.parametrize("example", sorted(p.name for p in EXAMPLES.glob("*.json")))
def test_every_error_of_a_machine_has_its_unit(example):
    machine = machine_json.load(EXAMPLES / example)
    for c in machine.components:
        for name in filter(None, (c.symbol, f"E_{c.symbol}", c.alias)):
            for unit in ("um", "urad"):
                table = {name: {"lower": -1, "upper": 1, "unit": unit}}
                found = faults("tolerances", {"format": "sens-tolerances", "version": 1, "tolerances": table})
                assert bool(found) == (unit != c.unit), (name, unit, found)


# -- files that are there ----------------------------------------------------------------------------------------------
def test_the_examples_follow_their_schemas():
    found = [p for p in EXAMPLES.rglob("*.json") if p.name != "spec.json"]
    assert len(found) > 5
    for path in found:
        kind = "features" if path.name == "features.json" else "machine"
        assert faults(kind, json.loads(path.read_text(encoding="utf-8"))) == [], path
    assert faults("sweep", json.loads((EXAMPLES / "sweep" / "spec.json").read_text(encoding="utf-8"))) == []


def test_the_examples_of_the_page_follow_their_schemas():
    page = (ROOT / "docs" / "formats.md").read_text(encoding="utf-8")
    texts = [json.loads(t) for t in re.findall(r"```json\n(.*?)```", page, re.DOTALL)]
    assert len(texts) == 4
    machine = next(t for t in texts if "fitted" in t)
    for data in texts:
        if "factor" in data:  # stands in a fitted machine
            data = machine | {"fitted": {"x-uncertainty": data}}
            machine_json.loads(json.dumps(data))
        assert faults("machine" if "format" in data else "mapping", data) == []


def test_machines_that_the_reader_accepts_follow_the_schema():
    accepted = 0
    for path in sorted((ROOT / "tests" / "fuzz" / "corpus").glob("machine--*.json")):
        try:
            machine_json.load(path)
        except Refused:
            continue
        accepted += 1
        assert faults("machine", json.loads(path.read_text(encoding="utf-8"))) == [], path.name
    assert accepted >= 4


# -- files that the verbs write ----------------------------------------------------------------------------------------
def written(out, *words) -> list:
    """The JSON files that a verb writes to a folder."""
    assert cli.main([*map(str, words), "--out", str(out)]) == 0
    return sorted(out.rglob("*.json"))


VERBS = {
    "sensitivity": ((MACHINE,), {"sensitivity.json", "manifest.json"}),
    "sensitivity of five axes": (
        (EXAMPLES / "trunnion.json", "--grid", "3"),
        {"sensitivity.json", "manifest.json"},
    ),
    "sensitivity at a place": ((MACHINE, "--at", "0,0,-200", "--angle-unit", "arcsec"), {"sensitivity.json"}),
    "sensitivity of the orientation": ((MACHINE, "--output", "orientation"), {"sensitivity.json"}),
    "sensitivity with a sign": ((MACHINE, "--signed", "--weights", "1,0,0"), {"sensitivity.json"}),
    "plan": ((MACHINE, EXAMPLES / "plan_grid.csv", "--suggest", "60"), {"plan.json", "manifest.json"}),
    "allocate": (
        (MACHINE, "--target", "rms=12", "--costs", EXAMPLES / "costs.csv"),
        {"allocation.json", "machine.json", "manifest.json"},
    ),
}


@pytest.mark.parametrize("case", VERBS)
def test_what_a_verb_writes_follows_its_schema(tmp_path, case):
    words, names = VERBS[case]
    paths = written(tmp_path / "out", case.partition(" ")[0], *words)
    assert {p.name for p in paths} >= names
    for path in paths:
        assert faults_of(path) == [], path.name


def test_a_trace_and_a_prediction_follow_their_schemas(tmp_path):
    readings_of(machine_json.load(MACHINE), tmp_path, 11)
    paths = written(tmp_path / "out", "trace", MACHINE, tmp_path / "measured.csv")
    assert {p.name for p in paths} == {"trace.json", "machine_augmented.json", "manifest.json"}
    table = tmp_path / "predicted.csv"
    words = ["predict", tmp_path / "out" / "machine_augmented.json", tmp_path / "positions.csv", "--out", table]
    assert cli.main(list(map(str, words))) == 0
    for path in [*paths, tmp_path / "predicted.csv.manifest.json"]:
        assert faults_of(path) == [], path.name
    data = json.loads((tmp_path / "out" / "trace.json").read_text(encoding="utf-8"))
    for key in list(data):  # nothing of it may be left out
        assert faults("trace", {k: v for k, v in data.items() if k != key}), key
    data["effects"][0]["shape"] = "cubic"
    assert faults("trace", data)


def test_a_proposal_follows_its_schema():
    axis = proposal_json.ProposedAxis("linear", (1.0, 0.0, 0.0), (-200.0, 200.0), (Message("error-note"),), 0.9)
    found = proposal_json.Proposal(
        True, "serial", "XFZ", {"F": ("Base",)}, {"X": axis}, (), (Message("error-note"),), 1.5
    )
    data = json.loads(proposal_json.dumps(found))
    assert faults("proposal", data) == []
    assert faults("proposal", data | {"kind": "hexapod"}) and faults("proposal", data | {"more": 1})
    assert faults("answers", {"bed": "Base", "body:X": ["Carriage"], "direction:X": [1, 0, 0]}) == []
    assert faults("answers", ["Base"])


def test_a_tolerance_file_follows_its_schema():
    text = tolerances.dumps_json(machine_json.load(MACHINE).all_tolerances)
    assert faults("tolerances", json.loads(text)) == []


def test_the_journal_follows_its_schema(tmp_path, monkeypatch):
    found = []
    forward = file_sets._forward
    monkeypatch.setattr(
        file_sets,
        "_forward",
        lambda work, place, journal: (
            found.append((work / file_sets.JOURNAL).read_text()) or forward(work, place, journal)
        ),
    )
    for text in ("one", "two"):
        study_files.write_set(tmp_path, "test", {"a.txt": text})
    assert found
    for text in found:
        assert faults("journal", json.loads(text)) == []


# -- wrong documents ---------------------------------------------------------------------------------------------------
FULL = golden(
    tolerances={"EXX": {"lower": -1, "upper": 1, "unit": "um"}, "EAZ": {"lower": -1, "upper": 1, "sigma": 1,
                                                                      "distribution": "normal"}},
    declared={"EXX": {"shape": "polynomial", "degree": 3}, "EAZ": {"shape": "none"}},
    fitted={
        "EXX": {"basis": "legendre", "domain": [-300, 300], "coefficients": [0, 4], "unit": "um", "u": [None, 1]},
        "C0Y": {"value": 12.0, "unit": "urad", "u": None},
        "alignment": {"EXW": 12.5},
        "runs": {"1": [1, 2, 3], "2": {"ECW": {"value": 1}}},
        "covariance": "covariance.npz",
        "x-tools": [{"offset_mm": [0, 0, 50], "error_um": [1, 2, 3]}],
        "x-ranges": {"t": [0, 10]},
    },
    effects=[
        {"name": "a", "component": "EXX", "driver": "dir_x", "shape": "reversal",
         "parameters": {"coefficient": {"value": 4, "unit": "um", "u": 0.1},
                        "extent": {"value": [-4, 4], "unit": "um"}}},
        {"name": "b", "component": "EAZ", "driver": "temp_column", "shape": "lag", "enabled": False,
         "parameters": {"coefficient": {"value": 4, "unit": "urad/K"}, "tau": {"value": 20, "unit": "min"}}},
    ],
    sources=[{"name": "heat", "distribution": "normal", "sigma": 1.0,
              "factors": {"EXX": {"value": 2, "unit": "um"}, "EAZ": {"value": 1}}}],
)  # fmt: skip
TRUNNION = json.loads((EXAMPLES / "trunnion.json").read_text(encoding="utf-8"))
FIVE = TRUNNION | {
    "frame": {"primary": "X", "secondary": "Y"},
    "tolerances": {"A0C": {"lower": -1, "upper": 1, "unit": "arcsec"}},
    "effects": [{"name": "a", "component": "EZZ", "driver": "temp_spindle", "shape": "linear", "extent": [-1, 5],
                 "parameters": {"coefficient": {"value": 4, "unit": "um/K"}}}],
}  # fmt: skip
TABLE = {"format": "sens-tolerances", "version": 1, "tolerances": FULL["tolerances"]}
SETS = {"format": "sens-manifest", "version": 1, "sets": [{
    "verb": "plan", "made_by": "x", "command": ["plan"], "seed": 1, "conventions": {"units": "mm"},
    "inputs": [{"path": "a", "sha256": "0" * 64, "bytes": 1}],
    "files": [{"name": "b/c", "sha256": "1" * 64, "bytes": 2}],
    "written_over": ["d"]}]}  # fmt: skip
MAPPING = {"t_s": "time", "x_mm": 0, "ignore": ["ch2"], "header": {"sign": "error"}}
SWEEP = {
    "machine": str(MACHINE), "design": "full", "n": 5, "seed": 1, "outputs": ["rms", "share.X"],
    "parameters": [{"path": "joints.Z.point.2", "range": [1, 2, 3]}, {"path": "tool_point.2", "values": [1, 2]}],
}  # fmt: skip
DOCUMENTS = {
    "machine": ("machine", FULL), "five axes": ("machine", FIVE), "tolerances": ("tolerances", TABLE),
    "manifest": ("manifest", SETS), "mapping": ("mapping", MAPPING), "sweep": ("sweep", SWEEP),
}  # fmt: skip
READERS = {
    "machine": machine_json.load,
    "tolerances": tolerances.load,
    "manifest": manifest.load,
    "mapping": readings_csv.load_mapping,
    "sweep": sweep_files.load,
}
# refusals that are about the form of a document alone, which a schema can see
FORM = re.compile(
    r"json-(key|object|list|number|integer|text|boolean|choice)-?.*|unit-not-of-.*|mapping-(ignore|header)"
)

UNCERTAIN = {"fitted", "EXX"}  # as many uncertainties as coefficients: no schema can compare the lengths of lists


def places(data, path=()):
    """The places in a document, itself too; of a list of numbers, the first stands for all."""
    yield path
    members = data.items() if isinstance(data, dict) else enumerate(data) if isinstance(data, list) else ()
    for key, value in members:
        if key in (1, 2) and isinstance(value, (int, float)):
            continue
        yield from places(value, (*path, key))


def changed(data, path, change):
    """A copy in which the member at `path` is changed; `change` gets what holds it and its key."""
    copied = {"": copy.deepcopy(data)}
    place, key = copied, ""
    for step in path:
        place, key = place[key], step
    change(place, key)
    return copied[""]


def put(value):
    def change(place, key):
        place[key] = value

    return change


def drop(place, key):
    del place[key]


def add(place, key):
    if not isinstance(place[key], dict):
        raise KeyError
    place[key]["surplus"] = 1


WRONG = {"number": put(-7), "text": put("furlong"), "null": put(None), "true": put(True), "list": put([]),
         "object": put({}), "dropped": drop, "added": add, "unit": put("urad")}  # fmt: skip


@pytest.mark.parametrize("document", DOCUMENTS)
def test_a_schema_is_as_strict_as_the_reader(tmp_path, document):
    """Every member in turn is replaced, dropped or gets a companion: what is read follows the schema, and what is
    refused for its form does not."""
    name, data = DOCUMENTS[document]
    path, refused, wrong = tmp_path / "f.json", 0, []
    assert faults(name, data) == []
    for place in places(data):
        for how, change in WRONG.items():
            try:
                spoilt = changed(data, place, change)
            except KeyError:  # nothing to drop or to add to
                continue
            path.write_text(json.dumps(spoilt), encoding="utf-8")
            try:
                READERS[name](path)
                code = ""
            except Refused as found:
                code = found.code
            follows = VALIDATORS[name].is_valid(spoilt)
            if not code and not follows:
                wrong.append(f"{place} {how}: is read, but {faults(name, spoilt)[0]}")
            lengths = code == "json-list-length" and UNCERTAIN <= set(place)
            if FORM.fullmatch(code) and follows and not lengths:
                wrong.append(f"{place} {how}: is refused ({code}), but follows the schema")
            refused += not follows
    assert "\n".join(wrong) == "" and refused > 10


BAD = {
    "a unit of another kind": ("machine", FULL, ("tolerances", "EXX", "unit"), "urad", "unit-not-of-length"),
    "a travel of one number": ("machine", FULL, ("axes", "X", "travel"), [1], "json-list-length"),
    "an unknown key": ("machine", FULL, ("toolpoint",), [1, 2, 3], "json-key-unknown"),
    "an extra key": ("machine", FULL, ("x-mine",), [1, 2, 3], ""),
    "a parameter of another shape": ("machine", FULL, ("effects", 0, "parameters", "tau"), 1, "parameter-unknown"),
    "axes in version 2": ("machine", FIVE, ("axes",), {}, "json-key-unknown"),
    "an endless linear joint": ("machine", FIVE, ("joints", 0, "travel"), None, "travel-linear-endless"),
    "a name that is taken": ("machine", FIVE, ("joints", 0, "name"), "F", "joint-name-taken"),
    "a law of its own": ("tolerances", TABLE, ("tolerances", "EXX", "distribution"), "cauchy", "json-choice"),
    "sigma of a flat law": ("tolerances", TABLE, ("tolerances", "EXX", "sigma"), 1, "distribution-without-sigma"),
    "a name that reaches out": ("manifest", SETS, ("sets", 0, "files", 0, "name"), "a/../../b", "manifest-name"),
    "a hidden name": ("manifest", SETS, ("sets", 0, "files", 0, "name"), ".sens-1/b", "manifest-name"),
    "a sum that is none": ("manifest", SETS, ("sets", 0, "files", 0, "sha256"), "ab", "manifest-sum"),
    "values and range": ("sweep", SWEEP, ("parameters", 0, "values"), [1], "sweep-values-or-range"),
    "a sample of values": ("sweep", SWEEP, ("design",), "lhs", "sweep-range-wanted"),
    "an output of no kind": ("sweep", SWEEP, ("outputs",), ["speed"], "sweep-output"),
    "a list for a column": ("mapping", MAPPING, ("x_mm",), [], "mapping-value"),
}  # fmt: skip


@pytest.mark.parametrize("case", BAD)
def test_a_wrong_document_is_refused_by_both(tmp_path, case):
    name, data, place, value, code = BAD[case]
    spoilt = changed(data, place, put(value))
    path = tmp_path / "f.json"
    path.write_text(json.dumps(spoilt), encoding="utf-8")
    try:
        READERS[name](path)
        said = ""
    except Refused as refused:
        said = refused.code
    assert (said, bool(faults(name, spoilt))) == (code, bool(code))
