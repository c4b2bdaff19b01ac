# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sources as they stand in machine.json: a cause, its law, and for each error that follows it a factor with its unit.

The same list, as text, is what a document keeps of the sources of its machine.
"""

from __future__ import annotations

import contextlib
import json
from collections.abc import Sequence
from dataclasses import replace

from sensworkbench.core.distributions import DISTRIBUTIONS, Tolerance
from sensworkbench.core.machine import Machine
from sensworkbench.core.refusal import Refused
from sensworkbench.core.sources import Source
from sensworkbench.core.units import exactly_shown

from .fitted_json import symbols, unit_scale
from .json_text import Node, parse


def read(place: Node, machine: Machine) -> tuple[Source, ...]:
    """The sources of a parsed list; refuses errors that the machine has not, and names that are taken."""
    found = tuple(_source(entry, machine) for entry in place.elements())
    with refused_at(place):
        replace(machine, sources=found)
    return found


def loads(text: str, where: str, machine: Machine) -> tuple[Source, ...]:
    """The sources in a text that `dumps` has written; none in an empty one.  where : stands in refusals."""
    return read(parse(text, where), machine) if text else ()


def dumps(sources: Sequence[Source], machine: Machine) -> str:
    """The text of some sources; "" for none."""
    return json.dumps([to_dict(s, machine) for s in sources], ensure_ascii=False) if sources else ""


def _source(entry: Node, machine: Machine) -> Source:
    entry.keys(("name", "distribution", "lower", "upper", "sigma", "factors"), ("name", "factors"))
    distribution = entry["distribution"].string(DISTRIBUTIONS) if "distribution" in entry else "uniform"
    sigma = entry["sigma"].number() if "sigma" in entry else None
    given = {key: entry[key].number() for key in ("lower", "upper") if key in entry}
    if len(given) < 2:
        if sigma is None or distribution != "normal" or given:
            raise entry.refuse("source-without-law")
        given = {"lower": -3 * sigma, "upper": 3 * sigma}  # a normal law needs its sigma alone
    factors = {}
    for c, value in symbols(entry["factors"], machine.component):
        value.keys(("value", "unit"), ("value",))
        factors[c.symbol] = value["value"].number() * unit_scale(value, c)
    with refused_at(entry):
        return Source(entry["name"].string(), Tolerance(given["lower"], given["upper"], distribution, sigma), factors)


def to_dict(source: Source, machine: Machine) -> dict:
    """A source as it stands in the file: factors in um and urad; mm or rad where only that reads back equal."""
    law = source.law
    data = {"name": source.name, "distribution": law.distribution, "lower": law.lower, "upper": law.upper}
    if law.sigma is not None:
        data["sigma"] = law.sigma
    data["factors"] = {}
    for symbol, size in source.factors.items():
        c = machine.component(symbol)
        shown = exactly_shown(size, c.from_shown(1.0))
        unit = c.unit if shown is not None else ("rad" if c.angular else "mm")
        data["factors"][symbol] = {"value": size if shown is None else shown, "unit": unit}
    return data


@contextlib.contextmanager
def refused_at(place: Node):
    """What the core refuses gets its place in the file, unless it names one already."""
    try:
        yield
    except Refused as refused:
        if refused.where.startswith(place.name):
            raise
        member = refused.where.rpartition(", ")[2]
        if isinstance(place.value, dict) and member in place.value:
            raise place[member].refuse(refused.code, **refused.fields) from None
        raise refused.at(place.where) from None
