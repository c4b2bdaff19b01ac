# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the verbs of the command line share: exit statuses, types of arguments, printing, and how a MACHINE is read.

Importing it imports neither numpy nor FreeCAD.
"""

from __future__ import annotations

import argparse
import contextlib
import importlib
import math
import os
import pkgutil
import sys
from pathlib import Path

from sensworkbench.messages import LANGUAGES, Refused

DONE, DEFECT, REFUSED, INTERRUPTED = 0, 1, 2, 130


# -- types of arguments ------------------------------------------------------------------------------------------------
def _number(text: str) -> float:
    """A number as people write it: Python alone would take 1_000."""
    if "_" in text:
        raise ValueError(text)
    return float(text)


def triple(text: str) -> tuple[float, float, float]:
    """Three finite numbers `X,Y,Z`."""
    try:
        values = tuple(_number(v) for v in text.split(","))
    except ValueError:
        values = ()
    if len(values) != 3:
        raise argparse.ArgumentTypeError(f"{text!r} is not three numbers X,Y,Z")
    if not all(math.isfinite(v) for v in values):
        raise argparse.ArgumentTypeError(f"{text!r} is not finite")
    return values


def numbers(text: str) -> tuple[float, ...]:
    """Finite numbers `A,B,...`, one per joint of a machine."""
    try:
        values = tuple(_number(v) for v in text.split(","))
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} is not numbers A,B,...") from None
    if not all(math.isfinite(v) for v in values):
        raise argparse.ArgumentTypeError(f"{text!r} is not finite")
    return values


def counts(text: str):
    """A number of positions, `N` (an int), or one per joint `N,N,...` (a tuple)."""
    try:
        values = [0 if "_" in v else int(v) for v in text.split(",")]
    except ValueError:
        values = []
    if not values or any(not 1 <= v <= 10**6 for v in values):
        raise argparse.ArgumentTypeError(f"{text!r} is not a number of positions, N or one per joint, N,N,...")
    return values[0] if len(values) == 1 else tuple(values)


def objective(text: str) -> dict:
    """The fields of an objective, of `NAME` or `NAME:FIELD=NUMBER,...`; which there are, `core.objectives` knows."""
    name, _, rest = text.partition(":")
    fields: dict = {"name": name}
    for part in filter(None, rest.split(",")):
        key, _, value = part.partition("=")
        try:
            fields[key] = float(value)
        except ValueError:
            raise argparse.ArgumentTypeError(f"{part!r} is not FIELD=NUMBER") from None
    return fields


def whole(text: str) -> int:
    """A whole number, 0 to 999999999."""
    if not text.isascii() or not text.isdigit() or len(text) > 9:
        raise argparse.ArgumentTypeError(f"{text!r} is not a whole number")
    return int(text)


def positive(text: str) -> float:
    """A finite number above zero."""
    try:
        value = _number(text)
    except ValueError:
        value = 0.0
    if not 0 < value < 1e9:
        raise argparse.ArgumentTypeError(f"{text!r} is not a number above zero")
    return value


def box(text: str) -> float | tuple[float, ...]:
    """A finite number above zero, or three that are not below it: X,Y,Z."""
    if "," not in text:
        return positive(text)
    try:
        sides = tuple(_number(part) for part in text.split(","))
    except ValueError:
        sides = ()
    if len(sides) != 3 or min(sides) < 0 or not 0 < max(sides) < 1e9:
        raise argparse.ArgumentTypeError(f"{text!r} is not three numbers X,Y,Z, none below zero")
    return sides


# -- arguments that several verbs take ---------------------------------------------------------------------------------
def add_machine(parser, name: str = "machine", metavar: str = "MACHINE", help: str | None = None) -> None:
    """Add the argument `name`, a file that may be a FreeCAD document: the verb is then run inside FreeCAD."""
    text = help or "machine.json, or a FreeCAD document (.FCStd) that holds a machine"
    parser.add_argument(name, metavar=metavar, help=text)
    parser.set_defaults(documents=(*(parser.get_default("documents") or ()), name))


def add_out(parser) -> None:
    """Add --out, the folder for the results; `write_study` writes them."""
    parser.add_argument("--out", metavar="DIR", required=True, help="folder for the results")


def write_study(arguments, verb: str, files, said: str = "") -> int:
    """Write name -> text of a study's files to --out as one set; say `said` and their paths; returns DONE."""
    from sensworkbench.formats import study_files

    paths = study_files.write_set(arguments.out, verb, files)
    if said:
        say(said)
    return say_paths(paths)


