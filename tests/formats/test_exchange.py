# SPDX-License-Identifier: LGPL-2.1-or-later
"""Error tables of other systems: a controller that runs them makes the error that we say remains, and tables that are
written and read again describe the same machine.
"""

from __future__ import annotations

import json
import re
from dataclasses import replace

import numpy as np
import pytest

from sensworkbench.closedloop.predict import predict
from sensworkbench.core.errors import AXES, FUNCTION_SYMBOLS, SQUARENESS_SYMBOLS
from sensworkbench.core.fitted import FittedModel
from sensworkbench.core.joints import linear
from sensworkbench.core.machine import Machine, structure_chains
from sensworkbench.core.shapes import Smooth
from sensworkbench.core.synthesis import volumetric_error
from sensworkbench.formats import fitted_json, readings_csv
from sensworkbench.formats.effects_json import of_parameters
from sensworkbench.formats.exchange import known
from sensworkbench.formats.exchange.convert import (
    after_compensation,
    convert,
    expressible,
    import_errors,
    statement,
    write,
)
from sensworkbench.formats.exchange.known import etalon, isg
from sensworkbench.messages import Message, Refused
from sensworkbench.studies import remaining as remains
from sensworkbench.studies.axis_tables import axis_tables, correction
from sensworkbench.studies.error_tables import Convention, converted, merged, to_machine
from sensworkbench.studies.fitted_errors import as_direction

FORMATS = [f.name for f in known.every() if f.takes_positions]  # of errors

TRAVEL = {"X": (-200.0, 200.0), "Y": (-150.0, 150.0), "Z": (-400.0, -100.0)}
TURN = {"X": (1.0, 0, 0), "Y": (0, 1.0, 0), "Z": (0, 0, 1.0)}


def remaining(m: Machine, name: str, positions=None):
    return remains.remaining(m, known.get(name), positions)


def machine(structure="XYFZ", *, directions=TURN, fitted=None, effects=(), squareness="direction") -> Machine:
    rng = np.random.default_rng(7)
    workpiece, tool = structure_chains(structure)
    if fitted is None:
        fitted = {}
        for s in FUNCTION_SYMBOLS:
            straight = s[1] in "XYZ" and s[1] != s[2]
            c = rng.normal(size=4) * 5
            c[0] = 0
            c[1] *= not straight
            unit = "urad" if s[1] in "ABC" else "um"
            fitted[s] = {"basis": "legendre", "domain": list(TRAVEL[s[2]]), "coefficients": list(c), "unit": unit}
        fitted |= {"C0Y": {"value": 20.0, "unit": "urad"}, "B0Z": 12.0, "A0Z": {"value": -4.0, "unit": "arcsec"}}
    references = {"X": (30.0, -180, 200), "Y": (-60.0, -200, 100), "Z": (15.0, 100, 600)}
    return Machine(
        name="test machine",
        workpiece_chain=workpiece,
        tool_chain=tool,
        joints={k: linear(k, directions[k], references[k], TRAVEL[k]) for k in AXES},
        tool_point=(10.0, -20, 150),
        fitted=fitted_json.loads(json.dumps(fitted), "fitted") if isinstance(fitted, dict) else fitted,
        effects=tuple(effects),
        squareness=squareness,
    )


def effect(name, component, driver, shape="linear", **parameters):
    return of_parameters(name, component, driver, shape, {k: {"value": v} for k, v in parameters.items()})


BACKLASH = effect("backlash", "EXX", "dir_x", "reversal", coefficient=4.0)
WINDUP = effect("wind-up", "EXX", "dir_x*x", coefficient=0.01)
PITCH = effect("pitch", "EYY", "y", "periodic", coefficient=[1.0, 0.5], period=40.0)
SAG = effect("sag", "EZX", "x*z", coefficient=1e-4)
TWIST = effect("twist", "EAY", "x", coefficient=0.05)
NEIGHBOUR = effect("neighbour", "EZY", "x", "polynomial", coefficient=[1.0, -2.0], domain=[-200.0, 200.0], degree=2)
HEAT = effect("heat", "EYZ", "temp_column", coefficient=1.5)
EFFECTS = (BACKLASH, WINDUP, PITCH, SAG, TWIST, NEIGHBOUR, HEAT)


