# SPDX-License-Identifier: LGPL-2.1-or-later
"""`batch LIST.csv --out DIR`: one run per row of a table; a bad one does not stop the rest."""

from __future__ import annotations

import contextlib
import io
import re
import sys
import time
from pathlib import Path

from sensworkbench.core.refusal import Refused

from .. import common

HELP = "one run per row of a table, and a summary of all"
FILES = "a folder per row, `summary.csv`"
SUMMARY = ("name", "verb", "status", "seconds", "message")
STATUS = {common.DONE: "done", common.REFUSED: "refused", common.DEFECT: "defect"}
SINGLE = {"predict": "predicted.csv", "import-errors": "machine.json", "import-machine": "machine.json"}
NOT_HERE = ("batch", "verify", "demo")
_NAME = re.compile(r"[\w][\w .+-]{0,99}")
_YES, _NO = ("1", "true", "yes"), ("", "0", "false", "no")


def add(parser) -> None:
    text = "a table with the columns name, verb, machine, and the other arguments and options of the verbs"
    parser.add_argument("list", metavar="LIST.csv", help=text)
    parser.add_argument("--out", metavar="DIR", required=True, help="folder for a folder per row and summary.csv")
    parser.add_argument("--verb", metavar="VERB", help="of rows that name none")
    text = "leave out rows whose results are whole and were made by the same command from the same files"
    parser.add_argument("--resume", action="store_true", help=text)


def run(arguments) -> int:
    from sensworkbench.formats import csv_table, files
    from sensworkbench.formats.study_files import write_set

    jobs = read_list(csv_table.read(arguments.list), arguments.verb)
    rows = []
    for job in jobs:
        start = time.monotonic()
        status, said = "as before", ""
        if not (arguments.resume and _is_done(Path(arguments.out), job)):
            status, said = _run(job, Path(arguments.out))
        took = f"{time.monotonic() - start:.2f}"
        rows.append((job["name"], job["verb"], status, took, files.neutral(" ".join(said.split())[:300])))
        common.say(f"{job['name']}: {status}")
    text = io.StringIO()
    _write(text, [SUMMARY, *rows])
    bad = sum(row[2] not in ("done", "as before") for row in rows)
    common.say(f"{len(rows) - bad} of {len(rows)} runs are done")
    return common.say_paths(write_set(arguments.out, "batch", {"summary.csv": text.getvalue()}))


def _write(stream, rows) -> None:
    import csv

    csv.writer(stream, lineterminator="\n").writerows(rows)


def read_list(table, verb: str | None) -> list[dict]:
    """One job per row: name, verb, where, and the cells of the other columns that are not empty.

    Refuses a table without names, names that are no folder names or stand twice, and verbs that there are not.
    """
    from .. import verbs

    columns = {name.strip().lower(): j for j, name in enumerate(table.names)}
    for needed in ("name",) if verb else ("name", "verb"):
        if needed not in columns:
            raise Refused("batch-column-missing", f"{table.source}, line {table.names_line}", column=needed)
    cells = {name: table.cells[j] for name, j in columns.items()}
    jobs, seen = [], set()
    known = [v for v in verbs.names() if v not in NOT_HERE]
    for row in range(table.rows):
        where = f"{table.source}, line {int(table.line[row])}"
        job = {name: column[row] for name, column in cells.items() if column[row]}
        name = job.pop("name", "")
        if not _NAME.fullmatch(name) or name.endswith((".", " ")):
            raise Refused("batch-name", where, name=name[:40])
        if name.lower() in seen:
            raise Refused("batch-name-twice", where, name=name)
        seen.add(name.lower())
        word = job.pop("verb", verb) or verb
        if word not in known:
            raise Refused("batch-verb", where, verb=str(word)[:40], known=known)
        jobs.append({"name": name, "verb": word, "where": where, "cells": job})
    if not jobs:
        raise Refused("batch-empty", table.source)
    return jobs


def words_of(job: dict) -> list[str]:
    """The command line of a job without --out; refuses a column that its verb does not know."""
    from .. import verbs
    from ..program import Parser

    grammar = Parser(prog=job["verb"], allow_abbrev=False)
    verbs.load(job["verb"]).add(grammar)
    positional, options, left = [], [], dict(job["cells"])
    for action in grammar._actions:
        names = {action.dest.replace("_", "-"), action.dest, *(o.lstrip("-") for o in action.option_strings)}
        cell = next((left.pop(n) for n in sorted(names) if n in left and n not in ("out", "help", "h")), None)
        if cell is None:
            continue
        if not action.option_strings:
            positional += cell.split("|") if action.nargs == "+" else [cell]
        elif action.nargs == 0:
            if cell.lower() not in (*_YES, *_NO):
                raise Refused("batch-flag", job["where"], column=action.dest, cell=cell[:40])
            options += [action.option_strings[-1]] if cell.lower() in _YES else []
        else:
            options.append(f"{action.option_strings[-1]}={cell}")
    if left:
        raise Refused("batch-column-unknown", job["where"], column=sorted(left)[0][:40], verb=job["verb"])
    return [job["verb"], *options, *positional]


def _place(out: Path, job: dict) -> Path:
    single = SINGLE.get(job["verb"])
    return out / job["name"] / single if single else out / job["name"]


def _run(job: dict, out: Path) -> tuple[str, str]:
    """(status, what was said on stderr) of one job."""
    from ..program import main

    said = io.StringIO()
    try:
        verb, *words = words_of(job)
        with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(said):
            status = main([verb, f"--out={_place(out, job)}", *words])
    except Refused as refused:
        return STATUS[common.REFUSED], refused.message
    if status == common.INTERRUPTED:
        raise KeyboardInterrupt
    sys.stdout.flush()
    return STATUS.get(status, "defect"), said.getvalue()


def _is_done(out: Path, job: dict) -> bool:
    """Whether a job's results are there, whole, made by the same command from files that are as they were."""
    from sensworkbench.formats import file_sets, manifest

    from .verify import check_set

    place = _place(out, job)
    single = place.name if job["verb"] in SINGLE else None
    folder = place.parent if single else place
    try:
        file_sets.recover(folder)
        entries = manifest.load(folder / manifest.name_of(single))["sets"]
        words = words_of(job)
    except Refused:
        return False
    mine = [e for e in entries if e["verb"] == job["verb"] and e["command"] == words]
    said = [s for e in mine for s in check_set(folder, e, single, recompute=False)]
    return bool(mine) and all(s.startswith("same:") for s in said)
