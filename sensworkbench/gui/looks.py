# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a result can be shown: the choices of its view properties, as they are stored in users' files."""

from __future__ import annotations

COLOUR_BY = {  # choice -> the property of the result that the parts show
    "Mean": "ComponentTotal",
    "Largest": "ComponentTotalMax",
    "Variance weighted": "ComponentTotalWeighted",
    "First order": "ComponentFirst",
}
MAP_SHOWS = ("Expected", "Upper estimate")
MAP_FORMS = ("Points", "Slice X", "Slice Y", "Slice Z")
CORNERS = ("Upper left", "Upper right", "Lower left", "Lower right")
VIEW_PROPERTIES = (
    "ColourBy", "ColourMap", "AutomaticRange", "RangeLower", "RangeUpper", "ShowLegend", "LegendCorner", "ShowErrorMap",
    "ErrorMapShows", "ErrorMapAs", "ErrorMapAt",
)  # fmt: skip
