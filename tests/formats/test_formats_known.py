# SPDX-License-Identifier: LGPL-2.1-or-later
"""Exchange formats as a registry: one module is a format everywhere; other machines are answered per error."""

from __future__ import annotations

import importlib
import json
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from sensworkbench import cli
from sensworkbench.core.fitted import Constant, FittedModel, Series
from sensworkbench.formats import machine_json
from sensworkbench.formats.exchange import convert, known, tables
from sensworkbench.messages import Refused
from sensworkbench.studies.axis_tables import correction, readings_at
from sensworkbench.studies.predict import predict_study

ROOT = Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "resources" / "examples"
NAMES = known.names()

PLAIN = '''"""Positioning errors, a line each."""
from sensworkbench.formats.exchange.base import AxisTables
from sensworkbench.messages import Message


class Plain(AxisTables):
    name, title = "plain-text", "a plain list"

    def shifts(self, source, output, reverses):
        return None if source == output else Message("table-shifts-own")

    def files(self, tables):
        return {"plain.txt": "".join(f"{s} {len(t.position)}\\n" for (s, _), t in tables.items())}


FORMAT = Plain()
'''


def fitted(name: str):
    """An example machine with a fitted error for every component that its declared model may hold."""
    machine = machine_json.load(EXAMPLES / f"{name}.json")
    series, constants = {}, {}
    for i, symbol in enumerate(machine.declared_symbols):
        c = machine.component(symbol)
        joint = machine.joint(c.body)
        size = c.from_shown(4.0 + i % 3)
        if c.line:
            constants[symbol] = Constant(size)
        else:
            series[symbol] = Series(tuple(joint.to_shown(v) for v in joint.span), (0.0, size, -size / 3))
    return replace(machine, fitted=FittedModel(series=series, constants=constants))


@pytest.fixture
def plain(tmp_path, monkeypatch):
    """A throw-away format: one more module in the package of formats, and nothing else."""
    (tmp_path / "plain_text.py").write_text(PLAIN, encoding="utf-8")
    monkeypatch.setattr(known, "__path__", [*known.__path__, str(tmp_path)])
    importlib.invalidate_caches()
    yield "plain-text"
    sys.modules.pop("sensworkbench.formats.exchange.known.plain_text", None)


def test_a_new_format_is_one_module(plain, tmp_path, capsys):
    assert plain in known.names() and plain in [f.name for f in known.every()]
    machine_json.save(fitted("vertical_machining_centre"), tmp_path / "m.json")
    words = ["convert", str(tmp_path / "m.json"), "--out", str(tmp_path / "o"), "--to"]
    assert cli.main([*words, plain]) == 0
    assert (tmp_path / "o" / "plain.txt").read_text(encoding="utf-8").startswith("X ")
    assert "a plain list" in (tmp_path / "o" / "statement.txt").read_text(encoding="utf-8")
    assert cli.main([*words, "plain-text-2"]) == 2
    assert "plain-text" in capsys.readouterr().err
    assert "| `plain-text` | a plain list | yes |  |" in tables.formats_table()
    assert "`plain-text`" in tables.holds_table().splitlines()[0]


def test_every_format_keeps_its_name_and_can_do_something():
    for name in NAMES:
        found = known.get(name)
        assert found.name == name and found.title
        assert found.writes or found.reads_errors or found.reads_machine
    with pytest.raises(Refused) as refused:
        known.get("../isg")
    assert refused.value.code == "format-unknown"


def test_help_names_every_format(capsys):
    assert cli.main(["convert", "--help"]) == 0
    said = capsys.readouterr().out
    assert all(name in said for name in NAMES)


@pytest.mark.parametrize("make", [tables.formats_table, tables.holds_table])
def test_the_tables_of_the_documentation_are_the_registry(make):
    assert make() in (ROOT / "docs" / "formats.md").read_text(encoding="utf-8"), "run tools/tables.py"