def error(m: Machine, q, direction=1.0, temperature=0.0) -> np.ndarray:
    """(P, 3) mm, straight from the text of SPEC: Legendre sums times Omega."""
    columns = {"temp_column": np.full(len(q), temperature)}
    values = {}
    for i, k in enumerate("xyz"):
        columns[k] = q[:, i]
        columns[f"dir_{k}"] = np.full(len(q), direction)
    for s, e in fitted_json.to_dict(m.fitted).items():
        if s in SQUARENESS_SYMBOLS:
            unit = {"urad": 1e-6, "arcsec": np.pi / 648000}[e["unit"]] if isinstance(e, dict) else 1e-6
            values[s] = np.full(len(q), (e["value"] if isinstance(e, dict) else e) * unit)
        elif s in FUNCTION_SYMBOLS:
            low, high = e["domain"]
            u = (2 * columns[s[2].lower()] - low - high) / (high - low)
            values[s] = np.polynomial.legendre.legval(u, e["coefficients"]) * (1e-6 if s[1] in "ABC" else 1e-3)
    for e in m.effects:
        if e.enabled:
            values[e.component] = values.get(e.component, 0) + e.values(columns)
    return volumetric_error(m, values, q) if values else np.zeros_like(q)


def places(count=60, inside=1.0):
    rng = np.random.default_rng(11)
    middle = np.array([sum(TRAVEL[k]) / 2 for k in AXES])
    half = np.array([(TRAVEL[k][1] - TRAVEL[k][0]) / 2 for k in AXES])
    return middle + inside * half * rng.uniform(-1, 1, size=(count, 3))


def compensated(m: Machine, q, shift, direction, temperature=3.0):
    """The error that a controller makes that goes to q + shift(q) when told q, (P, 3) mm."""
    moved = shift(q, direction)
    u = np.stack([m.directions[k] for k in AXES])
    return error(m, q + moved, direction, temperature) + moved @ u


# -- controllers, each read from its files by other code than wrote them ---------------------------------------------
def linuxcnc_shift(files):
    tables = {k: np.loadtxt(files[f"{k.lower()}.comp"].splitlines()) for k in AXES}
    types = set(re.findall(r"COMP_FILE_TYPE = (\d)", files["compensation.ini"]))

    def shift(q, direction):
        out = np.zeros_like(q)
        for i, k in enumerate(AXES):
            nominal, up, down = tables[k].T
            trim = up if direction > 0 else down
            trim = nominal - trim if types == {"0"} else trim  # usrmotLoadComp: forward_trim = nominal - forward
            out[:, i] = np.interp(q[:, i], nominal, trim)
        return out

    return shift


def siemens_shift(files):
    tables = []
    for text in files.values():
        for system, axis in sorted(set(re.findall(r"ENC_COMP_STEP\[(\d),(\w+)\]", text))):
            entries = dict(re.findall(rf"ENC_COMP\[{system},(\d+),{axis}\]=(\S+)", text))
            get = lambda n, t=text, s=system, a=axis: float(re.search(rf"ENC_COMP_{n}\[{s},{a}\]=(\S+)", t).group(1))  # noqa: E731
            tables.append((axis, axis, 0, entries, get("MIN"), get("MAX"), get("STEP")))
        for t in sorted(set(re.findall(r"AN_CEC_STEP\[(\d+)\]", text))):
            entries = dict(re.findall(rf"AN_CEC\[{t},(\d+)\]=(\S+)", text))
            get = lambda n, x=text, t=t: re.search(rf"AN_CEC_{n}\[{t}\]=\(?([^\s)]+)", x).group(1)  # noqa: E731
            limits = (float(get("MIN")), float(get("MAX")), float(get("STEP")))
            tables.append((get("INPUT_AXIS"), get("OUTPUT_AXIS"), int(get("DIRECTION")), entries, *limits))

    def shift(q, direction):
        out = np.zeros_like(q)
        for source, output, only, entries, low, high, step in tables:
            if only and only != direction:
                continue
            values = np.array([float(entries[str(i)]) for i in range(len(entries))])
            position = low + step * np.arange(len(values))
            assert position[-1] == pytest.approx(high, abs=1e-3)
            i, j = AXES.index(source[0]), AXES.index(output[0])
            out[:, j] -= np.interp(q[:, i], position, values)  # a positive value moves the axis the negative way
        return out

    return shift


def heidenhain_shift(files):
    tables = []
    for name, text in files.items():
        if not name.endswith(".COM"):
            continue
        lines = text.splitlines()
        assert lines[0] == f"BEGIN {name} MM" and lines[-1] == "[END]"
        head = lines[1].split()
        tables.append((name[5], head, np.array([[float(v) for v in line.split()] for line in lines[2:-1]])))

    def shift(q, direction):
        out = np.zeros_like(q)
        for source, head, rows in tables:
            at = rows[:, head.index("AXISPOS")]
            for output in set(head) & set(AXES):
                column = head.index(output)
                if output == source and direction < 0 and "BACKLASH" in head:
                    column = head.index("BACKLASH")
                out[:, AXES.index(output)] -= np.interp(q[:, AXES.index(source)], at, rows[:, column])
        return out

    return shift


