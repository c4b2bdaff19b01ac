# SPDX-License-Identifier: LGPL-2.1-or-later
"""Readers and writers.  Each refuses with file, line, column and what to do; writing is atomic."""
