# SPDX-License-Identifier: LGPL-2.1-or-later
"""The design half: machine -> synthesis -> sensitivity.  numpy only; runs where FreeCAD cannot be imported."""
