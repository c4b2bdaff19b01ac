# SPDX-License-Identifier: LGPL-2.1-or-later
"""SINUMERIK compensation: ENC_COMP for an axis's own error, CEC (sag) tables for the error of one axis by another.

"A positive compensation value causes the corresponding machine axis to move in the negative direction" (function
manual K3, measuring system error compensation): the value is the error itself.  For CEC no such sentence was found;
the same sign is taken, and `cec_sign=-1` turns it.  A table for one direction of travel is a CEC table.
"""

from __future__ import annotations

import numpy as np

from sensworkbench.core.errors import AXES
from sensworkbench.messages import Refused
from sensworkbench.studies.axis_tables import AxisTable

from ..base import AxisTables

AXIS_NAMES = {"X": "X1", "Y": "Y1", "Z": "Z1"}


class Siemens(AxisTables):
    """ENC_COMP of each axis and CEC between axes."""

    name, title, sign = "siemens", "Siemens ENC_COMP and CEC", "sign-siemens"
    limit = 1025

    def files(self, tables, **options):
        return files(tables, **options)


FORMAT = Siemens()


def files(
    tables: dict[tuple[str, str], AxisTable],
    axis_names=None,
    measuring_system: int = 0,
    reference=None,
    cec_sign: int = 1,
) -> dict[str, str]:
    """File name -> text.

    axis_names : machine axis names (default X1, Y1, Z1).  measuring_system : 0 or 1.  reference : axis -> position of
    its reference point, mm, where every table of that axis is made zero, as the manual asks (None: as they are).
    """
    names = {**AXIS_NAMES, **(axis_names or {})}
    if cec_sign not in (1, -1) or measuring_system not in (0, 1):
        raise Refused("siemens-options", "Siemens")
    out, cec, number = {}, [], 0
    for source in AXES:
        for output in AXES:
            table = tables.get((source, output))
            if table is None:
                continue
            zero = _at(table, (reference or {}).get(source))
            if source == output and not table.reverses:
                out[f"ENC_COMP_{names[source]}.MPF"] = _enc_comp(table, names[source], measuring_system, zero)
                continue
            for direction, values in _directions(table):
                cec += _cec(table, values - zero, number, names, direction, cec_sign)
                number += 1
    if cec:
        out["CEC.MPF"] = "\n".join(["CHANDATA(1)", *cec, "M17"]) + "\n"
    return out


def _at(table: AxisTable, position) -> float:
    """Value of the upward table at the reference point."""
    if position is None:
        return 0.0
    low, high = table.position[0], table.position[-1]
    if not low <= position <= high:  # also where it is not a number
        raise Refused("siemens-reference", f"Siemens, axis {table.source}", position=position, low=low, high=high)
    return float(np.interp(position, table.position, table.plus))


def _directions(table: AxisTable):
    return ((1, table.plus), (-1, table.minus)) if table.reverses else ((0, table.plus),)


def _range(table: AxisTable):
    low, high = float(table.position[0]), float(table.position[-1])
    return (high - low) / (len(table.position) - 1), low, high


def _enc_comp(table: AxisTable, axis: str, system: int, zero: float) -> str:
    step, low, high = _range(table)
    lines = ["CHANDATA(1)"]
    lines += [f"$AA_ENC_COMP[{system},{i},{axis}]={v - zero:.6f}" for i, v in enumerate(table.plus)]
    lines += [
        f"$AA_ENC_COMP_STEP[{system},{axis}]={step:.6f}",
        f"$AA_ENC_COMP_MIN[{system},{axis}]={low:.6f}",
        f"$AA_ENC_COMP_MAX[{system},{axis}]={high:.6f}",
        f"$AA_ENC_COMP_IS_MODULO[{system},{axis}]=0",
        "M17",
    ]
    return "\n".join(lines) + "\n"


def _cec(table: AxisTable, values, number: int, names, direction: int, sign: int) -> list[str]:
    step, low, high = _range(table)
    lines = [f"$AN_CEC[{number},{i}]={sign * v + 0.0:.6f}" for i, v in enumerate(values)]
    return lines + [
        f"$AN_CEC_INPUT_AXIS[{number}]=({names[table.source]})",
        f"$AN_CEC_OUTPUT_AXIS[{number}]=({names[table.output]})",
        f"$AN_CEC_STEP[{number}]={step:.6f}",
        f"$AN_CEC_MIN[{number}]={low:.6f}",
        f"$AN_CEC_MAX[{number}]={high:.6f}",
        f"$AN_CEC_DIRECTION[{number}]={direction}",
        f"$AN_CEC_MULT_BY_TABLE[{number}]=0",
        f"$AN_CEC_IS_MODULO[{number}]=0",
    ]
