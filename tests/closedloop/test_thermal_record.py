# SPDX-License-Identifier: LGPL-2.1-or-later
"""A real record of 46 h: trained on its first 60 %, judged on its last 40 %.  Skipped where the record is not there."""

import pytest

from benchmarks.thermal_record import RECORD, judge

pytestmark = pytest.mark.skipif(not RECORD.exists(), reason=f"{RECORD.name} is not part of the project")


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
