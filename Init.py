# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run by FreeCAD at every start, with and without a window: registers the tests, imports nothing else."""

import FreeCAD

if hasattr(FreeCAD, "__unit_test__"):
    FreeCAD.__unit_test__ += ["sensworkbench.document.selftest"]
