# SPDX-License-Identifier: LGPL-2.1-or-later
"""sensitivity.json: the exact indices of every error and component with all that they rest on.

Besides the indices the file states the settings, the conventions, the lever arms, the ranking under both squareness
conventions and, for comparison only, what Park & Yang's eq. (18) as printed would give.
"""

from __future__ import annotations

from sensworkbench.core.joints import Joint
from sensworkbench.core.machine import Machine
from sensworkbench.core.synthesis import POSITION
from sensworkbench.core.units import factor
from sensworkbench.core.workspace import Sensitivity, error_table
from sensworkbench.messages import Message
from sensworkbench.studies.sensitivity import Convention, SensitivityResult, ranking

from .trace_json import said

FORMAT, VERSION = "sens-sensitivity", 1

CONVENTIONS = {
    "names": "ISO 230-1",
    "sign": "error = actual - commanded position of the tool relative to the workpiece, in the machine frame",
    "frame": "x along the X axis, y along Y as far as it is square to X, z square to both",
    "lever_arm": "functional point minus the reference point of the axis, both where they are at that position",
    "model": "first order in the errors (Park & Yang 2012, eq. 1)",
    "first": "V(E(Y|X_i)) / V(Y)",
    "total": "1 - V(E(Y|X_~i)) / V(Y) = (V_i + sum_k V_ik) / V(Y), exact",
    "share": "Shapley effect, (first + total) / 2: the shares of the errors, and of the components, add up to 1",
    "component_total": "every V_i and V_ik that touches the component, once; not the sum of its members' totals",
}

SQUARENESS_WORDS = {
    "direction": "only the direction of motion tilts (ISO 230-1)",
    "carried": "the guide's rotation also turns what it carries",
}


def moments_shown(result: Sensitivity) -> dict:
    """E[Y] and V(Y) under names that hold their unit; the two of the position objective are always there."""
    judged = result.objective
    power, unit, scale = judged.power, "um", 1e3
    if judged.output != POSITION:
        unit, scale = "urad", 1e6
    mean = f"mean_square_{unit}2" if power == 2 else f"mean_{unit}"
    shown: dict = {"mean_square_um2": None, "variance_um4": None}
    shown[mean] = result.mean_square * scale**power
    if judged.has_shares:
        shown[f"variance_{unit}{2 * power}"] = result.variance * scale ** (2 * power)
    return shown


def limits(machine: Machine, angle_unit: str = "urad") -> list[dict]:
    """Per error of the table: unit, lower, upper, distribution, title (a message) and the ISO column it uses."""
    if angle_unit not in ("urad", "arcsec"):
        factor(angle_unit, angular=True, where="angle unit")
    out = []
    for label, column, owner, law in zip(*error_table(machine)):
        if column:
            c = machine.component(column)
            unit = angle_unit if c.angular else "um"
            scale = factor(unit, angular=c.angular)
            title = c.title if label == column else Message("error-traced", symbol=column)
        else:  # a source is a pure number
            followers = next(s.factors for s in machine.sources if s.name == label)
            unit, scale, title = "1", 1.0, Message("error-source", symbols=list(followers))
        out.append(
            {
                "symbol": label,
                "column": column,
                "unit": unit,
                "lower": tidy(law.lower / scale),
                "upper": tidy(law.upper / scale),
                "distribution": law.distribution,
                "owner": owner,
                "title": title,
                "sigma": None if law.sigma is None else tidy(law.sigma / scale),
            }
        )
    return out


def tidy(value: float) -> float:
    """A number without the last bits that a change of unit leaves behind (20.000000000000004)."""
    return float(f"{value:.12g}")


