# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random machines, measured, with a known answer: the same seed gives the same case.

Readings are the exact matrix product of cubic declared errors and the undeclared effects, plus noise; level 1 is plain,
level 2 small and dirty (outliers, short-wave roughness), level 3 an odd shape.
"""

from __future__ import annotations

import csv
import itertools
import json
import math
import zlib
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from .effects import Effect, driver_table, propose
from .effects import basis as shape_basis
from .kinematics import AXES, SQUARENESS, Machine, exact_error, from_dict
from .oracle import aliases, complement, declared_columns, effect_columns, lookalikes, oracle_prediction
from .plans import PLANS, conditions, directions, places, vary

CODES = tuple("".join(p[:n]) + "F" + "".join(p[n:]) for n in range(4) for p in itertools.permutations("XYZ"))
COMMON = ("FXYZ", "XYFZ", "YFXZ", "XFYZ", "YXFZ", "FYXZ", "XFZY")
NAMED = (
    "column_bend",
    "thermal_drift",
    "angular_reversal",
    "backlash",
    "windup",
    "thermal_scale",
    "spindle_growth",
    "drift",
    "cyclic",
    "step",
    "mass",
    "following",
    "cross_tilt",
    "overhang",
    "lag",
    "spindle_lag",
    "power",
    "hysteresis",
)
KINDS = ("none", *NAMED, "two", "missing", "unlogged", "odd")
NAMELESS = ("saturating", "delayed")  # shapes of one column that no catalogue holds
HIDEABLE = {n: f"{n}_C" for n in ("temp_column", "temp_ambient", "temp_scale_x", "temp_scale_y", "temp_scale_z")}
HIDEABLE["load_table"] = "load_table_kg"
READINGS = ("ex_um", "ey_um", "ez_um")


@dataclass
class Case:
    """A measured machine.  columns, fresh : name as in the file -> (N,) values; reading, fresh_truth : (N, 3) um."""

    machine: dict
    columns: dict
    reading: np.ndarray
    fresh: dict
    fresh_truth: np.ndarray
    truth: dict
    inside: tuple | None = None  # machine, effects and driver tables, for those who judge


def _declared(machine: Machine, rng) -> tuple[dict, dict]:
    """Legendre coefficients of the 18 cubic errors, mm or rad, and the three squareness errors."""
    errors = {}
    for axis in AXES:
        for motion in "XYZABC":
            size = 1.2e-3 if motion in AXES else 6e-6
            coefficient = np.concatenate([[0.0], rng.normal(size=3) * size * np.array([1.0, 0.8, 0.5])])
            if motion in AXES and motion != axis:
                coefficient[1] = 0.0
            errors[f"E{motion}{axis}"] = coefficient
    return errors, {name: float(rng.normal() * 12e-6) for name in SQUARENESS}


def _declared_values(machine, errors, square, q) -> dict:
    values = dict(square)
    for name, coefficient in errors.items():
        low, high = machine.travel[name[2]]
        u = (2 * q[:, AXES.index(name[2])] - low - high) / (high - low)
        values[name] = np.polynomial.legendre.legval(u, coefficient)
    return values


def _roughness(rng, travel, rms: float):
    """A function of q: short waves in each translation of each axis, `rms` mm per direction altogether."""
    waves = []
    for axis in range(3):
        length = float(np.ptp(travel[AXES[axis]]))
        for direction in range(3):
            for _ in range(3):
                wave = length * math.exp(rng.uniform(math.log(1 / 15), math.log(1 / 3)))
                waves.append((axis, direction, wave, rng.uniform(0, 2 * math.pi), rng.uniform(0.4, 1.0)))
    power = sum(w[4] ** 2 for w in waves) / 3 / 2

    def at(q):
        out = np.zeros_like(q)
        for axis, direction, wave, phase, weight in waves:
            out[:, direction] += weight * np.sin(2 * math.pi * q[:, axis] / wave + phase)
        return out * rms / math.sqrt(power)

    return at


def _add(values: dict, effect: Effect, table, scale) -> None:
    part = shape_basis(effect, table, scale) @ effect.coefficient
    values[effect.component] = values.get(effect.component, 0.0) + part


def _file(q, moved, logged, extra) -> dict:
    columns = {f"{k}_mm": np.round(q[:, i], 3) for i, k in enumerate("xyz")}
    columns["t_s"] = logged["t_s"]
    columns |= {f"dir_{k}": moved[:, i] for i, k in enumerate("xyz")}
    columns |= {k: v for k, v in logged.items() if k != "t_s"}
    return columns | extra


def make_case(
    seed: int,
    kind: str = "column_bend",
    level: int = 1,
    structure: str | None = None,
    plan: str | None = None,
    *,
    sigma_um: float | None = None,
    count: int | None = None,
    extras: bool = True,
    with_rivals: bool = True,
) -> Case:
    """One case.  `extras` lets tools, runs and a stated (right or wrong) uncertainty appear now and then."""
    if kind not in (*KINDS, *NAMELESS):
        raise ValueError(f"unknown kind {kind!r}; use one of {(*KINDS, *NAMELESS)}")
    rng = np.random.default_rng([seed, zlib.crc32(kind.encode()), level])
    while True:
        case = _attempt(rng, kind, level, structure, plan, sigma_um, count, extras, with_rivals)
        if case is not None:
            case.truth["seed"] = seed
            return case


def _attempt(rng, kind, level, structure, plan, sigma_um, count, extras, with_rivals):
    code = structure or str(rng.choice(COMMON if rng.random() < 0.75 else CODES))
    half = {k: float(rng.choice([150.0, 200.0, 250.0, 300.0])) for k in AXES}
    travel = {k: (-v, v) for k, v in half.items()}
    stack = code.split("F")[1]
    reference = {
        k: np.round(
            [*rng.uniform(-250, 250, 2), rng.uniform(500, 850) if k in stack else rng.uniform(50, 300)], 1
        ).tolist()
        for k in AXES
    }
    tool_point = np.round([*rng.uniform(-80, 80, 2), rng.uniform(350, 450)], 1).tolist()
    machine = Machine(code, reference, travel, tuple(tool_point))
    plan = plan or str(rng.choice(PLANS, p=[0.3, 0.3, 0.1, 0.3]))
    q = np.round(places(plan, travel, rng, count or int(rng.integers(300, 1401))), 3)
    total = len(q)
    fresh_q = np.round(places("random", travel, rng, total), 3)
    sigma = 1e-3 * (sigma_um or float(rng.choice([0.2, 0.4, 0.8, 2.0], p=[0.25, 0.3, 0.3, 0.15])))
    spindle = kind in ("spindle_lag", *NAMELESS) or (extras and rng.random() < 0.1)
    logged = conditions(total, rng, spindle=spindle)
    feeds = kind in ("following", "two") or rng.random() < 0.3
    columns = _file(q, directions(q), logged, vary(total, rng, feeds))
    fresh = _file(fresh_q, directions(fresh_q), logged, vary(total, rng, feeds))
    tool, fresh_tool, run, runs = np.zeros((total, 3)), np.zeros((total, 3)), None, ()
    offsets = np.zeros((1, 3))
    if extras and rng.random() < 0.12:
        offsets = np.round(
            np.array([[0, 0, 0], [rng.uniform(40, 80), 0, -rng.uniform(60, 120)], [0, rng.uniform(40, 80), -150]]), 1
        )
        if rng.random() < 0.3:
            offsets = offsets[1:2]
        tool = offsets[np.arange(total) * len(offsets) // total]
        fresh_tool = offsets[rng.integers(len(offsets), size=total)]
        for i, k in enumerate("xyz"):
            columns[f"tool_d{k}_mm"], fresh[f"tool_d{k}_mm"] = tool[:, i], fresh_tool[:, i]
    if extras and rng.random() < 0.1:
        runs = tuple(range(1, int(rng.integers(2, 4)) + 1))
        run = np.array(runs)[np.arange(total) * len(runs) // total]
        columns["run"] = fresh["run"] = run
    errors, square = _declared(machine, rng)
    table, fresh_table = driver_table(columns), driver_table(fresh)
    for t in (table, fresh_table):
        for name in ("run", "tool_dx", "tool_dy", "tool_dz"):
            t.pop(name, None)
    scale = {k: travel[k.upper()] if k in "xyz" else (float(v.min()), float(v.max())) for k, v in table.items()}
    measured = (q, table, scale, tool, run, runs, offsets)
    ahead = (fresh_q, fresh_table, scale, fresh_tool, run, runs, offsets)

    off = complement(declared_columns(machine, *[measured[i] for i in (0, 3, 4, 5, 6)]))
    effects, hidden = _choose(kind, level, rng, machine, measured, off, sigma)
    if effects is None:
        return None
    values, fresh_values = (_declared_values(machine, errors, square, p) for p in (q, fresh_q))
    plain = exact_error(machine, q, values, tool)
    spread = float(np.sqrt(np.mean(np.sum((plain - plain.mean(0)) ** 2, axis=1))))
    shrink = rng.uniform(5e-3, 15e-3) / spread  # the declared errors' rms, as usual on such machines
    for v in (values, fresh_values):
        for name in list(v):
            v[name] = v[name] * shrink
    for e in effects:
        _add(values, e, table, scale)
        _add(fresh_values, e, fresh_table, scale)
    truth_here = exact_error(machine, q, values, tool)
    fresh_truth = exact_error(machine, fresh_q, fresh_values, fresh_tool)
    unlogged = {}
    if kind == "unlogged":
        # a rotation: a shift in one direction is that direction's noise, and no more can be said
        name = f"E{rng.choice(list('ABC'))}{rng.choice(list('XYZ'))}"
        gain = sigma * (rng.uniform(1.5, 4) if level == 1 else rng.uniform(0.7, 1.2))
        way = effect_columns(machine, Effect(name, "t", "step", {"at": -1.0}), q, table, scale, tool)
        gain /= float(np.sqrt(np.mean(way**2)))
        shaken = way.reshape(-1, 3) * (gain * rng.normal(size=total))[:, None]
        truth_here = truth_here + shaken
        unlogged = {"component": name, "rms_3d_um": float(1e3 * np.sqrt(np.mean(np.sum(shaken**2, axis=1))))}
    outlier = np.zeros(total, dtype=bool)
    rough = 0.0
    if level >= 2:
        rough = float(rng.uniform(0.08, 0.28)) * sigma
        wave = _roughness(rng, travel, rough)
        truth_here, fresh_truth = truth_here + wave(q), fresh_truth + wave(fresh_q)
    for label in runs[1:]:
        jump = rng.normal(size=3) * 2e-3
        truth_here, fresh_truth = truth_here + np.outer(run == label, jump), fresh_truth + np.outer(run == label, jump)
    for offset in offsets[1:]:  # no tool is as long as its table says
        jump = rng.normal(size=3) * 1e-3
        truth_here = truth_here + np.outer(np.all(tool == offset, axis=1), jump)
        fresh_truth = fresh_truth + np.outer(np.all(fresh_tool == offset, axis=1), jump)
    reading = truth_here + sigma * rng.normal(size=(total, 3))
    if level >= 2:
        outlier = rng.random(total) < 0.015
        size = sigma * rng.uniform(10, 40, (int(outlier.sum()), 3)) * rng.choice([-1.0, 1.0], (int(outlier.sum()), 3))
        reading[outlier] += size
    stated = "not"
    if extras and rng.random() < 0.35:
        stated = str(rng.choice(["right", "wrong"], p=[0.65, 0.35]))
        factor = 1.0 if stated == "right" else float(rng.choice([0.4, 2.5]))
        columns["u_um"] = np.full(total, round(1e3 * sigma * factor, 4))

    known = [] if hidden or kind == "unlogged" else effects
    guess = oracle_prediction(machine, known, measured, reading, ahead, ~outlier)
    bound = float(1e3 * np.sqrt(np.mean(np.sum((guess - fresh_truth) ** 2, axis=1))))
    entries = []
    alike = lookalikes(machine, effects, measured, sigma) if with_rivals and effects and not hidden else []
    for i, e in enumerate(effects):
        entry = {"component": e.component, "driver": e.driver, "shape": e.shape, "visible_rms_over_sigma": e.visible}
        entry["parameters"] = {**e.free, **e.fixed, "coefficient": e.coefficient.tolist()}
        if e.odd:
            entry["odd"] = e.odd
        if e.shape == "periodic" and with_rivals:
            entry["alias_periods"] = aliases(machine, e, measured, sigma)
        entries.append(entry | (alike[i] if alike else {}))
    only = [effect_columns(machine, e, q, table, scale, tool) @ e.coefficient for e in effects]
    rms = lambda v: float(1e3 * np.sqrt(np.mean(np.sum(np.reshape(v, (-1, 3)) ** 2, axis=1))))  # noqa: E731
    for name in hidden:
        del columns[name], fresh[name]
    truth = {
        "kind": kind,
        "level": level,
        "structure": code,
        "plan": plan,
        "N": total,
        "sigma_um": 1e3 * sigma,
        "effects": entries,
        "missing": hidden,
        "unlogged": unlogged,
        "outliers": int(outlier.sum()),
        "outlier_rows": np.flatnonzero(outlier).tolist(),
        "roughness_um": 1e3 * rough,
        "stated_u": stated,
        "tools": len(np.unique(tool, axis=0)),
        "runs": len(runs) or 1,
        "rms_um": rms(truth_here),
        "effect_rms_um": rms(sum(only)) if only else 0.0,
        "fresh_bound_um": bound,
        "expect": _expected(kind, hidden),
    }
    return Case(
        machine.as_dict(), columns, 1e3 * reading, fresh, 1e3 * fresh_truth, truth, (machine, effects, measured)
    )


def _expected(kind: str, hidden) -> list[str]:
    """The verdicts that are right."""
    if kind == "none":
        return ["nothing_to_explain"]
    if kind in NAMELESS:
        return ["unexplained", "partly_explained", "explained"]
    if kind == "odd":
        return ["unexplained", "partly_explained"]
    if hidden or kind == "unlogged":
        return ["unexplained", "partly_explained"]
    return ["explained"]


def _choose(kind, level, rng, machine, measured, off, sigma):
    """Effects, sized by what the declared model cannot imitate, and columns to hide; None: the plan sees too little."""
    q, table, scale, tool, *_ = measured
    if kind in ("none", "unlogged"):
        return [], []
    span = float(table["t"][-1])
    hidden = []
    if kind == "two":
        wanted = [str(k) for k in rng.choice([k for k in NAMED if k != "spindle_lag"], size=2, replace=False)]
    elif kind == "missing":
        wanted = [str(rng.choice(["column_bend", "mass", "thermal_scale", "lag"]))]
    else:
        wanted = [kind]
    effects = [e for k in wanted for e in propose(k, rng, machine.travel, span)]
    if kind == "missing":
        hidden = [HIDEABLE[n] for n in effects[0].driver.split("*") if n in HIDEABLE]
        if {"temp_scale_x_C", "temp_scale_z_C"} & set(hidden):  # the twin would tell
            hidden = ["temp_scale_x_C", "temp_scale_z_C"]
    signals = []
    for e in effects:
        columns = effect_columns(machine, e, q, table, scale, tool)
        e.coefficient = np.ones(1)
        if e.shape == "periodic":
            phase = rng.uniform(0, 2 * math.pi)
            e.coefficient = np.array([math.cos(phase), math.sin(phase)])
        elif e.shape == "polynomial":
            size = np.sqrt(np.mean(columns**2, axis=0))
            e.coefficient = rng.uniform(0.4, 1.0, columns.shape[1]) * rng.choice([-1, 1], columns.shape[1]) / size
        e.coefficient = e.coefficient * rng.choice([-1.0, 1.0])
        signal = columns @ e.coefficient
        seen = float(np.sqrt(np.mean(off(signal) ** 2)))
        whole = float(np.sqrt(np.mean(signal**2)))
        if not whole or seen < 0.2 * whole:
            return None, None
        if level == 1:
            e.visible = float(np.exp(rng.uniform(math.log(2.2), math.log(12))))
        elif level == 2:
            e.visible = float(rng.uniform(0.35, 0.55))
        else:
            e.visible = float(rng.uniform(0.6, 1.5))
        e.coefficient = e.coefficient * (e.visible * sigma / seen)
        signals.append(off(signal) * (e.visible * sigma / seen))
        if e.visible * sigma / seen * whole > 25e-3:
            return None, None
    if len(signals) == 2:  # two effects that the readings can tell apart
        cosine = abs(signals[0] @ signals[1]) / np.linalg.norm(signals[0]) / np.linalg.norm(signals[1])
        if cosine > 0.6:
            return None, None
    return effects, hidden


def _cell(value) -> str:
    text = f"{value:.4f}".rstrip("0").rstrip(".") if isinstance(value, float) else str(value)
    return "0" if text == "-0" else text


def write_case(folder, case: Case) -> None:
    """machine.json, measured.csv, positions.csv, positions_truth_um.csv and truth.json in `folder`."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "machine.json").write_text(json.dumps(case.machine, indent=1) + "\n", encoding="utf-8")
    (folder / "truth.json").write_text(json.dumps(case.truth, indent=1) + "\n", encoding="utf-8")
    readings = dict(zip(READINGS, case.reading.T))
    _write_table(folder / "measured.csv", {**case.columns, **readings})
    _write_table(folder / "positions.csv", case.fresh)
    np.savetxt(folder / "positions_truth_um.csv", case.fresh_truth, delimiter=",")


def _write_table(path: Path, columns: dict) -> None:
    with path.open("w", newline="", encoding="utf-8") as stream:
        writer = csv.writer(stream)
        writer.writerow(columns)
        writer.writerows([_cell(v) for v in row] for row in zip(*(np.asarray(c).tolist() for c in columns.values())))


def read_case(folder) -> Case:
    """A case from a folder in the same formats."""
    folder = Path(folder)

    def table(name):
        with (folder / name).open(newline="", encoding="utf-8") as stream:
            rows = list(csv.reader(line for line in stream if not line.startswith("#")))
        return {k: np.array([float(r[i]) for r in rows[1:]]) for i, k in enumerate(rows[0])}

    columns = table("measured.csv")
    reading = np.stack([columns.pop(k) for k in READINGS], axis=1)
    machine = json.loads((folder / "machine.json").read_text(encoding="utf-8"))
    from_dict(machine)
    truth = json.loads((folder / "truth.json").read_text(encoding="utf-8"))
    return Case(
        machine,
        columns,
        reading,
        table("positions.csv"),
        np.loadtxt(folder / "positions_truth_um.csv", delimiter=","),
        truth,
    )
