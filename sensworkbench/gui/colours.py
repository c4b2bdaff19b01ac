# SPDX-License-Identifier: LGPL-2.1-or-later
"""Giving parts a colour and giving them their own back: features, bodies, leaves of App::Part, links.

How each part looked is written as JSON into the result object's `OriginalColours`, so it survives saving, closing and
reopening.  A link is coloured by overriding its material, so that other copies of the part keep theirs.  FreeCAD up to
0.21 has ShapeColor and DiffuseColor, later versions ShapeAppearance; what a view provider has decides.
"""

from __future__ import annotations

import functools
import json
from dataclasses import dataclass

import FreeCAD as App

from ..document import paths, refresh, tree
from .colormap import NO_DATA, Scale

_MATERIAL = ("AmbientColor", "DiffuseColor", "EmissiveColor", "SpecularColor")


@dataclass(frozen=True)
class Target:
    """What takes a colour: an object, or (with `element`) a part seen through a link.  Names live in one document."""

    obj: App.DocumentObject
    element: str = ""

    @property
    def key(self) -> str:
        """Return the text under which its own colours are stored in the document."""
        return f"{self.obj.Name}|{self.element}" if self.element else self.obj.Name


def _is_link(obj) -> bool:
    return obj.isDerivedFrom("App::Link")


def _target(leaf: paths.PartPath) -> Target:
    """The object to colour for a leaf: the first link on the way to it (with the rest of the way), or the leaf."""
    chain = leaf.chain
    names = [n for n in leaf.path.split(".") if n]
    for i, obj in enumerate(chain):
        if _is_link(obj):
            rest = names[i:]
            return Target(obj, ".".join(rest) + "." if rest else "")
    return Target(chain[-1])


def targets(machine) -> dict[str, list[Target]]:
    """Body ("F" the bed, joints, T, W) -> what to colour for it.  Parts of other documents are left alone.

    A link behind which everything belongs to one body is coloured as a whole, otherwise part by part.
    """
    parts, index = refresh.parts_and_index(machine)
    found: dict[str, dict[str, Target]] = {b: {} for b in parts}
    owners: dict[str, set] = {}
    seen = []
    for group in parts.values():
        for where in group:
            for leaf in paths.leaves(where):
                owner = tree.lookup(index, leaf.key)
                target = _target(leaf)
                if owner is None or target.obj.Document != machine.Document:
                    continue
                owners.setdefault(target.obj.Name, set()).add(owner)
                seen.append((owner, target))
    for owner, target in seen:
        whole = len(owners[target.obj.Name]) == 1
        target = Target(target.obj) if whole else target
        found[owner][target.key] = target
    return {b: list(t.values()) for b, t in found.items()}


# -- one object ------------------------------------------------------------------------------------------------------
def _rgb(colour) -> list[float]:
    return [float(v) for v in colour[:3]]


def _triple(colour) -> tuple[float, float, float]:
    return tuple(float(v) for v in colour[:3])


def _read_material(material) -> dict:
    found = {name: _rgb(getattr(material, name)) for name in _MATERIAL}
    return found | {"Shininess": float(material.Shininess), "Transparency": float(material.Transparency)}


def _make_material(data: dict):
    material = App.Material()
    for name in _MATERIAL:
        setattr(material, name, _triple(data[name]))
    material.Shininess, material.Transparency = float(data["Shininess"]), float(data["Transparency"])
    return material


def read(obj) -> dict:
    """Return the appearance of an object as plain data."""
    view = obj.ViewObject
    if _is_link(obj):
        return {
            "override": bool(view.OverrideMaterial),
            "colour": _rgb(view.ShapeMaterial.DiffuseColor),
            "elements": {k: _rgb(v) for k, v in view.getElementColors().items()},
        }
    data = {"colour": _rgb(view.ShapeColor), "transparency": int(getattr(view, "Transparency", 0))}
    if hasattr(view, "ShapeAppearance"):
        data["materials"] = [_read_material(m) for m in view.ShapeAppearance]
    else:
        data["faces"] = [_rgb(c) for c in view.DiffuseColor]
    return data


def write(obj, data: dict) -> None:
    """Make an object look as `read` found it, also where another version of FreeCAD wrote the data."""
    view = obj.ViewObject
    if _is_link(obj):
        _set_link(view, data["colour"], bool(data["override"]))
        view.setElementColors({k: _triple(v) for k, v in data["elements"].items()})
        return
    if hasattr(view, "ShapeAppearance") and "materials" in data:
        view.ShapeAppearance = tuple(_make_material(m) for m in data["materials"])
        return
    faces = data.get("faces") or [m["DiffuseColor"] for m in data.get("materials", [])]
    if not _near(_triple(view.ShapeColor), data["colour"]):
        view.ShapeColor = _triple(data["colour"])
    if hasattr(view, "DiffuseColor") and [_rgb(c) for c in view.DiffuseColor] != faces:
        _set_faces(view, faces)
    if hasattr(view, "Transparency") and view.Transparency != data["transparency"]:
        view.Transparency = data["transparency"]


