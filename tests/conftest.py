# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all tiers share: repeatable random examples, and tests that are collected only where what they need exists.

`@pytest.mark.needs("assembly")` names a part of FreeCAD that not every version has (`HAS` says how it is found).  Where
it is missing the test is left out of the collection, and pytest counts it as deselected: a skip would look like a test.
"""

from __future__ import annotations

import importlib

from hypothesis import settings

settings.register_profile("repeatable", derandomize=True, database=None, deadline=None)
settings.load_profile("repeatable")


def importable(*modules: str) -> bool:
    """Return whether all of these modules can be imported."""
    try:
        return all(importlib.import_module(name) for name in modules)
    except ImportError:
        return False


def panel_dock() -> bool:
    """Return whether task panels are in a dock of the main window; later versions lay them over the 3D view."""
    from sensworkbench.gui.qt import QtGui, main_window

    return any(d.objectName() == "Combo View" for d in main_window().findChildren(QtGui.QDockWidget))


HAS = {
    "assembly": lambda: importable("JointObject", "UtilsAssembly"),  # FreeCAD 1.0 and later
    "cam-machines": lambda: importable("Machine.models.machine"),  # later than 1.1, or a folder named by SENS_CAM
    "panel-dock": panel_dock,
}


def pytest_collection_modifyitems(config, items):
    wanted = {item: [mark.args[0] for mark in item.iter_markers("needs")] for item in items}
    there = {name: HAS[name]() for name in {n for names in wanted.values() for n in names}}
    left_out = [item for item in items if not all(there[name] for name in wanted[item])]
    if left_out:
        config.hook.pytest_deselected(items=left_out)
        items[:] = [item for item in items if item not in set(left_out)]
