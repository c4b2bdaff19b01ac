# SPDX-License-Identifier: LGPL-2.1-or-later
"""A machine out of any document: what its structure, its names and its shapes say, weighed against each other.

`engine.propose` looks and changes nothing; `building.build` makes the machine of what was found.
"""