CONTROLLERS = {"linuxcnc": linuxcnc_shift, "siemens": siemens_shift, "heidenhain": heidenhain_shift}
BACKWARDS = {"X": (1.0, 0, 0), "Y": (0, -1.0, 0), "Z": (0, 0, 1.0)}  # Y counts the other way: a left-handed machine


@pytest.mark.parametrize("direction", [1.0, -1.0])
@pytest.mark.parametrize("directions", [TURN, BACKWARDS])
@pytest.mark.parametrize("structure", ["FXYZ", "XYFZ", "YFXZ"])
@pytest.mark.parametrize("fmt", sorted(CONTROLLERS))
def test_a_controller_with_the_tables_makes_the_error_that_is_said_to_remain(fmt, structure, directions, direction):
    m = machine(structure, directions=directions, effects=EFFECTS)
    written = write(m, fmt, through=None)
    q = places(inside=0.95)
    left = compensated(m, q, CONTROLLERS[fmt](written.files), direction)
    said = error(after_compensation(m, fmt), q, direction, temperature=3.0)
    assert np.abs(left - said).max() < 2e-4  # um: second order, table spacing and rounding
    assert np.abs(error(m, q, direction, 3.0) - said).max() > 5e-3  # and there was something to take out


@pytest.mark.parametrize("through", ["middle", (100.0, -50.0, -350.0)])
@pytest.mark.parametrize("directions", [TURN, BACKWARDS])
@pytest.mark.parametrize("structure", ["FXYZ", "XYFZ", "YFXZ"])
@pytest.mark.parametrize("fmt", sorted(CONTROLLERS))
def test_tables_along_lines_leave_what_is_said_and_nothing_on_the_lines(fmt, structure, directions, through):
    tilt = effect("tilt", "EBX", "dir_x", "reversal", coefficient=12.0)
    m = machine(structure, directions=directions, effects=(*EFFECTS[:-1], tilt), squareness="carried")
    written = write(m, fmt, through=through)
    q = places(inside=0.95)
    for d in (1.0, -1.0):
        left = compensated(m, q, CONTROLLERS[fmt](written.files), d)
        said = error(m, q, d, 3.0) - correction(m, written.tables, q, np.full_like(q, d))
        assert np.abs(left - said).max() < 3e-4
    centre = np.array([0.0, 0, -250]) if through == "middle" else np.array(through)
    # along the line of X through the point all that changes is gone (LinuxCNC: in X only)
    line = np.repeat(centre[None], 9, axis=0)
    line[:, 0] = np.linspace(-190, 190, 9)
    rest = error(m, line, 1.0) - correction(m, written.tables, line, np.stack([np.ones(9), *np.zeros((2, 9))], axis=1))
    reversal = error(m, line, 1.0) - error(m, line, 0.0)
    if fmt == "siemens":
        assert np.abs(rest).max() < 1e-4
    elif fmt == "heidenhain":  # across, only the middle of a reversal is known
        assert np.abs(rest - reversal * [0, 1, 1]).max() < 1e-4
    else:
        assert np.abs(rest[:, 0]).max() < 1e-4
    text = statement(m, written)
    assert "EAX" in text and "held only along the lines of the axes through" in text


def test_lines_do_not_care_how_a_fit_shared_an_error():
    """EBZ and EXZ cannot be told apart with one tool; the tables must not depend on the choice."""
    lever = machine("FXYZ").lever_arms(np.zeros((1, 3)))["Z"][0]
    unit = {"basis": "legendre", "domain": list(TRAVEL["Z"])}
    rotation = unit | {"coefficients": [0, 10.0], "unit": "urad"}
    one = machine("FXYZ", fitted={"EBZ": rotation})
    shift = lambda v: unit | {"coefficients": [0, 10.0 * v * 1e-3], "unit": "um"}  # noqa: E731
    other = machine("FXYZ", fitted={"EXZ": shift(lever[2]), "EZZ": shift(-lever[0])})
    q = places()
    assert error(one, q) == pytest.approx(error(other, q), abs=1e-12)
    moved = [siemens_shift(write(m, "siemens").files)(q, 1) for m in (one, other)]
    assert moved[0] == pytest.approx(moved[1], abs=2e-6) and np.abs(moved[0]).max() > 1e-4
    with pytest.raises(Refused, match="nothing in this machine"):
        write(one, "siemens", through=None)
    with pytest.raises(Refused, match="no position"):
        write(one, "siemens", through="here")


