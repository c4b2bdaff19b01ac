# SPDX-License-Identifier: LGPL-2.1-or-later
"""A simulator of measured machines with a known answer, from the exact product of transformation matrices.

It shares no code with the package it judges: only numpy and the formats and conventions of the specification.
"""

from .cases import CODES, KINDS, NAMELESS, PLANS, Case, make_case, read_case, write_case

__all__ = ["CODES", "KINDS", "NAMELESS", "PLANS", "Case", "make_case", "read_case", "write_case"]
