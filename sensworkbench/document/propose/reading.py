# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parts of a document that can move as wholes, with all that names and structure say of them.

Containers are walked, links are parts of their own (what stands inside a link moves in every copy), folders only lend
their names.  Where a document holds next to nothing but one lump or one link, that is looked into.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import FreeCAD as App
import numpy as np

from .. import curves, joints
from ..base import kind_of
from ..imported import COMPOUNDS
from ..paths import DATUM_TYPES, PartPath, _is_folder, container_of, leaves, place
from . import words
from .facets import Looker, Solid, of_mesh
from .frame import Frame, frame_of

FEW = 3  # a document with fewer parts is looked into
SMALL = 0.02  # of the machine's size: smaller things hold others together, and are none themselves


@dataclass
class Unit:
    """A part that moves as a whole.  labels : names from the outermost container inwards, its own last.

    number : which solid of the object it is, where the object is one lump of many (None: the whole object).
    """

    where: PartPath
    labels: tuple[str, ...]
    solids: list[Solid] = field(default_factory=list)
    number: int | None = None
    holders: tuple = ()  # keys of the containers and folders that it stands in
    source: str = ""  # name of what it links to

    def __post_init__(self):
        self.label = self.labels[-1] + ("" if self.number is None else f" {self.number + 1}")
        own = [self.labels[-1], self.source] if self.source else [self.labels[-1]]
        self.hardware = next((h for t in own if (h := words.hardware(t))), "")
        self.stated_length = next((v for t in own if (v := words.length(t)) is not None), None)
        self.own_role = next((r for t in own if (r := words.role(t))), "")
        self.own_letter = next((a for t in own if (a := words.letter(t))), "")
        if self.hardware:  # named after the axis that it serves, and after what it belongs to
            self.own_role = "" if self.hardware not in ("block", "nut") else self.own_role
            self.own_letter = self.own_letter if self.hardware == "block" else ""

    @property
    def key(self) -> tuple:
        """Identifies the occurrence of the unit in the document."""
        return (*self.where.key, self.number)

    @property
    def role(self) -> str:
        """Its own place in the machine, else that of the innermost container whose name states one."""
        return self.own_role or next((r for t in reversed(self.labels[:-1]) if (r := words.role(t))), "")

    @property
    def box(self) -> np.ndarray:
        """(6,) bounding box: lowest and highest x, y, z, mm."""
        boxes = np.array([s.box for s in self.solids])
        return np.hstack([boxes[:, :3].min(0), boxes[:, 3:].max(0)])

    @property
    def size(self) -> float:
        """Length of the diagonal of its bounding box, mm."""
        box = self.box
        return float(np.linalg.norm(box[3:] - box[:3]))

    @property
    def bulk(self) -> float:
        """Volume of the boxes of its solids, mm3."""
        return float(sum(np.prod(np.maximum(s.size, 0.1)) for s in self.solids))

    def extent(self, u) -> tuple[float, float]:
        """Return the lowest and highest coordinate along the unit vector u, mm."""
        ends = [s.extent(u) for s in self.solids]
        return min(e[0] for e in ends), max(e[1] for e in ends)


@dataclass
class Bond:
    """What a joint or constraint of the document says of two units.

    kind : "fixed", "slider", "turning" (revolute, ball, cylindrical) or "placed" (a constraint that is neither).
    u : direction of a slider; limits : (low, high) in mm of how far `other` may stand from `one` along u, or None.
    """

    one: int
    other: int
    kind: str
    label: str
    u: np.ndarray | None = None
    stands: float = 0.0
    limits: tuple[float, float] | None = None
    joint: PartPath | None = None
    weight: float = 1.0  # of what only places: how firmly it may hold


@dataclass
class Document:
    """What was read, in the machine's own frame.

    grounded : numbers of units that the document itself holds still.  remarks : (code, fields).
    """

    units: list[Unit]
    bonds: list[Bond] = field(default_factory=list)
    grounded: set[int] = field(default_factory=set)
    remarks: list[tuple[str, dict]] = field(default_factory=list)
    rotary_joints: int = 0
    sampled: int = 0
    names: list[str] = field(default_factory=list)  # all labels, containers too
    inside_link: bool = False
    frame: Frame = field(default_factory=Frame)  # that solids and bonds are given in
    apart: dict = field(default_factory=dict)  # unit key -> PartPath of the object that a lump's solid became