def test_both_linuxcnc_types_move_the_machine_the_same_way():
    m = machine(effects=EFFECTS)
    q = places(inside=0.99)
    for d in (1.0, -1.0):
        first, second = (linuxcnc_shift(write(m, "linuxcnc", file_type=t).files)(q, d) for t in (0, 1))
        assert np.abs(first).max() > 1e-3
        assert np.allclose(first, second, atol=3e-6)


def test_linuxcnc_tables_stay_within_what_the_controller_reads():
    fine = effect("fine", "EXX", "x", "periodic", coefficient=[3.0, 0.0], period=2.0)
    written = write(machine(effects=[fine]), "linuxcnc")
    for k in "xyz":
        rows = np.loadtxt(written.files[f"{k}.comp"].splitlines())
        assert 3 <= len(rows) <= 256 and (np.diff(rows[:, 0]) > 0).all() and rows.shape[1] == 3
    assert any("X by X: 256 points" in str(n) and "interpolation error" in str(n) for n in written.notes)
    table = axis_tables(machine(effects=[fine]), written.coverage, known.get("linuxcnc"))["X", "X"]
    assert table.interpolation > 5e-4  # a pitch of 2 mm is lost in 256 points, and the table says so


def test_siemens_tables_can_be_zero_at_the_reference_point_and_turned():
    m = machine()
    plain, zeroed = write(m, "siemens").files, write(m, "siemens", reference={"X": 100.0}).files
    at = np.array([[100.0, 0.0, -200.0]])
    other = at + [[50.0, 0, 0]]
    before, after = siemens_shift(plain), siemens_shift(zeroed)
    moved = before(other, 1) - before(at, 1)
    assert (after(other, 1) - after(at, 1))[0] == pytest.approx(moved[0], abs=3e-6)
    enc = lambda f, name: siemens_shift({name: f[name]})  # noqa: E731
    assert abs(enc(plain, "ENC_COMP_X1.MPF")(at, 1)[0, 0]) > 1e-4
    assert enc(zeroed, "ENC_COMP_X1.MPF")(at, 1)[0, 0] == pytest.approx(0, abs=2e-6)
    turned = write(m, "siemens", cec_sign=-1).files
    assert enc(turned, "CEC.MPF")(other, 1) == pytest.approx(-enc(plain, "CEC.MPF")(other, 1))
    with pytest.raises(Refused, match="outside"):
        write(m, "siemens", reference={"X": 900.0})


def test_the_itnc_table_is_equidistant_and_refuses_a_reversal():
    written = write(machine(), "heidenhain", style="itnc530").files
    lines = written["AXIS-X.COM"].splitlines()
    datum, distance = map(float, re.match(r"BEGIN AXIS-X\.COM  DATUM:(\S+) DISTANCE:(\S+)", lines[0]).groups())
    assert datum == -200 and distance * (len(lines) - 4) == pytest.approx(400, abs=0.02)
    with pytest.raises(Refused, match="direction of travel"):
        write(machine(effects=[BACKLASH]), "heidenhain", style="itnc530")


# -- coverage --------------------------------------------------------------------------------------------------------
def test_what_each_format_can_express():
    m = machine(effects=EFFECTS)
    covered = {f: expressible(m, f) for f in FORMATS}
    assert set(covered["isg"].symbols) == set(FUNCTION_SYMBOLS) | set(SQUARENESS_SYMBOLS)
    assert covered["isg"].effects == ("pitch", "sag", "twist", "neighbour")
    assert set(covered["etalon"].symbols) == set(covered["isg"].symbols)
    assert covered["etalon"].effects == ("pitch",)
    assert set(covered["linuxcnc"].symbols) == {"EXX", "EYY", "EZZ"}
    assert covered["linuxcnc"].effects == ("backlash", "wind-up", "pitch")
    nine = {f"E{a}{k}" for a in AXES for k in AXES}
    assert set(covered["siemens"].symbols) == set(covered["heidenhain"].symbols) == nine | set(SQUARENESS_SYMBOLS)
    assert covered["siemens"].effects == ("backlash", "wind-up", "pitch", "neighbour")
    for f, c in covered.items():
        named = {*c.symbols, *c.effects, *(name for name, _ in c.missing)}
        assert named == set(FUNCTION_SYMBOLS) | set(SQUARENESS_SYMBOLS) | {e.name for e in EFFECTS}, f
    assert dict(covered["isg"].missing)["heat"] == Message("table-foreign-column", columns=["temp_column"])
    assert dict(covered["siemens"].missing)["EAX"].code == "table-no-rotation"


def test_a_switched_off_effect_is_neither_written_nor_missed():
    c = expressible(machine(effects=[replace(BACKLASH, enabled=False)]), "linuxcnc")
    assert "backlash" not in c.effects and "backlash" not in dict(c.missing)


