# SPDX-License-Identifier: LGPL-2.1-or-later
"""Records that are not part of the project: measured-data cases and a thermal record in a folder beside the clone.

These tests are collected only where that folder is there.  What they hold is held on simulated cases as well, by tests
that need nothing but the project.
"""

from __future__ import annotations

from .support import DATA

if not DATA.is_dir():
    collect_ignore_glob = ["test_*.py"]