def read(doc, selection=(), seconds: float = 8.0, progress=None) -> Document:
    """Read a document, or what is selected of it.  selection : links as `paths.place` takes them."""
    found, names = [], []
    folders = {o.Name: f for f in doc.Objects if _is_folder(f) and not kind_of(f) for o in f.Group if o is not None}
    tops = _tops(doc, selection)
    for where in tops:
        _walk(where, _folders_of(where, folders), found, names)
    visible = [f for f in found if _visible(f[0])]
    found = visible if len(visible) >= 2 or not found else found
    found = _without_library(found)
    inside = False
    while len(found) < FEW and (deeper := _inside_links(found, names)) is not None:
        found, inside = deeper, True
    made = _looked_at(found, names, seconds, progress)
    made.inside_link = inside
    _bonds(doc, made)
    for bond in made.bonds if not made.frame.is_document else ():
        bond.u = None if bond.u is None else made.frame.inward(bond.u)
    return made


def read_parts(chosen, seconds: float = 8.0) -> Document:
    """Read some parts alone, without the joints between them.  chosen : their places."""
    found, names = [], []
    for where in chosen:
        _walk(PartPath(where.root, where.path), (), found, names)
    return _looked_at(found, names, seconds, None)


def _looked_at(found, names, seconds: float, progress) -> Document:
    """The shapes of parts, in the frame in which they are best looked at."""
    looker = Looker(seconds)
    order = sorted(range(len(found)), key=lambda n: _faces(found[n][0]))  # rails and blocks before motors and castings
    looks: list[list[Solid]] = [[] for _ in found]
    for done, n in enumerate(order):
        if progress is not None and looker.wait(lambda done=done: progress(done, len(found))):
            break
        looks[n] = _solids(found[n][0], looker)
    units = _units(found, looks)
    frame = frame_of(units, {n for n, u in enumerate(units) if u.hardware == "fastener"})
    if not frame.is_document:
        looks = [_solids(entry[0], looker, frame) if seen else [] for entry, seen in zip(found, looks)]
        units = _units(found, looks)
    return Document(units, sampled=looker.sampled, names=names, frame=frame)


def _units(found, looks) -> list[Unit]:
    """A unit for each part; for each of its solids where there are next to no parts."""
    units, lumps = [], []
    for (where, labels, holders, source), solids in zip(found, looks):
        if solids:
            unit = Unit(where, labels, solids, None, holders, source)
            (lumps if len(found) < FEW and len(solids) > 1 else units).append(unit)
    for lump in lumps:
        units += [Unit(lump.where, lump.labels, [s], k, lump.holders, lump.source) for k, s in enumerate(lump.solids)]
    return units


def _tops(doc, selection) -> list[PartPath]:
    if selection:
        chosen = [w for link in selection if (w := place(link)) is not None and not kind_of(w.object)]
        chosen = [PartPath(w.root, w.path) for w in chosen]
        keys = {w.key: w for w in chosen}
        return [w for w in keys.values() if not any(w.key[:n] in keys for n in range(1, len(w.key)))]
    return [PartPath(o) for o in doc.Objects if container_of(o) is None and not _is_folder(o) and not kind_of(o)
            and not _consumed(o)]  # fmt: skip


def _consumed(obj) -> bool:
    """Whether an object is what another one is made of, or stands in a group or an array of links."""
    for parent in obj.InList:
        if obj in (getattr(parent, "ElementList", None) or ()):
            return True
        if parent.isDerivedFrom("App::Link") or hasattr(parent, "Group") or kind_of(parent):
            continue
        if parent.TypeId in COMPOUNDS and _opened(parent):
            continue
        if hasattr(parent, "Shape") and not hasattr(parent, "Placement1"):
            return True
    return False


def _opened(compound) -> bool:
    """Whether a compound is looked into: its parts can be moved, and there are no other compounds beside it."""
    others = [o for o in compound.Document.Objects if o.TypeId in COMPOUNDS and container_of(o) is None]
    return len(compound.Links) > 1 and compound.Placement.isIdentity() and len(others) < FEW


def _folders_of(where: PartPath, folders) -> tuple:
    outer, obj = [], where.root
    while obj.Name in folders and len(outer) < 20:
        obj = folders[obj.Name]
        outer.insert(0, obj)
    return tuple(((o.Document.Name, o.Name), o.Label) for o in outer)


