# SPDX-License-Identifier: LGPL-2.1-or-later
"""The closed loop in the document: imported readings, what a trace of them found, and its effects under their bodies.

Module and class names are stored in users' files and stay as they are.  The table is kept as it was imported and read
again where it is needed; a trace keeps its report, its augmented machine and the residuals of every reading.
"""

from __future__ import annotations

import hashlib
import json
from dataclasses import replace
from pathlib import Path

import FreeCAD as App

from ..messages import Message, Refused
from . import told
from .base import INVISIBLE, OUTPUT, READ_ONLY, Property, SensObject, coded, dress, internal, put, result
from .extract import core_machine
from .factory import make_effect
from .refresh import refresh
from .staleness import same, trace_inputs
from .tree import added_effects, owner_machine, trace_of

STAGES = ("uncorrected", "declared", "augmented")


class ReadingsObject(SensObject):
    """A table of readings as it was imported, with what its columns were taken for."""

    kind = "Readings"
    schema = 2
    properties = (
        Property("FileIncluded", "Table", "Readings", "The table as it was imported", None, 0, READ_ONLY),
        result("String", "Source", "Name of the file"),
        result("Integer", "Points", "Places at which something was read"),
        result("Integer", "Rows", "Displacements that were read"),
        result("StringList", "Columns", "Columns that may drive an error, with their units"),
        result("StringList", "Runs", "Runs by name"),
        Property("StringList", "Findings", "Results", "What was noticed while reading, with line numbers", None, OUTPUT,
                 INVISIBLE),
        internal("String", "Mapping", "What each column was taken for and how the sign questions were answered, JSON",
                 "{}"),
        internal("String", "Sha256", "SHA-256 of the table"),
    )  # fmt: skip

    def migrate(self, obj, step):
        if step == 1:
            self.renew(obj, "Digest", "Sha256")


class TraceObject(SensObject):
    """What a trace found; its effects become objects under their bodies on request."""

    kind = "Trace"
    schema = 2
    properties = (
        Property("Link", "Readings", "Trace", "The readings that were traced", None, 0, READ_ONLY),
        result("String", "Verdict", "nothing_to_explain, explained, partly_explained or unexplained"),
        coded("Summary", "The verdict in words"),
        result("StringList", "Effects", "Effects that were found, by name"),
        result("FloatList", "RmsInSample", "3-D rms, um: uncorrected, declared model, with the effects"),
        result("FloatList", "RmsHeldOut", "The same on readings that took no part in the fit"),
        result("StringList", "Joints", "Names of the machine's joints"),
        result("FloatList", "Positions", "Programmed position of every point, joint by joint, point after point"),
        result("VectorList", "ToolOffsets", "Tool offset of every point, mm, machine frame; empty: none"),
        result("VectorList", "Before", "Residual of the declared model at every point, held out, um, machine frame"),
        result("VectorList", "After", "The same with the effects"),
        result("Bool", "Stale", "The machine has changed since", False),
        internal("String", "Report", "trace.json"),
        internal("String", "Augmented", "machine_augmented.json"),
        internal("StringList", "ResidualNames", "Residual series in Residuals"),
        internal("FloatList", "Residuals", "One series after the other, one value per reading, um"),
        internal("StringList", "CovarianceNames", "Parameters of the fit"),
        internal("FloatList", "Covariance", "Their covariance, um and urad, row by row"),
        internal("String", "Inputs", "What of the machine the trace depends on, as JSON"),
        internal("StringList", "Added", "Names of the effect objects that were made from this trace"),
        internal("String", "FittedBefore", "The machine's fitted errors before the effects were added"),
    )

    def execute(self, obj):
        """Nothing: a trace is computed on command, never by a recompute."""

    def migrate(self, obj, step):
        if step == 1:  # positions by joint instead of vectors
            self.renew(obj, "Positions", "Positions", lambda points: [v for p in points for v in (p.x, p.y, p.z)])
            put(obj, "Joints", ["X", "Y", "Z"])
            self.renew(obj, "Basis", "Inputs")


# -- making ------------------------------------------------------------------------------------------------------------
def _make(machine, proxy, name: str, label: str):
    obj = machine.Document.addObject("App::FeaturePython", name)
    proxy(obj)
    obj.Label = label
    machine.addObject(obj)
    dress(obj)
    return obj


