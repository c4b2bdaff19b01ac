# SPDX-License-Identifier: LGPL-2.1-or-later
"""The reference set of resources/reference: its machines, and its numbers with 60 digits.

Nothing here imports the package: the kinematics, the derivatives and the indices are written from docs/reference-set.md
alone, so that a fault of the package cannot hide in them.
"""
