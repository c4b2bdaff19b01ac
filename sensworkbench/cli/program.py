# SPDX-License-Identifier: LGPL-2.1-or-later
"""From the words of a command line to the exit status of its verb.

Exit status 0: done, whatever the verdict; 2: the input was refused, with one message on stderr and nothing written;
1: a defect of the program; 130: interrupted.  The verbs are the same under plain Python (machine.json) and inside
FreeCAD (FCStd).
"""

from __future__ import annotations

import argparse
import contextlib
import importlib
import importlib.util
import os
import re
import signal
import sys
import tempfile
import threading
import traceback
from collections.abc import Sequence

from sensworkbench import __version__
from sensworkbench.core.refusal import Refused

from . import verbs
from .common import DEFECT, INTERRUPTED, REFUSED, hand_over, in_freecad, is_document, say

_VALUE_WITH_MINUS = re.compile(r"-(\d|\.\d|nan\b|inf\b)", re.IGNORECASE)


class Parser(argparse.ArgumentParser):
    """A parser that refuses instead of ending the program, so that every way out passes through `main`."""

    def error(self, message):
        """Refuse the words, with where they are explained."""
        raise Refused("command-line-words", self.prog, words=message, program=self.prog)


def parser() -> argparse.ArgumentParser:
    """The grammar of the command line, made from the modules of `verbs`."""
    top = Parser(
        prog="python -m sensworkbench",
        description="Which part of a machine tool spoils its accuracy, and what the error model lacks.",
        allow_abbrev=False,
    )
    top.add_argument("--version", action="version", version=f"Sens Workbench {__version__}")
    places = top.add_subparsers(dest="verb", metavar="VERB", required=True, parser_class=Parser)
    for name in verbs.names():
        module = verbs.load(name)
        place = places.add_parser(name, help=module.HELP, description=module.HELP, allow_abbrev=False)
        module.add(place)
        place.set_defaults(run=module.run)
    return top


def table() -> str:
    """The table of verbs of docs/command-line.md, made from the modules of `verbs`."""
    rows = [(f"[`{name}`](#{name})", verbs.load(name).HELP, verbs.load(name).FILES) for name in verbs.names()]
    return "\n".join(f"| {' | '.join(row)} |" for row in [("verb", "what it gives", "files"), ("---",) * 3, *rows])


def _joined(argv: Sequence[str]) -> list[str]:
    """`--at -10,5,3` as `--at=-10,5,3`: argparse would take the value for an option."""
    out: list[str] = []
    for word in argv:
        if out and out[-1].startswith("--") and "=" not in out[-1] and _VALUE_WITH_MINUS.match(word):
            out[-1] += "=" + word
        else:
            out.append(word)
    return out


def main(argv: Sequence[str] | None = None) -> int:
    """Run one command; returns the exit status.  Prints what was written to stdout and refusals to stderr."""
    argv = [str(a) for a in (sys.argv[1:] if argv is None else argv)]
    with _interrupts() as interrupted:
        return _run(argv, interrupted)


@contextlib.contextmanager
def _interrupts():
    """A list that is not empty once the user has interrupted: a library may turn the exception into one of its own."""
    noted: list[int] = []

    def note(number, frame):
        noted.append(number)
        raise KeyboardInterrupt

    usual = signal.getsignal(signal.SIGINT)
    ours = usual is signal.default_int_handler and threading.current_thread() is threading.main_thread()
    if ours:
        signal.signal(signal.SIGINT, note)
    try:
        yield noted
    finally:
        if ours:
            signal.signal(signal.SIGINT, usual)


def _run(argv: list[str], interrupted: list[int]) -> int:
    try:
        arguments = parser().parse_args(_joined(argv))
        if importlib.util.find_spec("numpy") is None:
            return _run_on_freecads_numpy(argv)
        for name in getattr(arguments, "documents", ()):
            if is_document(getattr(arguments, name)) and not in_freecad():
                return hand_over(getattr(arguments, name), argv)
        with _recorded(arguments, argv):
            return arguments.run(arguments)
    except Refused as refused:
        say(refused.message, sys.stderr)
        return REFUSED
    except SystemExit as end:  # --help and --version
        return int(end.code or 0)
    except KeyboardInterrupt:
        say("Interrupted.", sys.stderr)
        return INTERRUPTED
    except Exception as error:  # noqa: BLE001 - the last line of defence: a defect is reported, never shown raw
        if interrupted:
            say("Interrupted.", sys.stderr)
            return INTERRUPTED
        _report_defect(error)
        return DEFECT


def _recorded(arguments, argv):
    """The run that the results of this command state in their manifest."""
    provenance = importlib.import_module("sensworkbench.formats.provenance")
    seed = getattr(arguments, "seed", None)
    return provenance.running(arguments.verb, provenance.without_out(argv), seed)


def _run_on_freecads_numpy(argv: Sequence[str]) -> int:
    """This Python has no numpy, but FreeCAD brings one: run the same command inside it."""
    handoff = importlib.import_module("sensworkbench.document.handoff")
    try:
        handoff.freecadcmd()
    except Refused:
        if os.environ.get("SENS_FREECADCMD"):  # the one that was asked for is not there: that is the message
            raise
        raise Refused("numpy-missing", sys.executable) from None
    return handoff.run(argv)


def _report_defect(error: Exception) -> None:
    text = "".join(traceback.format_exception(error))
    if os.environ.get("SENS_DEBUG"):
        say(text, sys.stderr)
        return
    where = "set SENS_DEBUG=1 to see where"
    try:
        handle, path = tempfile.mkstemp(prefix="sensworkbench-", suffix=".log")
        with os.fdopen(handle, "w", encoding="utf-8") as stream:
            stream.write(text)
        where = f"details are in {path}"
    except OSError:
        pass
    say(f"This is a defect of Sens Workbench, not of your input: {type(error).__name__}; {where}.", sys.stderr)
