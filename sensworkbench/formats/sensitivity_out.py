# SPDX-License-Identifier: LGPL-2.1-or-later
"""sensitivity.json and sensitivity.csv: the exact indices of every error and component with all that they rest on.

Besides the indices the file states the settings, the conventions, the lever arms, the ranking under both squareness
conventions and, for comparison only, what Park & Yang's eq. (18) as printed would give.
"""

from __future__ import annotations

import csv
import io
import json
from dataclasses import replace

import numpy as np

from sensworkbench.core.distributions import moments
from sensworkbench.core.errors import BODIES, BODY_NAMES, SQUARENESS, TRANSLATION, component
from sensworkbench.core.machine import SQUARENESS_CONVENTIONS, Machine
from sensworkbench.core.refusal import Refused
from sensworkbench.core.sobol import group_indices, paper_eq18, signed_group_indices
from sensworkbench.core.synthesis import POSITION, omega
from sensworkbench.core.units import factor
from sensworkbench.core.workspace import CHUNK, Positions, Sensitivity, error_table, sensitivity

from .files import neutral

FORMAT, VERSION = "sens-sensitivity", 1

CONVENTIONS = {
    "names": "ISO 230-1",
    "sign": "error = actual - commanded position of the tool relative to the workpiece, in the machine frame",
    "frame": "x along the X axis, y along Y as far as it is square to X, z square to both",
    "lever_arm": "functional point minus the reference point of the axis, both where they are at that position",
    "model": "first order in the errors (Park & Yang 2012, eq. 1)",
    "first": "V(E(Y|X_i)) / V(Y)",
    "total": "1 - V(E(Y|X_~i)) / V(Y) = (V_i + sum_k V_ik) / V(Y), exact",
    "component_total": "every V_i and V_ik that touches the component, once; not the sum of its members' totals",
}

SQUARENESS_WORDS = {
    "direction": "only the direction of motion tilts (ISO 230-1)",
    "carried": "the guide's rotation also turns what it carries",
}


def objective_words(result: Sensitivity) -> str:
    """The objective as a formula: `T4² + T5² + T6²`."""
    names = ("T4", "T5", "T6") if result.objective.output == POSITION else ("R1", "R2", "R3")
    square = "" if result.objective.signed else "²"
    terms = [
        f"{'' if w == 1 else f'{w:g}·'}{name}{square}" for w, name in zip(result.objective.weights, names) if w != 0
    ]
    return " + ".join(terms).replace("+ -", "- ")


def positions_words(positions: Positions) -> str:
    """Where the indices were taken, in words."""
    if positions.kind == "at":
        return "at X {:g}, Y {:g}, Z {:g} mm".format(*positions.q[0])
    counts = " × ".join(str(c) for c in positions.counts)
    if positions.kind == "grid":
        return f"mean over a grid of {counts} positions over the travel (Park & Yang 2012, eq. 19)"
    return f"mean over the travel by Gauss-Legendre quadrature, {counts} positions"


def mean_position(machine: Machine, result: Sensitivity) -> np.ndarray:
    """(3,) the position asked for, or the middle of the travel; mm."""
    return result.positions.q[0] if result.positions.kind == "at" else machine.travel.mean(axis=1)


def moments_shown(result: Sensitivity) -> dict:
    """E[Y] and V(Y) under names that hold their unit; the two of the position objective are always there."""
    signed, position = result.objective.signed, result.objective.output == POSITION
    scale = 1e3 if position else 1e6
    unit = "um" if position else "urad"
    shown: dict = {"mean_square_um2": None, "variance_um4": None}
    if signed:
        shown |= {f"mean_{unit}": result.mean_square * scale, f"variance_{unit}2": result.variance * scale**2}
    else:
        shown |= {
            f"mean_square_{unit}2": result.mean_square * scale**2,
            f"variance_{unit}4": result.variance * scale**4,
        }
    return shown


KINDS = ("straightness", "linear displacement", "angular", "squareness", "spindle", "workpiece", "traced effects")


def kind_of(label: str, column: str) -> str:
    """The kind of error as Park & Yang group them."""
    c = component(column)
    if label != column:
        return "traced effects"
    if c.body in ("T", "W"):
        return "spindle" if c.body == "T" else "workpiece"
    if c.kind == TRANSLATION:
        return "linear displacement" if "XYZ"[c.axis] == c.body else "straightness"
    return "squareness" if c.kind == SQUARENESS else "angular"


