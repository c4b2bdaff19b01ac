# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a file of readings says is what the program takes: units, signs, directions, and nothing dropped in silence."""

from __future__ import annotations

import json

import numpy as np
import pytest

from sensworkbench.core.refusal import Refused
from sensworkbench.formats import column_guess, readings_csv
from tests.simulator import make_case, write_case

HEAD = "x_mm,y_mm,z_mm"


def written(tmp_path, text, name="measured.csv"):
    path = tmp_path / name
    path.write_text(text, encoding="utf-8")
    return path


def rows(header, *lines, pad=12):
    """A table with `lines`, repeated up to `pad` rows so that it is no tiny file."""
    body = [lines[i % len(lines)] for i in range(max(pad, len(lines)))]
    return "\n".join([header, *body]) + "\n"


def read(tmp_path, header, *lines, **kwargs):
    return readings_csv.load(written(tmp_path, rows(header, *lines, **kwargs)))


def codes(readings):
    return {f.code for f in readings.remarks}


@pytest.mark.parametrize(
    ("column", "cell", "name", "value"),
    [
        ("temp_column_C", "22.5", "temp_column", 2.5),
        ("temp_column_K", "293.15", "temp_column", 0.0),
        ("temp_column_F", "68", "temp_column", 0.0),
        ("temp_scale_x_degC", "20.5", "temp_scale_x", 0.5),
        ("load_table_t", "0.15", "load_table", 150.0),
        ("load_table_lb", "1000", "load_table", 453.59237),
        ("load_table_g", "500", "load_table", 0.5),
        ("feed_m_min", "2", "feed", 2000.0),
        ("feed_mm_s", "50", "feed", 3000.0),
        ("spindle_rpm", "3000", "spindle", 3000.0),
        ("spindle_1_s", "50", "spindle", 3000.0),
        ("t_min", "2", "t", 120.0),
        ("t_h", "1", "t", 3600.0),
        ("dir_x", "+1", "dir_x", 1.0),
        ("tilt_arcsec", "1", "tilt", np.pi / 180 / 3600),
        ("gap_um", "3", "gap", 0.003),
        ("humidity_pct", "45", "humidity_pct", 45.0),
        ("coolant_in", "4", "coolant_in", 4.0),
        ("spindle_nose_C", "25", "spindle_nose", 5.0),
    ],
)
def test_a_column_becomes_a_driver_in_internal_units(tmp_path, column, cell, name, value):
    readings = read(tmp_path, f"{HEAD},{column},ex_um", f"1,2,3,{cell},4")
    assert readings.columns[name] == pytest.approx(value, rel=1e-12, abs=1e-12)


@pytest.mark.parametrize("unit, factor", [("um", 1e-3), ("mm", 1.0), ("nm", 1e-6), ("µm", 1e-3)])
def test_readings_are_millimetres_inside(tmp_path, unit, factor):
    readings = read(tmp_path, f"{HEAD},ex_{unit},u_{unit}", "1,2,3,5,0.5")
    assert readings.value == pytest.approx(5 * factor)
    assert readings.u == pytest.approx(0.5 * factor)


@pytest.mark.parametrize(
    "column", ["temp_column_R", "temp_column", "feed_furlong", "x_parsec", "t", "spindle_turns", "load_table", "u_volt"]
)
def test_a_known_name_with_an_unknown_unit_is_refused_with_its_column(tmp_path, column):
    with pytest.raises(Refused, match=r"line 1, column 4.*" + column):
        read(tmp_path, f"{HEAD},{column},ex_um", "1,2,3,4,5")


def test_separator_and_decimal_comma_do_not_change_the_readings(tmp_path):
    plain = read(tmp_path, f"{HEAD},temp_a_C,ex_um", "1.5,2,3,20.25,-4.5")
    for header, line in [
        (f"{HEAD},temp_a_C,ex_um".replace(",", ";"), "1,5;2;3;20,25;-4,5"),
        (f"{HEAD},temp_a_C,ex_um".replace(",", "\t"), "1,5\t2\t3\t20,25\t-4,5"),
        ("\ufeff" + f"{HEAD},temp_a_C,ex_um", "1.5, 2, 3, 20.25, -4.5\r"),
        (f"{HEAD},temp_a_C,ex_um", '"1.5","2","3","20.25","-4.5"'),
    ]:
        other = read(tmp_path, header, line)
        assert np.array_equal(other.q, plain.q)
        assert np.array_equal(other.value, plain.value)
        assert np.array_equal(other.columns["temp_a"], plain.columns["temp_a"])


