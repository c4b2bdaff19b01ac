# SPDX-License-Identifier: LGPL-2.1-or-later
"""How our objects appear in the tree and in the 3D view: icon, double click, context menu, legend, arrows, error map.

Module and class names are stored in users' files and stay as they are.  A view provider keeps nothing but scene nodes;
what must survive is in view properties.  Nothing is read in `attach`: properties are not restored yet at that time.
"""

from __future__ import annotations

import FreeCAD as App

from ..document.base import alive, kind_of
from . import settings
from .colormap import MAPS
from .files import icon_path, tree_icon
from .qt import QtGui, later, soon, translate

COLOUR_BY = {
    "Mean": "ComponentTotal",
    "Largest": "ComponentTotalMax",
    "Variance weighted": "ComponentTotalWeighted",
    "First order": "ComponentFirst",
}
MAP_SHOWS = ("Expected", "Upper estimate")
MAP_FORMS = ("Points", "Slice X", "Slice Y", "Slice Z")
CORNERS = ("Upper left", "Upper right", "Lower left", "Lower right")


class ViewProviderSens:
    """Base: an icon, a double click that opens the panel, a context menu, nothing stored."""

    icon = "Sens_Machine"

    def __init__(self, vobj):
        vobj.Proxy = self

    def attach(self, vobj):
        self.name = (vobj.Object.Document.Name, vobj.Object.Name)

    @property
    def object(self):
        """The document object, or None where it is gone."""
        document, name = getattr(self, "name", ("", ""))
        if document not in App.listDocuments():
            return None
        return App.getDocument(document).getObject(name)

    def getIcon(self):
        obj = self.object
        return tree_icon(self.icon if obj is None or alive(obj) else DAMAGED)

    def menu(self) -> list[tuple[str, str]]:
        """(text, command) of the context menu."""
        return []

    def entries(self, obj) -> list[tuple[str, str]]:
        """The context menu of an object as it is: a damaged one offers its repair as well."""
        from ..document.repair import examine_object

        damaged = examine_object(obj)
        if any(finding.mendable for finding in damaged):
            return [_repair(), *self.menu()]
        return [*self.menu(), *([_repair()] if damaged else [])]

    def setupContextMenu(self, vobj, menu):
        for text, command in self.entries(vobj.Object):
            action = QtGui.QAction(QtGui.QIcon(icon_path(command)), text, menu)
            action.triggered.connect(_runner(command, vobj.Object))
            menu.addAction(action)

    def doubleClicked(self, vobj):
        entries = self.entries(vobj.Object)
        if not entries:
            return False
        _runner(entries[0][1], vobj.Object)()
        return True

    def dumps(self):
        return None

    def loads(self, state):
        return None

    def __getstate__(self):  # FreeCAD up to 0.21
        return None

    def __setstate__(self, state):
        return None


DAMAGED = "Sens_Damaged"


def _repair() -> tuple[str, str]:
    return translate("Sens", "Repair machine…"), "Sens_Repair"


def _runner(command: str, obj):
    def run(*_):
        import FreeCADGui as Gui

        from . import commands  # noqa: F401 - registers them where the workbench was not activated yet

        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(obj)
        Gui.runCommand(command, 0)

    return run


class ViewProviderMachine(ViewProviderSens):
    """The machine: edits it on double click; its arrows show axes, reference points and Abbe offsets."""

    icon = "SensWorkbench"

    def attach(self, vobj):
        super().attach(vobj)
        from .arrows import Arrows

        self.arrows = Arrows()
        vobj.RootNode.addChild(self.arrows.root)

    def menu(self):
        return [
            (translate("Sens", "Edit machine…"), "Sens_EditMachine"),
            (translate("Sens", "Tolerances…"), "Sens_Tolerances"),
            (translate("Sens", "Sensitivity"), "Sens_Sensitivity"),
            (translate("Sens", "Jog…"), "Sens_Jog"),
        ]


class ViewProviderAxis(ViewProviderSens):
    """An axis with its carriage."""

    icon = "Sens_Axis"

    def menu(self):
        return [
            (translate("Sens", "Edit axis…"), "Sens_EditMachine"),
            (translate("Sens", "Jog…"), "Sens_Jog"),
        ]


class ViewProviderBody(ViewProviderSens):
    """The spindle or the workpiece."""

    icon = "Sens_Body"

    def menu(self):
        return [(translate("Sens", "Edit machine…"), "Sens_EditMachine")]


class ViewProviderTolerances(ViewProviderSens):
    icon = "Sens_Tolerances"

    def menu(self):
        return [(translate("Sens", "Tolerances…"), "Sens_Tolerances")]


class ViewProviderEffect(ViewProviderSens):
    icon = "Sens_Effect"

    def menu(self):
        return [(translate("Sens", "On or off"), "Sens_SwitchEffect")]