def kind_indices(machine: Machine, result: Sensitivity) -> dict:
    """kind -> {"first", "total"}: group indices of all errors of a kind, mean over the positions of `result`."""
    labels, columns, _, laws = error_table(machine)
    kinds = [kind_of(*pair) for pair in zip(labels, columns)]
    present = [k for k in KINDS if k in kinds]
    groups = [[i for i, k in enumerate(kinds) if k == kind] for kind in present]
    law, objective, positions = moments(laws), result.objective, result.positions
    several = signed_group_indices if objective.signed else group_indices
    first, total = np.zeros(len(groups)), np.zeros(len(groups))
    for start in range(0, len(positions.q), CHUNK):
        block = slice(start, start + CHUNK)
        matrix = omega(machine, columns, positions.q[block], output=objective.output)
        found = several(matrix, law, groups, objective.weights)
        first += positions.weights[block] @ found.first
        total += positions.weights[block] @ found.total
    return {k: {"first": float(f), "total": float(t)} for k, f, t in zip(present, first, total)}


def squareness_conventions(machine: Machine, result: Sensitivity) -> dict:
    """The same indices under both squareness conventions, and what becomes of the paper's finding under each."""
    out = {}
    for convention in SQUARENESS_CONVENTIONS:
        other = replace(machine, squareness=convention)
        r = result
        if convention != machine.squareness:
            try:
                r = sensitivity(other, result.positions, result.objective, estimate=False)
            except Refused:  # an objective that only one convention gives a variance
                continue
        order, kinds = ranking(r), kind_indices(other, r)
        out[convention] = {
            "words": SQUARENESS_WORDS[convention],
            "total": {s: float(t) for s, t in zip(r.symbols, r.total)},
            "largest": [r.symbols[i] for i in order[:6]],
            "kinds": kinds,
            "finding": finding(r, order, kinds),
        }
    return out


def finding(result: Sensitivity, order: list[int], kinds: dict) -> str:
    """One sentence: does what Park & Yang found hold here?"""
    ranked = sorted(kinds, key=lambda k: -kinds[k]["total"])
    words = f"{result.symbols[order[0]]} comes first (Sᵀ = {result.total[order[0]]:.3f}); the kinds rank " + ", ".join(
        f"{k} {kinds[k]['total']:.3f}" for k in ranked if kinds[k]["total"] > 0
    )
    if not {"squareness", "angular", "linear displacement", "spindle", "straightness"} <= set(kinds):
        return words + "."
    leading = {"squareness", "angular"} == set(ranked[:2])
    small = max(kinds["linear displacement"]["total"], kinds["spindle"]["total"]) < 0.1
    if leading and small:
        return (
            words
            + ". The paper's finding holds: squareness and angular errors lead, displacement and spindle are small."
        )
    if small:
        return words + ". Of the paper's finding only the second half holds: displacement and spindle are small."
    return words + ". The paper's finding does not hold with these tolerances."


def paper_as_printed(machine: Machine, result: Sensitivity) -> dict | None:
    """Eq. (18) as printed beside the right S^T at one position; None where it does not apply.

    It knows uniform errors and the plain sum of squares of the position only.
    """
    labels, columns, _, laws = error_table(machine)
    objective = result.objective
    if objective.signed or objective.output != POSITION or any(w not in (0, 1) for w in objective.weights):
        return None
    if any(law.distribution != "uniform" for law in laws):
        return None
    q = mean_position(machine, result)
    rows = [a for a, w in enumerate(objective.weights) if w]
    matrix = omega(machine, columns, q)[0][rows]
    lower, upper = np.array([law.lower for law in laws]), np.array([law.upper for law in laws])
    here = result
    if result.positions.kind != "at":
        here = sensitivity(machine, Positions(q[None], np.ones(1), (1, 1, 1), "at"), objective)
    if not any((matrix**2).sum(axis=1) > 0):
        return None
    printed, variance = paper_eq18(matrix, lower, upper)
    return {
        "note": "for comparison only: eq. (18) as printed is the total index of everything but the error",
        "position": q.tolist(),
        "symbols": list(labels),
        "as_printed": np.where(np.isfinite(printed), printed, 0.0).tolist(),
        "total": here.total.tolist(),
        "variance_um4_eq15a": variance * 1e12,
        "variance_um4": here.variance * 1e12,
    }


