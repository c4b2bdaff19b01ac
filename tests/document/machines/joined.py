# SPDX-License-Identifier: LGPL-2.1-or-later
"""The machines of `kinds` as assemblies of FreeCAD's own Assembly workbench, as unlike people join them."""

from __future__ import annotations

from .. import assemblies
from . import add
from .kinds import Kind


def carriers(kind: Kind) -> dict[str, str]:
    """Body -> the body that carries it, by the structure (of a machine without one: in the order of its bodies)."""
    code = kind.truth.structure or "".join(kind.bodies)
    at = code.index("F")
    made = {}
    for branch in (code[:at][::-1], code[at + 1 :]):
        for before, body in zip("F" + branch, branch):
            made[body] = before
    for body in kind.bodies:  # rotary bodies
        if body != "F" and body not in made:
            made[body] = "X"
    return made


def _parts(doc, kind: Kind, names: bool = True):
    assembly = assemblies.new_assembly(doc)
    made = {body: [] for body in kind.bodies}
    for n, piece in enumerate(kind.pieces):
        obj = add(doc, piece.label if names else f"Part {n + 1:03d}", piece.shape, assembly)
        made[piece.body].append(obj)
    doc.recompute()
    return assembly, made


def _hold(assembly, made, across=None):
    """Ground the first part of the bed; fix all others of a body to its first."""
    assemblies.ground(assembly, made["F"][0])
    for objects in made.values():
        for other in objects[1:]:
            assemblies.join(
                assembly, "Fixed", f"Fixed {other.Label}", objects[0], other, tuple(other.Shape.BoundBox.Center)
            )
    for body, carrier in (across or {}).items():
        one, other = made[carrier][-1], made[body][0]
        assemblies.join(assembly, "Fixed", "Fixed", one, other, tuple(other.Shape.BoundBox.Center))


def _axis(kind: Kind, body: str):
    return kind.truth.axes.get(body, (0, 0, 1))


def loose(doc, kind: Kind, folder=None):
    """One part is grounded; nothing else is joined."""
    assembly, made = _parts(doc, kind)
    assemblies.ground(assembly, made["F"][0])


def all_fixed(doc, kind: Kind, folder=None):
    """Everything is fixed, blocks on their rails too, as for a picture."""
    assembly, made = _parts(doc, kind)
    _hold(assembly, made, carriers(kind))


def bodies_fixed(doc, kind: Kind, folder=None):
    """Each body is fixed in itself; between bodies there is nothing."""
    assembly, made = _parts(doc, kind)
    _hold(assembly, made)


def sliders(doc, kind: Kind, folder=None, joint="Slider", names=False):
    """A slider between every two bodies; parts with numbers for names."""
    assembly, made = _parts(doc, kind, names)
    _hold(assembly, made)
    for body, carrier in carriers(kind).items():
        one, other = made[carrier][0], made[body][0]
        what = joint if body in kind.truth.axes else "Revolute"
        assemblies.join(assembly, what, what, one, other, tuple(other.Shape.BoundBox.Center), _axis(kind, body))


def cylindrical(doc, kind: Kind, folder=None):
    """Cylindrical joints where sliders belong."""
    sliders(doc, kind, joint="Cylindrical", names=True)


def loose_sliders(doc, kind: Kind, folder=None):
    """Sliders between the main parts; all other parts are joined to nothing."""
    assembly, made = _parts(doc, kind)
    assemblies.ground(assembly, made["F"][0])
    for body, carrier in carriers(kind).items():
        if body in kind.truth.axes:
            one, other = made[carrier][0], made[body][0]
            assemblies.join(
                assembly, "Slider", "Slider", one, other, tuple(other.Shape.BoundBox.Center), _axis(kind, body)
            )


def one_slider(doc, kind: Kind, folder=None):
    """One slider is there, the others were never made."""
    assembly, made = _parts(doc, kind)
    _hold(assembly, made)
    body, carrier = next((b, c) for b, c in carriers(kind).items() if b in kind.truth.axes)
    one, other = made[carrier][0], made[body][0]
    assemblies.join(assembly, "Slider", "Slider", one, other, tuple(other.Shape.BoundBox.Center), _axis(kind, body))


def suppressed(doc, kind: Kind, folder=None):
    """Sliders that are switched off."""
    sliders(doc, kind, names=True)
    for obj in doc.Objects:
        if hasattr(obj, "JointType") and str(obj.JointType) == "Slider":
            if hasattr(obj, "Suppressed"):
                obj.Suppressed = True
            else:
                obj.Activated = False


JOINED = {f.__name__: f for f in (
    loose, all_fixed, bodies_fixed, sliders, cylindrical, loose_sliders, one_slider, suppressed)}  # fmt: skip
