# SPDX-License-Identifier: LGPL-2.1-or-later
"""Properties are tried on the same examples in every run, so that a failure can be repeated by anyone."""

from __future__ import annotations

from hypothesis import settings

settings.register_profile("repeatable", derandomize=True, database=None, deadline=None)
settings.load_profile("repeatable")
