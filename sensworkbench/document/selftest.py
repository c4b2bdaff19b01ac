# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run by FreeCAD's own test framework (`freecadcmd --run-test sensworkbench.document.selftest`).

A quick check that an installation works: an example machine is built, computed, saved and read back.  The full tests
are in the repository's tests folder.
"""

from __future__ import annotations

import tempfile
import unittest
from pathlib import Path

import FreeCAD as App


class Installation(unittest.TestCase):
    """Test an installed add-on: an example machine is made, computed, saved and read back."""

    def setUp(self):
        self.doc = App.newDocument("SensSelfTest")

    def tearDown(self):
        for name in list(App.listDocuments()):
            if name.startswith("SensSelfTest"):
                App.closeDocument(name)

    def test_an_example_machine_is_computed_saved_and_read_back(self):
        """Make an example machine, compute it, save it, open it again and compare the indices."""
        from . import examples, results, tree

        machine = examples.make_example(self.doc, "XYFZ")
        self.assertEqual(machine.Problem, "")
        found = results.compute(machine)
        total = list(found.Total)
        self.assertLess(found.EstimatedError, 1e-5)
        self.assertTrue(all(0 <= first <= all_ <= 1 for first, all_ in zip(found.First, total)))
        with tempfile.TemporaryDirectory() as folder:
            path = str(Path(folder) / "SensSelfTest.FCStd")
            self.doc.saveAs(path)
            App.closeDocument(self.doc.Name)
            self.doc = App.openDocument(path)
            again = tree.sensitivity_of(tree.machine_of(self.doc))
            self.assertEqual(list(again.Total), total)
            self.assertFalse(again.Stale)
