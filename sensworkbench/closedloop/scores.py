# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures of a fit: the machine as fitted, the error of points in and out of sample, repeats, covariance."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ..core.errors import SQUARENESS, component
from ..core.fitted import DECLARED, EFFECT, Constant, FittedModel, Series, ToolError, Uncertainty, scale_of
from ..core.machine import Machine
from ..core.units import um
from . import evidence
from .design import ALIGNMENT, Term, tool_labels
from .fit import Fit, basis, solution
from .readings import Readings
from .settings import DEFAULT, TraceSettings

SHIFTS = ("EXW", "EYW", "EZW")


def fitted_machine(
    machine: Machine, fitted: Fit, readings: Readings, effects, errors=None, uncertainty=None
) -> Machine:
    """The machine with declared errors, alignment and offsets as fitted, and `effects` added.

    errors : (terms,) standard uncertainties, NaN where not determined (default: those of the fit).  uncertainty : the
    `core.fitted.Uncertainty` that the machine keeps.
    """
    if errors is None:
        errors = np.sqrt(np.maximum(np.diag(fitted.covariance), 0.0))
    series: dict[str, Series] = {}
    constants: dict[str, Constant] = {}
    alignment: dict[str, Constant] = {}
    runs: dict[str, dict[str, Constant]] = {}
    tools: dict[str, list[float]] = {}
    for i, term in enumerate(fitted.design.terms):
        value = float(fitted.coefficients[i])
        u = float(errors[i]) if fitted.determined[i] and np.isfinite(errors[i]) else None
        if term.group == "run":
            runs.setdefault(term.symbol, {})[ALIGNMENT[term.order]] = Constant(value)
        elif term.group == "tool":
            tools.setdefault(term.symbol, [0.0, 0.0, 0.0])[term.order] = value
        elif term.group == "alignment":
            alignment[term.symbol] = Constant(value, u)
        elif component(term.symbol).kind == SQUARENESS:
            constants[term.symbol] = Constant(value, u)
        else:
            count = machine.declared_degree(term.symbol) + 1
            domain = machine.axes[component(term.symbol).body].travel
            known = series.get(term.symbol) or Series(domain, (0.0,) * count, (0.0,) * count)
            coefficients, errors_of = list(known.coefficients), list(known.u)
            coefficients[term.order], errors_of[term.order] = value, u
            series[term.symbol] = Series(domain, tuple(coefficients), tuple(errors_of))
    if readings.run is not None:
        first = sorted({str(r) for r in readings.run})[0]
        runs = {first: {s: Constant(0.0) for s in SHIFTS}} | runs
    labels = tool_labels(readings) or [(0.0, 0.0, 0.0)]
    model = FittedModel(
        series=series,
        constants=constants,
        alignment={s: alignment[s] for s in ALIGNMENT if s in alignment},
        runs=runs,
        tools=tuple(
            ToolError(offset, tuple(tools.get(str(i), (0.0, 0.0, 0.0)))) for i, offset in enumerate(labels, start=1)
        ),
        ranges={k: (float(v.min()), float(v.max())) for k, v in readings.columns.items()},
        uncertainty=uncertainty,
    )
    return replace(machine, fitted=model, effects=tuple(machine.effects) + tuple(effects))


def covariance_table(known: Uncertainty) -> tuple[list[str], np.ndarray]:
    """(labels, covariance) of all parameters of a fit, um, urad and the units of parameters of shapes.

    What the choice among names adds is in it.
    """
    labels, scales = [], []
    for key in known.parameters:
        group, *rest = key
        if group == DECLARED:
            label = str(Term(group, *rest).title)
        elif group == EFFECT:
            label = f"{rest[0]}: {rest[1] if len(key) == 3 else f'{rest[1]} {rest[2]}'}"
        else:
            label = " ".join(str(r) for r in rest)
        labels.append(f"{group} {label}")
        scales.append(1 / scale_of(key))
    factor = np.concatenate(
        [known.matrix(), *(np.sqrt(o.weight) * np.array(o.changes)[:, None] for o in known.others)], axis=1
    )
    scaled = factor * np.array(scales)[:, None]
    return labels, scaled @ scaled.T