# -- machines of other joints ------------------------------------------------------------------------------------------
@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("example", ["trunnion", "lathe", "rotary_table"])
def test_every_error_of_another_machine_is_held_or_has_its_reason(example, name, tmp_path):
    machine = fitted(example)
    try:
        written = convert.convert(machine, name, tmp_path / "o")
    except Refused as refused:
        assert refused.code == "format-holds-nothing" and example == "rotary_table"
        assert refused.fields["why"].code == "table-rotary"
        return
    if written.coverage is None:
        return
    named = dict(written.coverage.missing)
    assert set(written.coverage.symbols) | set(named) == set(machine.declared_symbols)
    rotary = {s for s in machine.declared_symbols if not machine.joint(machine.component(s).body).slides}
    assert {named[s].code for s in rotary} <= {"table-rotary"} and rotary <= set(named)
    said = (tmp_path / "o" / "statement.txt").read_text(encoding="utf-8")
    assert all(symbol in said for symbol in machine.declared_symbols)
    assert ("is a rotary axis" in said) == bool(rotary)


@pytest.mark.parametrize("example", ["trunnion", "lathe"])
def test_tables_through_a_place_take_its_error_out_on_the_lines(example):
    machine = fitted(example)
    q0 = np.array([0.7 * lo + 0.3 * hi if j.slides else 0.4 for j in machine.joints for lo, hi in [j.span]])
    written = known.get("siemens").write(machine, through=tuple(q0))
    for i, joint in enumerate(machine.joints):
        if not joint.slides:
            continue
        q = np.repeat(q0[None], 5, axis=0)
        q[:, i] = np.linspace(*joint.span, 5)
        before = predict_study(machine, readings_at(machine, q, np.ones_like(q))).error
        left = before - correction(machine, written.tables, q, np.ones_like(q))
        directions = [k for k in ("X", "Y", "Z") if k in machine.names]
        if len(directions) == 3:
            assert np.abs(left).max() < 1e-3 * np.abs(before).max() + 5e-5
        else:  # a lathe cannot shift the tool across its plane
            across = 3 - sum(machine.component(f"EX{k}").along for k in directions)
            assert np.abs(np.delete(left, across, axis=1)).max() < 1e-3 * np.abs(before).max() + 5e-5


def test_a_position_outside_the_travel_or_of_the_wrong_length_is_refused(tmp_path, capsys):
    machine = fitted("trunnion")
    for through, code in (((0, 0, 0), "through-count"), ((1e9, 0, 0, 0, 0), "through-outside")):
        with pytest.raises(Refused) as refused:
            known.get("linuxcnc").write(machine, through=through)
        assert refused.value.code == code
    with pytest.raises(Refused) as refused:
        known.get("linuxcnc").write(machine, through=(float("nan"), 0, 0, 0, 0))
    assert refused.value.code == "through-outside"


# -- files -------------------------------------------------------------------------------------------------------------
def test_version_1_is_lifted_to_version_2_and_means_the_same(tmp_path):
    source = EXAMPLES / "vertical_machining_centre.json"
    assert cli.main(["convert", str(source), "--to", "machine-2", "--out", str(tmp_path / "o")]) == 0
    lifted = json.loads((tmp_path / "o" / "machine.json").read_text(encoding="utf-8"))
    assert lifted["version"] == 2 and [j["name"] for j in lifted["joints"]] == ["X", "Y", "Z"]
    old, new = machine_json.load(source), machine_json.load(tmp_path / "o" / "machine.json")
    assert replace(new, version=1) == old


def test_tables_of_an_earlier_conversion_do_not_stay_beside_the_new_ones(tmp_path):
    whole, out = fitted("vertical_machining_centre"), tmp_path / "o"
    (out).mkdir()
    (out / "mine.txt").write_text("stays", encoding="utf-8")
    convert.convert(whole, "siemens", out)
    before = {p.name for p in out.iterdir()}
    alone = replace(whole, fitted=FittedModel(series={"EXX": whole.fitted.series["EXX"]}))
    convert.convert(alone, "siemens", out)
    after = {p.name for p in out.iterdir()}
    assert {"CEC.MPF", "ENC_COMP_Y1.MPF"} <= before - after
    assert after == {"ENC_COMP_X1.MPF", "statement.txt", "manifest.json", "mine.txt"}


@pytest.mark.parametrize("language", ["de", "ko"])
def test_the_statement_speaks_the_language_that_is_asked_for(language, tmp_path):
    machine = fitted("trunnion")
    texts = [convert.statement(machine, known.get("isg").write(machine), language=code) for code in ("en", language)]
    english, other = ([line for line in t.splitlines() if line.strip()] for t in texts)
    assert len(english) == len(other)
    assert not set(english) & set(other)
