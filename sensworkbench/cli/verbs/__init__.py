# SPDX-License-Identifier: LGPL-2.1-or-later
"""The verbs of the command line: every module of this package is one, `import_errors` the verb `import-errors`.

A verb is a module with
    HELP               one line for --help and for the table of docs/command-line.md
    FILES              what it writes, for that table
    add(parser)        adds its arguments to an argparse parser; imports nothing heavy
    run(arguments)     does it, and returns the exit status; raises Refused before anything is written
Nothing else names it: help and the table of the documentation are made from what is found here.
"""

from __future__ import annotations

import importlib
import pkgutil


def names() -> tuple[str, ...]:
    """The verbs in alphabetical order.  Reads the names of files only; imports none."""
    found = (module.name.replace("_", "-") for module in pkgutil.iter_modules(__path__))
    return tuple(sorted(found))


def load(name: str):
    """The module of the verb `name`, one of `names()`."""
    return importlib.import_module(f"{__name__}.{name.replace('-', '_')}")
