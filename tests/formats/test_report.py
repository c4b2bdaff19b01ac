# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report is one well-formed page that loads nothing, escapes everything and says what sensitivity.json says."""

from __future__ import annotations

import json
import re
import struct
import zlib
from xml.etree import ElementTree

import numpy as np
import pytest

from sensworkbench.core import objectives, workspace
from sensworkbench.formats import charts, html, json_text, machine_json, sensitivity_html, sensitivity_json
from sensworkbench.studies.sensitivity import completed

from .support import golden

NASTY = "<script>alert('1')</script> & \"co\""


def png() -> bytes:
    """A picture of one red pixel."""

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", 1, 1, 8, 2, 0, 0, 0)
    image = chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(b"\0\xff\0\0")) + chunk(b"IEND", b"")
    return b"\x89PNG\r\n\x1a\n" + image


def study(positions=None, objective=None, **changes):
    machine = machine_json.loads(json.dumps(golden(**changes)))
    result = workspace.sensitivity(
        machine,
        workspace.quadrature(machine, 3) if positions is None else workspace.at(machine, positions),
        objective or objectives.objective(),
    )
    return completed(machine, result)


def data(**settings) -> dict:
    return json.loads(json_text.dumps(sensitivity_json.to_dict(study(**settings))))


def tree(page: str) -> ElementTree.Element:
    assert page.startswith("<!DOCTYPE html>\n")
    return ElementTree.fromstring(page.removeprefix("<!DOCTYPE html>\n"))


def words(element) -> str:
    return " ".join("".join(element.itertext()).split())


@pytest.fixture(scope="module")
def page() -> str:
    effect = {
        "name": NASTY,
        "component": "EAZ",
        "driver": "temp_column",
        "shape": "linear",
        "parameters": {"coefficient": {"value": 1, "unit": "urad/K"}, "extent": {"value": [-30, 30], "unit": "urad"}},
    }
    return sensitivity_html.sensitivity_report(study(name=NASTY, effects=[effect]), picture=png())


def test_it_is_well_formed_and_escaped(page):
    root = tree(page)
    assert root.find(".//script") is None
    assert words(root.find(".//h1")).startswith(NASTY)
    assert any(NASTY in words(cell) for cell in root.iter("td"))


def test_it_loads_nothing_from_anywhere(page):
    assert not re.search(r"(https?:)?//[a-z]", page.replace("data:image/png;base64,", ""), re.IGNORECASE)
    for element in tree(page).iter():
        for name, value in element.attrib.items():
            if name in ("src", "href"):
                assert value.startswith(("#", "data:"))
    assert "@import" not in page and "<link" not in page


def test_every_id_is_used_once_and_every_reference_is_met(page):
    ids = re.findall(r'\bid="([^"]+)"', page)
    assert len(ids) == len(set(ids))
    assert set(re.findall(r'(?:url\(#|href="#)([^")]+)', page)) <= set(ids)


def test_the_picture_is_inside(page):
    assert "data:image/png;base64,iVBOR" in page


def test_the_ranking_says_what_the_data_say():
    facts = data(positions=(200, 150, -100))
    root = tree(sensitivity_html.sensitivity_report(study(positions=(200, 150, -100))))
    table = next(t for t in root.iter("table") if "Tolerance" in words(t.find("thead")))
    rows = [[words(c) for c in row] for row in table.find("tbody")]
    assert [r[1] for r in rows] == [e["symbol"] for e in facts["errors"]]
    assert rows[0][1:7] == ["EAX", "roll of X about X", "±20 µrad", "0.0144", "0.1874", "0.1009"]
    text = words(root)
    assert "T4² + T5² + T6²" in text and "at X 200, Y 150, Z -100 mm" in text
    assert "only the direction of motion tilts" in text and "the guide's rotation also turns" in text


def test_the_kinds_of_error_are_groups_and_not_sums():
    facts = data(positions=(200, 150, -100))
    totals = {e["symbol"]: e["total"] for e in facts["errors"]}
    kinds = facts["squareness_conventions"]["direction"]["kinds"]
    angular = [f"E{a}{b}" for a in "ABC" for b in "XYZ"]
    assert max(totals[s] for s in angular) < kinds["angular"]["total"] < 0.99 * sum(totals[s] for s in angular)
    # displacements along three square axes do not interact, so there the sum is the group
    assert kinds["linear displacement"]["total"] == pytest.approx(sum(totals[s] for s in ("EXX", "EYY", "EZZ")))
    assert sum(k["first"] for k in kinds.values()) <= 1 <= sum(k["total"] for k in kinds.values())


