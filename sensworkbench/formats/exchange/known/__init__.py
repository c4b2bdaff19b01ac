# SPDX-License-Identifier: LGPL-2.1-or-later
"""The formats: every module of this package is one, `machine_2` the format `machine-2`.

A format is a module whose FORMAT is an instance of a class of `formats.exchange.base`.  Nothing else names it: choices
of the command line and of the window, the table of the documentation and the tests are made from what is found here.
"""

from __future__ import annotations

import importlib
import pkgutil

from sensworkbench.messages import Refused

from ..base import Format


def names() -> tuple[str, ...]:
    """The formats in alphabetical order.  Reads the names of files only; imports none."""
    return tuple(sorted(module.name.replace("_", "-") for module in pkgutil.iter_modules(__path__)))


def get(name: str, where: str = "format") -> Format:
    """The format of that name; refuses one that is not there."""
    if name not in names():
        raise Refused("format-unknown", where, name=repr(name)[:60], known=list(names()))
    return importlib.import_module(f"{__name__}.{name.replace('-', '_')}").FORMAT


def every() -> tuple[Format, ...]:
    """All formats, in the order of their names."""
    return tuple(get(name) for name in names())
