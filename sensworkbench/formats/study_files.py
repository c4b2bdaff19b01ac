# SPDX-License-Identifier: LGPL-2.1-or-later
"""The files of a study, written as one set: all of them appear, or none."""

from __future__ import annotations

import io
from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path

import numpy as np

from sensworkbench.closedloop.result import TraceEvidence, TraceResult
from sensworkbench.core.machine import Machine
from sensworkbench.core.refusal import Refused
from sensworkbench.studies.plan import PlanResult
from sensworkbench.studies.sensitivity import SensitivityResult

from . import (
    json_text,
    machine_json,
    plan_html,
    plan_json,
    sensitivity_csv,
    sensitivity_html,
    sensitivity_json,
    trace_html,
    trace_json,
)
from .file_sets import staged
from .files import read_bytes, write_bytes

COVARIANCE = "covariance.npz"
PICTURE_LIMIT = 64 * 2**20  # bytes
Extra = Callable[[Path], None]


def write_set(folder, verb: str, files: Mapping[str, str | bytes], extra: Extra | None = None) -> list[Path]:
    """Write `files` (name -> text or bytes) to `folder`, all of them or none; returns the paths.

    verb : names the set; files of an earlier set of this verb that the new one lacks are removed.
    extra : called with the temporary folder, to add files that appear with the others.
    """
    with staged(folder, verb) as work:
        for name, content in files.items():
            write_bytes(work / name, content.encode("utf-8") if isinstance(content, str) else content)
        if extra is not None:
            extra(work)
        others = sorted(str(p.relative_to(work)) for p in work.rglob("*") if p.is_file() and p.name not in files)
    return [Path(folder) / name for name in [*files, *others]]


def write_sensitivity(
    folder,
    study: SensitivityResult,
    angle_unit: str = "urad",
    picture: bytes | None = None,
    extra: Extra | None = None,
    language: str = "en",
) -> list[Path]:
    """Write sensitivity.json, sensitivity.csv and report.html; returns their paths.

    picture : PNG of the machine for the report.  extra : as in `write_set`.  language : of the report.
    """
    return write_set(folder, "sensitivity", sensitivity_files(study, angle_unit, picture, language), extra)


def sensitivity_files(
    study: SensitivityResult, angle_unit: str = "urad", picture: bytes | None = None, language: str = "en"
) -> dict:
    """Name -> text of the files of a sensitivity study."""
    data = sensitivity_json.to_dict(study, angle_unit)
    return {
        "sensitivity.json": json_text.dumps(data),
        "sensitivity.csv": sensitivity_csv.dumps(data),
        "report.html": sensitivity_html.sensitivity_report(study, angle_unit, picture, language),
    }


def augmented(evidence: TraceEvidence) -> Machine:
    """The augmented machine of a trace with the name of its covariance file."""
    return replace(evidence.machine, fitted=replace(evidence.machine.fitted, covariance=COVARIANCE))


def write_trace(
    folder, result: TraceResult, extra: Callable[[Path, Machine], None] | None = None, language: str = "en"
) -> list[Path]:
    """Write trace.json, report.html, machine_augmented.json and the covariance of the fit; returns their paths.

    extra : called with the temporary folder and the augmented machine, to add files that appear with the others.
    language : of the report.
    """
    return write_saved_trace(folder, trace_json.to_dict(result), result.evidence, extra, language)


def write_saved_trace(
    folder, report: Mapping, evidence: TraceEvidence, extra=None, language: str = "en", motion=()
) -> list[Path]:
    """Write a trace that was kept as the data of trace.json and its evidence; see `write_trace`.

    motion : pictures (GIF or PNG) for the report of how the first effect moves the machine.
    """
    machine = augmented(evidence)
    names, matrix = evidence.covariance
    covariance = io.BytesIO()
    np.savez_compressed(covariance, parameters=np.array(names, dtype=str), covariance=np.asarray(matrix, dtype=float))
    files = {
        "trace.json": json_text.dumps(report),
        "report.html": trace_html.trace_report(report, evidence, language, motion),
        "machine_augmented.json": machine_json.dumps(machine),
        COVARIANCE: covariance.getvalue(),
    }
    return write_set(folder, "trace", files, None if extra is None else lambda work: extra(work, machine))


def write_plan(folder, study: PlanResult, language: str = "en") -> list[Path]:
    """Write plan.json, report.html, candidates.csv and, where one was asked for, the suggested plan.

    language : of the report.
    """
    return write_set(folder, "plan", plan_files(study, language))


def plan_files(study: PlanResult, language: str = "en") -> dict:
    """Name -> text of the files of a plan."""
    data = plan_json.to_dict(study)
    files = {
        "plan.json": json_text.dumps(data),
        "report.html": plan_html.plan_report(data, language),
        "candidates.csv": plan_json.candidates_csv(study.shown),
    }
    if study.suggested is not None:
        files[plan_html.SUGGESTED] = plan_json.positions_csv(study.suggested.readings)
    return files


def read_picture(path) -> bytes:
    """The bytes of a PNG file; refuses anything else."""
    data = read_bytes(path, PICTURE_LIMIT)
    if not data.startswith(b"\x89PNG\r\n\x1a\n"):
        raise Refused("picture-not-png", str(path))
    return data
