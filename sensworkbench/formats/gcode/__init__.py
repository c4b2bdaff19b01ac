# SPDX-License-Identifier: LGPL-2.1-or-later
"""G-code (ISO 6983, RS-274): read into moves, and written again with other points."""

from .corrected import kept, written
from .program import Program, Settings, Tool, load, loads

__all__ = ["Program", "Settings", "Tool", "kept", "load", "loads", "written"]
