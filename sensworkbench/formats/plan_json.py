# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files of a measuring plan: the table of places in, plan.json, report.html, candidates.csv and a suggested table out.

The table has the columns of measured.csv; readings in it are not needed and not used, but their names say which
directions will be measured.
"""

from __future__ import annotations

import csv
import io
import math
from dataclasses import replace

import numpy as np

from sensworkbench.closedloop import plan as planning
from sensworkbench.closedloop.design import tool_labels
from sensworkbench.closedloop.plan import Plan, PlannedTerm
from sensworkbench.closedloop.readings import Readings, Remark
from sensworkbench.core.refusal import Refused
from sensworkbench.core.units import mm
from sensworkbench.messages import Message
from sensworkbench.studies.plan import PlanResult

from . import column_names, csv_table, readings_csv
from .column_names import DIRECTION, ERROR, NORMAL, POSITION, TOOL
from .files import neutral
from .plan_html import number_words
from .trace_json import remark, said, said_all

_UNITS = {"K": "C", "mm/min": "mm_min"}


# -- in ----------------------------------------------------------------------------------------------------------------
def load(path, noise_um: float, mapping=None, joints=readings_csv.THREE_AXES) -> Readings:
    """A planned table as readings of value 0; approach directions that it lacks are derived from the order of places.

    One reading along nx, ny, nz where these are given; else the directions among ex, ey, ez that the names hold; else
    all three.
    """
    positions = readings_csv.load_positions(path, mapping, joints)
    table = csv_table.read(path)
    ours = {v: k for k, v in (mapping or {}).items() if isinstance(v, str)}
    bases = {}
    for j, name in enumerate(table.names):
        if name and name not in (mapping or {}).get("ignore", ()):
            bases[column_names.parse(ours.get(name, name)).base] = j
    columns, units, remarks = dict(positions.columns), dict(positions.units), list(positions.remarks)
    derived = []
    for axis in (j.column for j in joints):
        direction = readings_csv.approach_directions(columns[axis])
        if f"dir_{axis}" not in columns and direction.any():
            columns[f"dir_{axis}"], units[f"dir_{axis}"] = direction, ""
            derived.append(f"dir_{axis}")
    if derived:
        text = Message("remark-direction-derived", columns=derived, order=Message("order-of-file"))
        remarks.append(Remark("info", "direction-derived", text))
    positions = replace(positions, columns=columns, units=units, remarks=tuple(remarks))
    if all(n in bases for n in NORMAL):
        return planning.as_readings(positions, mm(noise_um), _normals(table, bases, positions))
    named = [i for i, e in enumerate(ERROR) if e in bases]
    return planning.as_readings(positions, mm(noise_um), None, named or (0, 1, 2))


def _normals(table, bases, positions) -> np.ndarray:
    n = np.stack([table.numbers(bases[a]) for a in NORMAL], axis=1)
    length = np.sqrt((n**2).sum(axis=1))
    bad = ~(np.abs(length - 1) < 1e-2)
    if bad.any():
        row = int(np.argmax(bad))
        raise Refused("plan-normal-not-unit", f"{table.source}, line {int(table.line[row])}, columns nx, ny, nz")
    order = np.searchsorted(table.line, positions.line)
    return (n / length[:, None])[order]


# -- out ---------------------------------------------------------------------------------------------------------------
def to_dict(checked: PlanResult) -> dict:
    """The data of plan.json: a sentence in English, and its code and fields beside it as `<key>_message(s)`."""
    plan = checked.shown
    pairs = [{**p, **said_all("effects", p["effects"])} for p in planning.pairs_in_words(plan.confused())]
    return {
        "format": "sens-plan",
        "version": 1,
        "machine": checked.machine.name,
        "structure": checked.machine.structure,
        "noise_um": checked.noise_um,
        "judged": "given" if checked.plan is not None else "suggested",
        "numbers": plan.numbers(),
        "tools": len(tool_labels(plan.readings)) or 1,
        "suggested": None
        if checked.suggested is None
        else {
            "numbers": checked.suggested.numbers(),
            "effects": [_entry(entry, found) for entry, found in checked.suggested.physical()],
        },
        "identifiability": {
            "columns": plan.parameters,
            "rank": plan.rank,
            **said_all("null_space", plan.null_space),
            "no_reading_shows": planning.unseen(plan),
            "move_alike": planning.bodies_alike(plan),
        },
        "errors": [_planned(checked.machine, e) for e in checked.errors],
        "threshold": {
            "family_wise_p": plan.settings.alpha,
            "power": plan.settings.power,
            "candidates": len(plan.candidates),
            "floor": plan.settings.floor,
            "chi_square": plan.threshold,
        },
        "effects": [_entry(entry, found) for entry, found in plan.physical()],
        "not_testable": [{**said("effect", e), "needs": needs} for e, needs in plan.not_testable],
        "hidden": [
            {
                **said("name", c.entry.name),
                "component": c.symbol,
                "driver": str(c.driver),
                "shape": c.shape.name,
                "visible": c.visible,
            }
            for c in plan.named
            if c.hidden
        ],
        "confused": pairs,
        "periods": [
            {
                "axis": lead.axis,
                "lead_mm": lead.lead,
                "visible": lead.visible,
                "looks_like_mm": "constant" if lead.alias == math.inf else lead.alias,
            }
            for lead in plan.leads
        ],
        "advice": [
            {
                **said("do", a.do),
                **said("improves", a.improves),
                "before": a.before,
                "after": a.after,
                "unit": "um" if a.unit == "um" else "",
                **({"why": ""} if a.why is None else said("why", a.why)),
            }
            for a in checked.advice
        ],
        "findings": [remark(f.severity, f.code, f.message, f.line) for f in plan.readings.remarks],
    }


def _planned(machine, error) -> dict:
    c = machine.component(error.symbol)
    shown = lambda u: None if u is None else float(f"{c.to_shown(u):.6g}")  # noqa: E731
    return {
        "symbol": error.symbol,
        "unit": c.unit,
        "u": shown(error.u),
        **{f"u_another_{name}": shown(u) for name, u in error.more.items()},
    }


def _entry(entry, found: list[PlannedTerm]) -> dict:
    best = planning.plain(found)
    plain = next((c for c in best if not c.hidden), best[0] if best else None)
    out = {
        **said("name", entry.name),
        **said("usual_size", entry.size),
        "candidates": len(found),
        "visible": sum(not c.hidden for c in found),
        "plainest": None,
    }
    if plain is not None:
        out["plainest"] = {
            "component": plain.symbol,
            "also": list(plain.alike),
            "driver": str(plain.driver),
            "shape": plain.shape.name,
            "visible_share": plain.visible,
            "smallest": None if plain.coefficient is None else {"value": plain.coefficient, "unit": plain.unit},
            "smallest_um": plain.amplitude_um,
        }
    return out


def candidates_csv(plan: Plan) -> str:
    """Return a table of all candidates (component x driver x shape), one row each, the simplest first."""
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(
        ("component", "also", "driver", "shape", "visible_share", "least_share", "smallest_um", "smallest", "unit",
         "effect")
    )  # fmt: skip
    for c in plan.candidates:
        number = lambda v: "" if v is None else f"{v:.6g}"  # noqa: E731
        texts = (c.symbol, " ".join(c.alike), neutral(str(c.driver)), c.shape.name)
        writer.writerow(
            (*texts, f"{c.visible:.4f}", f"{c.least:.4f}", number(c.amplitude_um), number(c.coefficient),
             neutral(c.unit), str(c.entry.name) if c.entry else "")
        )  # fmt: skip
    return stream.getvalue()


def positions_csv(readings: Readings) -> str:
    """Return a plan as a table of positions that `plan` can read, and `trace` after readings were added."""
    units = readings.units
    names, columns = [], []
    for base, values in readings.columns.items():
        unit = _UNITS.get(units.get(base, ""), units.get(base, ""))
        if base in POSITION:
            unit = "mm"
        shift = 20.0 if base.startswith("temp_") else 0.0
        names.append(f"{base}_{unit}" if unit and base not in DIRECTION else base)
        columns.append([f"{v + shift:.10g}" for v in np.asarray(values, dtype=float)])
    if readings.tool_offset is not None:
        for i, base in enumerate(TOOL):
            names.append(f"{base}_mm")
            columns.append([f"{v:.10g}" for v in readings.tool_offset[:, i]])
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow([csv_table.safe_cell(n) for n in names])
    writer.writerows(zip(*columns, strict=True))
    return stream.getvalue()


def summary(data: dict) -> list[str]:
    """What came out, in a few lines."""
    n = data["numbers"]
    lost = n["parameters"] - n["rank"]
    told = "all are told apart" if lost == 0 else f"{lost} combinations cannot be told apart"
    lines = [
        f"declared model: {n['rank']} of {n['parameters']} parameters determined; {told}",
        f"named physical effects that could be found: {n['physical_effects_testable']} of {len(data['effects'])}",
    ]
    if n["median_detectable_um"] is not None:
        lines.append(
            f"smallest effect found at {data['noise_um']:g} um noise: {n['median_detectable_um']:.2g} um rms (median)"
        )
    if n["aliased_leads"]:
        lines.append(f"aliased screw leads: {n['aliased_leads']} of {len(data['periods'])}")
    lines += [f"{f['severity']}: {f['message']}" for f in data["findings"] if f["severity"] != "info"]
    return lines + [f"advice: {a['do']} ({change_words(a)})" for a in data["advice"]]


def change_words(advice: dict) -> str:
    """`smallest drift that is found: not at all -> 0.8 um`."""
    words = [number_words(advice[k], advice["unit"]) for k in ("before", "after")]
    return f"{advice['improves']}: {words[0]} -> {words[1]}"