def _visible(where: PartPath) -> bool:
    return all(getattr(o, "Visibility", True) for o in where.chain)


def _without_library(found: list) -> list:
    """A container all of whose parts are only there to be linked to is a library, and no part of the machine."""
    targets = {(o.Document.Name, o.Name) for where, *_ in found if where.object.isDerivedFrom("App::Link")
               for o in (where.object.getLinkedObject(False),) if o is not None}  # fmt: skip
    inside: dict[tuple, list] = {}
    for entry in found:
        if entry[2]:
            inside.setdefault(entry[2][0], []).append(entry)
    for members in inside.values():
        keys = [entry[0].key[-1] for entry in members]
        if len(members) > 1 and all(key in targets for key in keys) and len(found) - len(members) >= 2:
            found = [entry for entry in found if entry not in members]
    return found


def _walk(where: PartPath, outer: tuple, found: list, names: list, label: str = "") -> None:
    obj = where.object
    if obj is None or kind_of(obj) or obj.TypeId in DATUM_TYPES or joints.is_joint(obj) or joints.is_ground(obj):
        return
    if len(found) > 20000:
        return
    here = (*outer, (where.key, label or obj.Label))
    elements = [o for o in getattr(obj, "ElementList", None) or () if o is not None]
    if elements:  # a group of links, or an array of them
        names.append(obj.Label)
        array = obj.isDerivedFrom("App::Link")
        for number, child in enumerate(elements, 1):
            _walk(where.child(child), here, found, names, f"{obj.Label} {number}" if array else "")
        return
    if obj.isDerivedFrom("App::Link") or obj.isDerivedFrom("App::LinkElement"):
        linked = joints.linked(obj)
        if linked is not None and linked is not obj:
            names.append(obj.Label)
            source = linked.Label
            if linked.Document is not obj.Document:
                source = f"{linked.Label} {linked.Document.Label}" if len(linked.Label) > 3 else linked.Document.Label
            found.append((where, tuple(t for _, t in here), tuple(k for k, _ in outer), source))
        return
    if obj.TypeId in COMPOUNDS and _opened(obj) and not where.path:
        return  # its parts stand at the top level themselves
    if hasattr(obj, "Group") and not obj.isDerivedFrom("PartDesign::Body"):
        names.append(obj.Label)
        used = {p.Name for o in obj.Group if o is not None for p in _made_of(o)}
        folded = {p.Name for o in obj.Group if o is not None and _is_folder(o) for p in o.Group}
        for child in obj.Group:
            if child is not None and child.Name not in used and (child.Name not in folded or _is_folder(obj)):
                _walk(where.child(child), here, found, names)
        return
    if hasattr(obj, "Mesh") or hasattr(obj, "Shape"):
        names.append(obj.Label)
        found.append((where, tuple(t for _, t in here), tuple(k for k, _ in outer), ""))


def _made_of(obj) -> list:
    """What a feature inside a container consumes."""
    if obj.isDerivedFrom("App::Link") or hasattr(obj, "Group") or not hasattr(obj, "Shape"):
        return []
    attached = {o for name in ("Support", "AttachmentSupport") for o, _ in getattr(obj, name, None) or ()}
    return [o for o in obj.OutList if o not in attached]


def _inside_links(found, names):
    """The parts inside links and containers where there are next to none outside; None where there are none inside."""
    deeper, changed = [], False
    for where, labels, holders, source in found:
        real = joints.linked(where.object)
        group = [o for o in getattr(real, "Group", None) or () if o is not None]
        before = len(deeper)
        if group and not real.isDerivedFrom("PartDesign::Body"):
            outer = (*zip(holders, labels), (where.key, labels[-1]))
            for child in group:
                _walk(where.child(child), outer, deeper, names)
        if len(deeper) == before:
            deeper.append((where, labels, holders, source))
        else:
            changed = True
    return deeper if changed else None


def _faces(where: PartPath) -> int:
    try:
        return len(curves.parts(where.shape(), "Faces"))
    except Exception:  # noqa: BLE001 - a damaged part comes last
        return 10**9


