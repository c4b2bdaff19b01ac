# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a result can be shown: the choices of its view properties, as they are stored in users' files."""

from __future__ import annotations

COLOUR_BY = {  # choice -> the properties of the result whose mean the parts show
    "Share": ("ComponentFirst", "ComponentTotal"),
    "Mean": ("ComponentTotal",),
    "Largest": ("ComponentTotalMax",),
    "Variance weighted": ("ComponentTotalWeighted",),
    "First order": ("ComponentFirst",),
}
MAP_SHOWS = ("Expected", "Upper estimate")
POINTS = "Points"  # how the error map is drawn, or "Slice " and the name of the axis that is held
CORNERS = ("Upper left", "Upper right", "Lower left", "Lower right")


def slice_form(name: str) -> str:
    """The form of the error map in which the axis of a name is held."""
    return f"Slice {name}"


def sliced(form: str) -> str:
    """Name of the axis that a form of the error map holds, "" where it holds none."""
    return form.removeprefix("Slice ") if form != POINTS else ""


def map_forms(names) -> list[str]:
    """The forms of the error map of a machine whose axes move along lines.  names : of these axes."""
    return [POINTS, *(slice_form(n) for n in names if len(names) > 1)]


VIEW_PROPERTIES = (
    "ColourBy", "ColourMap", "AutomaticRange", "RangeLower", "RangeUpper", "ShowLegend", "LegendCorner", "ShowErrorMap",
    "ErrorMapShows", "ErrorMapAs", "ErrorMapAt",
)  # fmt: skip
