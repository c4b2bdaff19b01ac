# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a result looks like: its parts' colours, legend and error map, made from its properties and view properties.

`update` may be called at any time and changes only what differs; a result that is not `Coloured` leaves parts alone.
"""

from __future__ import annotations

from pivy import coin

from ..core.errors import AXES
from ..core.joints import KINDS
from ..core.refusal import Refused
from ..document import told, tree
from ..document.base import alive, kind_of
from . import colours, live, state
from .colormap import Scale, automatic
from .legend import LegendText
from .looks import COLOUR_BY, CORNERS, VIEW_PROPERTIES
from .qt import translate
from .texts import body_name, objective_text, position_words, positions_text, square_text


def ready(result) -> bool:
    """True where there are indices, and a view provider with all its properties to show them."""
    view = result.ViewObject if result is not None else None
    return view is not None and bool(result.Bodies) and all(hasattr(view, name) for name in VIEW_PROPERTIES)


def values(result) -> dict[str, float]:
    """Body -> the index that its parts show."""
    return dict(zip(result.Bodies, mean_of(result, COLOUR_BY[result.ViewObject.ColourBy])))


def mean_of(result, properties) -> list[float]:
    """The mean of lists of a result, entry by entry: of S and Sᵀ, the shares that add to one (Owen 2014)."""
    return [sum(row) / len(properties) for row in zip(*(getattr(result, name) for name in properties))]


def values_at(result, found) -> dict[str, float]:
    """Body -> the index that parts show, of indices at one position.  found : `core.workspace.Sensitivity`."""
    chosen = result.ViewObject.ColourBy if result is not None else "Share"
    shown = {"Share": found.component_share, "First order": found.component_first}.get(chosen, found.component_total)
    return dict(zip(found.bodies, shown.tolist()))


def scale(result) -> Scale:
    """The range of colours: as set by hand, else from 0 to just above the largest value."""
    view = result.ViewObject
    if view.AutomaticRange:
        return lasting(result, values(result).values())
    return Scale(float(view.RangeLower), float(view.RangeUpper), view.ColourMap)


def lasting(result, shown) -> Scale:
    """The automatic range for some values.  It stays while they fill it, so that colours can be compared.

    A new computation of the result (`compute_and_colour`) takes it anew; what undo brings back has its own colours.
    """
    shown = [v for v in shown if v is not None]
    found, ranges = automatic(shown, result.ViewObject.ColourMap), state.of(result.Document).ranges
    here, largest = f"{result.Name} {hash(result.Inputs)}", max(shown, default=0.0)
    kept = ranges.get(here, ranges.get(result.Name))
    if kept is None or not FILLED * kept <= largest <= kept:
        kept = found.upper
    ranges[result.Name] = ranges[here] = kept
    return Scale(0.0, kept, found.name)


FILLED = 0.4  # the part of the range below which the largest value would be hard to see


def title(result) -> str:
    """Return the title of the legend: which index the colours show."""
    return {
        "Share": translate("Sens", "Share of the component in the variance"),
        "Mean": translate("Sens", "Total index Sᵀ of the component"),
        "Largest": translate("Sens", "Largest total index Sᵀ of the component"),
        "Variance weighted": translate("Sens", "Variance-weighted total index Sᵀ"),
        "First order": translate("Sens", "First-order index S of the component"),
    }[result.ViewObject.ColourBy]


def legend_text(machine, result) -> LegendText:
    """Return the lines of the legend: title, unit, positions, objective and convention."""
    lines = [
        unit_line(result),
        positions_text(result),
        objective_text(result),
        square_text(result),
    ]
    if result.Stale:
        lines.append(translate("Sens", "Out of date: the machine has changed"))
    marks = tuple((body_name(machine, b), v) for b, v in values(result).items())
    note = translate("Sens", "Out of date") if result.Stale else ""
    return LegendText(title(result), "", "\n".join(lines), translate("Sens", "no index"), marks, symbol(result), note)


def symbol(result) -> str:
    """What the colours show, in a word that fits a narrow view or a column."""
    chosen = result.ViewObject.ColourBy if result is not None else "Share"
    return {"Share": translate("Sens", "Share"), "First order": "S"}.get(chosen, "Sᵀ")


def unit_line(result) -> str:
    """What the numbers of the legend are, and their range."""
    if told.has_shares(result.Objective):
        return translate("Sens", "Share of the variance, 0 to 1")
    return translate("Sens", "Contribution to Y; the contributions add to 1")


def position_legend(machine, result, shown: dict[str, float], position: dict[str, float]) -> LegendText:
    """The legend while the colours are those of one position.  shown : body -> its index there."""
    where = position_words({name: f"{value:.1f}" for name, value in position.items()})
    marks = tuple((body_name(machine, b), v) for b, v in shown.items())
    note = translate("Sens", "one position")
    lines = "\n".join((unit_line(result), where))
    return LegendText(title(result), "", lines, translate("Sens", "no index"), marks, symbol(result), note)


def update(result, *, fresh: bool = False) -> None:
    """Bring colours, legend and error map of a result up to date; `fresh`: compute it again first if stale."""
    machine = tree.owner_machine(result)
    if machine is None or not ready(result) or not hasattr(result.ViewObject.Proxy, "legend"):
        return
    view = result.ViewObject
    proxy = view.Proxy
    if fresh and result.Coloured and result.Stale:
        live.answer(machine, result)  # before anything is drawn: one frame shows the moved part and its new colour
    if result.Coloured:
        try:
            colours.apply(machine, result, values(result), scale(result))
        except Refused:
            pass  # the machine's Problem says what is wrong; the last colours stay
    if result.Coloured and view.ShowLegend:
        proxy.legend.drag_to(tuple(getattr(view, "LegendPlace", (0, 0)))[:2])
        proxy.legend.show(legend_text(machine, result), scale(result), view.LegendCorner)
    else:
        proxy.legend.hide()
    show_map(machine, result)
    ask_for_frame()
    if result.Coloured and result.Stale:
        live.wake(machine)


def show_map(machine, result, at: float | None = None) -> None:
    """Show the error map according to the view properties.  at : another position of the slice, mm, while it is
    being dragged.
    """
    view = result.ViewObject
    drawn = view.Proxy.map
    if not view.ShowErrorMap:
        drawn.hide()
        return
    taken = {view.LegendCorner, *(key_corner(o) for o in result.Document.Objects)}
    corner = next((c for c in reversed(CORNERS) if c not in taken), "Lower right")
    colour_map = next(m for m in ("magma", "cividis") if m != view.ColourMap)  # its colours mean something else
    at = view.ErrorMapAt.Value if at is None else at
    try:
        drawn.show(machine, colour_map, corner, view.ErrorMapShows, view.ErrorMapAs, at)
    except Refused:
        drawn.hide()


def sliding_axes(machine) -> list[str]:
    """Names of the axes of a machine that move along a line; X, Y and Z where there is no machine yet."""
    if machine is None:
        return list(AXES)
    owners = tree.bodies(machine)
    return [name for name in tree.joint_names(owners) if not KINDS[owners[name].Kind].angular]


def key_corner(obj) -> str:
    """The corner in which a trace shows the key of its residuals, "" where it shows none."""
    view = obj.ViewObject if kind_of(obj) == "Trace" else None
    return view.KeyCorner if getattr(view, "ShowResiduals", "Off") != "Off" else ""


def ask_for_frame() -> None:
    """Let the changed scene ask for its frame now: Qt then paints the model with the panels, not after them."""
    coin.SoDB.getSensorManager().processDelayQueue(False)


def results(doc) -> list:
    """Return the results of a document that are not damaged."""
    return [o for o in doc.Objects if kind_of(o) == "Sensitivity" and alive(o)]


def compute_and_colour(machine):
    """Compute, store and show the indices of a machine; returns the result.  The caller opens the transaction."""
    machine.Document.recompute()
    result = live.compute(machine)
    result.Coloured = True
    update(result)
    return result
