# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sources of a machine in the document: causes that several errors follow (see `core.sources`).

The machine keeps them as the list of machine.json.  An error that follows a source has no usual tolerance; a row that
the tolerance table has for it is its independent part.  None of these functions opens a transaction.
"""

from __future__ import annotations

from dataclasses import replace

from ..core.distributions import Tolerance
from ..core.sources import Source
from ..formats import sources_json
from ..messages import Refused
from .base import put
from .extract import core_machine
from .factory import set_tolerances
from .tables import read_tolerances, read_units


def declare(machine, source: Source, instead_of: str = "", *, own: bool = False) -> None:
    """Let errors follow a source.  instead_of : name of the source that it replaces.

    own : whether each error keeps its tolerance as an independent part; otherwise the source takes its place.  Errors
    that the replaced source held alone get tolerances of the same width.  Refuses a name that is taken and errors that
    the machine has not; nothing is changed then.
    """
    core = core_machine(machine)
    others = [s for s in core.sources if s.name != instead_of]
    replace(core, sources=(*others, source))  # refuses
    former = [s for s in core.sources if s.name == instead_of]
    tolerances = read_tolerances(machine, core)
    if not own:
        tolerances = {s: t for s, t in tolerances.items() if s not in source.factors}
    _write(machine, core, [*others, source], _freed(former, [*others, source], tolerances))


def remove(machine, name: str) -> None:
    """Take a source away; errors that followed it alone get tolerances of the same width.  Refuses an unknown name."""
    core = core_machine(machine)
    gone = [s for s in core.sources if s.name == name]
    if not gone:
        raise Refused("source-unknown", machine.Label, name=name)
    others = [s for s in core.sources if s.name != name]
    _write(machine, core, others, _freed(gone, others, read_tolerances(machine, core)))


def _freed(gone, left, tolerances: dict) -> dict:
    """`tolerances`, and for errors of the sources that are gone those of the width that they had there."""
    found = dict(tolerances)
    followed = {symbol for source in left for symbol in source.factors}
    for source in gone:
        for symbol, factor in source.factors.items():
            own = found.get(symbol)
            if (own is None or own.lower == own.upper) and symbol not in followed and factor:
                found[symbol] = _times(source.law, factor)
    return found


def _times(law: Tolerance, factor: float) -> Tolerance:
    ends = sorted((law.lower * factor, law.upper * factor))
    return Tolerance(*ends, law.distribution, None if law.sigma is None else law.sigma * abs(factor))


def _write(machine, core, sources, tolerances: dict) -> None:
    units = read_units(machine)
    put(machine, "Sources", sources_json.dumps(sources, core))
    machine.touch()
    set_tolerances(machine, tolerances, units)