def _set_faces(view, faces) -> None:
    """Colours face by face (or one for all), keeping the transparency that FreeCAD 0.20 hides in the fourth number."""
    hidden = view.Transparency / 100 if hasattr(view, "Transparency") else 0.0
    view.DiffuseColor = [(*_triple(c), hidden) for c in faces]


def _set_link(view, colour, override: bool) -> None:
    material = view.ShapeMaterial
    material.DiffuseColor = _triple(colour)
    view.ShapeMaterial = material
    view.OverrideMaterial = override


def paint(obj, colour) -> None:
    """Give an object one colour (r, g, b in 0..1); transparency stays."""
    view, colour = obj.ViewObject, _triple(colour)
    if _is_link(obj):
        _set_link(view, colour, True)
    elif hasattr(view, "ShapeAppearance"):
        material = view.ShapeAppearance[0]
        material.DiffuseColor = colour
        view.ShapeAppearance = (material,)
    elif len(view.DiffuseColor) > 1:
        # setting ShapeColor would do too, but FreeCAD 0.20 then loses the faces' colours on undo
        _set_faces(view, [colour])
    else:
        view.ShapeColor = colour


def shown_colour(obj) -> tuple[float, float, float]:
    """The colour that an object has in the view."""
    view = obj.ViewObject
    if _is_link(obj):
        return _triple(view.ShapeMaterial.DiffuseColor)
    return _triple(view.DiffuseColor[0] if hasattr(view, "DiffuseColor") else view.ShapeColor)


def _with_features(obj):
    """A PartDesign body and its features: colouring the body also colours its tip."""
    yield obj
    if obj.isDerivedFrom("PartDesign::Body"):
        for feature in obj.Group:
            if hasattr(feature, "Shape") and hasattr(feature.ViewObject, "ShapeColor"):
                yield feature


def _can(obj) -> bool:
    view = getattr(obj, "ViewObject", None)
    if view is None:
        return False
    if _is_link(obj):
        return hasattr(view, "OverrideMaterial")
    return hasattr(view, "ShapeColor") and (hasattr(view, "ShapeAppearance") or hasattr(view, "DiffuseColor"))


# -- the machine -----------------------------------------------------------------------------------------------------
def _originals(result) -> dict:
    """Name -> how the object looked, of those that are coloured; a dictionary of the caller's own."""
    try:
        return dict(_parsed(result.OriginalColours))
    except ValueError:
        App.Console.PrintWarning(f"{result.Label}: the stored original colours cannot be read\n")
        return {}


@functools.lru_cache(maxsize=8)
def _parsed(text: str) -> dict:
    found = json.loads(text) if text else {}
    return found if isinstance(found, dict) else {}


def apply(machine, result, values: dict[str, float], scale: Scale) -> int:
    """Colour every part by the value of its body (missing: grey); returns how many objects were coloured."""
    kept = _originals(result)
    before = len(kept)
    count = 0
    for body, group in targets(machine).items():
        colour = scale.colour(values[body]) if body in values else NO_DATA
        elements: dict[str, dict] = {}
        for target in group:
            obj = target.obj
            if not _can(obj):
                continue
            for one in _with_features(obj):
                if one.Name not in kept:
                    kept[one.Name] = read(one)
            if target.element:
                elements.setdefault(obj.Name, {})[f"{target.element}Face"] = colour
            elif not _near(shown_colour(obj), colour) or not _plain(obj):
                paint(obj, colour)
            count += 1
        for name, faces in elements.items():
            view = machine.Document.getObject(name).ViewObject
            others = {k: _triple(v) for k, v in view.getElementColors().items() if k not in faces}
            view.setElementColors({**others, **faces})
    if len(kept) != before:
        result.OriginalColours = json.dumps(kept, separators=(",", ":"))
    if not result.Coloured:
        result.Coloured = True
    return count


def _near(a, b) -> bool:
    return max(abs(p - q) for p, q in zip(a, b)) < 1e-4


def _plain(obj) -> bool:
    """True where one colour covers the object."""
    view = obj.ViewObject
    if _is_link(obj):
        return bool(view.OverrideMaterial)
    if hasattr(view, "ShapeAppearance"):
        return len(view.ShapeAppearance) == 1
    return len(view.DiffuseColor) <= 1


def restore(result) -> int:
    """Give every part its own look back; returns how many objects."""
    count = 0
    for name, data in _originals(result).items():
        obj = result.Document.getObject(name)
        if obj is not None and _can(obj):
            write(obj, data)
            count += 1
    if result.OriginalColours:
        result.OriginalColours = ""
    if result.Coloured:
        result.Coloured = False
    return count


def forget_missing(result) -> None:
    """Drop the looks of parts that are gone."""
    kept = _originals(result)
    left = {n: d for n, d in kept.items() if result.Document.getObject(n) is not None}
    if len(left) != len(kept):
        result.OriginalColours = json.dumps(left, separators=(",", ":"))
