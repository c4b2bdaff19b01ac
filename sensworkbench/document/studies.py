# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results of further studies in the document: where to move what, limits, correlated errors; one object for each.

Module and class names are stored in users' files and stay as they are.  A study keeps what was asked and the data of
its JSON file as the command line writes it, and what it was computed from, so that it knows when it is out of date.
"""

from __future__ import annotations

import json

from ..core.machine import Machine
from ..messages import Refused
from .base import SensObject, dress, internal, members, put, result
from .staleness import study_inputs
from .tree import FEATURE


class StudyObject(SensObject):
    """What a study found; its panel shows it again."""

    kind = "Study"
    properties = (
        result("String", "Study", "Which study: its verb of the command line"),
        result("Bool", "Stale", "The machine has changed since", True),
        internal("String", "Settings", "What was asked, as JSON", "{}"),
        internal("String", "Data", "What was found, as the JSON file of the verb", "{}"),
        internal("String", "Inputs", "What it was computed from, as JSON"),
    )

    def execute(self, obj):
        """Nothing: a study runs on command, never by a recompute."""


def study_of(machine, name: str):
    """The Study object of a verb such as "moves", or None."""
    return next((o for o in members(machine, "Study") if o.Study == name), None)


def store(machine, name: str, settings: dict, data: dict, core: Machine, label: str = ""):
    """Keep what a study found in its Study object, made where there is none; returns it.

    settings, data : plain, as JSON holds them.  core : the machine that was studied.  label : of a new object.
    Opens no transaction.
    """
    obj = study_of(machine, name)
    if obj is None:
        obj = machine.Document.addObject(FEATURE, "Study")
        StudyObject(obj)
        obj.Label = label or name
        put(obj, "Study", name)
        dress(obj)
        machine.addObject(obj)
    put(obj, "Settings", json.dumps(settings, sort_keys=True))
    put(obj, "Data", json.dumps(data, sort_keys=True))
    put(obj, "Inputs", study_inputs(core))
    put(obj, "Stale", False)
    return obj


def read(obj) -> tuple[dict, dict]:
    """(settings, data) of a Study object; refuses texts that are no JSON."""
    found = []
    for name in ("Settings", "Data"):
        try:
            found.append(json.loads(getattr(obj, name)))
        except ValueError:
            raise Refused("document-no-json", obj.Label, name=name) from None
    return found[0], found[1]
