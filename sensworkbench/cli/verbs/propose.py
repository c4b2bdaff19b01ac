# SPDX-License-Identifier: LGPL-2.1-or-later
"""`propose DOCUMENT.FCStd --out DIR`: the machine that a FreeCAD document shows, with evidence and open questions."""

from __future__ import annotations

import importlib
import json

from sensworkbench.messages import Refused

from .. import common

HELP = "the machine that any FreeCAD document shows"
FILES = "`proposal.json`; where complete `machine.json`, `machine.FCStd`"


def add(parser) -> None:
    common.add_machine(parser, "document", "DOCUMENT", "any .FCStd document: an assembly, a STEP import, plain parts")
    text = "folder for proposal.json and, where it is complete, machine.json and machine.FCStd"
    parser.add_argument("--out", metavar="DIR", required=True, help=text)
    text = 'JSON with answers to questions, such as {"bed": "Base", "body:X": ["Carriage"], "direction:X": [1, 0, 0]}'
    parser.add_argument("--answers", metavar="FILE", help=text)


def run(arguments) -> int:
    if not common.is_document(arguments.document):
        raise Refused("propose-no-document", str(arguments.document))
    answers = _answers(arguments.answers) if arguments.answers else None
    headless = importlib.import_module("sensworkbench.document.propose.headless")
    return common.say_paths(headless.propose(arguments.document, arguments.out, answers))


def _answers(path) -> dict:
    from sensworkbench.formats.files import read_text

    try:
        found = json.loads(read_text(path))
    except ValueError as error:
        if isinstance(error, Refused):
            raise
        found = None
    if not isinstance(found, dict):
        raise Refused("propose-answers-unread", str(path), example='{"bed": "Base"}')
    return found