def test_each_given_component_is_one_row_and_an_empty_cell_none(tmp_path):
    readings = read(tmp_path, f"{HEAD},ex_um,ey_um,ez_um", "1,2,3,4,,6", "7,8,9,,5,", pad=12)
    assert readings.points == 12 and readings.rows == 18
    assert readings.kind[:3].tolist() == [0, 2, 1]
    assert readings.point[:3].tolist() == [0, 0, 1]
    assert readings.sense[:3].tolist() == [[1, 0, 0], [0, 0, 1], [0, 1, 0]]


def test_a_reading_along_its_own_vector(tmp_path):
    readings = read(tmp_path, f"{HEAD},nx,ny,nz,reading_um", "1,2,3,0.6,0.8,0,10")
    assert readings.sense[0] == pytest.approx([0.6, 0.8, 0])
    assert set(readings.kind) == {3}
    with pytest.raises(Refused, match="line 2.*nx, ny, nz.*unit vector"):
        read(tmp_path, f"{HEAD},nx,ny,nz,reading_um", "1,2,3,1,1,0,10")
    with pytest.raises(Refused, match="needs its direction"):
        read(tmp_path, f"{HEAD},nx,ny,reading_um", "1,2,3,1,0,10")


@pytest.mark.parametrize(
    ("header", "factor"),
    [
        ("# sign: error", 1),
        ("# sign: compensation", -1),
        ("# frame: table", -1),
        ("# Sign: compensation\n# frame: table", 1),
    ],
)
def test_a_stated_sign_convention_is_converted_and_said(tmp_path, header, factor):
    plain = read(tmp_path, f"{HEAD},ex_um,nx,ny,nz,reading_um", "1,2,3,4,0,0,1,7")
    path = written(tmp_path, header + "\n" + rows(f"{HEAD},ex_um,nx,ny,nz,reading_um", "1,2,3,4,0,0,1,7"))
    readings = readings_csv.load(path)
    assert readings.value == pytest.approx(factor * plain.value)
    assert ("sign-converted" in codes(readings)) == ("table" in header or "compensation" in header)
    assert "sign-assumed" in codes(plain)


def test_positions_of_a_table_are_turned_into_programmed_ones(tmp_path):
    path = written(tmp_path, "# positions: table X\n" + rows(f"{HEAD},dir_x,ex_um", "10,2,3,-1,4"))
    readings = readings_csv.load(path)
    assert readings.q[0].tolist() == [-10, 2, 3]
    assert readings.columns["dir_x"][0] == 1
    assert "positions-converted" in codes(readings)


@pytest.mark.parametrize("line", ["# sign: positive", "# frame: moon", "# positions: table", "# positions: table U"])
def test_an_answer_that_is_none_is_refused_with_its_line(tmp_path, line):
    with pytest.raises(Refused, match="line 2"):
        readings_csv.load(written(tmp_path, f"# a comment\n{line}\n" + rows(f"{HEAD},ex_um", "1,2,3,4")))


def test_missing_directions_are_derived_from_the_order_and_said(tmp_path):
    lines = ["0,0,0,1", "10,0,0,1", "10,5,0,1", "5,5,0,1", "5,5,0,1"]
    readings = read(tmp_path, f"{HEAD},ex_um", *lines, pad=5)
    assert readings.columns["dir_x"].tolist() == [0, 1, 1, -1, -1]
    assert readings.columns["dir_y"].tolist() == [0, 0, 1, 1, 1]
    assert "dir_z" not in readings.columns  # the axis never moved
    assert "direction-derived" in codes(readings)


def test_positions_to_predict_get_no_derived_directions(tmp_path):
    path = written(tmp_path, "x_mm,y_mm,z_mm\n0,0,0\n10,0,0\n")
    assert "dir_x" not in readings_csv.load_positions(path).columns