def add_mapping(parser) -> None:
    """Add --mapping; `mapping(arguments)` reads it."""
    parser.add_argument("--mapping", metavar="FILE", help="JSON that maps foreign column names")


def add_language(parser, of: str = "report.html") -> None:
    """Add --language, of the file that a person reads; files for programs and stderr stay English."""
    parser.add_argument("--language", choices=LANGUAGES, default="en", help=f"of {of} (default: en)")


def format_names() -> str:
    """The exchange formats for --help: names of modules, none of which is imported, because they need numpy."""
    folder = Path(__file__).parents[1] / "formats" / "exchange" / "known"
    names = sorted(module.name.replace("_", "-") for module in pkgutil.iter_modules([str(folder)]))
    return f"one of {', '.join(names)}"


def mapping(arguments):
    """The mapping of column names that --mapping names, or None."""
    from sensworkbench.formats import readings_csv

    return readings_csv.load_mapping(arguments.mapping) if arguments.mapping else None


# -- documents ---------------------------------------------------------------------------------------------------------
def is_document(path) -> bool:
    """Whether a path is that of a FreeCAD document."""
    return Path(path).suffix.lower() == ".fcstd"


def in_freecad() -> bool:
    """Whether the program runs inside FreeCAD."""
    return "FreeCAD" in sys.modules


def hand_over(path, argv) -> int:
    """Run the command line `argv` about the document `path` in a new FreeCAD process; returns its exit status."""
    if not Path(path).is_file():
        raise Refused("input-missing", str(path))
    return importlib.import_module("sensworkbench.document.handoff").run(argv)


def batch():
    """The module that opens and saves documents without a window; inside FreeCAD only."""
    return importlib.import_module("sensworkbench.document.batch")


def load_machine(path):
    """The machine of a machine.json, or inside FreeCAD of a document."""
    if not is_document(path):
        from sensworkbench.formats import machine_json

        return machine_json.load(path)
    machine, opened = batch().load_machine(path)
    opened.close()
    return machine


# -- results -----------------------------------------------------------------------------------------------------------
def same_file(one, other) -> bool:
    """Whether both paths name one existing file."""
    return Path(one).exists() and Path(one).samefile(other)


def keep_inputs(out, *inputs) -> None:
    """Refuse to write the file `out` over one of the inputs."""
    for given in inputs:
        if same_file(out, given):
            raise Refused("out-is-input", str(given))


@contextlib.contextmanager
def rows_of(path):
    """Put the name of a table before a refusal of the block that names a line only."""
    try:
        yield
    except Refused as refused:
        if not refused.where.startswith("line "):
            raise
        raise refused.at(str(path)) from None


def say(text: str, stream=None) -> None:
    """Print a line, whatever the encoding of the stream, and whether or not somebody still reads it."""
    stream = sys.stdout if stream is None else stream
    if stream is None:  # closed before the program began
        return
    encoding = getattr(stream, "encoding", None) or "utf-8"
    try:
        print(text.encode(encoding, "replace").decode(encoding, "replace"), file=stream, flush=True)
    except (OSError, ValueError):  # a closed pipe or stream: the files are the result, not what is said about them
        _silence(stream)


def _silence(stream) -> None:
    """Send what a broken stream still buffers nowhere, so that the end of the program does not fail on it."""
    try:
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, stream.fileno())
        os.close(nowhere)
    except (OSError, ValueError, AttributeError):
        pass


def say_paths(paths) -> int:
    """Say what was written, a path a line; returns DONE."""
    for path in paths:
        say(str(path))
    return DONE
