# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fixtures for the tests that run inside FreeCAD (tests/run_in_freecad.py); outside of it they are skipped."""

from __future__ import annotations

import pytest

try:
    import FreeCAD as App
    import Part  # noqa: F401
except ImportError:
    App = None
    collect_ignore_glob = ["test_*.py"]


def pytest_collection_modifyitems(items):
    for item in items:
        if "tests/document" in str(item.fspath).replace("\\", "/"):
            item.add_marker(pytest.mark.freecad)


@pytest.fixture
def doc():
    document = App.newDocument("SensTest")
    document.UndoMode = 1
    yield document
    App.closeDocument(document.Name)