def make_readings(machine, path, mapping=None, label: str | None = None):
    """Import a table (see docs/formats.md) under `machine`; the document keeps a copy of the file.

    mapping : as `formats.readings_csv.load_mapping` returns, or None.  Refuses what cannot be read; nothing is made.
    """
    from ..formats import readings_csv

    path = Path(path)
    readings = readings_csv.load(path, mapping)
    obj = _make(machine, ReadingsObject, "Readings", label or path.stem)
    obj.Table = str(path)
    put(obj, "Source", path.name)
    put(obj, "Sha256", hashlib.sha256(path.read_bytes()).hexdigest())
    _describe(obj, readings, mapping)
    return obj


def map_again(obj, mapping) -> None:
    """Take the columns of a Readings object for something else; a trace of them was of other readings and goes.

    mapping : as in `make_readings`.  Refuses what cannot be read, and a trace whose effects were added; nothing is
    changed then.
    """
    from ..formats import readings_csv

    readings, trace = readings_csv.load(obj.Table, mapping), trace_of(obj)
    if trace is not None:
        if added_effects(trace):
            raise Refused("trace-effects-added", trace.Label)
        obj.Document.removeObject(trace.Name)
    _describe(obj, readings, mapping)


def _describe(obj, readings, mapping) -> None:
    """Write to a Readings object what its table was taken for."""
    put(obj, "Mapping", json.dumps(mapping or {}, sort_keys=True))
    put(obj, "Points", readings.points)
    put(obj, "Rows", readings.rows)
    units = {name: readings.units.get(name, "") for name in readings.columns}
    put(obj, "Columns", [f"{name} ({unit})" if unit else name for name, unit in units.items()])
    put(obj, "Runs", [] if readings.run is None else sorted({str(r) for r in readings.run}))
    put(obj, "Findings", [told.dumps(finding_message(f)) for f in readings.remarks])


def finding_message(finding) -> Message:
    """What was noticed while reading, with its line where it has one."""
    said = finding.message if isinstance(finding.message, Message) else Message("finding-text", text=finding.message)
    return Message("finding-in-line", line=finding.line, words=said) if finding.line else said


def read(obj):
    """The `closedloop.readings.Readings` of a Readings object."""
    from ..formats import readings_csv

    if not obj.Table or not Path(obj.Table).is_file():
        raise Refused("readings-table-missing", obj.Label)
    return readings_csv.load(obj.Table, json.loads(obj.Mapping) or None)


def make_trace(machine, readings_obj, outcome, traced):
    """Store the `TraceResult` of a trace; returns the Trace object (that of the same readings is used again).

    traced : the core machine that was traced.
    """
    from ..formats import json_text, machine_json, trace_json
    from ..studies.trace import point_vectors

    obj = trace_of(readings_obj)
    if obj is None:
        obj = _make(machine, TraceObject, "Trace", f"Trace of {readings_obj.Label}")
        obj.Readings = readings_obj
    report, readings = trace_json.to_dict(outcome), outcome.readings
    known = {e.name for e in traced.effects}
    put(obj, "Verdict", report["verdict"])
    put(obj, "Summary", told.dumps(summary(report)))
    put(obj, "Effects", [e.name for e in outcome.machine.effects if e.name not in known])
    put(obj, "RmsInSample", [report["error"][s]["in_sample"]["rms_um"] for s in STAGES])
    put(obj, "RmsHeldOut", [report["error"][s]["held_out"]["rms_um"] for s in STAGES])
    put(obj, "Joints", traced.names)
    put(obj, "Positions", readings.q.ravel())
    put(obj, "ToolOffsets", [] if readings.tool_offset is None else _vectors(readings.tool_offset))
    put(obj, "Before", _vectors(point_vectors(outcome, "declared_held_out")))
    put(obj, "After", _vectors(point_vectors(outcome, "augmented_held_out")))
    put(obj, "Report", json_text.dumps(report))
    put(obj, "Augmented", machine_json.dumps(outcome.machine))
    put(obj, "ResidualNames", list(outcome.residuals))
    put(obj, "Residuals", [float(v) for series in outcome.residuals.values() for v in series.tolist()])
    names, matrix = outcome.covariance
    put(obj, "CovarianceNames", list(names))
    put(obj, "Covariance", matrix.ravel())
    put(obj, "Inputs", trace_inputs(traced))
    put(obj, "Added", [])
    put(obj, "FittedBefore", "")
    put(obj, "Stale", False)
    return obj


