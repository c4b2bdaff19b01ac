# SPDX-License-Identifier: LGPL-2.1-or-later
"""Propose a machine for a document: read, look, weigh, and say what is left to ask.  Changes nothing.

The order: parts and joints of the document; faces of its solids; what touches; what slides; bodies by a cut at the
guides, by the joints and by names; bed and chain; directions, letters, travel; confidence; questions.
"""

from __future__ import annotations

import time

from ...core.workspace import Cancelled
from ...messages import Message
from .asking import ask_bodies
from .by_guides import by_guides
from .by_joints import by_joints
from .by_names import by_names
from .directing import direct
from .found import Found, Question, State
from .leading import lead, named_bodies
from .links import Chains
from .look import look
from .reading import read
from .speech import common_holders, place_of
from .told import as_told
from .unlike import no_serial
from .upright import upright

SECONDS = 14.0  # at most, on a busy computer; a machine of two hundred parts takes two or three


LIMIT = 18.0  # by the clock, however many parts there are


def propose(doc, selection=(), answers=None, progress=None, seconds: float = SECONDS, early=None) -> Found:
    """What a document proposes.  selection : links of what is to be looked at; nothing: the whole document.

    answers : `Question.name` -> what a person said, which is never overruled.  progress(done, all) : called often; a
    true answer stops, and raises Cancelled.  seconds : for the look at shapes; the rest is bounded by it too.
    early(make) : called once when the parts are read, before what touches is examined; make(answers) is what names and
    joints alone propose.
    """
    start = time.monotonic()
    away = 0.0  # s in `progress` and `early`, which are no part of the look

    def watch(done, total):
        nonlocal away
        before = time.monotonic()
        stop = progress is not None and progress(done, total)
        away += time.monotonic() - before
        if stop:
            raise Cancelled
        return False

    document = read(doc, selection, 0.6 * seconds, lambda n, total: watch(0.5 * n, total))
    if early is not None:
        before = time.monotonic()
        early(lambda said=None: weigh(glance(document, doc.Label), said))
        away += time.monotonic() - before
    state = look(document, doc.Label, watch, max(start + away + LIMIT - 1.0, time.monotonic() + 2.0))
    found = weigh(state, answers)
    found.seconds = time.monotonic() - start - away
    return found


def glance(document, title: str) -> State:
    """A document of which only names, joints and boxes are known."""
    state = look(document, title, lambda *_: False, float("-inf"))
    state.found.cut_short = False
    return state


def again(found: Found, answers) -> Found:
    """The same document weighed anew with what a person has said; takes no look at shapes."""
    start = time.monotonic()
    made = weigh(found.state, answers)
    made.seconds = time.monotonic() - start
    return made


def weigh(state: State, answers=None) -> Found:
    """What the look at a document means, with the answers of a person."""
    answers = dict(answers or {})
    document, said = state.document, state.said
    made = Found(document=document, state=state)
    if document.sampled:
        made.remarks.append(Message("propose-sampled", count=document.sampled))
    if state.found.cut_short:
        made.remarks.append(Message("propose-cut-short"))
    if len(document.units) < 2:
        made.remarks.append(Message("propose-too-few", count=len(document.units)))
        made.questions.append(Question("parts", Message("propose-ask-parts"), "parts"))
        return made
    common = common_holders(document, state.minor)
    places = {n: place_of(document, n, said, common) for n in range(len(document.units)) if n not in state.minor}
    if no_serial(state, made, answers):
        return made
    up, up_sure = upright(state, places)
    made.up, made.lathe = document.frame.outward(up), said.lathe
    reading = as_told(state, _best(state, places, up, answers), answers)
    if reading is None:
        named_bodies(made, state, places)
        ask_bodies(made, state)
        return made
    direct(document, reading, places, state.axes, up, said, state.found.slides, state.size)
    lead(state, reading, places, (up, up_sure), made, answers)
    return made


def _best(state: State, places, up, answers) -> Chains | None:
    joints = by_joints(state, places, up, answers)
    if joints is not None and len(joints.links) >= 2:
        return joints
    guides = by_guides(state, places, up, answers)
    names = by_names(state.document, state.found, places, state.minor, state.size, state.said, up, answers)
    options = [r for r in (joints, guides, names) if r is not None and r.links]
    if not options:
        return None

    def value(r: Chains) -> float:
        count = min(3, len(r.links))
        if r.source == "guides":
            sure = sum(max((g.weight for g in k.guides), default=0.0) for k in r.links[:3])
            return sure + 0.1 * count
        if r.source == "joints":
            return 1.0 * count
        return 0.62 * count - (0.4 if len(r.links) > 3 else 0.0)

    return max(options, key=value)
