# SPDX-License-Identifier: LGPL-2.1-or-later
"""`correlated MACHINE --out DIR`: shares of components whose errors vary together."""

from __future__ import annotations

from .. import common

HELP = "shares of components whose errors vary together: by a covariance, or by that of a fit"
FILES = "`correlated.json`, `correlated.csv`, `report.html`"


def add(parser) -> None:
    common.add_machine(parser)
    common.add_out(parser)
    text = "covariance of errors, um and urad (default: that of the fit in the machine's file)"
    parser.add_argument("--covariance", metavar="FILE.csv", help=text)
    common.add_language(parser)


def run(arguments) -> int:
    from sensworkbench.formats import correlated_files
    from sensworkbench.studies.correlated import correlated_study

    machine = common.load_machine(arguments.machine)
    given = correlated_files.load(arguments.covariance, machine) if arguments.covariance else None
    result = correlated_study(machine, given)
    return common.write_study(arguments, "correlated", correlated_files.files(result, arguments.language))
