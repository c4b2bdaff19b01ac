# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sens Workbench: which part of a machine tool spoils its accuracy, and what nobody has thought of yet.

Packages, each importing only those to its right: gui -> document -> formats -> closedloop -> core.
`core` and `closedloop` need numpy alone.
"""

__version__ = "0.1.0"
