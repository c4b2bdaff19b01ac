# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that shows how an error or effect moves the machine: its body moves in the view, exaggerated and animated.

Copies of the parts are drawn beside them in the scene graph; no object of the document is touched, so there is nothing
to undo.  The lever arm and the tool's answer are arrows.
"""

from __future__ import annotations

import math
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
from pivy import coin

from ..core.refusal import Refused
from ..core.workspace import Cancelled
from ..document import cam_path, closed_loop, extract, paths, refresh, tree
from ..document.base import alive, kind_of
from ..formats import part_files
from ..formats.files import write_bytes
from ..studies.motion import Course, Motion, course, motion, movable
from ..studies.part_path import of_points
from . import gif, live, messages
from .arrows import OFFSET_COLOUR, Arrow, Arrows
from .command import Command, Where, command
from .current import current_machine
from .export import picture
from .legend import unbounded
from .panel import Panel
from .panel import show as show_panel
from .pointers import BODY_COLOURS, OTHER_COLOUR, extent
from .preferences import combo
from .qt import QT_TRANSLATE_NOOP, Qt, QtCore, QtGui, translate
from .texts import body_name, length, meaning, short_name

PERIOD_S, STEP_MS, FRAMES = 3.0, 40, 24
SHOWN = 0.08  # of the machine's size, for the tool's answer or the largest displacement
ANSWER_COLOUR = (0.85, 0.10, 0.15)
FINENESS_MM = 0.5
SWING, PATH = "swing", "path"  # what the motion goes over; else the label of readings
MOMENTS, COURSE_S = 120, 9.0  # of a course, and how long it takes
MOST_LINE = 3000  # points of a path that is drawn
GIF_SIZE = (800, 560)


class Ghost:
    """Copies of the parts of some bodies.  `root` goes into the scene graph; `place` moves them."""

    def __init__(self, machine, bodies):
        self.root = coin.SoSeparator()
        style = coin.SoPickStyle()
        style.style = coin.SoPickStyle.UNPICKABLE
        self.transform = coin.SoTransform()
        sides = coin.SoShapeHints()
        sides.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
        sides.creaseAngle = 0.5
        for node in (style, self.transform, sides):
            self.root.addChild(node)
        self.corners = np.zeros((0, 3))
        for body in bodies:
            material = coin.SoMaterial()
            material.diffuseColor = BODY_COLOURS.get(body, OTHER_COLOUR)
            material.transparency = 0.35
            self.root.addChild(material)
            for where in tree.parts_of(machine, body):
                for leaf in paths.leaves(where):
                    self._add(leaf.shape())

    def _add(self, shape) -> None:
        if shape is None or shape.isNull():
            return
        points, faces = shape.tessellate(FINENESS_MM)
        if not faces:
            return
        points = [tuple(p) for p in points]
        coordinates, mesh = coin.SoCoordinate3(), coin.SoIndexedFaceSet()
        coordinates.point.setValues(0, len(points), points)
        indices = [i for face in faces for i in (*face, -1)]
        mesh.coordIndex.setValues(0, len(indices), indices)
        self.root.addChild(coordinates)
        self.root.addChild(mesh)
        box = shape.BoundBox
        corners = [(x, y, z) for x in (box.XMin, box.XMax) for y in (box.YMin, box.YMax) for z in (box.ZMin, box.ZMax)]
        self.corners = np.concatenate([self.corners, corners])

    def place(self, shift, turn, centre) -> None:
        """Displace by `shift` (3,) mm, and turn by the rotation vector `turn` (3,) rad about `centre` (3,)."""
        angle = float(np.linalg.norm(turn))
        axis = coin.SbVec3f(*(turn / angle).tolist()) if angle > 0 else coin.SbVec3f(0, 0, 1)
        self.transform.center = tuple(float(v) for v in centre)
        self.transform.rotation = coin.SbRotation(axis, angle)
        self.transform.translation = tuple(float(v) for v in shift)


class TaskMotion(Panel):
    """The panel.  `moving` : the `Motion` shown; `times` : how much larger than it is; `phase` : -1 to 1; `course` :
    what it goes over, None for a swing between the ends."""

    guide = "5. Jog"
    standard = ("Close",)

    def __init__(self, machine, label: str = ""):
        found = extract.survey(machine)  # refuses before anything is opened
        self.machine, self.core = machine, found.core
        self.at = np.array([found.at[n] for n in found.core.names])
        self.ghost, self.arrows, self.root = None, Arrows(), unbounded()
        self._copies = coin.SoSeparator()
        for node in (coin.SoResetTransform(), self._copies, self.arrows.root):
            self.root.addChild(node)
        machine.ViewObject.RootNode.addChild(self.root)
        self.phase, self.times = 0.0, 1.0
        self.moving: Motion | None = None
        self.course: Course | None = None
        self._paths: dict = {}
        self._began = 0
        self.make_form("SensMotion", translate("Sens", "Motion of {name}").format(name=machine.Label), "Sens_Motion")
        page = QtGui.QVBoxLayout(self.form)
        names = list(movable(self.core))
        self.choice = combo([(n, f"{short_name(machine, n)}: {meaning(machine, n)}") for n in names])
        self.choice.setObjectName("SensMotionOf")
        page.addWidget(self.choice)
        self.over = combo(self._courses())
        self.over.setObjectName("SensMotionOver")
        self.over.setToolTip(translate("Sens", "A swing between the ends, or as fitted along a path or over readings"))
        self.over.setVisible(self.over.count() > 1)
        page.addWidget(self.over)
        row = QtGui.QHBoxLayout()
        row.addWidget(QtGui.QLabel(translate("Sens", "Exaggeration")))
        self.slider = QtGui.QSlider(Qt.Horizontal)
        self.slider.setRange(-100, 100)
        self.slider.setToolTip(translate("Sens", "From a tenth to ten times of what fits the view"))
        row.addWidget(self.slider, 1)
        page.addLayout(row)
        self.note = QtGui.QLabel()
        self.note.setWordWrap(True)
        page.addWidget(self.note)
        save = QtGui.QPushButton(translate("Sens", "Save pictures…"))
        save.setToolTip(translate("Sens", "Writes the motion as an animated GIF and as numbered PNG pictures"))
        save.clicked.connect(self.ask_and_save)
        page.addWidget(save)
        page.addStretch(1)
        if label in names:
            self.choice.setCurrentIndex(names.index(label))
        self.choice.currentIndexChanged.connect(self.show)
        self.over.currentIndexChanged.connect(self.show)
        self.slider.valueChanged.connect(self._scaled)
        self._clock, self._timer = QtCore.QElapsedTimer(), QtCore.QTimer()
        self._timer.timeout.connect(self._tick)
        self._clock.start()
        self.show()
        self._timer.start(STEP_MS)

    # -- what it goes over -----------------------------------------------------------------------------------------
    def _courses(self) -> list[tuple[str, str]]:
        found = [(SWING, translate("Sens", "Swing between the ends"))]
        if self.core.fitted is None and not any(e.enabled and e.coefficients for e in self.core.effects):
            return found
        if cam_path.has_path(self.machine.Document):
            found.append((PATH, translate("Sens", "Along the tool path")))
        for table in tree.readings_of(self.machine):
            found.append((table.Name, translate("Sens", "Over the readings {name}").format(name=table.Label)))
        return found

    def _path(self, what: str):
        """The path of a job, or the places of readings, read once."""
        if what not in self._paths:
            document, core = self.machine.Document, self.core
            if what == PATH:
                given = cam_path.given(cam_path.of_document(document), core)
                options = part_files.Options()
                job = live.in_background(
                    lambda progress: part_files.read(core, document.Name, options, given, progress),
                    translate("Sens", "Reading the tool path"),
                )
                self._paths[what] = job.path
            else:
                rows = closed_loop.read(document.getObject(what))
                self._paths[what] = of_points(core, rows, None, {})
        return self._paths[what]

    def _course(self, label: str) -> Course | None:
        what = self.over.itemData(self.over.currentIndex())
        if what in (None, SWING):
            return None
        return course(self.core, label, self._path(what), MOMENTS)

    # -- what is shown ---------------------------------------------------------------------------------------------
    def show(self, *_) -> None:
        """Show the motion of the chosen error."""
        self._take_away()
        self.moving = None
        label = self.choice.itemData(self.choice.currentIndex())
        if label is None:
            return
        try:
            self.course = None
            moving = motion(self.core, label, self.at)
            self.course = self._course(label)
        except Refused as refused:
            self.note.setText(messages.words(refused))
            return
        except Cancelled:
            self.over.setCurrentIndex(0)
            return
        self.moving = moving
        moving = self.moving
        self.ghost = Ghost(self.machine, moving.bodies)
        body = tree.body_of(self.machine, moving.body)
        displaced = refresh.latest(self.machine).displacements
        self.centre = np.array(displaced[moving.body].multVec(body.ReferencePoint))
        self.tip = self.centre + np.array(body.AbbeOffset)
        self.size = extent(self.machine)
        far = np.abs(self.ghost.corners - self.centre).max() if len(self.ghost.corners) else 0.0
        largest = max(
            np.linalg.norm(moving.answer) if self.course is None else np.linalg.norm(self.course.answer, axis=1).max(),
            np.linalg.norm(moving.shift),
            np.linalg.norm(moving.turn) * far,
            1e-12,
        )
        self.usual = SHOWN * self.size / largest
        self._copies.addChild(self.ghost.root)
        self.arrows.outline([] if self.course is None else [self._line()])
        self._began = self._clock.elapsed()
        self._scaled()

    def _line(self) -> list:
        """The places of the course, as a line in the view."""
        path = self._path(self.over.itemData(self.over.currentIndex()))
        rows = np.unique(np.linspace(0, path.points - 1, MOST_LINE).astype(int))
        return [tuple(p) for p in self.core.tool_position(path.q[rows], path.contact[rows]).tolist()]

    def _scaled(self, *_) -> None:
        if self.moving is None:
            return
        self.times = self.usual * 10 ** (self.slider.value() / 100)
        moving = self.moving
        c = self.core.component(moving.symbol)
        text = translate(
            "Sens", "{error} moves {body} by {value} {unit}, and the tool by {answer} µm. Shown {times} times as large."
        )
        fields = {
            "error": short_name(self.machine, moving.label),
            "body": body_name(self.machine, moving.body),
            "value": f"{c.to_shown(moving.value):.3g}",
            "unit": {"um": "µm", "urad": "µrad"}.get(c.unit, c.unit),
            "answer": f"{1e3 * np.linalg.norm(moving.answer):.3g}",
            "times": f"{self.times:,.0f}",
        }
        self.note.setText(text.format(**fields))
        self.draw(self.phase)

    def draw(self, phase: float) -> None:
        """Show the motion at a phase, -1 to 1: the size of the error over its largest."""
        self.phase = phase
        if self.moving is None or self.ghost is None:
            return
        moving = self.moving
        if self.course is not None:
            self._draw_course(int(round((phase + 1) / 2 * (MOMENTS - 1))))
            return
        shift = phase * (moving.slide + self.times * moving.shift)
        self.ghost.place(shift, phase * self.times * moving.turn, self.centre)
        tip = self.tip + (phase * moving.slide if self.core.side(moving.body) > 0 else 0.0)
        answer = tip + phase * self.times * moving.answer
        size = 1e3 * phase * float(np.linalg.norm(moving.answer))
        words = f"{size if abs(size) > 1e-9 else 0.0:.2g} µm"
        arm = length(float(np.linalg.norm(self.tip - self.centre)))
        self.arrows.show(
            [
                Arrow(tuple(self.centre.tolist()), tuple(self.tip.tolist()), OFFSET_COLOUR, arm),
                Arrow(tuple(tip.tolist()), tuple(answer.tolist()), ANSWER_COLOUR, words, 1.0),
            ],
            self.size,
        )

    def _draw_course(self, moment: int) -> None:
        """Show a moment of the course: the body as displaced then, the point that cuts, and its error as an arrow."""
        moving, now = self.moving, self.course
        share = float(now.value[moment] / moving.value) if moving.value else 0.0
        self.ghost.place(share * self.times * moving.shift, share * self.times * moving.turn, self.centre)
        place, answer = now.place[moment], now.answer[moment]
        c = self.core.component(moving.symbol)
        unit = {"um": "µm", "urad": "µrad"}.get(c.unit, c.unit)
        words = f"{c.to_shown(now.value[moment]):+.3g} {unit}  →  {1e3 * np.linalg.norm(answer):.2g} µm"
        if now.t is not None:
            seconds = now.t[moment] - now.t.min()
            words = (
                (f"{seconds:.0f} s" if now.t.max() - now.t.min() < 600 else f"{seconds / 60:.0f} min") + "\n" + words
            )
        end = place + self.times * answer
        self.arrows.show([Arrow(tuple(place.tolist()), tuple(end.tolist()), ANSWER_COLOUR, words, 1.0)], self.size)

    def _tick(self) -> None:
        if self.course is not None:
            self.draw(2 * ((self._clock.elapsed() - self._began) / 1000 / COURSE_S % 1.0) - 1)
            return
        self.draw(math.sin(2 * math.pi * self._clock.elapsed() / 1000 / PERIOD_S))

    # -- pictures --------------------------------------------------------------------------------------------------
    def ask_and_save(self, *_) -> list[Path]:
        """Ask for a folder and save the pictures there; returns their paths."""
        folder = messages.ask_folder(translate("Sens", "Folder for the pictures"))
        names = [*(["motion.gif"] if gif.available() else []), *(f"motion_{i:02d}.png" for i in range(FRAMES))]
        if not folder or not messages.may_write(folder, names):
            return []
        written = self.save(folder)
        messages.written(written)
        return written

    def frames(self, count: int = FRAMES, size: tuple[int, int] = GIF_SIZE) -> list[bytes]:
        """PNG pictures of one period, or of the whole course; empty without a view."""
        self._timer.stop()
        found = []
        try:
            for i in range(count):
                self.draw(math.sin(2 * math.pi * i / count) if self.course is None else 2 * i / max(count - 1, 1) - 1)
                data = picture(self.machine.Document, *size)
                if data is not None:
                    found.append(data)
        finally:
            self._timer.start(STEP_MS)
        return found

    def save(self, folder) -> list[Path]:
        """Write the motion as FRAMES pictures and, where Pillow is there, as a GIF into a folder; returns their
        paths."""
        shown = self.frames(FRAMES)
        files = {f"motion_{i:02d}.png": data for i, data in enumerate(shown)}
        lasts = PERIOD_S if self.course is None else COURSE_S
        moving = gif.animated(shown, int(1000 * lasts / FRAMES))
        if moving is not None:
            files = {"motion.gif": moving, **files}
        written = []
        for name, data in files.items():
            write_bytes(Path(folder) / name, data)
            written.append(Path(folder) / name)
        return written

    # -- the end ---------------------------------------------------------------------------------------------------
    def _take_away(self) -> None:
        self._copies.removeAllChildren()
        self.ghost = None
        self.arrows.clear()

    def leave(self) -> None:
        self._timer.stop()
        self._take_away()
        if alive(self.machine):
            root = self.machine.ViewObject.RootNode
            if root.findChild(self.root) >= 0:
                root.removeChild(self.root)


def open_panel(machine, label: str = "") -> TaskMotion:
    """Open the panel for a machine, with an error or effect chosen."""
    panel = TaskMotion(machine, label)
    show_panel(panel, machine.Document)
    return panel


def stills(machine, labels, count: int = 16, size: tuple[int, int] = (600, 430)) -> tuple[bytes, ...]:
    """Pictures for a report of how the first of the `labels` that can be shown moves the machine: a GIF, or three PNG
    pictures where no GIF can be written; none without a view."""
    try:
        names = movable(extract.survey(machine).core)
        label = next((one for one in labels if one in names), None)
        if label is None:
            return ()
        panel = TaskMotion(machine, label)
    except Refused:
        return ()
    try:
        if panel.moving is None:
            return ()
        shown = panel.frames(count if gif.available() else 3, size)
        moving = gif.animated(shown, int(1000 * PERIOD_S / count))
    finally:
        panel.leave()
    return tuple(shown) if moving is None else (moving,)


@command
class ShowMotion(Command):
    name = "Sens_Motion"
    menu_text = QT_TRANSLATE_NOOP("Sens_Motion", "Show Motion…")
    tip = QT_TRANSLATE_NOOP("Sens_Motion", "Moves the body of an error or effect in the view, exaggerated and animated")
    guide = TaskMotion.guide
    where = Where("analysis", 35, tree=("Machine", "Effect"))

    def run(self):
        chosen = Gui.Selection.getSelection(App.ActiveDocument.Name)
        effects = [o.Label for o in chosen if kind_of(o) == "Effect"]
        open_panel(current_machine(), effects[0] if effects else "")
