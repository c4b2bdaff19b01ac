# SPDX-License-Identifier: LGPL-2.1-or-later
"""The review: a dock next to the model with the ranking, the components, what-if and the settings of the result.

The table and the 3D view are linked both ways: selecting an error or component highlights its parts and shows its
arrows; clicking a part selects its errors.  The dock changes the document only in named transactions.
"""

from __future__ import annotations

import FreeCAD as App
import FreeCADGui as Gui

from ..core.refusal import Refused
from ..document import refresh, tree
from ..document.base import alive, kind_of
from . import display, messages, pointers, state
from .bars import ComponentBars
from .command import after_command, busy
from .export import save_picture
from .guide import HelpKey
from .panel import overlaid
from .qt import Qt, QtCore, QtGui, later, main_window, translate
from .ranking import Ranking
from .review_settings import Settings
from .texts import body_name, mean_square_text, objective_text, positions_text, short_name
from .whatif import WhatIf

NAME = "SensReview"
ROOMY = 1700  # pixels of a window that has room for the tree, the model, a task panel and the review


def existing():
    """The dock where it was made already, or None."""
    return main_window().findChild(QtGui.QDockWidget, NAME)


def dock():
    """The one dock, made when first asked for."""
    found = existing()
    if found is None:
        found = Review(main_window())
        main_window().addDockWidget(Qt.RightDockWidgetArea, found)
        main_window().resizeDocks([found], [430], Qt.Horizontal)
    return found


def show(machine) -> Review:
    """Show the review of a machine."""
    found = dock()
    found.set_machine(machine)
    found.show()
    found.raise_()
    return found


def hide() -> None:
    """Close the dock where there is one."""
    found = existing()
    if found is not None:
        found.close()


@after_command
def make_room() -> None:
    """Give way to a task panel that lies over the 3D view (FreeCAD 1.1) where both leave the model no room."""
    found = existing()
    if not busy() or found is None or not found.isVisible() or main_window().width() >= ROOMY or not _overlaid():
        return
    found.hide()
    _come_back()


def _come_back() -> None:
    """Show the dock again once the panel is closed."""
    if busy():
        later(_come_back, 200)
    elif (found := existing()) is not None:
        found.show()
        found.refresh()


def _overlaid() -> bool:
    """Whether FreeCAD shows task panels as an overlay at the right of the 3D view."""
    panel = main_window().findChild(QtGui.QDockWidget, "Tasks")
    return panel is not None and overlaid(panel)


def workbench_activated() -> None:
    """Nothing is opened unasked; the dock keeps what it shows."""
    found = existing()
    if found is not None and found.isVisible():
        found.refresh()


class Watch:
    """Answers clicks in the 3D view and the tree."""

    def __init__(self, review):
        self.review = review

    def addSelection(self, doc, name, sub, _point):
        self.review.picked(doc, name, sub)

    def clearSelection(self, _doc):
        self.review.unpicked()


class Follow:
    """Follows the document: results that change, objects that go."""

    def __init__(self, review):
        self.review = review

    def slotChangedObject(self, obj, prop):
        if prop in ("Variance", "Stale", "Coloured", "Total", "Label") and kind_of(obj):
            self.review.soon()

    def slotDeletedObject(self, obj):
        if kind_of(obj):
            self.review.soon()

    def slotCreatedObject(self, obj):
        self.review.soon()

    def slotDeletedDocument(self, doc):
        self.review.soon()

    def slotActivateDocument(self, doc):
        self.review.soon()