def to_dict(study: SensitivityResult, angle_unit: str = "urad") -> dict:
    """Return sensitivity.json as plain data.  The keys of the format come first, explanations after them."""
    machine, result = study.machine, study.sensitivity
    table = limits(machine, angle_unit)
    errors = []
    for i in ranking(result):
        row = {k: v for k, v in table[i].items() if k not in ("column", "sigma", "title")}
        errors.append(
            row
            | said("description", table[i]["title"])
            | {
                "first": float(result.first[i]),
                "total": float(result.total[i]),
                "share": float(result.share[i]) if result.objective.has_shares else None,
                "total_max": float(result.total_max[i]),
                "first_variance_weighted": float(result.first_vw[i]),
                "total_variance_weighted": float(result.total_vw[i]),
            }
        )
    components = [
        {
            "body": b,
            **said("name", machine.body_title(b)),
            "first": float(result.component_first[i]),
            "total": float(result.component_total[i]),
            "share": float(result.component_share[i]) if result.objective.has_shares else None,
            "total_max": float(result.component_total_max[i]),
            "total_variance_weighted": float(result.component_total_vw[i]),
        }
        for i, b in enumerate(result.bodies)
    ]
    components.sort(key=lambda c: -c["total"])
    q = study.position
    shown = [j.to_shown(float(v)) for j, v in zip(machine.joints, q)]
    arms = machine.lever_arms(q)
    kind, counts = result.positions.kind, list(result.positions.counts)
    return {
        "format": FORMAT,
        "version": VERSION,
        **({"remarks": [m.to_dict() for m in study.remarks]} if study.remarks else {}),
        "errors": errors,
        "without_extent": without_extent(study),
        "components": components,
        **moments_shown(result),
        "aggregate": kind,
        "points": shown if kind == "at" else counts[0] if kind == "low_discrepancy" else counts,
        "estimated_error": result.estimated_error,
        "machine": {"name": machine.name, "structure": machine.structure},
        "settings": {
            "output": result.objective.output,
            "weights": list(result.objective.weights),
            "signed": result.objective.signed,
            "objective": result.objective.formula,
            "judged": result.objective.to_json(),
            "squareness": machine.squareness,
            "travel_mm": [list(j.span) if j.slides else None for j in machine.joints],
            "joints": [_joint(j) for j in machine.joints],
        },
        "conventions": CONVENTIONS
        | result.objective.conventions
        | {"squareness": SQUARENESS_WORDS[machine.squareness]},
        "lever_arms_mm": {"position": shown} | {b: arms[b][0].tolist() for b in machine.bodies},
        "skew_deg": machine.skew_deg,
        "squareness_conventions": {name: _convention(name, c) for name, c in study.conventions.items()},
        "paper_eq18": _as_printed(study),
    }


def without_extent(study: SensitivityResult) -> list[dict]:
    """The enabled effects that take no part, because no range of them is known: name, owner, and why."""
    owners = {e.name: study.machine.component(e.component).body for e in study.machine.effects}
    why = Message("effect-unranked").to_dict()
    return [{"effect": name, "owner": owners[name], **why} for name in study.sensitivity.without_extent]


def _joint(joint: Joint) -> dict:
    """Name, kind, unit and travel of a joint as the file states them; travel None: endless, one turn is taken."""
    travel = None if joint.travel is None else [tidy(joint.to_shown(v)) for v in joint.travel]
    return {"name": joint.name, "kind": joint.kind.name, "unit": joint.unit, "travel": travel}


def _convention(name: str, c: Convention) -> dict:
    found = c.sensitivity
    return {
        "words": SQUARENESS_WORDS[name],
        "total": {s: float(t) for s, t in zip(found.symbols, found.total)},
        "largest": [found.symbols[i] for i in ranking(found)[:6]],
        "kinds": {kind: {"first": share.first, "total": share.total} for kind, share in c.kinds.items()},
        "finding": " ".join(m.text() for m in c.finding),
        "finding_messages": [m.to_dict() for m in c.finding],
    }


def _as_printed(study: SensitivityResult) -> dict | None:
    found = study.as_printed
    if found is None:
        return None
    return {
        "note": "for comparison only: eq. (18) as printed is the total index of everything but the error",
        "position": found.position.tolist(),
        "symbols": list(found.symbols),
        "as_printed": found.as_printed.tolist(),
        "total": found.total.tolist(),
        "variance_um4_eq15a": found.variance_15a * 1e12,
        "variance_um4": found.variance * 1e12,
    }
