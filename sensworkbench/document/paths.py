# SPDX-License-Identifier: LGPL-2.1-or-later
"""Positions of linked parts and pieces of geometry: object, path, element, and the placement along the path.

The position of a part in a moved App::Part, behind an App::Link or in another document follows from its whole path; a
part that is linked twice has two paths.  FreeCAD's own global placement ignores links, so it is not used here.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import FreeCAD as App
import Part

from ..messages import Refused

PLACEMENT_ONLY = 3  # retType of getSubObject


def container_of(obj):
    """The App::Part, Body or assembly that holds `obj`, or None."""
    return obj.getParentGeoFeatureGroup() if hasattr(obj, "getParentGeoFeatureGroup") else None


def _is_folder(obj) -> bool:
    return obj.isDerivedFrom("App::DocumentObjectGroup")


def _is_body(obj) -> bool:
    return obj.isDerivedFrom("PartDesign::Body")


@dataclass(frozen=True, eq=False)
class PartPath:
    """An occurrence of an object.  root : topmost object.  path : "Inner.Link.Part." or "".  element : "Face6" or
    "".
    """

    root: App.DocumentObject
    path: str = ""
    element: str = ""

    @property
    def chain(self) -> list:
        """The objects from the topmost one to the one that is meant; refuses a path that leads nowhere."""
        found, reached = [self.root], self.root.getSubObject(self.path, retType=1) if self.path else self.root
        if reached is None:
            raise Refused("part-path-dead", self.root.Label, path=self.path.rstrip("."), root=self.root.Label)
        names = [n for n in self.path.split(".") if n and not n.startswith(";")]
        for i in range(len(names)):
            found.append(self.root.getSubObject(".".join(names[: i + 1]) + ".", retType=1))
        return found

    @property
    def object(self):
        """Return the object at the end of the path."""
        return self.chain[-1]

    @property
    def label(self) -> str:
        """Return the object's label, with the element if there is one."""
        return self.object.Label + (f" {self.element}" if self.element else "")

    @cached_property
    def key(self) -> tuple:
        """Identifies the occurrence: (document, name) along the path, folders left out."""
        return tuple((o.Document.Name, o.Name) for o in self.chain if not _is_folder(o))

    @property
    def placement(self) -> App.Placement:
        """Placement in the coordinates of the document that holds the topmost object."""
        self.chain  # noqa: B018 - refuses a dead path
        return _outer(self.root) * self.root.getSubObject(self.path, retType=PLACEMENT_ONLY)

    @property
    def parent_placement(self) -> App.Placement:
        """Placement of the container that the object's own Placement is written in."""
        if not self.path:
            return _outer(self.root)
        names = self.path.rstrip(".").split(".")[:-1]
        return PartPath(self.root, ".".join(names) + "." if names else "").placement

    def shape(self):
        """The element's shape (or the object's, None where it has none) in document coordinates."""
        self.chain  # noqa: B018
        try:
            shape = self.root.getSubObject(self.path + self.element)
        except (ValueError, Part.OCCError):  # an element that the shape has lost
            shape = None
        if not isinstance(shape, Part.Shape) or shape.isNull():
            if self.element:
                raise Refused("part-element-gone", self.object.Label, element=self.label)
            return None
        outer = _outer(self.root)
        if not outer.isIdentity():
            shape = shape.transformed(outer.toMatrix())
        return shape

    def child(self, obj) -> PartPath:
        """Return the place of an object inside this one."""
        return PartPath(self.root, f"{self.path}{obj.Name}.")


def _outer(root) -> App.Placement:
    placement = App.Placement()
    while (root := container_of(root)) is not None:
        placement = root.Placement * placement
    return placement


def place(link) -> PartPath | None:
    """The `PartPath` of an object, (object, "path.element"), (object, ["path.element"]) or a PropertyXLinkSub value.

    A path that starts inside a container is extended to the topmost one.  None for None or an empty link.
    """
    if isinstance(link, PartPath):
        return link
    obj, sub = link if isinstance(link, (tuple, list)) else (link, "")
    if isinstance(sub, (tuple, list)):
        if len(sub) > 1:
            raise Refused("part-several-elements", obj.Label, count=len(sub))
        sub = sub[0] if sub else ""
    if obj is None:
        return None
    path, _, element = sub.rpartition(".")
    path = path + "." if path else ""
    while (outer := container_of(obj)) is not None:
        path = f"{obj.Name}.{path}"
        obj = outer
    return PartPath(obj, path, element)


