# SPDX-License-Identifier: LGPL-2.1-or-later
"""`allocate MACHINE --target KIND=VALUE --costs COSTS.csv --out DIR`: the cheapest tolerances that meet a target."""

from __future__ import annotations

from pathlib import Path

from sensworkbench.core.refusal import Refused

from .. import common

HELP = "the cheapest tolerances that meet a target"
FILES = "`allocation.json`, `tolerances.csv`, `front.csv`, `machine.json`, `report.html`"


def add(parser) -> None:
    common.add_machine(parser)
    text = "mean_square=UM2, rms=UM, worst=UM (rms at the worst place) or quantile=P:UM (P of all errors are smaller)"
    parser.add_argument("--target", metavar="KIND=VALUE", required=True, help=text)
    text = "what each tolerance costs; `catalogue`: grades of guides, screws and scales; may be given more than once"
    parser.add_argument("--costs", metavar="COSTS.csv", required=True, action="append", help=text)
    common.add_out(parser)
    common.add_language(parser)


def _target(text: str):
    from sensworkbench.studies.allocation import Target

    kind, _, value = text.partition("=")
    level, _, limit = value.partition(":")
    try:
        if kind.strip() == "quantile":
            return Target("quantile", float(limit), float(level))
        return Target(kind.strip(), float(value))
    except ValueError as error:
        if isinstance(error, Refused):
            raise
        raise Refused("target-not-a-number", "--target", text=repr(text)[:60]) from None


def run(arguments) -> int:
    from sensworkbench.formats import allocation_json, costs_csv
    from sensworkbench.studies.allocation import allocation_study

    target = _target(arguments.target)
    machine = common.load_machine(arguments.machine)
    costs = costs_csv.load_all(arguments.costs, machine)
    if any(costs_csv.unpriced(path, machine) for path in arguments.costs):
        common.say("the catalogue has no prices: its costs count from the present tolerances, 1 each, and are no money")
    common.keep_inputs(Path(arguments.out) / "machine.json", arguments.machine)
    result = allocation_study(machine, target, costs)
    return common.write_study(arguments, "allocate", allocation_json.files(result, arguments.language))