class ViewProviderSensitivity(ViewProviderSens):
    """The result: colours of the parts, the legend, the error map.  Its view properties say how."""

    icon = "Sens_Sensitivity"

    def __init__(self, vobj):
        super().__init__(vobj)
        self._declare(vobj)

    def _declare(self, vobj):
        def add(kind, name, tip, value, choices=None):
            if hasattr(vobj, name):
                return
            vobj.addProperty(f"App::Property{kind}", name, "Sensitivity", tip)
            if choices:
                setattr(vobj, name, list(choices))
            setattr(vobj, name, value)

        add("Enumeration", "ColourBy", "Which index of a component its parts show", settings.get("ColourBy"), COLOUR_BY)
        add("Enumeration", "ColourMap", "Colours from low to high", settings.get("ColourMap"), MAPS)
        add("Bool", "AutomaticRange", "From 0 to just above the largest index", settings.get("AutomaticRange"))
        add("Float", "RangeLower", "Value of the lowest colour", settings.get("RangeLower"))
        add("Float", "RangeUpper", "Value of the highest colour", settings.get("RangeUpper"))
        add("Bool", "ShowLegend", "Show the legend in the view and in saved images", True)
        add("Enumeration", "LegendCorner", "Where the legend stands", settings.get("LegendCorner"), CORNERS)
        add("Bool", "ShowErrorMap", "Show the volumetric error over the workspace", False)
        add("Enumeration", "ErrorMapShows", "Root of the mean square, or two standard deviations of Y above the mean",
            MAP_SHOWS[0], MAP_SHOWS)  # fmt: skip
        add("Enumeration", "ErrorMapAs", "Points over the workspace, or a slice square to one axis", MAP_FORMS[0],
            MAP_FORMS)  # fmt: skip
        add("Distance", "ErrorMapAt", "Position of the sliced axis", 0.0)

    def attach(self, vobj):
        super().attach(vobj)
        from pivy import coin

        from .errormap import ErrorMap
        from .legend import Legend

        self.legend, self.map = Legend(), ErrorMap()
        self._waiting = False
        group = coin.SoGroup()
        group.addChild(self.map.root)
        group.addChild(self.legend.root)
        vobj.addDisplayMode(group, "Legend")
        self.schedule(later)  # an opened document is adopted first

    def getDisplayModes(self, vobj):
        return ["Legend"]

    def getDefaultDisplayMode(self):
        return "Legend"

    def setDisplayMode(self, mode):
        return mode

    def updateData(self, obj, prop):
        if prop in _SHOWN:
            self.schedule()

    def onChanged(self, vobj, prop):
        if prop == "Visibility":
            show_late(vobj)
        if prop in _VIEW:
            self.schedule()

    def onDelete(self, vobj, subelements):
        from .colours import restore

        if vobj.Object.Coloured:
            restore(vobj.Object)
        return True

    def schedule(self, when=soon):
        """Bring colours and legend up to date once the present change is over, in the frame that shows it."""
        if not getattr(self, "_waiting", False):
            self._waiting = True
            when(self._update)

    def _update(self):
        try:
            obj = self.object
            if obj is not None and obj.ViewObject is not None:
                from .display import update

                update(obj, fresh=True)
        finally:
            self._waiting = False  # what the update itself has stored asks for no second one

    def menu(self):
        return [
            (translate("Sens", "Review…"), "Sens_Review"),
            (translate("Sens", "Compute again"), "Sens_Sensitivity"),
            (translate("Sens", "Original colours"), "Sens_OriginalColours"),
            (translate("Sens", "Export report…"), "Sens_Report"),
        ]


VIEW_PROPERTIES = (
    "ColourBy", "ColourMap", "AutomaticRange", "RangeLower", "RangeUpper", "ShowLegend", "LegendCorner", "ShowErrorMap",
    "ErrorMapShows", "ErrorMapAs", "ErrorMapAt",
)  # fmt: skip
_SHOWN = {"Coloured", "Stale", "Bodies", "Variance", "MeanSquare", *COLOUR_BY.values()}
_VIEW = {*VIEW_PROPERTIES, "Visibility"}

PROVIDERS = {
    "Machine": ViewProviderMachine,
    "Axis": ViewProviderAxis,
    "Body": ViewProviderBody,
    "Tolerances": ViewProviderTolerances,
    "Sensitivity": ViewProviderSensitivity,
    "Effect": ViewProviderEffect,
}


def dress(obj) -> None:
    """Give an object its view provider where it has none, or a property that an older file lacks."""
    if kind_of(obj) in ("Readings", "Trace") and getattr(obj, "ViewObject", None) is not None:
        from .residuals import dress as dress_readings

        dress_readings(obj, kind_of(obj))
        attach_late(obj.ViewObject)
        return
    kind, view = PROVIDERS.get(kind_of(obj)), getattr(obj, "ViewObject", None)
    if kind is None or view is None:
        return
    if not isinstance(getattr(view, "Proxy", None), ViewProviderSens):
        kind(view)
    elif kind is ViewProviderSensitivity:
        view.Proxy._declare(view)
    attach_late(view)
    if hasattr(view, "signalChangeIcon"):
        view.signalChangeIcon()  # the tree may have asked before the view provider stood


def attach_late(view) -> None:
    """FreeCAD attaches a view provider once, when its object is made or opened: what a repair gives it comes later.

    Then there is no display mode for its nodes until the document is opened again; they get a switch of their own.
    """
    if hasattr(view.Proxy, "name"):
        return
    from pivy import coin

    view.Proxy.attach(view)
    modes = view.SwitchNode
    if modes.getNumChildren() and not view.DisplayMode:
        view.Proxy.late = coin.SoSwitch()
        view.Proxy.late.addChild(modes.getChild(0))
        view.RootNode.addChild(view.Proxy.late)
        show_late(view)


def show_late(view) -> None:
    late = getattr(view.Proxy, "late", None)
    if late is not None:
        late.whichChild.setValue(0 if view.Visibility else -1)