def test_given_directions_stay_and_must_be_minus_one_zero_or_one(tmp_path):
    readings = read(tmp_path, f"{HEAD},dir_x,ex_um", "1,2,3,-1,4", "2,2,3,-1,4")
    assert set(readings.columns["dir_x"]) == {-1}
    with pytest.raises(Refused, match=r"line 2, column 4 \(dir_x\).*-1, 0 or 1"):
        read(tmp_path, f"{HEAD},dir_x,ex_um", "1,2,3,0.5,4")


def test_rows_out_of_time_order_are_sorted_stably_and_keep_their_line(tmp_path):
    lines = ["1,0,0,30,1,a", "2,0,0,10,2,b", "3,0,0,10,3,c", "4,0,0,20,4,d"]
    readings = read(tmp_path, f"{HEAD},t_s,ex_um,run", *lines, pad=4)
    assert readings.q[:, 0].tolist() == [2, 3, 4, 1]
    assert readings.line.tolist() == [3, 4, 5, 2]
    assert readings.run.tolist() == ["b", "c", "d", "a"]
    assert (readings.value * 1e3).tolist() == pytest.approx([2, 3, 4, 1])
    assert any(f.code == "time-order" and f.line == 3 for f in readings.remarks)


@pytest.mark.parametrize(
    ("text", "where"),
    [
        (f"{HEAD},ex_um\n1,2,3,4\n1,2,3\n", "line 3"),
        (f"{HEAD},ex_um\n1,2,3,4,5\n", "line 2"),
        (f"# c\n\n{HEAD},ex_um\n1,2,3,4\n1,two,3,4\n", r"line 5, column 2 \(y_mm\)"),
        (f"{HEAD},ex_um\n1,,3,4\n", r"line 2, column 2 \(y_mm\)"),
        (f"{HEAD},ex_um\n1,2,inf,4\n", r"line 2, column 3 \(z_mm\)"),
        (f"{HEAD},ex_um\n1,2,nan,4\n", r"line 2, column 3 \(z_mm\)"),
        (f"{HEAD},ex_um\n1,2,3,inf\n", r"line 2, column 4 \(ex_um\)"),
        (f"{HEAD},ex_um\n1,2,1_000,4\n", r"line 2, column 3 \(z_mm\)"),
        (f"{HEAD},ex_um,ex_mm\n1,2,3,4,5\n", "line 1, column 5"),
        (f"{HEAD},ex_um,\n1,2,3,4,5\n", "line 1, column 5"),
        (f'{HEAD},ex_um,note\n1,2,3,4,"a\nb"\n', "line 2"),
        (f"{HEAD},ex_um,u_um\n1,2,3,4,0\n", r"line 2, column 5 \(u_um\)"),
        (f"{HEAD},flow,ex_um\n" + "1,2,3,4,5\n" * 9 + "1,2,3,4x,5\n", r"line 11, column 4 \(flow\)"),
        ("X_mm,y_mm,z_mm,ex_um\n1,2,3,4\n", "x_mm is missing"),
        (f"{HEAD},ex_um\n1,2,3,\n", "no readings"),
        (f"{HEAD}\n1,2,3\n", "no readings"),
        (f"{HEAD},ex_um\n", "no readings"),
        ("", "no row of names"),
        ("# only a comment\n", "no row of names"),
    ],
)
def test_what_cannot_be_understood_is_refused_with_its_place(tmp_path, text, where):
    with pytest.raises(Refused, match=where):
        readings_csv.load(written(tmp_path, text))


def test_text_that_is_not_utf8_is_refused_with_its_line(tmp_path):
    path = tmp_path / "latin.csv"
    path.write_bytes(b"x_mm,y_mm,z_mm,ex_\xb5m\n1,2,3,4\n")
    with pytest.raises(Refused, match="line 1.*UTF-8"):
        readings_csv.load(path)
    with pytest.raises(Refused, match="cannot be read"):
        readings_csv.load(tmp_path / "absent.csv")