def _whole(found: PartPath) -> PartPath:
    """Return the place of the whole part: without its element, and with a PartDesign body in place of a feature
    inside it.
    """
    names = found.path.rstrip(".").split(".") if found.path else []
    for i, obj in enumerate(found.chain):
        if _is_body(obj):
            return PartPath(found.root, ".".join(names[:i]) + "." if i else "")
    return PartPath(found.root, found.path)


def places(links) -> list[PartPath]:
    """Return the `PartPath`s of a PropertyXLinkSubList value or of a list of what `place` takes; folders give their
    content.
    """
    found = []
    for link in links:
        obj, subs = link if isinstance(link, (tuple, list)) else (link, "")
        for sub in subs if isinstance(subs, (tuple, list)) and subs else [subs or ""]:
            where = obj if isinstance(obj, PartPath) else place((obj, sub))
            if where is not None:
                found.extend(_expanded(_whole(where)))
    unique = {}
    for where in found:
        unique.setdefault(where.key, where)
    return list(unique.values())


def _expanded(where: PartPath) -> list[PartPath]:
    obj = where.object
    if not _is_folder(obj):
        return [where]
    inside = [place((o, "")) if not where.path else where.child(o) for o in obj.Group]
    return [leaf for w in inside for leaf in _expanded(w)]


def as_links(parts) -> list:
    """Value for a PropertyXLinkSubList."""
    if parts is None or isinstance(parts, (App.DocumentObject, PartPath)):
        parts = [] if parts is None else [parts]
    return [(w.root, w.path) for w in (_whole(p) for p in map(place, _flat(parts)) if p is not None)]


def _flat(parts):
    for part in parts:
        if isinstance(part, (tuple, list)) and len(part) == 2 and isinstance(part[1], (tuple, list)):
            yield from ((part[0], sub) for sub in part[1] or [""])
        else:
            yield part


def as_sub(source):
    """Value for a PropertyXLinkSub."""
    found = None if source is None else place(source)
    return None if found is None else (found.root, [found.path + found.element])


# -- leaves ----------------------------------------------------------------------------------------------------------
def leaves(where: PartPath) -> list[PartPath]:
    """The things with a shape of their own at or below a place: what is coloured, and what has mass.

    Containers and links to containers are walked; what another feature of the container has consumed is left out.
    """
    obj = where.object
    real = obj.getLinkedObject(True) if hasattr(obj, "getLinkedObject") else obj
    if real is None:
        return []
    if _is_body(real) or not hasattr(real, "Group"):
        return [where] if hasattr(real, "Shape") and not _is_datum(real) else []
    content = [o for o in real.Group if o is not None]
    inside_folder = {o for f in content if _is_folder(f) for o in f.Group}
    content = [o for o in content if o not in inside_folder]
    used = {used for o in content if hasattr(o, "Shape") and not hasattr(o, "Group") for used in _inputs(o)}
    return [leaf for o in content if o not in used for leaf in leaves(where.child(o))]


def _inputs(obj) -> set:
    if obj.isDerivedFrom("App::Link"):
        return set()
    attached = {o for name in ("Support", "AttachmentSupport") for o, _ in getattr(obj, name, None) or ()}
    return set(obj.OutList) - attached


def _is_datum(obj) -> bool:
    return obj.TypeId in DATUM_TYPES


LINE_ALONG_X = {"App::Line"}
LINE_ALONG_Z = {"PartDesign::Line", "Part::DatumLine"}
PLANES = {"App::Plane", "PartDesign::Plane", "Part::DatumPlane"}
DATUM_TYPES = (
    LINE_ALONG_X | LINE_ALONG_Z | PLANES
    | {"PartDesign::CoordinateSystem", "Part::LocalCoordinateSystem", "App::LocalCoordinateSystem", "App::Point",
       "PartDesign::Point", "Part::DatumPoint", "App::Placement", "App::Origin"}
)  # fmt: skip
