# SPDX-License-Identifier: LGPL-2.1-or-later
"""machine.json of version 2: what version 1 says, with the joints as a list.  Nothing is lost."""

from __future__ import annotations

from dataclasses import replace

from ... import machine_json
from ..base import MachineFile


class Machine2(MachineFile):
    """A machine file of version 1 or 2, or the machine of a document, as version 2."""

    name, title = "machine-2", "machine.json, version 2"
    file = "machine.json"

    def machine_text(self, machine):
        return machine_json.dumps(replace(machine, version=2))


FORMAT = Machine2()
