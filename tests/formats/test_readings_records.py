# SPDX-License-Identifier: LGPL-2.1-or-later
"""Records of a session: header lines and a mapping's header, texts and numbers."""

from __future__ import annotations

import pytest

from sensworkbench.core.refusal import Refused
from sensworkbench.formats import readings_csv

ROWS = "x_mm,y_mm,z_mm,ex_um\n" + "".join(f"{i},0,0,1\n" for i in range(14))


def load(tmp_path, head: str, mapping=None):
    path = tmp_path / "measured.csv"
    path.write_text(head + ROWS, encoding="utf-8")
    return readings_csv.load(path, mapping)


def test_header_lines_and_a_side_file_state_what_a_certificate_needs(tmp_path):
    head = "# Instrument: laser, serial 12-3456\n# certificate = D-K-1, 2026-01-07\n# u_scale_um_m: 0,5\n# note: x\n"
    found = load(tmp_path, head, {"header": {"operator": "A. B.", "instrument": "another"}})
    assert found.records == {
        "instrument": "another",  # the side file goes first
        "operator": "A. B.",
        "certificate": "D-K-1, 2026-01-07",
        "u_scale_um_m": "0.5",
    }
    assert load(tmp_path, "").records == {}


@pytest.mark.parametrize("text", ["much", "-1", "nan", "1e9"])
def test_a_number_that_is_none_is_refused_with_its_line(tmp_path, text):
    with pytest.raises(Refused, match="line 2.*u_scale_um_m"):
        load(tmp_path, f"# sign: error\n# u_scale_um_m: {text}\n")
