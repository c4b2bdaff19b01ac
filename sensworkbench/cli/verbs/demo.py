# SPDX-License-Identifier: LGPL-2.1-or-later
"""`demo --out DIR`: an example machine from design to report."""

from __future__ import annotations

from .. import common

HELP = "an example machine from design to report"
FILES = "those of every step, on an example machine"


def add(parser) -> None:
    parser.add_argument("--out", metavar="DIR", required=True, help="folder for everything it makes")
    text = "which example machine"
    parser.add_argument("--structure", choices=("XYFZ", "FXYZ", "YFXZ"), default="XYFZ", help=text)


def run(arguments) -> int:
    from sensworkbench import demo

    return common.say_paths(demo.run(arguments.out, arguments.structure, common.say))
