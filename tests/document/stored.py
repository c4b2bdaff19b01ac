# SPDX-License-Identifier: LGPL-2.1-or-later
"""What an object of ours stores, in a form that JSON holds and that can be compared."""

from __future__ import annotations

import hashlib
from pathlib import Path

import FreeCAD as App


def values(obj) -> dict:
    """Property -> value; links as names, vectors as lists, quantities as numbers."""
    found = {}
    for name in obj.PropertiesList:
        if name not in ("Proxy", "Group", "ExpressionEngine", "Visibility", "Label2") and not name.startswith("_"):
            found[name] = plain(getattr(obj, name))
            if obj.getTypeIdOfProperty(name) == "App::PropertyFileIncluded":  # its path is another at every opening
                found[name] = hashlib.sha256(Path(found[name]).read_bytes()).hexdigest()
    return found


def plain(value):
    if isinstance(value, App.Vector):
        return [value.x, value.y, value.z]
    if isinstance(value, App.Placement):
        return [*plain(value.Base), *value.Rotation.Q]
    if isinstance(value, App.DocumentObject):
        return value.Name
    if hasattr(value, "Value"):
        return value.Value
    if isinstance(value, dict):
        return {k: plain(v) for k, v in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(v) for v in value]
    return value
