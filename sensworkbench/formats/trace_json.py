# SPDX-License-Identifier: LGPL-2.1-or-later
"""trace.json of a `closedloop.result.TraceResult`: um and urad, sentences in English with their codes.

A sentence is the text under its key; its code and fields are beside it, under `<key>_message`, or for a list of texts
under `<key>_messages`.  Texts without codes, as 0.1.0 wrote them, are shown as they are.
"""

from __future__ import annotations

from collections.abc import Mapping

from sensworkbench.closedloop.result import (
    HiddenMotion,
    NamedEffect,
    NoiseSummary,
    StageError,
    TraceResult,
)
from sensworkbench.core.effects import shown
from sensworkbench.core.errors import component
from sensworkbench.core.units import um
from sensworkbench.messages import Message
from sensworkbench.messages.tables import known

FORMAT, VERSION = "sens-trace", 1
VERDICTS = {  # verdict -> its title and its sentence
    "nothing_to_explain": (
        Message("tr-verdict-nothing-to-explain"),
        Message("tr-verdict-nothing-to-explain-words"),
    ),
    "explained": (Message("tr-verdict-explained"), Message("tr-verdict-explained-words")),
    "partly_explained": (Message("tr-verdict-partly-explained"), Message("tr-verdict-partly-explained-words")),
    "unexplained": (Message("tr-verdict-unexplained"), Message("tr-verdict-unexplained-words")),
}


# -- sentences ---------------------------------------------------------------------------------------------------------
def said(key: str, message: Message | None) -> dict:
    """{key: English text, key_message: code and fields}."""
    if message is None:
        return {}
    return {key: str(message), f"{key}_message": message.to_dict()}


def said_all(key: str, messages) -> dict:
    """{key: [English text], key_messages: [code and fields]}."""
    return {key: [str(m) for m in messages], f"{key}_messages": [m.to_dict() for m in messages]}


def remark(severity: str, code: str, message: Message | str, line: int) -> dict:
    """A remark on the readings: `code` names its kind.  line : of the table, 0 for all of it."""
    words = said("message", message) if isinstance(message, Message) else {"message": message}
    return {"severity": severity, "code": code, **words, "line": line}


def text(data: Mapping, key: str, language: str = "en") -> str:
    """The sentence under `key` in a language; as it stands where its code is not known ("" where it is not there)."""
    return _spoken(data.get(f"{key}_message"), data.get(key) or "", language)


def texts(data: Mapping, key: str, language: str = "en") -> list[str]:
    """The sentences under `key` in a language; as they stand where their codes are not known."""
    found = data.get(f"{key}_messages")
    if found is None:
        return list(data.get(key, ()))
    return [_spoken(m, m.get("text", ""), language) for m in found]


def _spoken(entry: Mapping | None, text: str, language: str) -> str:
    """The message of its plain data in a language; `text` where there is none, or one of a later version."""
    return Message.from_dict(entry).text(language) if entry and known(entry.get("code", "")) else text


# -- the file ----------------------------------------------------------------------------------------------------------
def to_dict(result: TraceResult) -> dict:
    """The result as plain data, as it stands in trace.json."""
    declared = result.identifiability
    return {
        "format": FORMAT,
        "version": VERSION,
        "verdict": result.verdict,
        "verdict_message": VERDICTS[result.verdict][1].to_dict(),
        "floor": result.floor,
        "seed": result.seed,
        "permutations": result.permutations,
        "alignment": result.alignment,
        "guarantee": {
            "rate": result.guarantee.rate,
            "by": [{"exchange": e, "number": n, "exact": exact} for e, n, exact in result.guarantee.by],
            **said_all("conditions", result.guarantee.conditions),
        },
        "effects": [_effect(e) for e in result.effects] + ([_hidden(result.hidden)] if result.hidden else []),
        "budget": [{"source": b.source, "variance_um2": b.variance * 1e6} for b in result.budget],
        "records": dict(result.readings.records),
        "error": {name: _stage(e) for name, e in result.error.items()} | said("note", Message("error-note")),
        "noise": _noise(result.noise),
        "identifiability": {
            "columns": declared.columns,
            "rank": declared.rank,
            "condition": declared.condition,
            **said_all("null_space", declared.null_space),
        },
        "depends_on": [{"column": c, "p": p} for c, p in result.depends_on],
        "not_testable": [{**said("effect", e), "needs": needs} for e, needs in result.not_testable],
        **said_all("not_identifiable", result.not_identifiable),
        "next_measurements": [
            {
                **said_all("separates", n.separates),
                **said("do", n.do),
                "predicted_difference_um": um(n.difference),
            }
            for n in result.next_measurements
        ],
        "parameter_shifts": [_shift(s) for s in result.parameter_shifts],
        "sensitivity_shift": [
            {"symbol": s.symbol, "before": s.before, "after": s.after} for s in result.sensitivity_shift
        ],
        "refused_names": [
            {"component": r.component, "driver": r.driver, "shape": r.shape, "p_familywise": r.p, **said("why", r.why)}
            for r in result.refused
        ],
        "remainder": _left(result.left),
        "outliers": [{"line": o.line, "position_mm": list(o.position)} for o in result.outliers],
        "findings": [remark(f.severity, f.code, f.message, f.line) for f in result.readings.remarks]
        + [remark("info" if m.code.startswith("input-") else "warning", m.code, m, 0) for m in result.remarks],
    }