def _solids(where: PartPath, looker: Looker, frame: Frame | None = None) -> list[Solid]:
    turn = None if frame is None else frame.turn
    try:
        if hasattr(where.object, "Mesh"):
            mesh = where.object.Mesh.copy()
            place_there = where.placement if turn is None else turn.multiply(where.placement)
            mesh.Placement = place_there
            solids = of_mesh(mesh)
        else:
            shape = where.shape()
            if curves.is_something(shape):
                solids = looker.solids(shape, turn)
            else:
                solids = [s for leaf in leaves(where) for s in looker.solids(leaf.shape(), turn)]
    except Exception:  # noqa: BLE001 - a damaged part is no reason to know nothing of the others
        return []
    return solids if frame is None or frame.scale == 1.0 else [s.scaled(frame.scale) for s in solids]


# -- joints and constraints of the document --------------------------------------------------------------------------
JOINT_KINDS = {"Fixed": "fixed", "Slider": "slider", "Revolute": "turning", "Ball": "turning", "Cylindrical": "turning"}


def _bonds(doc, made: Document) -> None:
    index = {u.where.key: n for n, u in enumerate(made.units)}
    by_name = {}
    for n, unit in enumerate(made.units):
        by_name.setdefault(unit.where.root.Name, []).append(n)

    def numbers(where: PartPath) -> list[int]:
        """The units that a place is, or stands in, or holds."""
        key = where.key
        inside = next((index[key[:n]] for n in range(len(key), 0, -1) if key[:n] in index), None)
        if inside is not None:
            return [inside]
        return [n for k, n in index.items() if k[: len(key)] == key]

    for obj in doc.Objects:
        try:
            if joints.is_joint(obj):
                _joint(obj, made, numbers)
            elif joints.is_ground(obj) and joints.is_active(obj) and obj.ObjectToGround is not None:
                made.grounded.update(numbers(place(obj.ObjectToGround)))
            elif getattr(obj, "SubElement1", None) is not None and hasattr(obj, "Object1"):
                _constraint(obj, made, by_name)
            elif getattr(obj, "fixedPosition", False) and obj.Name in by_name:
                made.grounded.update(by_name[obj.Name])
        except Exception:  # noqa: BLE001, S112 - a joint that has lost its parts says nothing
            continue
    if len(made.grounded) == len(made.units):
        made.grounded = set()


def _joint(obj, made: Document, numbers) -> None:
    if not joints.is_active(obj):
        return
    kind = JOINT_KINDS.get(str(obj.JointType), "placed")
    ends = [numbers(joints.reference(obj, side)) for side in (1, 2)]
    if not ends[0] or not ends[1] or set(ends[0]) & set(ends[1]):
        return
    where = place(obj)
    u, stands, limits = None, 0.0, None
    if kind in ("slider", "turning"):
        u = np.array(tuple(joints.frame(where, 1).Rotation.multVec(App.Vector(0, 0, 1))))
    if kind == "turning":
        made.rotary_joints += 1
    if kind == "slider":
        stands = joints.distance(where)
        low, high = (_limit(obj, end) for end in ("Min", "Max"))
        if low is not None and high is not None and low < high:
            limits = (low, high)
    one, other = ends[0][0], ends[1][0]
    made.bonds.append(Bond(one, other, kind, obj.Label, u, stands, limits, where if kind == "slider" else None))
    for group in ends:  # an end that is a container holds all that stands in it
        made.bonds += [Bond(group[0], n, "fixed", obj.Label) for n in group[1:]]


def _limit(obj, end: str):
    if not getattr(obj, f"EnableLength{end}", False):
        return None
    value = getattr(obj, f"Length{end}", 0.0)
    return float(getattr(value, "Value", value))


CONSTRAINTS = (  # of a2plus: how firmly each kind holds; one that only turns a part to lie parallel holds nothing
    ("parallel", 0.05), ("angle", 0.05), ("normal", 0.05), ("circular", 1.0), ("center", 0.6), ("point", 0.6),
    ("axial", 0.3), ("axis", 0.3), ("plane", 0.4),
)  # fmt: skip


def _constraint(obj, made: Document, by_name) -> None:
    """A constraint of a2plus or of the older Assembly 2: two parts, of which it takes some freedom."""
    if str(obj.Name).endswith("_mirror") or getattr(obj, "Suppressed", False):
        return
    one, other = by_name.get(str(obj.Object1)), by_name.get(str(obj.Object2))
    if one and other and one[0] != other[0]:
        said = f"{getattr(obj, 'Type', '')} {obj.Name}".lower()
        weight = next((w for word, w in CONSTRAINTS if word in said), 0.5)
        made.bonds.append(Bond(one[0], other[0], "placed", obj.Label, weight=weight))