def test_carried_squareness_is_tilt_of_direction_and_constant_rotations():
    q = places()
    for structure in ("FXYZ", "XYFZ", "YFXZ"):
        m = machine(structure, squareness="carried", effects=[effect("warp", "C0Y", "temp_column", coefficient=2.0)])
        same = as_direction(m)
        assert same.squareness == "direction"
        assert np.abs(error(m, q, 1.0, 3.0) - error(machine(structure), q, 1.0, 3.0)).max() > 1e-3
        assert error(same, q, 1.0, 3.0) == pytest.approx(error(m, q, 1.0, 3.0), abs=1e-12)


@pytest.mark.parametrize("fmt", sorted(FORMATS))
def test_the_predictor_of_the_program_tells_the_error_after_compensation(tmp_path, fmt):
    m = machine(effects=(BACKLASH, SAG, PITCH))
    path = tmp_path / "positions.csv"
    q = np.round(places(20), 3)
    path.write_text("x_mm,y_mm,z_mm,dir_x\n" + "\n".join(f"{x},{y},{z},-1" for x, y, z in q))
    positions = readings_csv.load_positions(path)
    before, after = predict(m, positions), predict(after_compensation(m, fmt), positions)
    assert before == pytest.approx(error(m, q, -1.0), abs=1e-12)
    assert after == pytest.approx(error(after_compensation(m, fmt), q, -1.0), abs=1e-12)
    gain = (before**2).sum() - (after**2).sum()
    assert gain > 0


def test_a_free_form_of_positions_is_a_table_too():
    height = np.linspace(-1, 2, Smooth(bumps=(5,), domains=((-200.0, 200.0),)).size).tolist()
    wavy = effect("wavy", "EZX", "x", "smooth", coefficient=height, bumps=[5.0], domains=[-200.0, 200.0])
    m = machine(fitted={}, effects=[wavy])
    q = places()
    along = np.zeros_like(q)
    along[:, 2] = wavy.values({"x": q[:, 0]})
    assert np.ptp(along) > 1e-3
    assert siemens_shift(write(m, "siemens").files)(q, 1) == pytest.approx(-along, abs=5e-5)
    (table,) = isg.loads(next(iter(write(m, "isg").files.values()))).tables
    assert np.interp(q[:, 0], table.points[:, 0], table.values) == pytest.approx(along[:, 2], abs=5e-5)


# -- ISG and Etalon --------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("squareness", ["direction", "carried"])
@pytest.mark.parametrize("fmt", ["isg", "etalon"])
def test_tables_that_are_written_and_read_again_describe_the_same_machine(tmp_path, fmt, squareness):
    effects = [SAG, TWIST] if fmt == "isg" else []
    m = machine("XYFZ", effects=effects, squareness=squareness)
    written = convert(m, fmt, tmp_path / "out")
    (name,) = written.files
    bare = machine("XYFZ", fitted={}, squareness=squareness)
    convention = Convention(squareness="direction")
    again, quality, _ = import_errors(bare, fmt, tmp_path / "out" / name, convention=convention)
    q = places()
    assert error(again, q) == pytest.approx(error(m, q), abs=1e-5)
    assert len(quality) == 18 and max(a.largest for a in quality) < 1e-3
    assert error(after_compensation(m, fmt), q) == pytest.approx(np.zeros((len(q), 3)), abs=1e-12)


def test_the_approximation_of_a_rough_table_is_reported():
    x = np.linspace(-200, 200, 81)
    rough = 1e-3 * np.sin(2 * np.pi * x / 80)
    text = "X EXX\n" + "\n".join(f"{a} {v}" for a, v in zip(x, rough, strict=True))
    m, (quality,), _ = to_machine(machine(fitted={}), isg.loads(text))
    assert quality.symbol == "EXX" and quality.degree == 3 and quality.unit == "um"
    assert 0.5 < quality.rms < 0.75 and 0.9 < quality.largest < 1.7
    _, (finer,), _ = to_machine(m, isg.loads(text), degree=30)
    assert finer.rms < 1e-3 * quality.rms
    with pytest.raises(Refused, match="degree"):
        to_machine(m, isg.loads(text), degree=31)


