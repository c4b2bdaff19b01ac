# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line: `python -m sensworkbench sensitivity|plan|trace|predict|convert|import-errors|import-machine|demo`.

Exit status 0: done, whatever the verdict; 2: the input was refused, with one message on stderr and nothing written;
1: a defect of the program.  The verbs are the same under plain Python (machine.json) and inside FreeCAD (FCStd).
"""

from __future__ import annotations

import argparse
import importlib
import importlib.util
import os
import sys
import tempfile
import traceback
from collections.abc import Sequence
from pathlib import Path

from sensworkbench import __version__, cli_exchange
from sensworkbench.core.refusal import Refused

DONE, DEFECT, REFUSED = 0, 1, 2

# options whose value may begin with a minus sign
_VALUED = ("--at", "--weights", "--through", "--tool-point", "--noise")


class _Parser(argparse.ArgumentParser):
    """Refuses instead of ending the program, so that every way out passes through `main`."""

    def error(self, message):
        raise Refused(message, self.prog, f"See {self.prog} --help.")


def parser() -> argparse.ArgumentParser:
    """The grammar of the command line."""
    top = _Parser(
        prog="python -m sensworkbench",
        description="Which part of a machine tool spoils its accuracy, and what the error model lacks.",
        allow_abbrev=False,
    )
    top.add_argument("--version", action="version", version=f"Sens Workbench {__version__}")
    verbs = top.add_subparsers(dest="verb", metavar="VERB", required=True, parser_class=_Parser)

    verb = verbs.add_parser(
        "sensitivity", help="exact sensitivity indices of every error and component", allow_abbrev=False
    )
    verb.add_argument(
        "machine", metavar="MACHINE", help="machine.json, or a FreeCAD document (.FCStd) that holds a machine"
    )
    verb.add_argument("--out", metavar="DIR", required=True, help="folder for sensitivity.json, .csv and report.html")
    where = verb.add_mutually_exclusive_group()
    where.add_argument("--at", metavar="X,Y,Z", type=_triple, help="at one position, mm")
    where.add_argument(
        "--grid", metavar="N", type=_counts, help="mean over a grid of N (or NX,NY,NZ) positions per axis"
    )
    where.add_argument("--quadrature", metavar="N", type=_counts, help="mean by Gauss-Legendre quadrature (default, 8)")
    verb.add_argument(
        "--weights", metavar="WX,WY,WZ", type=_triple, help="weights of the three components (default 1,1,1)"
    )
    verb.add_argument("--output", choices=("position", "orientation"), help="what is judged (default: position)")
    verb.add_argument(
        "--signed", action="store_true", help="the weighted sum of the components instead of their squares"
    )
    verb.add_argument(
        "--squareness", choices=("direction", "carried"), help="convention, in place of the machine's own"
    )
    verb.add_argument("--tolerances", metavar="FILE", help="tolerances (.csv or .json) in place of the machine's own")
    verb.add_argument("--angle-unit", choices=("urad", "arcsec"), default="urad", help="unit of angles in the results")
    verb.add_argument("--picture", metavar="PNG", help="picture of the machine for the report")
    verb.set_defaults(run=_sensitivity)

    verb = verbs.add_parser("trace", help="from readings to the effect that the model lacks", allow_abbrev=False)
    verb.add_argument(
        "machine", metavar="MACHINE", help="machine.json, or a FreeCAD document (.FCStd) that holds a machine"
    )
    verb.add_argument("readings", metavar="MEASURED.csv", help="what was measured")
    verb.add_argument(
        "--out", metavar="DIR", required=True, help="folder for trace.json, report.html, machine_augmented.*"
    )
    verb.add_argument("--mapping", metavar="FILE", help="JSON that maps foreign column names")
    verb.add_argument("--seed", metavar="N", type=_whole, default=0, help="of the permutations (default 0)")
    verb.add_argument("--permutations", metavar="N", type=_whole, default=199, help="behind each p (default 199)")
    verb.set_defaults(run=_trace)

    verb = verbs.add_parser("predict", help="the error at new places and conditions", allow_abbrev=False)
    verb.add_argument("machine", metavar="MACHINE_AUGMENTED", help="what trace wrote")
    verb.add_argument("positions", metavar="POSITIONS.csv", help="the columns of measured.csv without readings")
    verb.add_argument("--out", metavar="FILE", required=True, help="the positions with ex_um, ey_um, ez_um")
    verb.add_argument("--mapping", metavar="FILE", help="JSON that maps foreign column names")
    verb.add_argument("--no-alignment", action="store_true", help="leave out the fitted alignment and offsets")
    verb.set_defaults(run=_predict)

    verb = verbs.add_parser("plan", help="what a measuring plan could find, before measuring", allow_abbrev=False)
    verb.add_argument(
        "machine", metavar="MACHINE", help="machine.json, or a FreeCAD document (.FCStd) that holds a machine"
    )
    verb.add_argument(
        "positions", metavar="POSITIONS.csv", nargs="?", help="planned places and conditions; optional with --suggest"
    )
    verb.add_argument("--out", metavar="DIR", required=True, help="folder for plan.json, report.html, candidates.csv")
    verb.add_argument("--noise", metavar="UM", type=_positive, default=1.0, help="of one reading, um (default 1)")
    verb.add_argument("--suggest", metavar="N", type=_whole, help="write positions_suggested.csv with N places")
    verb.add_argument("--seed", metavar="N", type=_whole, default=0, help="of the suggested plan (default 0)")
    verb.add_argument("--mapping", metavar="FILE", help="JSON that maps foreign column names")
    verb.set_defaults(run=_plan)

    cli_exchange.add(verbs, triple=_triple, whole=_whole)

    verb = verbs.add_parser("demo", help="an example machine from design to report", allow_abbrev=False)
    verb.add_argument("--out", metavar="DIR", required=True, help="folder for everything it makes")
    verb.add_argument("--structure", choices=("XYFZ", "FXYZ", "YFXZ"), default="XYFZ", help="which example machine")
    verb.set_defaults(run=_demo)
    return top


def _triple(text: str) -> tuple[float, float, float]:
    try:
        values = tuple(float(v) for v in text.split(","))
    except ValueError:
        values = ()
    if len(values) != 3:
        raise argparse.ArgumentTypeError(f"{text!r} is not three numbers X,Y,Z")
    return values


def _counts(text: str):
    try:
        values = [int(v) for v in text.split(",")]
    except ValueError:
        values = []
    if len(values) not in (1, 3) or any(not 1 <= v <= 10**6 for v in values):
        raise argparse.ArgumentTypeError(f"{text!r} is not a number of positions, N or NX,NY,NZ")
    return values[0] if len(values) == 1 else tuple(values)


def _whole(text: str) -> int:
    if not text.isascii() or not text.isdigit() or len(text) > 9:
        raise argparse.ArgumentTypeError(f"{text!r} is not a whole number")
    return int(text)


def _positive(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = 0.0
    if not 0 < value < 1e9:
        raise argparse.ArgumentTypeError(f"{text!r} is not a number above zero")
    return value


def _joined(argv: Sequence[str]) -> list[str]:
    """`--at -10,5,3` as `--at=-10,5,3`: argparse would take the value for an option."""
    out: list[str] = []
    for word in argv:
        if out and out[-1] in _VALUED and word[:1] == "-" and word[1:2] in tuple("0123456789.niNI"):
            out[-1] += "=" + word
        else:
            out.append(word)
    return out


def main(argv: Sequence[str] | None = None) -> int:
    """Run one command; returns the exit status.  Prints what was written to stdout and refusals to stderr."""
    argv = [str(a) for a in (sys.argv[1:] if argv is None else argv)]
    try:
        arguments = parser().parse_args(_joined(argv))
        arguments.argv = argv
        if importlib.util.find_spec("numpy") is None:
            return _run_on_freecads_numpy(argv)
        return arguments.run(arguments)
    except Refused as refused:
        say(refused.message, sys.stderr)
        return REFUSED
    except SystemExit as end:  # --help and --version
        return int(end.code or 0)
    except (KeyboardInterrupt, BrokenPipeError):
        return DEFECT
    except Exception as error:  # noqa: BLE001 - the last line of defence: a defect is reported, never shown raw
        _report_defect(error)
        return DEFECT


def _run_on_freecads_numpy(argv: Sequence[str]) -> int:
    """This Python has no numpy, but FreeCAD brings one: run the same command inside it."""
    handoff = importlib.import_module("sensworkbench.document.handoff")
    try:
        handoff.freecadcmd()
    except Refused:
        if os.environ.get("SENS_FREECADCMD"):  # the one that was asked for is not there: that is the message
            raise
        what = "numpy is missing from this Python, and there is no FreeCAD to run in"
        do = "Install numpy for it, use another Python, or install FreeCAD, which brings numpy."
        raise Refused(what, sys.executable, do) from None
    return handoff.run(argv)


def say(text: str, stream=None) -> None:
    """Print a line, whatever the encoding of the stream."""
    stream = sys.stdout if stream is None else stream
    encoding = getattr(stream, "encoding", None) or "utf-8"
    print(text.encode(encoding, "replace").decode(encoding, "replace"), file=stream, flush=True)


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


def is_document(path) -> bool:
    """Whether a MACHINE argument is a FreeCAD document."""
    return Path(path).suffix.lower() == ".fcstd"


def in_freecad() -> bool:
    """Whether the program runs inside FreeCAD."""
    return "FreeCAD" in sys.modules


def hand_over(arguments) -> int:
    """Run the same verb inside a new FreeCAD process; returns its exit status."""
    if not Path(arguments.machine).is_file():
        raise Refused("cannot be read: no such file", arguments.machine, "Check the name.")
    return importlib.import_module("sensworkbench.document.handoff").run(arguments.argv)


# -- sensitivity -----------------------------------------------------------------------------------------------------
def _sensitivity(arguments) -> int:
    if is_document(arguments.machine) and not in_freecad():
        return hand_over(arguments)
    from sensworkbench.formats import machine_json, runs

    picture = runs.read_picture(arguments.picture) if arguments.picture else None
    options = sensitivity_options(arguments)
    if is_document(arguments.machine):
        batch = importlib.import_module("sensworkbench.document.batch")
        paths = batch.sensitivity(arguments.machine, arguments.out, options, picture)
    else:
        machine, result = runs.compute(machine_json.load(arguments.machine), options)
        paths = runs.write(arguments.out, machine, result, arguments.angle_unit, picture)
    for path in paths:
        say(str(path))
    return DONE


def sensitivity_options(arguments):
    """The options of a sensitivity run from the parsed command line."""
    from sensworkbench.formats.runs import Options

    names = ("at", "grid", "quadrature", "weights", "output", "signed", "squareness", "tolerances", "angle_unit")
    return Options(**{n: getattr(arguments, n) for n in names})


# -- trace and predict -----------------------------------------------------------------------------------------------
def _trace(arguments) -> int:
    if is_document(arguments.machine) and not in_freecad():
        return hand_over(arguments)
    from sensworkbench.formats import machine_json, readings_csv, trace_run

    readings = readings_csv.load(arguments.readings, _mapping(arguments))
    if not is_document(arguments.machine):
        outcome = _traced(machine_json.load(arguments.machine), readings, arguments)
        paths = trace_run.write(arguments.out, outcome)
    else:
        batch = importlib.import_module("sensworkbench.document.batch")
        machine, opened = batch.load_machine(arguments.machine)
        with opened:
            outcome = _traced(machine, readings, arguments)

            def add_document(work, augmented):
                batch.write_augmented(opened, work / "machine_augmented.FCStd", augmented)

            if _same_file(Path(arguments.out) / "machine_augmented.FCStd", arguments.machine):
                raise Refused("would be overwritten by its own result", arguments.machine, "Choose another folder.")
            paths = trace_run.write(arguments.out, outcome, add_document)
    say(outcome.report["verdict"])
    for effect in outcome.report["effects"]:
        say(f"  {effect['component']} driven by {effect['driver']}: {effect['name']}")
    for path in paths:
        say(str(path))
    return DONE


def _traced(machine, readings, arguments):
    from sensworkbench.closedloop.trace import trace

    if not 199 <= arguments.permutations <= 9999:
        raise Refused(f"{arguments.permutations} permutations", "--permutations", "Give 199 to 9999.")
    return trace(machine, readings, seed=arguments.seed, permutations=arguments.permutations)


def _mapping(arguments):
    from sensworkbench.formats import readings_csv

    return readings_csv.load_mapping(arguments.mapping) if arguments.mapping else None


def _same_file(one, other) -> bool:
    return Path(one).exists() and Path(one).samefile(other)


def _predict(arguments) -> int:
    if is_document(arguments.machine) and not in_freecad():
        return hand_over(arguments)
    from sensworkbench.closedloop import predict
    from sensworkbench.formats import machine_json, readings_csv

    mapping = _mapping(arguments)
    positions = readings_csv.load_positions(arguments.positions, mapping)
    if is_document(arguments.machine):
        batch = importlib.import_module("sensworkbench.document.batch")
        machine, opened = batch.load_machine(arguments.machine)
        opened.close()
    else:
        machine = machine_json.load(arguments.machine)
    keep_inputs(arguments.out, arguments.positions, arguments.machine)
    try:
        error = predict.predict(machine, positions, alignment=not arguments.no_alignment)
    except Refused as refused:  # what is missing, is missing from this file
        place = arguments.positions if machine.fitted is not None else arguments.machine
        raise refused.at(str(place)) from None
    outside = predict.extrapolated(machine, positions)
    readings_csv.save_predicted(arguments.out, arguments.positions, positions, error, outside, mapping)
    say(str(arguments.out))
    return DONE


# -- plan ------------------------------------------------------------------------------------------------------------
def _plan(arguments) -> int:
    if arguments.positions is None and arguments.suggest is None:
        raise Refused("there is no plan to check", "plan", "Name POSITIONS.csv, or ask for one with --suggest N.")
    if is_document(arguments.machine) and not in_freecad():
        return hand_over(arguments)
    from sensworkbench.formats import plan_out

    readings = None
    if arguments.positions is not None:
        readings = plan_out.load(arguments.positions, arguments.noise, _mapping(arguments))
        keep_inputs(Path(arguments.out) / plan_out.SUGGESTED, arguments.positions)
    try:
        machine = load_machine(arguments.machine)
        checked = plan_out.check(machine, readings, arguments.noise, arguments.suggest, arguments.seed)
    except Refused as refused:
        if refused.where == "plan" and arguments.positions is not None:
            raise Refused(refused.what, arguments.positions, refused.do) from None
        raise
    data = plan_out.to_dict(checked)
    paths = plan_out.write(arguments.out, checked, data)
    for line in plan_out.summary(data):
        say(line)
    for path in paths:
        say(str(path))
    return DONE


def load_machine(path):
    """The machine of a machine.json, or inside FreeCAD of a document."""
    if not is_document(path):
        from sensworkbench.formats import machine_json

        return machine_json.load(path)
    machine, opened = importlib.import_module("sensworkbench.document.batch").load_machine(path)
    opened.close()
    return machine


def keep_inputs(out, *inputs) -> None:
    """Refuse to write the file `out` over one of the inputs."""
    for given in inputs:
        if _same_file(out, given):
            raise Refused("would be overwritten by the result", str(given), "Choose another name for --out.")


# -- demo ------------------------------------------------------------------------------------------------------------
def _demo(arguments) -> int:
    from sensworkbench import demo

    for path in demo.run(arguments.out, arguments.structure, say):
        say(str(path))
    return DONE
