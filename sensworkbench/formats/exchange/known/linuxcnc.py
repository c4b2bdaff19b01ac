# SPDX-License-Identifier: LGPL-2.1-or-later
"""LinuxCNC compensation files, one per joint (meaning read from src/emc/motion/usrmotintf.cc, usrmotLoadComp).

Type 0: nominal, actual position moving up, actual position moving down.  Type 1: nominal and the *trims*, nominal
minus actual, that the controller adds to the command.  At most 256 lines, ascending; mm.  With a table the joint's
BACKLASH is not used: the difference of the two columns takes its place.
"""

from __future__ import annotations

from sensworkbench.core.errors import AXES
from sensworkbench.messages import Message, Refused
from sensworkbench.studies.axis_tables import AxisTable

from ..base import AxisTables


class LinuxCnc(AxisTables):
    """`x.comp` ... and the lines for the machine's INI file."""

    name, title, sign = "linuxcnc", "LinuxCNC COMP_FILE", "sign-linuxcnc"
    limit = 256

    def shifts(self, source, output, reverses):
        return None if source == output else Message("table-shifts-own")

    def files(self, tables, file_type: int = 0):
        return files(tables, file_type)


FORMAT = LinuxCnc()


def files(tables: dict[tuple[str, str], AxisTable], file_type: int = 0) -> dict[str, str]:
    """File name -> text: `x.comp` ... and the lines for the INI file."""
    if file_type not in (0, 1):
        raise Refused("linuxcnc-type", "LinuxCNC", value=repr(file_type)[:60])
    out, ini = {}, ["# lines for the machine's INI file; joint numbers as in [KINS] of a trivkins XYZ machine"]
    for joint, axis in enumerate(AXES):
        table = tables.get((axis, axis))
        if table is None:
            continue
        name = f"{axis.lower()}.comp"
        out[name] = dumps(table, file_type)
        ini += [f"[JOINT_{joint}]", f"COMP_FILE = {name}", f"COMP_FILE_TYPE = {file_type}"]
    out["compensation.ini"] = "\n".join(ini) + "\n"
    return out


def dumps(table: AxisTable, file_type: int = 0) -> str:
    """Triplets; the controller stops reading at the first line that is none, so there are no comments."""
    lines = []
    for q, plus, minus in zip(table.position, table.plus, table.minus, strict=True):
        if file_type == 0:
            lines.append(f"{q:.6f} {q + plus:.6f} {q + minus:.6f}")
        else:
            lines.append(f"{q:.6f} {-plus + 0.0:.6f} {-minus + 0.0:.6f}")
    return "\n".join(lines) + "\n"