def _vectors(array) -> list:
    return [App.Vector(*row) for row in array.tolist()]


def summary(report) -> Message:
    """The verdict and what was found, in a sentence or two.  report : trace.json, as stored."""
    from ..formats import trace_html

    title, words = trace_html.VERDICTS[report["verdict"]]
    found = [_found(e, trace_html.driver_words(e["driver"])) for e in report["effects"]]
    if found:
        return Message("trace-summary-found", title=title, words=words, found=found)
    return Message("trace-summary", title=title, words=words)


def _found(entry, driver: str) -> Message:
    said = entry.get("name_message")
    name = entry["name"] if said is None else Message.from_dict(said)
    return Message("trace-found", component=entry["component"], driver=driver, name=name)


def evidence_of(obj):
    """The `closedloop.result.TraceEvidence` of a Trace object; refuses when its readings are gone."""
    import numpy as np

    from ..closedloop.result import TraceEvidence

    if obj.Readings is None:
        raise Refused("trace-readings-deleted", obj.Label)
    readings = read(obj.Readings)
    series = np.array(obj.Residuals).reshape(len(obj.ResidualNames), -1)
    if series.shape[1] != readings.rows:
        raise Refused("trace-of-other-readings", obj.Label)
    residuals = dict(zip(obj.ResidualNames, series))
    if "used" in residuals:
        residuals["used"] = residuals["used"] > 0
    names = list(obj.CovarianceNames)
    matrix = np.array(obj.Covariance).reshape(len(names), len(names))
    return TraceEvidence(augmented(obj), readings, residuals, (names, matrix))


def positions_of(obj):
    """(P, n) programmed positions of the points of a Trace object, mm or rad, and (P, 3) tool offsets or None."""
    import numpy as np

    offsets = np.array([tuple(v) for v in obj.ToolOffsets]) if obj.ToolOffsets else None
    return np.array(obj.Positions).reshape(-1, len(obj.Joints)), offsets


def report_of(obj) -> dict:
    """trace.json of a Trace object."""
    return json.loads(obj.Report)


def augmented(obj):
    """The core machine with fitted errors and traced effects, as it was when it was traced."""
    from ..formats import machine_json

    return machine_json.loads(obj.Augmented, obj.Label)


# -- effects -----------------------------------------------------------------------------------------------------------
def can_add(obj) -> bool:
    """Whether a trace found effects that are not added yet, and is still valid."""
    return bool(obj.Effects) and not obj.Stale and not added_effects(obj)


def add_effects(obj, names=None) -> list:
    """Make the found effects (or those in `names`) objects under their bodies, with the errors fitted beside them.

    Returns the effect objects.  They take part in the machine's error from then on.
    """
    from ..formats import fitted_json

    machine = owner_machine(obj)
    wanted = [n for n in obj.Effects if names is None or n in names]
    if not wanted:
        raise Refused("trace-without-effects", obj.Label)
    if added_effects(obj):
        raise Refused("trace-effects-added", obj.Label)
    if not same(obj.Inputs, trace_inputs(core_machine(machine))):
        raise Refused("trace-machine-changed", obj.Label)
    model = augmented(obj)
    made = [make_effect(machine, e) for e in model.effects if e.name in wanted]
    put(obj, "FittedBefore", machine.Fitted)
    put(obj, "Added", [o.Name for o in made])
    put(machine, "Fitted", fitted_json.dumps(replace(model.fitted, covariance=None)))
    refresh(machine)
    return made


def remove_effects(obj) -> None:
    """Take the effects of a trace out of the machine again, and the fitted errors that came with them."""
    machine = owner_machine(obj)
    for effect in added_effects(obj):
        obj.Document.removeObject(effect.Name)
    put(machine, "Fitted", obj.FittedBefore)
    put(obj, "Added", [])
    put(obj, "FittedBefore", "")
    refresh(machine)
