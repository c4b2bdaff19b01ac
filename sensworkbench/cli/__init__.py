# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line: `python -m sensworkbench VERB ...`.  One module of `verbs` per verb; `program` runs them."""

from .program import main, parser

__all__ = ["main", "parser"]