def metrics(error_um: np.ndarray, readings: Readings, use=None) -> dict:
    """rms, 95th percentile and largest 3-D error over points (um), and rms per component; error_um (R,)."""
    rows = np.ones(len(error_um), dtype=bool) if use is None else use
    square = np.bincount(readings.point[rows], weights=error_um[rows] ** 2, minlength=readings.points)
    present = np.bincount(readings.point[rows], minlength=readings.points) > 0
    size = np.sqrt(square[present])
    if not len(size):
        return {"rms_um": 0.0, "p95_um": 0.0, "max_um": 0.0}
    out = {
        "rms_um": float(np.sqrt((size**2).mean())),
        "p95_um": float(np.percentile(size, 95)),
        "max_um": float(size.max()),
    }
    for kind, name in enumerate(("x", "y", "z", "along")):
        mine = rows & (readings.kind == kind)
        if mine.any():
            out[f"rms_{name}_um"] = float(np.sqrt((error_um[mine] ** 2).mean()))
    return out


def interval(error_um: np.ndarray, readings: Readings, block, use, seed: int) -> list[float]:
    """95 % interval of the 3-D rms by drawing whole blocks again (500 times)."""
    square = np.bincount(readings.point[use], weights=error_um[use] ** 2, minlength=readings.points)
    present = np.bincount(readings.point[use], minlength=readings.points) > 0
    sums = np.bincount(block[present], weights=square[present], minlength=block.max() + 1)
    counts = np.bincount(block[present], minlength=block.max() + 1).astype(float)
    draws = np.random.default_rng(seed).integers(0, len(sums), size=(500, len(sums)))
    rms = np.sqrt(sums[draws].sum(axis=1) / np.maximum(counts[draws].sum(axis=1), 1))
    return [float(v) for v in np.percentile(rms, [2.5, 97.5])]


def held_out_rows(grams_columns, fitted: Fit, row_block: np.ndarray, y: np.ndarray, x: np.ndarray) -> np.ndarray:
    """(R,) residuals of each row predicted by a fit of all other blocks; x (R, n) unweighted columns."""
    grams = evidence.BlockGrams(fitted.white(x[:, grams_columns]), fitted.white(y), row_block)
    out = np.empty(len(y))
    for b, beta in enumerate(grams.left_out_coefficients()):
        rows = row_block == b
        out[rows] = y[rows] - x[np.ix_(rows, grams_columns)] @ beta
    return out


def left_out_runs(columns, fitted: Fit, readings: Readings, y, x) -> list[float]:
    """3-D rms (um) of each run by a fit of all others; () where there are fewer than two runs.

    The offset of the run that is left out, or with `alignment` "per run" its set-up, is fitted to it before it is
    judged: it belongs to the run, and no other can know it.  columns : of x (R, n) that the model holds.
    """
    if readings.run is None:
        return []
    labels = np.array([str(r) for r in readings.run])
    terms, out = fitted.design.terms, []
    own = [i for i, t in enumerate(terms) if t.group == "alignment"]
    own = own if readings.alignment == "per run" else own[:3]
    nuisance = fitted.design.matrix[:, own]
    for label in sorted(set(labels)):
        mine = (labels == label)[readings.point]
        used = mine & (fitted.weight > 0)
        if not used.any() or mine.all():
            continue
        train = x[:, columns] * (fitted.weight * ~mine)[:, None]
        b = basis(train)
        theta = solution(b, train, y * fitted.weight * ~mine)
        left = y - x[:, columns] @ theta
        shift, *_ = np.linalg.lstsq(nuisance[used], left[used], rcond=1e-9)
        left = um(left - nuisance @ shift)
        out.append(metrics(left, readings, used)["rms_um"])
    return out


def left_out_blocks(error_um, readings: Readings, block, used) -> list[float]:
    """3-D rms (um) of each block of readings by a fit of all others; error_um (R,), block (P,)."""
    return [metrics(error_um, readings, used & (block == b)[readings.point])["rms_um"] for b in np.unique(block)]


def replicates(readings: Readings, residual_um: np.ndarray, used, settings: TraceSettings = DEFAULT) -> float | None:
    """Pure error (um, one reading) from points whose place and conditions repeat exactly, else None."""
    names = [n for n in readings.columns if n != "t"]
    table = np.round(np.stack([readings.columns[n] for n in names], axis=1), 6)
    _, group = np.unique(table, axis=0, return_inverse=True)
    key = group.ravel()[readings.point] * 4 + readings.kind
    rows = np.flatnonzero(used)
    _, key = np.unique(key[rows], return_inverse=True)
    count = np.bincount(key)
    if (count > 1).sum() < settings.least_repeats:
        return None
    value = residual_um[rows]
    mean = np.bincount(key, weights=value) / count
    square = np.bincount(key, weights=(value - mean[key]) ** 2)
    return float(np.sqrt(square[count > 1].sum() / (count[count > 1] - 1).sum()))
