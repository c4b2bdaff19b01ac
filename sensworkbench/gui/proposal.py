# SPDX-License-Identifier: LGPL-2.1-or-later
"""The proposal as the machine panel shows it: found by `document.propose`, with its words in the window's language."""

from __future__ import annotations

from dataclasses import dataclass, field

import FreeCADGui as Gui

from ..document import paths
from ..document.base import kind_of
from ..document.propose import building
from ..document.propose.found import Found
from ..document.propose.suggestions import AxisProposal, suggested
from ..messages import Message

BODIES = ("F", "X", "Y", "Z", "T", "W")
LANGUAGES = {"German": "de", "Korean": "ko"}


@dataclass
class Shown:
    """What the panel says of a proposal.

    found : the proposal, None where a machine is edited.  reasons : body, "structure" or "tool point" -> pieces, each
    the property that it speaks of ("parts", "direction", "travel") and a message.  directions : what else the geometry
    suggests.
    """

    found: Found | None = None
    reasons: dict[str, list[tuple[str, Message]]] = field(default_factory=dict)
    notes: list[Message] = field(default_factory=list)
    directions: list[AxisProposal] = field(default_factory=list)

    @property
    def bodies(self) -> list[str]:
        """The bodies that have parts by the proposal."""
        return [] if self.found is None else [b for b in BODIES if self.found.bodies.get(b)]


def language() -> str:
    """The language of the window, as `Message.text` takes it."""
    return LANGUAGES.get(Gui.getLocale(), "en")


def candidates(doc) -> list[tuple]:
    """Parts of a document that could be bodies: top-level containers, links and shapes, and containers inside them."""
    found = []
    for obj in doc.Objects:
        if kind_of(obj) or not _part_like(obj):
            continue
        outer = paths.container_of(obj)
        if outer is None or obj.isDerivedFrom("App::Part") or obj.isDerivedFrom("App::Link"):
            found.append((obj, ""))
    return found


def _part_like(obj) -> bool:
    if obj.isDerivedFrom("App::Part") or obj.isDerivedFrom("App::Link") or hasattr(obj, "Mesh"):
        return True
    if paths._is_datum(obj) or not hasattr(obj, "Shape"):
        return False
    used = any(hasattr(parent, "Shape") and not hasattr(parent, "Group") for parent in obj.InList)
    return not used and not obj.Shape.isNull() and bool(obj.Shape.Faces)


def make(doc, found: Found, label: str):
    """(machine of a proposal, what to say of it).  Axes that were not found are made empty.  Opens no transaction."""
    blanks = () if found.complete else ("X", "Y", "Z")
    machine = building.build(doc, found, label=label, blanks=blanks)
    return machine, shown(doc, found)


def shown(doc, found: Found) -> Shown:
    """What to say of a proposal."""
    made = Shown(found, notes=list(found.remarks))
    for body, messages in found.reasons.items():
        made.reasons[body] = [("parts", m) for m in messages]
    for name, axis in found.axes.items():
        sure = Message("propose-panel-sure", percent=100 * axis.confidence)
        pieces = [("travel" if m.code.startswith("propose-travel") else "direction", m) for m in axis.evidence]
        made.reasons[name] = [("direction", sure), *pieces]
    if found.structure:
        made.reasons["structure"] = [("structure", Message("propose-panel-chain"))]
    named = building.named_tool_point(doc)
    if named is not None and named.object.Name not in found.made:
        made.reasons["tool point"] = [("tool", Message("propose-panel-tool-name", part=named.object.Label))]
    elif found.axes:
        made.reasons["tool point"] = [("tool", Message("propose-panel-tool"))]
    if len(found.axes) < 3 and not found.complete:
        made.directions = suggested(found.document) if found.document and found.document.units else []
    return made


def selected_links() -> list[tuple]:
    """What is selected in the window, as links with the path from the topmost container."""
    links = []
    for item in Gui.Selection.getSelectionEx("", 0):
        links.extend((item.Object, sub) for sub in (item.SubElementNames or ("",)))
    return links
