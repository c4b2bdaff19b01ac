# SPDX-License-Identifier: LGPL-2.1-or-later
"""From links to a machine: axes, bodies, order, confidence, remarks."""

from __future__ import annotations

import numpy as np

from ...messages import Message
from . import words
from .asking import ask, ask_bodies
from .directing import direct
from .found import LEAST, Axis, Found, State
from .lettering import give_letters
from .links import Chains, Link, label_of
from .reading import Document
from .rooting import contract, swallow
from .sides import branches_of, sides_of
from .travel import travel_of


def lead(state: State, reading: Chains, places, upright, made: Found, answers) -> None:
    """Fill a proposal from a reading: axes, bodies, order, confidence, remarks, questions."""
    document, (up, up_sure) = state.document, upright
    made.kind = "serial"
    links = [k for k in reading.links if k.confidence >= LEAST or k.told_letter]
    weak = [k for k in reading.links if k not in links]
    for link in sorted(weak, key=lambda k: -_depth(reading, k)):
        if any(k.inner == link.outer for k in reading.links):
            links.append(link)
        else:
            made.remarks.append(Message("propose-weak", part=label_of(document, reading.bodies[link.outer])))
            swallow(reading, link)
    links = [k for k in reading.links if k in links]
    for link in _doubled(
        links
    ):  # a quill in a head, a spindle in its bore: one axis of that direction is the machine's
        contract(reading, link)
        links.remove(link)
    if not links:
        ask_bodies(made, state)
        return
    give_letters(state, reading, links, places, up)
    told = [k for k in links if f"direction:{k.letter}" in answers]
    if told:
        for link in told:
            link.told = document.frame.inward(answers[f"direction:{link.letter}"])
        direct(document, reading, places, state.axes, up, state.said, state.found.slides, state.size)
    branches = branches_of(links, reading.bed)
    work, tool, sure = sides_of(state, reading, branches, places, up, answers)
    for n in reading.far:
        made.left_out.append(document.units[n])
    made.workpiece_chain = [k.letter for k in work]
    made.tool_chain = [k.letter for k in tool]
    made.structure = "".join(reversed(made.workpiece_chain)) + "F" + "".join(made.tool_chain)
    made.bodies["F"] = [document.units[n] for n in sorted(reading.bodies[reading.bed])]
    made.confidence = {"bed": reading.bed_sure, "sides": sure}
    made.reasons["F"] = [_bed_reason(state, reading, places)]
    for branch, on_work in ((work, True), (tool, False)):
        for link in branch:
            made.axes[link.letter] = _axis(state, reading, link, on_work, made, answers)
            made.bodies[link.letter] = [document.units[n] for n in sorted(reading.bodies[link.outer])]
    _ends(state, reading, work, tool, places, made)
    whole = reading.bed_sure * 0.5 + 0.5
    agree = _agreement(state, reading, places, tool, work)
    for axis in made.axes.values():
        value = axis.confidence * (0.75 + 0.25 * whole) * (0.85 + 0.15 * sure)
        if reading.source == "names":
            value = min(value, 0.72)
        elif reading.source == "guides":
            value = min(value, 0.9 if agree else 0.78)
        if len(made.axes) < 2 or (len(made.axes) == 2 and not state.said.lathe):
            value = min(value, 0.7)
        if up_sure < 0.25 and reading.source != "joints" and not state.said.lathe:
            value = min(value, 0.75)  # which axis is Z is not clear
        axis.confidence = round(float(value), 3)
    disputed = _disputed(document, places, made)
    if disputed:
        made.remarks.append(Message("propose-disagree", parts=", ".join(disputed[:3]) + (" …" if disputed[3:] else "")))
    if state.said.rotary:
        made.remarks.append(Message("propose-rotary", parts=", ".join(state.said.rotary)))
    made.complete = bool(made.axes) and (len(made.axes) == 3 or (state.said.lathe and len(made.axes) == 2))
    if answers.get("enough"):
        made.complete = True
    ask(state, reading, made, sure, answers)


def _doubled(links: list[Link]) -> list[Link]:
    """The weaker of every two links along one direction, unless a joint or a person says that it is an axis."""
    weak: list[Link] = []

    def strength(link: Link) -> float:
        return max((e.weight for e in link.evidence if e.u is not None and abs(e.u @ link.u) > 0.9), default=0.0)

    for link in sorted(links, key=strength):
        stated = link.bond is not None or link.told_letter or link.told is not None
        others = [k for k in links if k is not link and k not in weak]
        if not stated and any(abs(k.u @ link.u) > 0.9 for k in others):
            weak.append(link)
    return weak


