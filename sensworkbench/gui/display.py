# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a result looks like: its parts' colours, legend and error map, made from its properties and view properties.

`update` may be called at any time and changes only what differs; a result that is not `Coloured` leaves parts alone.
"""

from __future__ import annotations

from pivy import coin

from ..core.errors import AXES
from ..core.joints import KINDS
from ..core.refusal import Refused
from ..document import tree
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
    chosen = getattr(result, COLOUR_BY[result.ViewObject.ColourBy])
    return dict(zip(result.Bodies, chosen))


def scale(result) -> Scale:
    """The range of colours: as set by hand, else from 0 to just above the largest value."""
    view = result.ViewObject
    if view.AutomaticRange:
        return lasting(result, values(result).values())
    return Scale(float(view.RangeLower), float(view.RangeUpper), view.ColourMap)


def lasting(result, shown) -> Scale:
    """The automatic range for some values.  It stays while they fill it, so that colours can be compared.

    A new computation of the result (`compute_and_colour`) takes it anew.
    """
    shown = [v for v in shown if v is not None]
    found, ranges = automatic(shown, result.ViewObject.ColourMap), state.of(result.Document).ranges
    kept, largest = ranges.get(result.Name), max(shown, default=0.0)
    if kept is None or not FILLED * kept <= largest <= kept:
        kept = ranges[result.Name] = found.upper
    return Scale(0.0, kept, found.name)


FILLED = 0.4  # the part of the range below which the largest value would be hard to see


def title(result) -> str:
    """Return the title of the legend: which index the colours show."""
    return {
        "Mean": translate("Sens", "Total index Sᵀ of the component"),
        "Largest": translate("Sens", "Largest total index Sᵀ of the component"),
        "Variance weighted": translate("Sens", "Variance-weighted total index Sᵀ"),
        "First order": translate("Sens", "First-order index S of the component"),
    }[result.ViewObject.ColourBy]


def legend_text(machine, result) -> LegendText:
    """Return the lines of the legend: title, unit, positions, objective and convention."""
    lines = [
        translate("Sens", "Share of the variance, 0 to 1"),
        positions_text(result),
        objective_text(result),
        square_text(result),
    ]
    if result.Stale:
        lines.append(translate("Sens", "Out of date: the machine has changed"))
    marks = tuple((body_name(machine, b), v) for b, v in values(result).items())
    short = "S" if result.ViewObject.ColourBy == "First order" else "Sᵀ"
    note = translate("Sens", "Out of date") if result.Stale else ""
    return LegendText(title(result), "", "\n".join(lines), translate("Sens", "no index"), marks, short, note)


def position_legend(machine, totals: dict[str, float], position: dict[str, float]) -> LegendText:
    """The legend while the colours are those of one position."""
    where = position_words({name: f"{value:.1f}" for name, value in position.items()})
    marks = tuple((body_name(machine, b), v) for b, v in totals.items())
    lines = (translate("Sens", "Share of the variance, 0 to 1"), where)
    head = translate("Sens", "Total index Sᵀ of the component")
    note = translate("Sens", "one position")
    return LegendText(head, "", "\n".join(lines), translate("Sens", "no index"), marks, "Sᵀ", note)


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
    return [o.Axis for o in tree.bodies(machine).values() if kind_of(o) == "Axis" and not KINDS[o.Kind].angular]


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