def test_the_printed_formula_is_the_total_index_of_everything_else():
    facts = data(positions=(200, 150, -100))
    paper = facts["paper_eq18"]
    assert min(paper["as_printed"]) > 0.98
    assert paper["variance_um4_eq15a"] < paper["variance_um4"] == pytest.approx(7154.85)


def test_the_printed_formula_is_left_out_where_it_does_not_apply():
    table = {"EXX": {"lower": -1, "upper": 1, "distribution": "normal"}}
    assert data(tolerances=table)["paper_eq18"] is None
    assert "as printed" not in sensitivity_html.sensitivity_report(study(tolerances=table))


@pytest.mark.parametrize(
    "objective",
    [
        objectives.objective("orientation"),
        objectives.objective(weights=(1, -2, 0), signed=True),
        objectives.objective(weights=(0, 0, 3)),
    ],
)
def test_every_objective_has_its_report(objective):
    root = tree(sensitivity_html.sensitivity_report(study(objective=objective)))
    assert objective.formula in words(root)


def test_text_from_outside_is_escaped_by_every_helper():
    for made in (
        html.table([NASTY], [[NASTY]], NASTY),
        html.facts([(NASTY, NASTY)]),
        html.tiles([(NASTY, NASTY)]),
        html.note(NASTY),
        html.section(NASTY, NASTY),
        html.picture(png(), NASTY, NASTY),
        html.body_label("X", NASTY),
    ):
        element = ElementTree.fromstring(f"<div>{made}</div>")
        assert element.find(".//script") is None
        assert NASTY in "".join(element.itertext()) + "".join(v for e in element.iter() for v in e.attrib.values())


def test_charts_are_well_formed_whatever_they_hold():
    rng = np.random.default_rng(1)
    q, v = rng.normal(size=(40, 3)) * 100, rng.normal(size=(40, 3))
    drawn = [
        charts.bar_chart([NASTY, "b$_2$"], [0.1, 0.0], [0.5, 0.1], ["#3b82c4"] * 2, [0.6, 0.2], {NASTY: "#3b82c4"}),
        charts.grouped_bars([NASTY], {"a": [1], NASTY: [2]}, NASTY, NASTY),
        charts.scatter(q[:, 0], {NASTY: v[:, 0], "b": v[:, 1]}, NASTY, "$y$", line=(q[:, 0], v[:, 0]), alt=NASTY),
        charts.histogram({NASTY: v[:, 0], "empty": []}, NASTY),
        charts.histogram({"constant": np.zeros(5)}),
        charts.arrows(q, {"before": v, NASTY: 0 * v}),
        charts.arrows(np.zeros((0, 3)), {"none": np.zeros((0, 3))}),
        charts.arrows(q[:1], {"one": v[:1]}),
    ]
    for svg in drawn:
        root = ElementTree.fromstring(svg)
        assert root.tag == "svg" and root.attrib["role"] == "img"
        assert root.find(".//script") is None
    assert NASTY[:30] in "".join(ElementTree.fromstring(drawn[0]).itertext())
    assert "b$_2$" in drawn[0]


def test_a_long_name_leaves_the_chart_its_room(recwarn):
    svg = charts.bar_chart(["a long name of an effect " * 9], [0.1], [0.5], ["#3b82c4"])
    assert "…" in svg
    assert not [w for w in recwarn if "constrained_layout" in str(w.message)]


def test_the_bars_are_as_long_as_the_numbers():
    svg = ElementTree.fromstring(charts.bar_chart(["a", "b"], [0.0, 0.0], [0.4, 0.1], ["#3b82c4", "#e0812b"]))
    lengths = []
    for path in svg.iter("path"):
        style, shape = path.attrib.get("style", ""), path.attrib.get("d", "")
        if ("#3b82c4" in style or "#e0812b" in style) and "opacity" in style:
            x = [float(n) for n in re.findall(r"[ML] ([-\d.]+) ", shape)]
            lengths.append(max(x) - min(x))
    assert len(lengths) == 2
    assert lengths[0] / lengths[1] == pytest.approx(4, rel=1e-3)
