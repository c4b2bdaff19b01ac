# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the add-on's own files are: icons, translations, examples."""

from __future__ import annotations

import os

import sensworkbench

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(sensworkbench.__file__)))
RESOURCES = os.path.join(ROOT, "resources")


def icon_path(name: str) -> str:
    return os.path.join(RESOURCES, "icons", f"{name}.svg")


def translations() -> str:
    return os.path.join(RESOURCES, "translations")
