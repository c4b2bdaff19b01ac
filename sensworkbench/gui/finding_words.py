# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sentences of the closed loop in the language of the window.

The fit and the trace speak English, in their reports and files as well.  What they say in fixed words is translated
here; what is not known is shown as it is.
"""

from __future__ import annotations

import re

from ..formats.trace_html import driver_words
from .qt import QT_TRANSLATE_NOOP, translate
from .texts import error_meaning

SAID = (
    QT_TRANSLATE_NOOP("Sens", "nothing beyond noise"),
    QT_TRANSLATE_NOOP("Sens", "structure above the floor"),
    QT_TRANSLATE_NOOP("Sens", "structure below the floor: a short-wave remainder, not named"),
    QT_TRANSLATE_NOOP("Sens", "structure above the floor that no named effect explains"),
    QT_TRANSLATE_NOOP("Sens", "short waves along the axes (roughness), not named"),
    QT_TRANSLATE_NOOP("Sens", "reversal error (backlash)"),
    QT_TRANSLATE_NOOP("Sens", "angular reversal error"),
    QT_TRANSLATE_NOOP("Sens", "position-dependent reversal (wind-up)"),
    QT_TRANSLATE_NOOP("Sens", "following error with feed and direction"),
    QT_TRANSLATE_NOOP("Sens", "error with feed"),
    QT_TRANSLATE_NOOP("Sens", "hysteresis of guide or drive"),
    QT_TRANSLATE_NOOP("Sens", "thermal expansion of a scale or screw"),
    QT_TRANSLATE_NOOP("Sens", "thermal bending of the structure"),
    QT_TRANSLATE_NOOP("Sens", "thermal displacement"),
    QT_TRANSLATE_NOOP("Sens", "spindle growth"),
    QT_TRANSLATE_NOOP("Sens", "drift in time"),
    QT_TRANSLATE_NOOP("Sens", "sudden shift in time"),
    QT_TRANSLATE_NOOP("Sens", "cyclic error of screw or encoder"),
    QT_TRANSLATE_NOOP("Sens", "deflection under the moved mass"),
    QT_TRANSLATE_NOOP("Sens", "sag with overhang"),
    QT_TRANSLATE_NOOP("Sens", "carriage that another axis bends"),
    QT_TRANSLATE_NOOP("Sens", "displacement with spindle speed"),
    QT_TRANSLATE_NOOP("Sens", "ball screw nut, coupling, guide preload"),
    QT_TRANSLATE_NOOP("Sens", "guide preload, drive offset from the guides"),
    QT_TRANSLATE_NOOP("Sens", "ball screw stiffness and preload along the travel"),
    QT_TRANSLATE_NOOP("Sens", "servo gain, feed forward"),
    QT_TRANSLATE_NOOP("Sens", "friction, cable chain, preload"),
    QT_TRANSLATE_NOOP("Sens", "scale temperature, screw cooling, expansion coefficient in the control"),
    QT_TRANSLATE_NOOP("Sens", "temperature difference front to back, coolant and sun on the casting"),
    QT_TRANSLATE_NOOP("Sens", "heat sources beside the part that moves"),
    QT_TRANSLATE_NOOP("Sens", "spindle cooling, warm-up cycle"),
    QT_TRANSLATE_NOOP("Sens", "warm-up, fixture, foundation; log temperatures"),
    QT_TRANSLATE_NOOP("Sens", "clamping of workpiece, artefact, probe or tool"),
    QT_TRANSLATE_NOOP("Sens", "screw lead and bearing, encoder head"),
    QT_TRANSLATE_NOOP("Sens", "guide stiffness, levelling, load on the table"),
    QT_TRANSLATE_NOOP("Sens", "weight compensation, ram and rail stiffness"),
    QT_TRANSLATE_NOOP("Sens", "stiffness of the guide that carries the other axis"),
    QT_TRANSLATE_NOOP("Sens", "spindle bearings, centrifugal growth"),
)


def patterns():
    """(pattern, sentence with the fields of its groups)."""
    return (
        (r"(?P<names>.+) cannot be told apart with one tool: measure with a second tool length or offset",
         translate("Sens", "{names} cannot be told apart with one tool: measure with a second tool length or offset")),
        (r"(?P<names>.+) cannot be told apart", translate("Sens", "{names} cannot be told apart")),
        (r"(?P<names>.+) does not show in these readings with one tool: measure with a second tool length or offset",
         translate("Sens", "{names} does not show in these readings with one tool: "
                           "measure with a second tool length or offset")),
        (r"(?P<names>.+) does not show in these readings",
         translate("Sens", "{names} does not show in these readings")),
        (r"(?P<names>\w+) driven by (?P<driver>\w+): (?P<share>\S+) of it would show beside the declared model",
         translate("Sens", "{names} driven by {driver}: {share} of it would show beside the declared model")),
    )  # fmt: skip


def said(text: str) -> str:
    """A text of the closed loop in the language of the window."""
    if text in SAID:
        return translate("Sens", text)
    for pattern, sentence in patterns():
        found = re.fullmatch(pattern, text)
        if found:
            return sentence.format(**found.groupdict())
    parts = text.split("; ")
    return "; ".join(said(p) for p in parts) if len(parts) > 1 else text


def effect_name(entry) -> str:
    """The name of a finding: what it is physically, and where it acts."""
    what, colon, _where = entry["name"].partition(": ")
    if not colon or said(what) == what:
        return entry["name"]
    where = translate("Sens", "{error}, driven by {driver}").format(
        error=error_meaning(entry["component"]), driver=driver_words(entry["driver"])
    )
    return f"{said(what)}: {where}"
