# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the given records are."""

from __future__ import annotations

from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
DATA = ROOT.parent / "shared" / "data"
