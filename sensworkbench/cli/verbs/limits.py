# SPDX-License-Identifier: LGPL-2.1-or-later
"""`limits MACHINE --out DIR`: how large the error of a machine within its tolerances may become."""

from __future__ import annotations

from .. import common

HELP = "how large the error may become: quantiles, P(|error| > limit), V_XYZ, diagonals"
FILES = "`limits.json`, `contributions.csv`, `report.html`"


def add(parser) -> None:
    common.add_machine(parser)
    common.add_out(parser)
    text = "probability of the quantiles (default 0.95)"
    parser.add_argument("--level", metavar="P", type=common.positive, default=0.95, help=text)
    text = "error in um whose probability to be exceeded is asked for; may be given several times"
    parser.add_argument("--limit", metavar="UM", type=common.positive, action="append", default=[], help=text)
    common.add_language(parser)


def run(arguments) -> int:
    from sensworkbench.formats import limits_json
    from sensworkbench.studies.limits import limits_study

    machine = common.load_machine(arguments.machine)
    result = limits_study(machine, arguments.level, tuple(arguments.limit))
    said = f"{100 * result.level:g} % of |error| is below {result.quantile:.4g} um"
    return common.write_study(arguments, "limits", limits_json.files(result, arguments.language), said)