def ranking(result: Sensitivity) -> list[int]:
    """Indices of the errors by total index, largest first; equals keep their order."""
    return sorted(range(len(result.symbols)), key=lambda i: -round(result.total[i], 12))


def limits(machine: Machine, angle_unit: str = "urad") -> list[dict]:
    """Per error of the table: unit, lower, upper, distribution, description and the ISO column it uses."""
    if angle_unit not in ("urad", "arcsec"):
        factor(angle_unit, angular=True, where="angle unit")
    out = []
    for label, column, owner, law in zip(*error_table(machine)):
        c = component(column)
        unit = angle_unit if c.angular else "um"
        scale = factor(unit, angular=c.angular)
        words = c.description if label == column else f"traced effect on {column}"
        out.append(
            {
                "symbol": label,
                "column": column,
                "unit": unit,
                "lower": tidy(law.lower / scale),
                "upper": tidy(law.upper / scale),
                "distribution": law.distribution,
                "owner": owner,
                "description": words,
                "sigma": None if law.sigma is None else tidy(law.sigma / scale),
            }
        )
    return out


def tidy(value: float) -> float:
    """A number without the last bits that a change of unit leaves behind (20.000000000000004)."""
    return float(f"{value:.12g}")


def to_dict(machine: Machine, result: Sensitivity, angle_unit: str = "urad") -> dict:
    """sensitivity.json as plain data.  The keys of the format come first, the explanations after them."""
    table = limits(machine, angle_unit)
    errors = []
    for i in ranking(result):
        row = {k: v for k, v in table[i].items() if k not in ("column", "sigma")}
        errors.append(
            row
            | {
                "first": float(result.first[i]),
                "total": float(result.total[i]),
                "total_max": float(result.total_max[i]),
                "first_variance_weighted": float(result.first_vw[i]),
                "total_variance_weighted": float(result.total_vw[i]),
            }
        )
    components = [
        {
            "body": b,
            "name": BODY_NAMES[b],
            "first": float(result.component_first[i]),
            "total": float(result.component_total[i]),
            "total_max": float(result.component_total_max[i]),
            "total_variance_weighted": float(result.component_total_vw[i]),
        }
        for i, b in enumerate(result.bodies)
    ]
    components.sort(key=lambda c: -c["total"])
    at = result.positions.kind == "at"
    q = mean_position(machine, result)
    arms = machine.lever_arms(q)
    return {
        "format": FORMAT,
        "version": VERSION,
        "errors": errors,
        "components": components,
        **moments_shown(result),
        "aggregate": result.positions.kind,
        "points": [float(v) for v in q] if at else list(result.positions.counts),
        "estimated_error": result.estimated_error,
        "machine": {"name": machine.name, "structure": machine.structure},
        "settings": {
            "output": result.objective.output,
            "weights": list(result.objective.weights),
            "signed": result.objective.signed,
            "objective": objective_words(result),
            "squareness": machine.squareness,
            "travel_mm": machine.travel.tolist(),
        },
        "conventions": CONVENTIONS | {"squareness": SQUARENESS_WORDS[machine.squareness]},
        "lever_arms_mm": {"position": [float(v) for v in q]} | {b: arms[b][0].tolist() for b in BODIES},
        "skew_deg": machine.skew_deg,
        "squareness_conventions": squareness_conventions(machine, result),
        "paper_eq18": paper_as_printed(machine, result),
    }


def dumps(data: dict) -> str:
    """The text of a result file; never holds NaN."""
    return json.dumps(data, indent=1, ensure_ascii=False, allow_nan=False) + "\n"


_COLUMNS = (
    "rank", "symbol", "description", "owner", "lower", "upper", "unit", "distribution", "first", "total", "total_max",
    "first_variance_weighted", "total_variance_weighted",
)  # fmt: skip


def csv_text(data: dict) -> str:
    """sensitivity.csv of the data of sensitivity.json: one line per error, the largest total index first."""
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(_COLUMNS)
    for rank, row in enumerate(data["errors"], start=1):
        cells = [rank] + [row[k] for k in _COLUMNS[1:]]
        writer.writerow([neutral(c) if isinstance(c, str) else c for c in cells])
    return stream.getvalue()