@pytest.mark.parametrize(
    ("values", "symbol", "said"),
    [("0 8 -5", "EXX", "8 mm"), ("0 0.99 0", "EXX", ""), ("0 1.2 20", "EAX", "20 rad"), ("0 0.009 0", "EAX", "")],
)
def test_a_table_in_another_unit_than_mm_and_rad_is_noticed(values, symbol, said):
    text = f"X {symbol}\n" + "\n".join(f"{x} {v}" for x, v in zip((-200, 0, 200), values.split(), strict=True))
    _, _, remarks = to_machine(machine(fitted={}), isg.loads(text))
    found = [f for f in remarks if f.code == "table-size-implausible"]
    assert len(found) == bool(said)
    assert all(f.severity == "warning" and symbol in f.text() and said in f.text() for f in found)


@pytest.mark.parametrize(
    ("places", "said"),
    [("-200000 0 200000", "200000 mm"), ("-0.3 0 0.3", "0.3 mm"), ("-400 0 400", ""), ("0 50 100", "")],
)
def test_positions_in_another_unit_than_mm_are_noticed(places, said):
    text = "X EXX\n" + "\n".join(f"{x} {v}" for x, v in zip(places.split(), (0, 0.005, 0.001), strict=True))
    _, _, remarks = to_machine(machine(fitted={}), isg.loads(text))
    found = [f for f in remarks if f.code == "table-places-implausible"]
    assert len(found) == bool(said)
    assert all(f.severity == "warning" and f.text().startswith("X: ") and said in f.text() for f in found)


def test_a_squareness_in_another_unit_than_rad_is_noticed():
    _, _, remarks = to_machine(machine(fitted={}), etalon.loads("[C0Y]\nVALUE = 20\n"))
    assert [f.message.fields["symbol"] for f in remarks if f.code == "table-size-implausible"] == ["C0Y"]


def test_the_examples_of_the_isg_pages_are_read():
    text = """// Machine position errors
Y0A    Z0A    X0B
0.1    0.2    0.11
# Z = 0 and Z = 100
Z      X      EXX    EYX    EZX    EAX    EBX    ECX
// In the first block Z is always = 0.
0.0    0.0    0.02   0.01   0.07   0.00   0.0042 0.003
0.0    10.0   0.00   -0.1   0.01   0.00   0.0011 0.002
// In the second block Z is always = 100.
100.0  0.0    0.01   0.02   0.03   0.07   0.0040 0.003
100.0  10.0   0.03   -0.09  0.03   0.06   0.0015 0.000
"""
    read = isg.loads(text)
    assert [t.symbol for t in read.tables] == ["EXX", "EYX", "EZX", "EAX", "EBX", "ECX"]
    assert read.tables[0].arguments == ("Z", "X")
    assert {f.text()[:3] for f in read.remarks} == {"Y0A", "Z0A", "X0B"}
    m, quality, _ = to_machine(machine(fitted={}), read)
    corners = np.array([[0, 0, 0], [10, 0, 0], [0, 0, 100], [10, 0, 100]], dtype=float)
    columns = {"x": corners[:, 0], "z": corners[:, 2]}
    for table in read.tables:  # four corners: the bilinear form goes through them
        e = m.fitted.series[table.symbol]
        own = np.polynomial.legendre.legval(corners[:, 0] / 5 - 1, e.coefficients)
        rest = sum((f.values(columns) for f in m.effects if f.component == table.symbol), 0 * own)
        assert own + rest == pytest.approx(table.values, abs=1e-9)


def test_the_example_of_the_etalon_page_is_read():
    text = """[C0B]
VALUE = 0.000022355737
[EXY]
Gridpoints = {
          -280.0 -0.001358635132
          -270.0 -0.000240680764
           270.0 -0.000316265101
}  // end of EXY
"""
    read = etalon.loads(text)
    (table,) = read.tables
    assert table.symbol == "EXY" and table.arguments == ("Y",)
    assert table.points[:, 0].tolist() == [-280, -270, 270]
    assert table.values[0] == -0.001358635132
    assert [f.line for f in read.remarks] == [1]


def test_redundant_position_errors_become_three_squareness_errors():
    angles = dict(zip(("A0X", "B0X", "C0X", "A0Y", "B0Y", "C0Y", "A0Z", "B0Z", "C0Z"), range(1, 10), strict=True))
    names = " ".join(angles)
    read = isg.loads(f"{names} X0Y\n" + " ".join(f"{v}e-6" for v in angles.values()) + " 0.5\n")
    assert read.constants == pytest.approx({"C0Y": 3e-6, "A0Z": 3e-6, "B0Z": 6e-6})
    # the same machine seen from a set-up turned by (a, b, c) has the same squareness
    a, b, c = 7e-6, -4e-6, 9e-6
    turned = {n: v * 1e-6 + {"A": a, "B": b, "C": c}[n[0]] for n, v in angles.items()}
    again = isg.loads(f"{names}\n" + " ".join(f"{v:.12g}" for v in turned.values()) + "\n")
    assert again.constants == pytest.approx(read.constants)
    assert {"alignment-removed", "rotation-ignored", "offset-ignored"} <= {f.code for f in read.remarks}