def _effect(e: NamedEffect) -> dict:
    entry = {
        "name": e.effect.name,
        "name_message": e.title.to_dict(),
        "component": e.effect.component,
        "driver": str(e.effect.driver),
        "shape": e.effect.shape.name,
        "parameters": {k: v.to_dict() for k, v in shown(e.effect, component(e.effect.component), exact=False).items()},
        "amplitude_um": um(e.amplitude),
        **({} if e.amplitude_u is None else {"amplitude_u_um": e.amplitude_u * 1e3}),
        "p_familywise": e.p,
        "selection_frequency": e.selection,
        "held_out_gain_chi2": {"value": e.gain[0], "u": e.gain[1]},
        "visible_share": e.visible,
        "size_over_noise": e.size,
        "rivals": [
            {"component": r.component, "driver": r.driver, "shape": r.shape, **said("why", r.why)} for r in e.rivals
        ],
        **({"catalogue": e.catalogue} if e.catalogue else {}),
        **said("usual_size", e.usual),
        **said("check", e.check),
        **said("note", e.note),
    }
    return entry | ({"alias_periods": list(e.aliases)} if e.aliases else {})


def _hidden(h: HiddenMotion) -> dict:
    """A motion that nobody logged stands among the effects; its shape is "random"."""
    motion, c = h.motion, component(h.motion.symbol)
    return {
        **said("name", h.title),
        "component": motion.symbol,
        "driver": f"unlogged*{motion.place}" if motion.place else "unlogged",
        "shape": "random",
        "parameters": {"rms": {"value": c.to_shown(motion.rms), "unit": f"{c.unit}/mm" if motion.place else c.unit}},
        "amplitude_um": um(h.amplitude),
        "p_familywise": motion.p,
        "selection_frequency": motion.selection,
        "rivals": [],
    }


def _stage(e: StageError) -> dict:
    out = {"in_sample": dict(e.in_sample), "held_out": {**e.held_out, "rms_interval_um": list(e.interval)}}
    if e.left_out:
        count = len(e.left_out)
        out["left_out"] = {
            "by": e.by,
            "number": count,
            "lowest_um": min(e.left_out),
            "highest_um": max(e.left_out),
            "coverage": count / (count + 1),
        }
    return out


def _um(length: float | None) -> float | None:
    return None if length is None else um(length)


def _noise(n: NoiseSummary) -> dict:
    return {
        "stated_um": _um(n.stated),
        "pure_error_um": _um(n.pure),
        "residual_um": um(n.residual),
        "per_direction_um": {k: um(v) for k, v in n.direction.items()},
        "memory": dict(n.memory),
        "memory_modelled": dict(n.modelled),
        "chi2_per_dof": dict(n.ratio),
        **said_all("remarks", n.remarks),
    }


def _shift(s) -> dict:
    scale, unit = (1e6, "urad") if s.angular else (1e3, "um")
    values = {"before": s.before * scale, "after": s.after * scale, "u": s.u * scale, "unit": unit}
    return (said("parameter", s.title) if isinstance(s.title, Message) else {"parameter": s.title}) | values


def _left(left) -> dict:
    words = "; ".join(str(m) for m in left.words)
    out = {
        "words": words,
        "words_messages": [m.to_dict() for m in left.words],
        "p": left.p,
        "rms_over_noise": left.size,
    }
    return out | ({"component": left.component, "columns": list(left.columns)} if left.component else {})