def test_nothing_is_left_out_without_a_word(tmp_path):
    header = f"{HEAD},temp_a_C,temp_b_C,temp_c_C,ex_um,"
    lines = [
        f"{i},0,0,{20 + i},{'' if i == 3 else 21},{'' if i % 2 else 22},{'' if i == 7 else i + 1}," for i in range(20)
    ]
    readings = read(tmp_path, header, *lines, pad=20)
    assert readings.points == 18
    assert set(readings.line) == set(range(2, 22)) - {5, 9}
    assert "temp_c" not in readings.columns and "temp_b" in readings.columns
    said = " ".join(f.text() for f in readings.remarks)
    assert "line 5: these rows are left out" in said
    assert "no reading in line 9: left out" in said
    assert '"temp_c_C"' in said and "the column is left out" in said


def test_a_nan_reading_is_not_a_reading_and_that_is_said(tmp_path):
    readings = read(tmp_path, f"{HEAD},ex_um,ey_um", *["1,2,3,4,5"] * 11, "1,2,3,nan,5")
    assert readings.rows == 23
    assert any(f.code == "nan-reading" and f.line == 13 for f in readings.remarks)


def test_text_columns_are_categories_and_unknown_names_are_reported(tmp_path):
    readings = read(tmp_path, f"{HEAD},operator,flow,run,ex_um", "1,2,3,Ann,4,7,5", "1,2,3,Bo,4,8,5")
    assert set(readings.categories["operator"]) == {"Ann", "Bo"}
    assert readings.columns["flow"][0] == 4
    assert set(readings.run) == {"7", "8"}
    assert any(f.code == "unknown-column" and '"flow"' in f.text() for f in readings.remarks)


def test_tool_offsets_are_vectors(tmp_path):
    readings = read(tmp_path, f"{HEAD},tool_dz_mm,ex_um", "1,2,3,-100,4")
    assert readings.tool_offset[0].tolist() == [0, 0, -100]
    assert read(tmp_path, f"{HEAD},ex_um", "1,2,3,4").tool_offset is None


def test_few_and_huge_readings_are_pointed_out(tmp_path):
    readings = readings_csv.load(written(tmp_path, f"{HEAD},ex_mm\n1,2,3,100\n"))
    assert {"few-readings", "huge-reading"} <= codes(readings)


def test_a_foreign_table_is_read_through_a_mapping_file(tmp_path):
    path = written(tmp_path, rows("Pos X [mm];Pos Y [mm];Dev;Remark", "1,5;2;4;ok"))
    mapping = {"x_mm": "Pos X [mm]", "y_mm": "Pos Y [mm]", "z_mm": 7, "ex_um": "Dev", "ignore": ["Remark"]}
    mapping["header"] = {"sign": "compensation"}
    file = written(tmp_path, json.dumps(mapping), "map.json")
    readings = readings_csv.load(path, readings_csv.load_mapping(file))
    assert readings.q[0].tolist() == [1.5, 2, 7]
    assert readings.value[0] == pytest.approx(-0.004)
    assert "Remark" not in readings.categories
    assert "ignored-column" in codes(readings)
    for bad, why in [
        ('{"x_mm": "Nowhere"}', "Nowhere"),
        ('{"x_mm": ["a"]}', "column's name or a number"),
        ('{"temp_a_R": "Dev"}', "temp_a_R"),
        ('{"x_mm": ', "map.json, line 1"),
        ('{"header": {"sign": "up"}}', "no answer"),
        ('{"header": {"mood": "up"}}', "no question"),
    ]:
        file.write_text(bad, encoding="utf-8")
        with pytest.raises(Refused, match=why):
            readings_csv.load(path, readings_csv.load_mapping(file))