class Review(QtGui.QDockWidget):
    """The dock of a machine's result: ranking, components, what-if and settings."""

    def __init__(self, parent):
        super().__init__(translate("Sens", "Sensitivity review"), parent)
        self.setObjectName(NAME)
        self.key = ("", "")
        self._timer = QtCore.QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(self.refresh)
        body = QtGui.QWidget()
        layout = QtGui.QVBoxLayout(body)
        layout.setContentsMargins(6, 6, 6, 6)
        self.head = QtGui.QLabel()
        self.head.setWordWrap(True)
        self.head.setTextFormat(Qt.RichText)
        layout.addWidget(self.head)
        self.tabs = QtGui.QTabWidget()
        self.tabs.setDocumentMode(True)
        layout.addWidget(self.tabs, 1)
        self.ranking = Ranking()
        self.bars = ComponentBars()
        scroll = QtGui.QScrollArea()
        scroll.setWidgetResizable(True)
        scroll.setFrameShape(QtGui.QFrame.NoFrame)
        scroll.setWidget(self.bars)
        self.what_if = WhatIf()
        self.settings = Settings()
        self.tabs.addTab(self.ranking, translate("Sens", "Errors"))
        self.tabs.addTab(scroll, translate("Sens", "Components"))
        self.tabs.addTab(self.what_if, translate("Sens", "What if"))
        self.tabs.addTab(self.settings, translate("Sens", "Settings"))
        layout.addLayout(self._buttons())
        self.setWidget(body)
        self.setMinimumWidth(340)
        HelpKey(self, "3. Sensitivity")
        self.ranking.chosen.connect(self.choose)
        self.bars.picked.connect(lambda b: self.choose([b]))
        self.what_if.chosen.connect(self.choose)
        self._watch, self._follow = Watch(self), Follow(self)
        self._watching = False

    def _buttons(self):
        row = QtGui.QHBoxLayout()
        for text, tip, command in (
            (translate("Sens", "Compute again"), translate("Sens", "Computes the indices of the machine as it is now"),
             "Sens_Sensitivity"),
            (translate("Sens", "Original colours"), translate("Sens", "Gives every part its own colours back"),
             "Sens_OriginalColours"),
            (translate("Sens", "Report…"), translate("Sens", "Writes HTML, JSON and CSV"), "Sens_Report"),
        ):  # fmt: skip
            button = QtGui.QPushButton(text)
            button.setToolTip(tip)
            button.setObjectName(command)
            button.clicked.connect(lambda *_, c=command: self._run(c))
            row.addWidget(button)
        button = QtGui.QPushButton(translate("Sens", "Picture…"))
        button.setToolTip(translate("Sens", "Saves the 3D view with its legend"))
        button.clicked.connect(self._picture)
        row.addWidget(button)
        return row

    def _run(self, command: str):
        """Run a command on the machine that is shown, whatever is selected and whichever document is in front."""
        machine = self.machine
        if machine is None:
            return
        if App.ActiveDocument is not machine.Document:
            App.setActiveDocument(machine.Document.Name)
        with state.quietly(machine.Document):
            Gui.Selection.clearSelection()
            Gui.Selection.addSelection(machine)
        Gui.runCommand(command, 0)

    def _picture(self):
        if self.machine is not None:
            try:
                save_picture(self.machine.Document)
            except Refused as error:
                messages.show(messages.words(error))

    # -- what is shown -----------------------------------------------------------------------------------------------
    @property
    def machine(self):
        """Return the machine that is shown, or None if it was deleted."""
        return _machine(self.key)

    @property
    def result(self):
        """Return the result of the machine that is shown, or None."""
        machine = self.machine
        return tree.sensitivity_of(machine) if machine is not None else None

    def set_machine(self, machine) -> None:
        """Show another machine."""
        key, before = (machine.Document.Name, machine.Name), self.key
        state.of(machine.Document).reviewed = machine.Name
        if key != before:
            self.key = key
            self._left(before)
        self.refresh()

    def soon(self):
        """Show again what has changed, once the present change is over."""
        if self.isVisible():
            self._timer.start(0)

    def _follow_document(self) -> None:
        """Turn to the document in front: to the machine that was reviewed in it before, else to its first one."""
        doc = App.ActiveDocument
        if doc is None:
            self.key = ("", "")
            return
        if self.machine is not None and self.key[0] == doc.Name:
            return
        before = self.key
        here = [m.Name for m in tree.machines(doc) if alive(m)]
        name = state.of(doc).reviewed
        self.key = (doc.Name, name if name in here else here[0] if here else "")
        if self.key != before:
            self._left(before)

    def _left(self, key) -> None:
        """What was chosen belonged to another machine."""
        self.ranking.forget()
        before = _machine(key)
        if before is not None:
            pointers.clear(before)

    def refresh(self) -> None:
        """Show the present state of the machine and its result."""
        self._follow_document()
        machine, result = self.machine, self.result
        ready = display.ready(result)
        self.tabs.setEnabled(machine is not None)
        self.head.setText(self._heading(machine, result if ready else None))
        self.ranking.show_result(machine, result if ready else None)
        self.bars.show_blocks(_blocks(machine, result) if ready else [])
        self.what_if.show_machine(machine, result if ready else None)
        self.settings.show_machine(machine, result)
        for name in ("Sens_Sensitivity", "Sens_OriginalColours", "Sens_Report"):
            button = self.findChild(QtGui.QPushButton, name)
            button.setEnabled(machine is not None and (name == "Sens_Sensitivity" or ready))

    def _heading(self, machine, result) -> str:
        if machine is None:
            return translate("Sens", "No machine in this document. Start with <b>Machine from Selection…</b> "
                                     "or <b>Example Machine</b>.")  # fmt: skip
        name = f"{_escape(machine.Label)}</b> ({_escape(machine.Document.Label)})<b>"
        if machine.Problem:
            problem = refresh.problem_text(machine, messages.language())
            return f"<b>{name}</b><br><span style='color:#c0392b'>{_escape(problem)}</span>"
        if result is None:
            ask = translate("Sens", "No result yet: press <b>Compute again</b>.")
            return f"<b>{name}</b> · {machine.Structure}<br>{ask}"
        lines = [f"<b>{name}</b> · {result.Label} · {machine.Structure} · {_escape(mean_square_text(result))}"]
        accuracy = f" (±{result.EstimatedError:.1g})" if result.EstimatedError > 1e-4 else ""
        lines.append(f"{_escape(positions_text(result))}{accuracy} · {_escape(objective_text(result))}")
        if result.WithoutExtent:
            words = translate("Sens", "No extent, not in the ranking: {effects}")
            lines.append(_escape(words.format(effects=", ".join(result.WithoutExtent))))
        if result.Stale:
            words = translate("Sens", "Out of date: the machine has changed since.")
            lines.append(f"<span style='color:#c0392b'>{words}</span>")
        return "<br>".join(lines)

    # -- linked selection --------------------------------------------------------------------------------------------
    def choose(self, bodies) -> None:
        """Components or errors were chosen here: outline their parts, draw their arrows, select them in the tree."""
        machine = self.machine
        if machine is None:
            return
        with state.quietly(machine.Document):
            try:
                pointers.point_at(machine, bodies)
                self.bars.choose(bodies[0] if len(bodies) == 1 else "")
            except Refused as error:
                messages.status(messages.words(error))

    def picked(self, document: str, name: str, sub: str) -> None:
        """A part, axis or effect was clicked: choose its errors here and draw its arrows."""
        machine = self.machine
        if machine is None or document != machine.Document.Name or state.of(document).quiet:
            return
        obj = machine.Document.getObject(name)
        if obj is None:
            return
        kind = kind_of(obj)
        try:
            body = getattr(obj, kind) if kind in ("Axis", "Body") else "" if kind else tree.owner_of(machine, obj, sub)
        except Refused:
            return
        with state.quietly(machine.Document):
            if kind == "Effect":  # its row, and what its body points at
                body = refresh.components(machine)[obj.Component].body
                self.ranking.choose_error(obj.Label)
            else:
                self.ranking.choose_body(body or "")
            self.bars.choose(body or "")
            pointers.show(machine, [body] if body else [])

    def unpicked(self) -> None:
        """Remove the arrows when nothing is selected any more."""
        machine = self.machine
        if machine is not None and not state.of(machine.Document).quiet:
            pointers.clear(machine)

    def showEvent(self, event):
        if not self._watching:
            self._watching = True
            Gui.Selection.addObserver(self._watch)
            App.addDocumentObserver(self._follow)
        self.soon()  # the document in front may be another one than when it was closed
        super().showEvent(event)

    def closeEvent(self, event):
        if self._watching:
            self._watching = False
            Gui.Selection.removeObserver(self._watch)
            App.removeDocumentObserver(self._follow)
            if self.machine is not None:
                pointers.clear(self.machine)
        super().closeEvent(event)


def _machine(key):
    """The machine of (document, name), or None where it is gone."""
    document, name = key
    if document not in App.listDocuments():
        return None
    obj = App.getDocument(document).getObject(name) if name else None
    return obj if obj is not None and kind_of(obj) == "Machine" and alive(obj) else None


def _escape(text: str) -> str:
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")


def _blocks(machine, result):
    """What the component bars show, largest first."""
    scale = display.scale(result)
    shown = display.values(result)
    shares = list(zip(result.Symbols, result.Owners, display.mean_of(result, ("First", "Total"))))
    whole = display.mean_of(result, ("ComponentFirst", "ComponentTotal"))
    blocks = []
    for body, share, first, total in zip(result.Bodies, whole, result.ComponentFirst, result.ComponentTotal):
        errors = sorted(((short_name(machine, s), v) for s, o, v in shares if o == body and v > 0), key=lambda e: -e[1])
        blocks.append((body, body_name(machine, body), share, first, total, scale.colour(shown.get(body)), errors))
    return sorted(blocks, key=lambda b: -b[2])
