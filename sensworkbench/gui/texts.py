# SPDX-License-Identifier: LGPL-2.1-or-later
"""Words and numbers as the window shows them: names of bodies and errors, limits with units, settings of a result."""

from __future__ import annotations

import re

from ..core.errors import COMPONENTS, Component
from ..core.objectives import MeanSquare, Objective
from ..core.refusal import Refused
from ..core.sources import Source
from ..core.synthesis import POSITION
from ..core.units import factor, shown
from ..document import refresh, told, tree
from ..messages import Message
from . import messages, settings
from .qt import translate
from .settings import length_unit

UNIT_SIGNS = {"um": "µm", "urad": "µrad", "arcsec": "″", "deg": "°"}


def unit_sign(unit: str) -> str:
    """Return a unit as it is shown: `um` is µm."""
    return UNIT_SIGNS.get(unit, unit)


def body_name(machine, body: str) -> str:
    """What the user calls a body: the label of its object."""
    if body == "F":
        return translate("Sens", "Bed")
    obj = tree.body_of(machine, body) if machine is not None else None
    if obj is None and body in sources_of(machine):
        return body
    # FreeCAD makes labels unique by a number of three digits
    return re.sub(r"(?<=\D)\d{3}$", "", obj.Label) if obj is not None else body_kind(body)


def body_kind(body: str) -> str:
    """Return what a body of a machine is, in words."""
    return {
        "F": translate("Sens", "Bed"),
        "X": translate("Sens", "X carriage"),
        "Y": translate("Sens", "Y carriage"),
        "Z": translate("Sens", "Z carriage"),
        "T": translate("Sens", "Spindle and tool"),
        "W": translate("Sens", "Workpiece and fixture"),
    }.get(body) or translate("Sens", "{axis} carriage").format(axis=body)


def error_meaning(symbol: str, known: dict[str, Component] = COMPONENTS) -> str:
    """What an error is, in words.  known : components of the machine (`refresh.components`); default: X, Y, Z."""
    c = known.get(symbol)
    if c is None:  # a traced effect: its name says what it is
        return translate("Sens", "traced effect")
    return messages.words(c.title)


def sources_of(machine) -> dict[str, Source]:
    """name -> source of a machine; none where it has none or cannot be computed."""
    if machine is None or not machine.Sources:
        return {}
    try:
        return {s.name: s for s in refresh.latest(machine).core.sources}
    except Refused:
        return {}


def effect_of(machine, name: str):
    """The effect object of a name, or None."""
    return next((e for e in tree.effects_of(machine) if e.Label == name), None) if machine is not None else None


def short_name(machine, symbol: str) -> str:
    """What stands for an error in a narrow column: its symbol; of an effect its component and driver."""
    effect = effect_of(machine, symbol)
    return symbol if effect is None else f"{effect.Component} × {effect.Driver.replace('*', ' × ')}"


def meaning(machine, symbol: str, known: dict[str, Component] = COMPONENTS) -> str:
    """What an error or effect is, in words.  known : components of the machine."""
    source = sources_of(machine).get(symbol) if symbol not in known else None
    if source is not None:
        return messages.words(Message("error-source", symbols=list(source.factors)))
    return error_meaning(symbol, known) if effect_of(machine, symbol) is None else symbol


def fixed(value: float, digits: int) -> str:
    """A number with so many digits, and no minus before a zero."""
    text = f"{value:.{digits}f}"
    return text.lstrip("-") if not float(text) else text


def length(value: float, digits: int = 1) -> str:
    """A length in mm as the preferences want it, with its unit; an inch has two digits more."""
    unit, size = length_unit()
    return f"{fixed(value / size, digits + 2 * (unit == 'in'))} {unit}"


def point_text(point, digits: int = 1) -> str:
    """x, y and z of a point in mm, as the preferences want lengths."""
    unit, size = length_unit()
    more = digits + 2 * (unit == "in")
    return "   ".join(f"{k} {fixed(v / size, more)}" for k, v in zip("xyz", tuple(point))) + f" {unit}"


def span_text(low: float, high: float) -> str:
    """Two lengths in mm as the preferences want them, from … to, with the unit once."""
    unit, size = length_unit()
    return f"{low / size:.6g} … {high / size:.6g} {unit}"


def distribution_name(name: str) -> str:
    """Return the name of a distribution, in words."""
    return {
        "uniform": translate("Sens", "uniform"),
        "normal": translate("Sens", "normal (limits ±3σ)"),
        "truncated_normal": translate("Sens", "truncated normal"),
        "triangular": translate("Sens", "triangular"),
        "u_shaped": translate("Sens", "U-shaped"),
        "point": translate("Sens", "fixed value"),
    }[name]