@pytest.mark.parametrize(
    ("convention", "symbol", "factor", "flip"),
    [
        (Convention(sign="compensation"), "EXX", -1, 1),
        (Convention(sign="compensation"), "C0Y", -1, 1),
        (Convention(own_motion=("X",)), "EXX", -1, 1),
        (Convention(own_motion=("X",)), "EXY", 1, 1),
        (Convention(own_motion=("Y",)), "C0Y", 1, 1),
        (Convention(table_positions=("X",)), "EXX", 1, -1),
        (Convention(angles="passive"), "EAX", -1, 1),
        (Convention(angles="passive"), "EXX", 1, 1),
        (Convention(squareness_sign="larger_than_90"), "B0Z", -1, 1),
        (Convention(squareness_sign="larger_than_90"), "C0Y", 1, 1),
        (Convention(squareness_sign="larger_than_90"), "A0Z", 1, 1),
    ],
)
def test_a_stated_convention_is_converted_and_said(convention, symbol, factor, flip):
    read = isg.loads("C0Y B0Z A0Z\n1 2 3\n#\nX EXX EAX\n0 4 5\n10 6 7\n#\nY EXY\n0 1\n1 2\n")
    out = converted(read, convention)
    if symbol in read.constants:
        assert out.constants[symbol] == factor * read.constants[symbol]
    else:
        old, new = (next(t for t in r.tables if t.symbol == symbol) for r in (read, out))
        assert np.array_equal(new.values, factor * old.values)
        assert np.array_equal(new.points, flip * old.points)
    assert len(out.remarks) == 1


def test_larger_than_90_means_the_angle_between_the_axes():
    """Turning Y about +Z or Z about +X opens the angle to the primary axis, Z about +Y closes it."""
    m = machine("FXYZ", fitted={}, effects=())
    base = np.array([[0.0, 0, 0], [100, 0, 0], [0, 100, 0], [0, 0, 100]])
    for symbol, (first, second), opens in (("C0Y", (1, 2), 1), ("B0Z", (1, 3), -1), ("A0Z", (2, 3), 1)):
        actual = base + volumetric_error(m, {symbol: 1e-4}, base)
        u, v = actual[first] - actual[0], actual[second] - actual[0]
        angle = np.arccos(u @ v / np.linalg.norm(u) / np.linalg.norm(v)) - np.pi / 2
        assert angle == pytest.approx(opens * 1e-4, rel=1e-3)


@pytest.mark.parametrize(
    ("module", "text", "where"),
    [
        (isg, "", "no error"),
        (isg, "X EXX\n", "line 1.*without values"),
        (isg, "X EXX\n0 1\n1\n", "line 3.*1 values under 2"),
        (isg, "X EXX\n0 one\n", "line 2.*number"),
        (isg, "X EXX\n0 nan\n1 2\n", "line 2.*finite"),
        (isg, "X EXX\n0 1\n0 2\n", "two rows for one position"),
        (isg, "X EXX EXX\n0 1 2\n", "line 1.*twice"),
        (isg, "X EXX\n0 1\n1 2\n#\nX EXX\n0 1\n1 2\n", "lines 1 and 5"),
        (isg, "X EQX\n0 1\n", 'line 1.*unknown parameter "EQX"'),
        (isg, "EXX\n0.1\n", "line 1.*no argument"),
        (etalon, "", "no error"),
        (etalon, "VALUE = 1\n", "line 1.*before the first"),
        (etalon, "[EXX]\nGridpoints = {\n0 1\n", "ends inside"),
        (etalon, "[EXX]\nGridpoints = {\n0 1 2\n}\n", "line 3.*position and a value"),
        (etalon, "[EXX]\nGridpoints = {\n0 x\n}\n", "line 3.*not a number"),
        (etalon, "[EXX]\nVALUE = 1\n", "line 1.*no Gridpoints"),
        (etalon, "[C0Y]\nGridpoints = {\n0 1\n}\n", "line 1.*no VALUE"),
        (etalon, "[EXX]\nGridpoints = {\n0 1\n0 2\n}\n", "line 1.*two values"),
        (etalon, "[FOO]\nVALUE = 1\n", "line 1.*unknown parameter"),
        (etalon, "[C0Y]\nVALUE = inf\n", "line 2.*not finite"),
        (etalon, "[C0Y]\nVALUE = 1\n[C0Y]\nVALUE = 1\n", "line 3.*twice"),
        (etalon, "[C0Y]\nWERT = 1\n", "line 2.*neither"),
    ],
)
def test_a_table_that_cannot_be_understood_is_refused_with_its_line(module, text, where):
    with pytest.raises(Refused, match=where):
        module.loads(text)


