# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a file of readings records of its session: machine, instrument, certificate, operator, environment.

Comments above the names (`# instrument: laser XL-80, serial 12-3456`), or the `header` of a mapping file, which is a
side file for tables that cannot be edited.  Numbers among them enter the uncertainty (see `closedloop.sources`).
"""

from __future__ import annotations

import math
from collections.abc import Mapping

from sensworkbench.core.refusal import Refused

from .json_text import short

TEXTS = (
    *("machine", "serial", "instrument", "certificate", "artefact", "operator", "date", "place", "environment"),
    *("procedure", "reviewer"),
)
NUMBERS = {  # key -> (least, most)
    "temperature_c": (-60.0, 200.0),
    "pressure_hpa": (300.0, 1200.0),
    "humidity_pct": (0.0, 100.0),
    "u_scale_um_m": (0.0, 1e4),
    "expansion_um_m_k": (-100.0, 100.0),
    "u_expansion_um_m_k": (0.0, 100.0),
    "u_temperature_k": (0.0, 50.0),
}
KEYS = (*TEXTS, *NUMBERS)
LONGEST, MOST = max(map(len, KEYS)), 500  # characters of a key; of a text


def statement(text: str) -> tuple[str, str]:
    """(key, what is stated) of a comment, cut at its first colon or equals sign; ("", "") where it records nothing."""
    cut = min((at for at in (text.find(":"), text.find("=")) if at >= 0), default=-1)
    name, said = text[: max(cut, 0)].strip(), text[cut + 1 :].strip()
    key = name.lower().replace(" ", "_") if len(name) <= LONGEST else ""
    return (key, said) if key in KEYS and said else ("", "")


def read_records(comments, header: Mapping, names_line: int, source: str) -> dict[str, str]:
    """key -> text: of a mapping's `header` and of `comments` (line, text) above the names; the first of a key holds.

    Refuses a number that is none or out of its range.
    """
    stated = [(f"{k}: {v}", 0) for k, v in header.items()]
    stated += [(text, line) for line, text in comments if line <= names_line]
    found: dict[str, str] = {}
    for text, line in stated:
        key, said = statement(text)
        if not key or key in found:
            continue
        if key in NUMBERS:
            where = f"{source}, line {line}" if line else "mapping, header"
            low, high = NUMBERS[key]
            try:
                value = float(said.replace(",", "."))
            except ValueError:
                value = math.nan
            if not low <= value <= high:
                raise Refused("record-number", where, key=key, text=short(said), least=low, most=high)
            said = f"{value:.12g}"
        found[key] = said[:MOST]
    return found