def plain(value: float, digits: int = 6) -> str:
    """A number with at most so many significant digits, and none that is needless."""
    return f"{value:.{digits}g}"


def limits(lower: float, upper: float, unit: str, angular: bool, digits: int = 6) -> str:
    """±5 µm, or -1 … 3 µm, with so many significant digits.  unit : "1" for a pure number."""
    a, b = (lower, upper) if unit == "1" else (shown(v, unit, angular=angular) for v in (lower, upper))
    sign = "" if unit == "1" else f" {unit_sign(unit)}"
    if abs(a + b) <= 1e-9 * max(abs(a), abs(b), 1e-30):
        return f"±{plain(b, digits)}{sign}"
    return f"{plain(a, digits)} … {plain(b, digits)}{sign}"


def positions_text(result) -> str:
    """Where the indices were taken."""
    points = [int(p) if result.Aggregate != "at" else p for p in result.Points]
    if result.Aggregate == "at":
        names = tree.joint_names(tree.bodies(tree.owner_machine(result)))
        return position_words(dict(zip(names, map(plain, points))))
    counts = "×".join(str(p) for p in points)
    if result.Aggregate == "grid":
        return translate("Sens", "Over a grid of {counts} positions").format(counts=counts)
    return translate("Sens", "Over the workspace, {counts} positions").format(counts=counts)


def position_words(position: dict[str, str]) -> str:
    """Return one position of the axes in words.  position : name of an axis -> its value in mm, as text."""
    unit, size = length_unit()
    shown = position if size == 1.0 else {k: plain(float(v) / size, 5) for k, v in position.items()}
    places = ", ".join(f"{name} {value}" for name, value in shown.items())
    return translate("Sens", "At {positions} {unit}").format(positions=places, unit=unit)


def objective_text(result) -> str:
    """What Y is: the squared error of position or orientation, or the formula of any other objective."""
    try:
        found = told.objective(result.Objective)
    except Refused as error:  # of an objective that is not registered here
        return error.what
    if found == MeanSquare(found.output):
        if found.output == POSITION:
            return translate("Sens", "Y: square of the position error of the tool")
        return translate("Sens", "Y: square of the orientation error of the tool")
    return "Y = " + _SYMBOLS.sub(lambda m: SHOWN[m.group()], found.formula).replace("-", "−")


SHOWN = {"T4": "Δx", "T5": "Δy", "T6": "Δz", "R1": "Δa", "R2": "Δb", "R3": "Δc"}  # the paper's symbol -> the window's
_SYMBOLS = re.compile(r"\b(?:T4|T5|T6|R1|R2|R3)")


def square_text(result) -> str:
    """Return the convention for squareness of a result, in words."""
    if result.Squareness == "carried":
        return translate("Sens", "squareness carried")
    return translate("Sens", "squareness tilts the direction (ISO)")


def shown_unit(output: str) -> tuple[str, float]:
    """Return (sign, factor from mm or rad) of the unit in which an error is shown; angles as in the preferences."""
    if output == "position":
        return "µm", 1e3
    unit = settings.get("AngleUnit")
    return unit_sign(unit), 1 / factor(unit, angular=True)


def size_of(objective: Objective, mean: float) -> str:
    """The mean of an objective as a length or angle with its unit, and how it is called: `√E[Y] = 12.3 µm`."""
    unit, value = shown_size(objective, mean)
    return f"{mean_name(objective)} = {value:.3g} {unit}"


def shown_size(objective: Objective, mean: float) -> tuple[str, float]:
    """(unit, value) of the mean of an objective in µm, or in the preferred unit of angles."""
    unit, scale = shown_unit(objective.output)
    return unit, objective.size_shown(max(mean, 0.0) if objective.power == 2 else mean) * scale / (
        1e3 if objective.output == POSITION else 1e6
    )


def mean_name(objective: Objective) -> str:
    """What the mean is called where it is shown as a length."""
    if not objective.has_shares:  # a size already, of which no mean is taken
        return "Y"
    return "E[Y]" if objective.power == 1 else "√E[Y]"


def mean_square_text(result) -> str:
    """E[Y] or the root of it, in µm or the preferred unit of angles; "" for an objective that is not registered."""
    try:
        return size_of(told.objective(result.Objective), result.MeanSquare)
    except Refused:
        return ""


def error_unit() -> tuple[str, float]:
    """(unit, µm in it) in which errors are typed and shown where FreeCAD's preferences are asked: µm, or µin."""
    return ("µm", 1.0) if length_unit()[0] == "mm" else ("µin", 0.0254)