def test_two_files_may_not_state_the_same_parameter():
    one = isg.loads("X EXX\n0 1\n1 2\n")
    with pytest.raises(Refused, match="EXX is stated by two files"):
        merged([one, one])
    with pytest.raises(Refused, match="one position only"):
        to_machine(machine(fitted={}), isg.loads("X EXX\n0 1\n"))


# -- folders and statements ------------------------------------------------------------------------------------------
@pytest.mark.parametrize("fmt", sorted(FORMATS))
def test_the_statement_names_everything_that_is_not_held(tmp_path, fmt):
    m = machine(effects=EFFECTS)
    written = convert(m, fmt, tmp_path / "out")
    assert {p.name for p in (tmp_path / "out").iterdir()} == {*written.files, "statement.txt", "manifest.json"}
    text = (tmp_path / "out" / "statement.txt").read_text(encoding="utf-8")
    assert text == statement(m, written)
    for name, why in written.coverage.missing:
        assert any(
            line.endswith(f": {why}.") and name in re.split(r", |: ", line.strip()) for line in text.splitlines()
        )
    for name in (*written.coverage.symbols, *written.coverage.effects):
        assert name in text
    assert "errors" in text or "positions" in text  # the sign is stated


@pytest.mark.parametrize("fmt", sorted(FORMATS))
def test_the_error_that_remains_is_that_of_the_workspace(fmt):
    m = machine(effects=EFFECTS)
    r = remaining(m, fmt)
    assert r.left_out == ("heat",)
    q = np.array([[x, y, z] for x in np.linspace(*TRAVEL["X"], 7) for y in np.linspace(*TRAVEL["Y"], 7)
                  for z in np.linspace(*TRAVEL["Z"], 7)])  # fmt: skip
    for rms, largest, what in (
        (r.rms_before_um, r.max_before_um, m),
        (r.rms_after_um, r.max_after_um, after_compensation(m, fmt)),
    ):
        vectors = np.concatenate([error(what, q, d) for d in (1.0, -1.0)])
        length = np.linalg.norm(vectors - vectors.mean(axis=0), axis=1) * 1e3
        assert rms == pytest.approx(np.sqrt((length**2).mean()))
        assert largest == pytest.approx(length.max())
    written = write(m, fmt) if fmt in ("isg", "etalon") else write(m, fmt, through=None)
    text = statement(m, written)
    assert f"before compensation: rms {r.rms_before_um:.2f} um" in text
    assert f"after compensation:  rms {r.rms_after_um:.2f} um" in text
    assert "What positions alone decide" in text and "does not know: heat." in text
    assert remaining(machine(), "isg").max_after_um == pytest.approx(0, abs=1e-9)


def test_at_given_places_a_temperature_that_no_table_knows_is_in_the_figures(tmp_path):
    straight = FittedModel({"EXX": machine().fitted.series["EXX"]})
    m = machine(fitted=straight, effects=[HEAT])  # 1.5 um/K along y
    path = tmp_path / "places.csv"
    q = places(20)
    rows = [[*p, 20 + k] for p in q for k in (10, -10)]
    path.write_text("x_mm,y_mm,z_mm,temp_column_C\n" + "\n".join(",".join(f"{v:.9g}" for v in r) for r in rows) + "\n")
    positions = readings_csv.load_positions(path)
    r = remaining(m, "isg", positions)
    assert r.left_out == () and r.rms_after_um == pytest.approx(15) and r.max_after_um == pytest.approx(15)
    vectors = np.concatenate([error(m, q, temperature=k) for k in (10, -10)])
    length = np.linalg.norm(vectors - vectors.mean(axis=0), axis=1) * 1e3
    assert r.max_before_um == pytest.approx(length.max()) and r.max_before_um > 15.2
    text = statement(m, write(m, "isg"), positions)
    assert "at the 40 places given" in text and "after compensation:  rms 15.00 um, largest 15.00 um" in text


def test_a_machine_without_errors_or_with_none_that_fit_is_refused(tmp_path):
    with pytest.raises(Refused, match="nothing in this machine"):
        convert(machine(fitted={}), "isg", tmp_path / "out")
    with pytest.raises(Refused, match="nothing in this machine.*heat"):
        convert(machine(fitted={}, effects=[HEAT]), "siemens", tmp_path / "out")
    with pytest.raises(Refused, match="unknown format"):
        convert(machine(), "fanuc", tmp_path / "out")
    assert not (tmp_path / "out").exists()
