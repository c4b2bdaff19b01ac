# SPDX-License-Identifier: LGPL-2.1-or-later
"""A real record of 46 h: read through a mapping, trained on its first 60 %, judged on its last 40 %."""

from __future__ import annotations

import numpy as np

from benchmarks.thermal_record import RECORD, judge
from sensworkbench.formats import readings_csv


def test_channel_one_is_a_lag_of_the_spindle_and_few_sensors_and_predicts_the_rest_of_the_record():
    found = judge(RECORD, 1)
    assert any("spindle" in e and "lag" in e for e in found["effects"])
    assert len(found["effects"]) <= 3  # few sensors: all sixteen leave 8 um on the last part
    assert found["test_um"] < 2.0
    assert found["verdict"] == "partly_explained"  # what is left still remembers from reading to reading


def test_channel_five_stays_unexplained():
    found = judge(RECORD, 5)
    assert found["verdict"] == "unexplained"
    assert found["effects"] == []


def test_the_thermal_record_is_read_through_a_mapping():
    mapping = {"t_s": "time_s", "x_mm": 0, "y_mm": 0, "z_mm": 0, "ez_um": "ch1_um"}
    mapping |= {f"temp_t{i}_C": f"t{i}_degC" for i in range(1, 17)}
    mapping["ignore"] = [f"ch{i}_um" for i in range(2, 6)]
    readings = readings_csv.load(RECORD, mapping)
    assert readings.rows == readings.points == 2779
    raw = np.genfromtxt(RECORD, delimiter=",", names=True)
    assert np.allclose(readings.value, raw["ch1_um"] * 1e-3, rtol=0, atol=1e-15)
    assert np.allclose(readings.columns["temp_t9"], raw["t9_degC"] - 20, rtol=0, atol=1e-12)
    assert {"t", "spindle", "temp_t1", "temp_t16"} <= set(readings.columns)
    assert not any(name.startswith("ch") for name in readings.columns)