def _depth(reading, link) -> int:
    before = next((k for k in reading.links if k.outer == link.inner), None)
    return 1 + (_depth(reading, before) if before is not None else 0)


def _bed_reason(state: State, reading: Chains, places) -> Message:
    document, body = state.document, reading.bodies[reading.bed]
    if document.grounded & body:
        return Message("propose-bed-grounded", part=document.units[min(document.grounded & body)].label)
    named = [n for n in body if places.get(n, ("", ""))[0] in words.FIXED]
    if named:
        return Message("propose-bed-name", part=document.units[max(named, key=lambda n: document.units[n].bulk)].label,
                       count=len(body))  # fmt: skip
    return Message("propose-bed-shape", count=len(body))


def _disputed(document: Document, places, made: Found) -> list[str]:
    """Labels of parts whose names state another axis than the one that they move with."""
    body = {u.key: name for name, units in made.bodies.items() for u in units}
    labels = []
    for n, (_, letter) in places.items():
        unit = document.units[n]
        got = body.get(unit.key)
        if letter and not unit.hardware and got in ("F", *"XYZ") and got != letter and letter in made.axes:
            labels.append(repr(unit.label))
    return labels


def _agreement(state: State, reading: Chains, places, tool, work) -> bool:
    """Whether names say the same as the guides: what is called fixed stands, what is called moving moves."""
    units = state.document.units
    moved = set().union(*[reading.bodies[k.outer] for k in reading.links]) if reading.links else set()
    wrong = right = 0.0
    for n, (role, letter) in places.items():
        if units[n].hardware:
            continue
        moving = role in words.MOVING or bool(letter)
        if role in words.FIXED or moving:
            fits = (n in moved) == moving
            right, wrong = right + fits * units[n].bulk, wrong + (not fits) * units[n].bulk
    ends = reading.bodies[tool[-1].outer] if tool else reading.bodies[reading.bed]
    tools = [n for n, (role, _) in places.items() if role in ("tool", "toolpost")]
    if tools and not any(n in ends for n in tools):
        return False
    return right > 0 and wrong <= 0.15 * right


def _axis(state: State, reading: Chains, link: Link, on_work: bool, made: Found, answers) -> Axis:
    document = state.document
    u, frame = np.array(link.u, float), document.frame
    out = frame.outward(u)
    if out[np.argmax(np.abs(out))] < 0:
        u, out = -u, -out
    spoken = [Message(e.code, **e.fields) for e in sorted(link.evidence, key=lambda e: -e.weight) if e.weight > 0.05]
    messages = list(dict.fromkeys(spoken))[:6]
    if not messages:
        messages = [Message("propose-evidence-order")]
    travel, point, assumed, why = travel_of(state, reading, link, u, on_work)
    messages.append(why)
    rail = None
    slides = [s for g in link.guides for s in g.slides] or [s for s in link.slides if abs(s.u @ u) > 0.99]
    if slides:
        rail = document.units[max(slides, key=lambda s: (s.weight, s.length)).rail[0]]
    made_axis = Axis(link.letter, out, travel, messages, link.confidence, [], frame.point(point), assumed, rail=rail)
    if link.bond is not None:
        made_axis.joint = link.bond.joint
        made_axis.reverse = float(link.bond.u @ u) < 0
    stated = answers.get(f"travel:{link.letter}")
    if stated is not None:
        made_axis.travel, made_axis.assumed = (float(stated[0]), float(stated[1])), False
    return made_axis


def _ends(state: State, reading: Chains, work, tool, places, made: Found) -> None:
    """Spindle and workpiece out of the last bodies, where their names say so."""
    document = state.document
    for name, branch, roles in (("T", tool, {"tool", "toolpost"}), ("W", work, {"work"})):
        if state.said.lathe and name == "W":
            roles = {"chuck", "work"}
        last = branch[-1].letter if branch else "F"
        body = reading.bodies[branch[-1].outer] if branch else reading.bodies[reading.bed]
        own = [n for n in sorted(body) if not document.units[n].hardware and (
            words.role(document.units[n].label) in roles or places.get(n, ("", ""))[0] in roles)]  # fmt: skip
        if own and len(own) < len(body):
            made.bodies[name] = [document.units[n] for n in own]
            made.bodies[last] = [u for u in made.bodies[last] if u not in made.bodies[name]]


def named_bodies(made: Found, state: State, places) -> None:
    """Where nothing shows what slides: the parts whose names say what they are."""
    for n, (role, letter) in places.items():
        body = letter or {"tool": "T", "work": "W"}.get(role, "F" if role in words.FIXED else "")
        if body:
            made.bodies.setdefault(body, []).append(state.document.units[n])
