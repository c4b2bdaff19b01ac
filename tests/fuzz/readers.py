# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is done with a fuzzed file: it is read, what is accepted is computed with, and the outcome is judged."""

from __future__ import annotations

import json
import os
import warnings
from pathlib import Path

import numpy as np

from sensworkbench.closedloop.predict import predict
from sensworkbench.closedloop.readings import Readings
from sensworkbench.core import workspace
from sensworkbench.core.refusal import Refused
from sensworkbench.core.toolpath import counts, sample
from sensworkbench.formats import (
    features_json,
    files,
    gcode,
    machine_json,
    manifest,
    path_csv,
    readings_csv,
    tolerances,
)
from sensworkbench.formats.exchange.known import etalon, fcm, isg

LONGEST = 300  # characters of a refusal
MAPPED = "Pos X,y_mm,Remark,ex_um\n" + 14 * "1,2,a,3\n"


class Fault(AssertionError):
    """An input that was neither read rightly nor refused properly."""


def judge(kind: str, data: bytes, folder: Path) -> bool:
    """Read `data` as a file of `kind`; True where it was accepted, False where it was refused; else raises Fault."""
    path = folder / "f.txt"
    path.write_bytes(data)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            READERS[kind](path)
    except Refused as refused:
        text = refused.message.replace(str(folder) + os.sep, "")
        if len(text) > LONGEST:
            raise Fault(f"{kind}: a refusal of {len(text)} characters: {text[:400]}") from None
        return False
    except Exception as error:
        raise Fault(f"{kind}: {type(error).__name__}: {error}") from error
    return True


def _finite(what: str, *values) -> None:
    for value in values:
        if not np.isfinite(np.asarray(value, dtype=float)).all():
            raise ValueError(f"{what} is not finite")


def _machine(path) -> None:
    machine = machine_json.load(path)
    text = machine_json.dumps(machine)
    if machine_json.dumps(machine_json.loads(text, "again")) != text:
        raise ValueError("written and read again it is another machine")
    try:
        found = workspace.sensitivity(machine, workspace.at(machine, machine.travel.mean(axis=1)))
        _finite("an index", found.first, found.total)
    except Refused:
        pass
    if machine.fitted is not None:
        low, high = machine.travel.T
        q = low + (high - low) * np.linspace(0, 1, 5)[:, None]
        columns = {name.lower(): q[:, i] for i, name in enumerate(machine.names)}
        columns |= {"t": np.arange(5.0), "temp_column": np.arange(5.0) - 2, "dir_x": np.array([1.0, -1, 1, 0, 1])}
        none = np.empty(0, dtype=int)
        rows = Readings(
            q=q, point=none, sense=np.empty((0, 3)), value=np.empty(0), u=np.empty(0), kind=none, columns=columns
        )
        _finite("a prediction", predict(machine, rows))


def _readings(path) -> None:
    found = readings_csv.load(path)
    _finite("a reading", found.value, found.q, *found.columns.values())


def _positions(path) -> None:
    found = readings_csv.load_positions(path)
    _finite("a position", found.q, *found.columns.values())


def _mapping(path) -> None:
    table = path.with_name("t.csv")
    if not table.exists():
        table.write_text(MAPPED, encoding="utf-8")
    _finite("a reading", readings_csv.load(table, readings_csv.load_mapping(path)).value)


def _tolerances(path) -> None:
    for tolerance in tolerances.load(path).values():
        _finite("a limit", tolerance.lower, tolerance.upper)


def _tables(module):
    def read(path) -> None:
        for table in module.loads(files.read_text(path), "f").tables:
            _finite("a table", table.points, table.values)

    return read


def _fcm(path) -> None:
    machine, _ = fcm.loads(files.read_text(path), "f")
    _finite("a travel", machine.travel)
    json.loads(fcm.dumps(machine))


JOINTS = readings_csv.THREE_AXES
SETTINGS = gcode.Settings({"G54": (1.0, 2.0, 3.0)}, {1: gcode.Tool(2.0, 3.0)})


def _program(path) -> None:
    moves = gcode.load(path, JOINTS, SETTINGS).moves
    _finite("a move", moves.begin, moves.end, moves.sweep, moves.centre, moves.dwell)
    number, _ = counts(moves, 1.0, 20_000)
    found = sample(moves, number, 1e4)
    _finite("a point", found.q, found.t)


def _features(path) -> None:
    found = features_json.load(path, JOINTS)
    _finite("an offset", *found.offsets.values(), *(t.radius or 0 for t in found.tools.values()))


def _path_points(path) -> None:
    found = path_csv.load(path, JOINTS)
    _finite("a position", found.positions.q)


def _conditions(path) -> None:
    found = path_csv.load_conditions(path, JOINTS)
    _finite("a condition", found.at, *found.columns.values())


READERS = {
    "program": _program,
    "features": _features,
    "path points": _path_points,
    "conditions": _conditions,
    "machine": _machine,
    "readings": _readings,
    "vector readings": _readings,
    "positions": _positions,
    "mapping": _mapping,
    "tolerances": _tolerances,
    "isg": _tables(isg),
    "etalon": _tables(etalon),
    "fcm": _fcm,
    "manifest": manifest.load,
}