def test_predictions_stand_beside_the_positions_in_their_order(tmp_path):
    text = "# site: hall 3\nx_mm;y_mm;z_mm;t_s;note;ex_um\n1,5;0;0;20;=A1;9\n2,5;0;0;10;-x;9\n"
    path = written(tmp_path, text, "positions.csv")
    positions = readings_csv.load_positions(path)
    assert positions.columns["t"].tolist() == [10, 20] and positions.rows == 0
    out = tmp_path / "predicted.csv"
    error = np.array([[2e-3, 0, -1e-3], [1e-3, 0, 0.5e-3]])  # in the order of time
    readings_csv.save_predicted(out, path, positions, error, extrapolated=[True, False])
    lines = out.read_text(encoding="utf-8").splitlines()
    assert lines[0] == "x_mm;y_mm;z_mm;t_s;note;ex_um;ey_um;ez_um;extrapolated"
    assert lines[1] == "1,5;0;0;20;'=A1;1,000000;0,000000;0,500000;0"
    assert lines[2] == "2,5;0;0;10;'-x;2,000000;0,000000;-1,000000;1"
    assert [p.name for p in tmp_path.iterdir() if p.name.startswith(".")] == []
    again = readings_csv.load(out)
    assert again.value.reshape(2, 3) == pytest.approx(error)
    with pytest.raises(Refused, match="do not belong"):
        readings_csv.save_predicted(out, path, positions, error[:1])


def test_predictions_through_a_mapping_carry_our_names(tmp_path):
    path = written(tmp_path, "PX,PY\n1,2\n", "positions.csv")
    mapping = {"x_mm": "PX", "y_mm": "PY", "z_mm": 3}
    positions = readings_csv.load_positions(path, mapping)
    out = tmp_path / "predicted.csv"
    readings_csv.save_predicted(out, path, positions, np.zeros((1, 3)), mapping=mapping)
    assert out.read_text().splitlines()[0] == "x_mm,y_mm,z_mm,ex_um,ey_um,ez_um"
    assert readings_csv.load(out).q.tolist() == [[1, 2, 3]]


def test_a_position_with_an_empty_condition_is_refused(tmp_path):
    path = written(tmp_path, "x_mm,y_mm,z_mm,temp_a_C\n1,2,3,20\n1,2,3,\n", "positions.csv")
    with pytest.raises(Refused, match=r"line 3, column 4 \(temp_a_C\)"):
        readings_csv.load_positions(path)


def test_a_hundred_thousand_rows_in_a_few_seconds(tmp_path):
    import time
    import tracemalloc

    header = f"{HEAD},t_s," + ",".join(f"temp_{c}_C" for c in "abcdefgh") + ",ex_um,ey_um,ez_um"
    line = ",".join(["-123.456"] * 3 + ["{t}"] + ["20.125"] * 8 + ["1.2345"] * 3)
    path = written(tmp_path, header + "\n" + "\n".join(line.replace("{t}", str(t)) for t in range(100_000)))
    start = time.process_time()
    readings = readings_csv.load(path)
    assert readings.rows == 300_000
    assert time.process_time() - start < 10
    tracemalloc.start()
    readings_csv.load(path)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 1.0 * 2**30


def test_a_simulated_session_is_read_whole(tmp_path):
    case = make_case(2, "column_bend", 2)
    write_case(tmp_path, case)
    raw = np.genfromtxt(tmp_path / "measured.csv", delimiter=",", names=True)
    readings = readings_csv.load(tmp_path / "measured.csv")
    assert np.allclose(readings.value.reshape(-1, 3)[:, 0], raw["ex_um"] * 1e-3, rtol=0, atol=1e-15)
    assert np.allclose(readings.columns["temp_column"], raw["temp_column_C"] - 20, rtol=0, atol=1e-12)
    assert np.array_equal(readings.columns["dir_y"], raw["dir_y"])
    assert not [f for f in readings.remarks if f.severity != "info"]
    assert readings_csv.load_positions(tmp_path / "positions.csv").points == len(raw)


@pytest.mark.parametrize("constants", [{}, {"z_mm": 42.5}])
def test_the_choice_of_columns_is_read_back_from_its_mapping(constants):
    names = ["Pos X [mm]", "y_um", "Zeit [min]", "Column temperature [°C]", "Fx", "EX [µm]", "comment", "ey_um"]
    chosen = column_guess.guesses(names)
    chosen[6] = column_guess.Guess(column_guess.IGNORE)
    chosen[4] = column_guess.Guess(column_guess.DRIVER)
    answers = {"sign": "error"}
    table = column_guess.mapping(names, chosen, constants, answers)
    assert column_guess.from_mapping(names, table) == (chosen, constants, answers)
