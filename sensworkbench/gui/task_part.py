# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of a part: the faces that the document's tool path cuts, coloured by the error of the machine there.

Features with their values, who makes them, the exaggerated shape, before and after compensation.  The study runs in the
background; nothing of the document is changed.
"""

from __future__ import annotations

from dataclasses import dataclass

import FreeCAD as App
import numpy as np

from ..core.refusal import Refused
from ..core.workspace import Cancelled
from ..document import cam_path, extract, part_faces
from ..document.base import alive
from ..formats import part_files, study_files
from ..messages import Message
from ..studies.part import FITTED, PartResult, features_on
from ..studies.part_correct import value_under
from ..studies.part_shape import face_fields
from ..studies.part_words import unsure
from . import live, messages, pointers
from .arrows import Arrow, Arrows
from .bars import BAR, BarDelegate
from .colormap import automatic, symmetric
from .command import NEEDS, Command, Where, command
from .copying import copyable
from .current import current_machine
from .export import PICTURE, picture, view_of
from .legend import Legend, LegendText
from .panel import Panel
from .panel import show as show_panel
from .part_scene import Hidden, PartScene
from .pointers import BODY_COLOURS, OTHER_COLOUR
from .preferences import number_box
from .qt import QT_TRANSLATE_NOOP, Qt, QtGui, later, translate
from .ranking import NumericItem
from .task_motion import open_panel as open_motion
from .task_motion import stills
from .texts import body_name, meaning, point_text, short_name

FEATURE, VALUE, UNSURE, AFTER = range(4)
NAME = Qt.UserRole + 2
SHARE, WHO = 0, 1
MOST_SHARES = 8
SHOWN = 0.04  # of the size of the part, for the largest error, with the slider in the middle
MARK_COLOUR = (0.10, 0.10, 0.10)

NEEDS["path"] = (
    lambda: bool(NEEDS["machine"][0]()) and cam_path.has_path(App.ActiveDocument),
    "a machine and a tool path",
)


def kinds() -> dict[str, str]:
    """Kind of feature -> its name."""
    return {
        "straightness": translate("Sens", "straightness"),
        "flatness": translate("Sens", "flatness"),
        "roundness": translate("Sens", "roundness"),
        "cylindricity": translate("Sens", "cylindricity"),
        "parallelism": translate("Sens", "parallelism"),
        "perpendicularity": translate("Sens", "perpendicularity"),
        "position": translate("Sens", "position"),
        "distance": translate("Sens", "distance"),
    }


@dataclass(frozen=True)
class Found:
    """A study of the part: its job and result, and of fitted errors the same features with the corrected program."""

    job: part_files.Job
    result: PartResult
    after: dict[str, float] | None = None
    correction: object = None


class TaskPart(Panel):
    """The panel; `found` is the study, None before it.  `chosen` : the face that is looked at."""

    guide = "5b. The part"
    standard = ("Close",)

    def __init__(self, machine):
        self.machine, self.document = machine, machine.Document
        self.core = extract.core_machine(machine)  # refuses before anything is opened
        self.path = cam_path.of_document(self.document)
        self.given = cam_path.given(self.path, self.core)
        faces = part_faces.named_faces(self.path.models)
        if not faces:
            raise Refused("part-no-model", self.document.Label)
        self.found: Found | None = None
        self.chosen, self.fields = "", {}
        self.scene, self.legend, self.mark, self.hidden = PartScene(faces), Legend(), Arrows(), Hidden()
        root = machine.ViewObject.RootNode
        for node in (self.scene.root, self.mark.root, self.legend.root):
            root.addChild(node)
        self.make_form(
            "SensPart", translate("Sens", "The part that {name} makes").format(name=machine.Label), "Sens_Part"
        )
        page = QtGui.QVBoxLayout(self.form)
        page.addLayout(self._asked())
        self.table = self.grows = self._features()
        page.addWidget(self.table)
        self.words = QtGui.QLabel()
        self.words.setObjectName("SensPartWords")
        self.words.setWordWrap(True)
        page.addWidget(self.words)
        self.shares = self._who()
        page.addWidget(self.shares)
        page.addLayout(self._looks())
        page.addLayout(self._buttons())
        self._view = view_of(self.document)
        self._click = None
        if self._view is not None:
            self._click = self._view.addEventCallback("SoMouseButtonEvent", self._clicked)
        self._camera = self._view.getCamera() if self._view is not None else None
        self._alone()
        self._enable()

    # -- the form ------------------------------------------------------------------------------------------------------
    def _asked(self):
        row = QtGui.QHBoxLayout()
        row.addWidget(QtGui.QLabel(translate("Sens", "Limit")))
        self.limit = number_box(0.0, 1e6, 2, 0.0, " µm")
        self.limit.setSpecialValueText(translate("Sens", "none"))
        self.limit.setToolTip(translate("Sens", "Features that exceed it are marked; 0: no limit"))
        self.limit.valueChanged.connect(self._fill)
        row.addWidget(self.limit, 1)
        self.compute_button = QtGui.QPushButton(translate("Sens", "Compute"))
        self.compute_button.setToolTip(translate("Sens", "Judges the faces that the tool path cuts"))
        self.compute_button.clicked.connect(self.compute)
        row.addWidget(self.compute_button)
        return row

    def _features(self):
        table = QtGui.QTreeWidget()
        table.setObjectName("SensPartFeatures")
        table.setRootIsDecorated(False)
        table.setAlternatingRowColors(True)
        table.setUniformRowHeights(True)
        table.setHeaderLabels([translate("Sens", "Feature"), "µm", "u µm", translate("Sens", "After")])
        table.headerItem().setToolTip(AFTER, translate("Sens", "With the corrected program"))
        table.setSortingEnabled(True)
        table.sortByColumn(VALUE, Qt.DescendingOrder)
        table.itemSelectionChanged.connect(self._selected)
        copyable(table, "features.csv")
        return table

    def _who(self):
        table = QtGui.QTreeWidget()
        table.setObjectName("SensPartShares")
        table.setRootIsDecorated(False)
        table.setUniformRowHeights(True)
        table.setHeaderLabels([translate("Sens", "Share"), translate("Sens", "Who makes it")])
        table.setItemDelegateForColumn(SHARE, BarDelegate(table))
        table.setColumnWidth(SHARE, 130)
        table.setFixedHeight(122)
        table.setToolTip(translate("Sens", "Click: the parts of the component light up. Double click: its motion"))
        table.itemClicked.connect(self._point)
        table.itemDoubleClicked.connect(self._move)
        return table

    def _looks(self):
        rows = QtGui.QVBoxLayout()
        row = QtGui.QHBoxLayout()
        row.addWidget(QtGui.QLabel(translate("Sens", "Exaggeration")))
        self.slider = QtGui.QSlider(Qt.Horizontal)
        self.slider.setRange(0, 100)
        self.slider.setValue(0)
        self.slider.setToolTip(translate("Sens", "How much larger than it is the error is drawn; left: not at all"))
        self.slider.valueChanged.connect(self._shape)
        row.addWidget(self.slider, 1)
        self.times = QtGui.QLabel("×0")
        self.times.setMinimumWidth(60)
        row.addWidget(self.times)
        rows.addLayout(row)
        row = QtGui.QHBoxLayout()
        self.alone = QtGui.QCheckBox(translate("Sens", "Part alone"))
        self.alone.setChecked(True)
        self.alone.setToolTip(translate("Sens", "Hides the machine while the panel is open"))
        self.alone.toggled.connect(self._alone)
        self.ideal = QtGui.QCheckBox(translate("Sens", "Ideal part beside"))
        self.ideal.toggled.connect(self._show_ideal)
        self.compensated = QtGui.QCheckBox(translate("Sens", "Compensated"))
        self.compensated.setToolTip(
            translate("Sens", "The part of the corrected program, in the same colours; needs fitted errors or effects")
        )
        self.compensated.toggled.connect(self._compensate)
        for box in (self.alone, self.ideal, self.compensated):
            row.addWidget(box)
        rows.addLayout(row)
        return rows

    def _buttons(self):
        row = QtGui.QHBoxLayout()
        self.report_button = QtGui.QPushButton(translate("Sens", "Report…"))
        self.report_button.setToolTip(translate("Sens", "Writes features, shares and pictures of the part"))
        self.report_button.clicked.connect(self.ask_report)
        self.motion_button = QtGui.QPushButton(translate("Sens", "Show Motion"))
        self.motion_button.setToolTip(translate("Sens", "How the largest share of the feature moves the machine"))
        self.motion_button.clicked.connect(self._move)
        for button in (self.report_button, self.motion_button):
            row.addWidget(button)
        return row

    def _enable(self) -> None:
        known = self.found is not None
        self.report_button.setEnabled(known)
        self.motion_button.setEnabled(known and bool(self._labels()))
        self.compensated.setEnabled(known and self.found.result.model == FITTED)
        self.table.setColumnHidden(AFTER, not (known and self.found.after))

    # -- the study -----------------------------------------------------------------------------------------------------
    def compute(self, *_) -> None:
        """Run the study in the background and show it."""
        core, given = self.core, self.given

        def study(progress):
            options = part_files.Options()
            job = part_files.read(core, self.document.Name, options, given, lambda part: progress(0.2 * part))
            return Found(job, part_files.judged(job, lambda part: progress(0.2 + 0.8 * part)))

        try:
            self.found = live.in_background(study, translate("Sens", "Judging the faces that the tool path cuts"))
        except Refused as error:
            self.words.setText(messages.words(error))
        except Cancelled:
            self.words.setText(translate("Sens", "Cancelled; nothing was changed"))
        else:
            self._shown()
        self._enable()

    def _shown(self) -> None:
        found, faced = self.found, self.found.job.faced
        names = [f.name for f in faced.faces]
        self.fields = face_fields(found.result, names)
        self.scene.fill(self.fields)
        signed = [f for f in self.fields.values() if f.signed]
        values = [1e3 * float(v) for f in (signed or self.fields.values()) for v in f.value]
        self.scale = symmetric(values) if signed else automatic(values)
        title = (translate("Sens", "Error across the face, + outwards") if signed
                 else translate("Sens", "Expected error"))  # fmt: skip
        self.legend.show(
            LegendText(title, "µm", self.document.Label, translate("Sens", "not cut by the path"), short="µm"),
            self.scale, "Lower left",
        )  # fmt: skip
        self._fill()
        self.slider.setValue(50)
        self._shape()
        self._choose("")
        remarks = [r.text(messages.language()) for r in found.job.source.get("remarks", ()) if isinstance(r, Message)]
        outside = len({o.line for o in found.result.outside})
        if outside:
            remarks.insert(0, translate("Sens", "{n} blocks leave the travel of the machine.").format(n=outside))
        text = translate("Sens", "{faces} faces are cut. Click a face or a row.").format(faces=len(names))
        if self.table.topLevelItemCount():
            self.table.setCurrentItem(self.table.topLevelItem(0))
        self.words.setText(" ".join([text, *remarks]))
        self.fit()

    def _fill(self, *_) -> None:
        """The table of features."""
        self.table.setSortingEnabled(False)
        self.table.clear()
        if self.found is None:
            return
        limit, words = self.limit.value(), kinds()
        for f in self.found.result.features:
            item = NumericItem(self.table)
            name = f.feature.name.partition(",")[0]
            item.setText(FEATURE, f"{name}: {words[f.feature.kind.name]}")
            item.setData(FEATURE, NAME, f.feature.name)
            judged = f.value if f.quantile is None else f.quantile
            texts = {VALUE: f"{1e3 * f.value:.2f}", UNSURE: "" if f.u is None else f"{1e3 * f.u:.2f}"}
            values = {VALUE: abs(f.value), UNSURE: f.u or 0.0}
            if self.found.after is not None:
                values[AFTER] = abs(self.found.after[f.feature.name])
                texts[AFTER] = f"{1e3 * self.found.after[f.feature.name]:.2f}"
            for column, text in texts.items():
                item.setText(column, text)
                item.setData(column, Qt.UserRole, float(values[column]))
                item.setTextAlignment(column, Qt.AlignRight | Qt.AlignVCenter)
            tip = item.text(FEATURE)
            if f.quantile is not None:
                tip += "\n" + translate("Sens", "95 % of all parts below {value} µm").format(
                    value=f"{1e3 * f.quantile:.2f}"
                )
            if limit > 0 and abs(1e3 * judged) > limit:
                item.setForeground(VALUE, QtGui.QBrush(QtGui.QColor(200, 30, 30)))
                bold = item.font(VALUE)
                bold.setBold(True)
                item.setFont(VALUE, bold)
                tip += "\n" + translate("Sens", "exceeds its limit")
            item.setToolTip(FEATURE, tip)
        self.table.setSortingEnabled(True)
        self.table.setColumnWidth(FEATURE, 210 if self.found.after is None else 170)
        for column in (VALUE, UNSURE, AFTER):
            self.table.setColumnWidth(column, 62 if self.found.after is None else 52)

    # -- choosing ------------------------------------------------------------------------------------------------------
    def _feature(self):
        """The feature of the selected row, or None."""
        chosen = self.table.selectedItems()
        if not chosen or self.found is None:
            return None
        name = chosen[0].data(FEATURE, NAME)
        return next(f for f in self.found.result.features if f.feature.name == name)

    def _clicked(self, event) -> None:
        if event.get("State") != "DOWN" or event.get("Button") != "BUTTON1" or self.found is None:
            return
        name = self.scene.face_at(self._view, event["Position"])
        if name:
            later(lambda: self.choose(name))

    def choose(self, name: str) -> None:
        """Look at a face: the row of its first feature is selected, or only the face where it has none."""
        for i in range(self.table.topLevelItemCount()):
            feature = next(f for f in self.found.result.features
                           if f.feature.name == self.table.topLevelItem(i).data(FEATURE, NAME))  # fmt: skip
            if feature.feature.surface.name == name:
                self.table.setCurrentItem(self.table.topLevelItem(i))
                return
        self.table.clearSelection()
        self._choose(name)

    def _selected(self) -> None:
        feature = self._feature()
        if feature is not None:
            self._choose(feature.feature.surface.name)
            self._say(feature)
        self._enable()

    def _choose(self, name: str) -> None:
        """Show a face: its colour is brighter, and its worst place is marked."""
        self.chosen = name
        self.scene.paint(self.scale, name)
        self.shares.clear()
        field = self.fields.get(name)
        if field is None:
            self.mark.clear()
            if name:
                self.words.setText(translate("Sens", "{face}: not cut by the path").format(face=name))
            return
        row = field.worst
        start, moved = field.points[row], field.error[row]
        end = start + self._times() * moved
        far = 0.12 * self.scene.size
        size = np.linalg.norm(end - start)
        if size < far:
            direction = moved / np.linalg.norm(moved) if np.linalg.norm(moved) > 0 else np.array([0.0, 0.0, 1.0])
            end = start + far * direction
        text = (
            f"{name}: {1e3 * field.value[row]:+.1f} µm" if field.signed else f"{name}: {1e3 * field.value[row]:.1f} µm"
        )
        self.mark.show([Arrow(tuple(start.tolist()), tuple(end.tolist()), MARK_COLOUR, text, 1.0)], self.scene.size)
        self.words.setText(translate("Sens", "{face}: largest error {value} µm at {place}").format(
            face=name, value=f"{1e3 * field.value[row]:.2f}", place=point_text(start)))  # fmt: skip

    def _labels(self) -> list[str]:
        return [self.shares.topLevelItem(i).data(SHARE, NAME) for i in range(self.shares.topLevelItemCount())]

    def _say(self, feature) -> None:
        """Who makes a feature."""
        self.shares.clear()
        result = self.found.result
        code = unsure(result, feature)
        if code:
            self.words.setText(self.words.text() + ". " + Message(code).text(messages.language()))
            return
        ranked = sorted(zip(feature.shares, result.labels, result.owners), key=lambda one: -abs(one[0]))
        ranked = [one for one in ranked if abs(one[0]) >= 5e-4][:MOST_SHARES]
        for share, label, owner in ranked:
            item = QtGui.QTreeWidgetItem(self.shares)
            item.setData(SHARE, BAR, (float(share), float(abs(ranked[0][0])), BODY_COLOURS.get(owner, OTHER_COLOUR)))
            item.setData(SHARE, NAME, label)
            text = f"{body_name(self.machine, owner)}: {short_name(self.machine, label)}"
            item.setText(WHO, text)
            item.setData(WHO, NAME, owner)
            item.setToolTip(WHO, f"{text}\n{meaning(self.machine, label, {c.symbol: c for c in self.core.components})}")

    def _point(self, item, *_) -> None:
        """The parts of a component light up; the machine is shown for it."""
        self.alone.setChecked(False)
        self.mark.clear()
        pointers.point_at(self.machine, [item.data(WHO, NAME)])

    def _move(self, *_) -> None:
        chosen = self.shares.selectedItems()
        labels = self._labels()
        if not labels:
            return
        label, machine = chosen[0].data(SHARE, NAME) if chosen else labels[0], self.machine
        self.close()
        later(lambda: open_motion(machine, label))

    # -- looks ---------------------------------------------------------------------------------------------------------
    def _times(self) -> float:
        """How much larger than it is the error is drawn: 0 to ten times what fits, the middle what fits."""
        largest, place = self.scene.largest, self.slider.value()
        if not place or largest <= 0:
            return 0.0
        return float(f"{SHOWN * self.scene.size / largest * 10 ** ((place - 50) / 50):.2g}")

    def _shape(self, *_) -> None:
        self.times.setText(f"×{self._times():,.0f}")
        self.scene.shape(self._times())
        if self.chosen in self.fields and self.found is not None:
            words = self.words.text()
            feature = self._feature()
            self._choose(self.chosen)
            if feature is not None:
                self._say(feature)
            self.words.setText(words)

    def _alone(self, *_) -> None:
        models = list(self.path.models)
        sources = {o for m in models for o in (m, *m.OutList)}
        jobs = [o for o in self.document.Objects if hasattr(o, "PostProcessor") and hasattr(o, "Stock")]
        others = {j.Stock for j in jobs if j.Stock is not None}
        bodies = set()
        if self.alone.isChecked():
            bodies = {o for o in self.document.Objects if o not in sources and o is not self.machine}
            bodies -= set(self.machine.InListRecursive)
        self.hidden.hide([*sources, *others, *bodies])
        if self.alone.isChecked():
            pointers.clear(self.machine)
        self.fit()

    def _show_ideal(self, *_) -> None:
        self.scene.show_ideal(self.ideal.isChecked())
        self.fit()

    def fit(self) -> None:
        """Turn the camera to the part, or to the machine where it is shown."""
        if self._view is None:
            return
        if not self.alone.isChecked():
            self._view.fitAll()
            return
        self._view.getCameraNode().viewAll(self.scene.body, coin_region(self._view), 1.1)

    def _compensate(self, *_) -> None:
        """Show the part of the corrected program, or that of the program as it is."""
        if self.found is None:
            return
        if self.compensated.isChecked() and self.found.correction is None and not self._correct():
            self.compensated.setChecked(False)
            return
        found, names = self.found, [f.name for f in self.found.job.faced.faces]
        if self.compensated.isChecked():
            made = found.correction
            self.fields = face_fields(found.result, names, made.after, made.path)
        else:
            self.fields = face_fields(found.result, names)
        usual = self._times()
        self.scene.fill(self.fields)
        self.scene.shape(usual)
        self._choose(self.chosen)
        self._enable()

    def _correct(self) -> bool:
        job, result = self.found.job, self.found.result
        try:
            made = live.in_background(
                lambda progress: part_files.correction_of(job), translate("Sens", "Correcting the program")
            )
            features = features_on(job.machine, made.path, job.request.features)
            after = {f.name: value_under(f, made.path, made.after) for f in features}
        except Refused as error:
            messages.show(messages.words(error))
            return False
        except Cancelled:
            return False
        self.found = Found(job, result, after, made)
        self._fill()
        return True

    # -- out -----------------------------------------------------------------------------------------------------------
    def ask_report(self, *_) -> list:
        """Ask for a folder and write part.json, tables, report and picture there; returns their paths."""
        folder = messages.ask_folder(translate("Sens", "Folder for the report"))
        if not folder or self.found is None:
            return []
        png = picture(self.document)
        found, language = self.found, messages.language()
        files = part_files.files(found.job, found.result, language, picture=png, motion=self._motion())
        if png is not None:
            files[PICTURE] = png
        if not messages.may_write(folder, files):
            return []
        try:
            paths = study_files.write_set(folder, "part", files)
        except Refused as error:
            messages.show(messages.words(error))
            return []
        messages.written(paths)
        return paths

    def _motion(self) -> tuple[bytes, ...]:
        """How the largest share of the chosen feature moves the machine, or of the largest one where none is chosen."""
        feature = self._feature() or max(self.found.result.features, key=lambda f: abs(f.value), default=None)
        if feature is None or self._view is None:
            return ()
        ranked = sorted(zip(feature.shares, self.found.result.labels), key=lambda one: -abs(one[0]))
        root, camera = self.machine.ViewObject.RootNode, self._view.getCamera()
        shown = (self.scene.root, self.mark.root, self.legend.root)
        for node in shown:
            node.ref()  # else it would be gone with its place in the graph
            root.removeChild(node)
        self.hidden.show()
        pointers.clear(self.machine)
        self._view.fitAll()
        try:
            return stills(self.machine, [label for _, label in ranked])
        finally:
            for node in shown:
                root.addChild(node)
                node.unref()
            self._alone()
            self._view.setCamera(camera)

    def leave(self) -> None:
        self.hidden.show()
        if self._view is not None and self._click is not None:
            self._view.removeEventCallback("SoMouseButtonEvent", self._click)
            self._click = None
        pointers.clear(self.machine)
        if alive(self.machine):
            root = self.machine.ViewObject.RootNode
            for node in (self.scene.root, self.mark.root, self.legend.root):
                if root.findChild(node) >= 0:
                    root.removeChild(node)
            if self._view is not None and self._camera is not None:
                self._view.setCamera(self._camera)
                self._camera = None


def coin_region(view):
    """The region of pixels of a view."""
    from pivy import coin

    return coin.SbViewportRegion(*(int(v) for v in view.getSize()))


def open_panel(machine, compute: bool = True) -> TaskPart:
    """Open the panel for a machine, and begin the study."""
    panel = TaskPart(machine)
    show_panel(panel, machine.Document)
    if compute:
        later(panel.compute)
    return panel


@command
class ShowPart(Command):
    name = "Sens_Part"
    menu_text = QT_TRANSLATE_NOOP("Sens_Part", "The Part…")
    tip = QT_TRANSLATE_NOOP("Sens_Part", "Shows the part that the tool path of the document makes, and who spoils it")
    needs = "path"
    guide = TaskPart.guide
    where = Where("analysis", 37, tree=("Machine",))

    def run(self):
        open_panel(current_machine())
