# SPDX-License-Identifier: LGPL-2.1-or-later
"""Undeclared effects: component x driver x shape, and the odd ones that no catalogue holds.

Driver values are mm, seconds, kelvin from 20 degC, directions -1/+1 and others as written; rows are in time order.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np


@dataclass
class Effect:
    """`free` holds the nonlinear parameters, `fixed` what is known; `coefficient` (m,) is mm or rad per driver unit."""

    component: str
    driver: str
    shape: str
    free: dict = field(default_factory=dict)
    fixed: dict = field(default_factory=dict)
    coefficient: np.ndarray | None = None
    visible: float = 0.0
    odd: str = ""


def driver_table(columns: dict) -> dict:
    """File columns -> drivers: names without unit, temperatures from 20 degC."""
    table = {}
    for name, values in columns.items():
        for unit in ("_mm_min", "_mm", "_s", "_rpm", "_kg"):
            if name.endswith(unit):
                table[name[: -len(unit)]] = values
                break
        else:
            if name.startswith("temp_") and name.endswith("_C"):
                table[name[:-2]] = values - 20.0
            else:
                table[name] = values
    return table


def lag(v, t, tau: float, start: float = 0.0) -> np.ndarray:
    """y' = (v - y)/tau, v held over each interval at its end value."""
    y = np.empty(len(v))
    y[0] = start
    for i in range(1, len(v)):
        y[i] = v[i] + (y[i - 1] - v[i]) * math.exp(-(t[i] - t[i - 1]) / tau)
    return y


def play(v, width: float) -> np.ndarray:
    """Position minus what a drive with friction follows: saturates at +-width after each reversal."""
    state, out = v[0], np.empty(len(v))
    for i, x in enumerate(v):
        state = min(max(state, x - width), x + width)
        out[i] = x - state
    return out


def _unit(table: dict, name: str, scale: dict) -> np.ndarray:
    low, high = scale[name]
    return (2 * table[name] - low - high) / (high - low)


ODD = {
    # name: (columns, function of unit columns u and free parameters a, b)
    "sine_mix": (("t", "axis"), lambda u, v, a, b: np.sin(3.1 * u + a) * np.cos(4.3 * v + b)),
    "turning": (("t", "axis"), lambda u, v, a, b: np.sin(2.3 * u * v + 2.0 * u + a) * (1 + b * v)),
    "bumps": (("axis", "other"), lambda u, v, a, b: np.exp(-8 * (u - a) ** 2) * np.sin(5 * v + b)),
    "saddle": (("temp_column", "axis"), lambda u, v, a, b: np.tanh(3 * (u - a)) * np.cos(4.5 * v + b)),
    "burst": (("t", "temp_ambient"), lambda u, v, a, b: np.exp(-10 * (u - a) ** 2) * np.sin(4 * v + b)),
    "triple": (("axis", "other", "temp_column"), lambda u, v, w, a, b: np.sin(4.2 * u * v + a) * np.tanh(3 * w + b)),
    "folded": (("axis", "other"), lambda u, v, a, b: np.abs(np.sin(3.3 * u + a)) * np.sign(np.sin(2.2 * v + b))),
    "loaded": (("load_table", "axis"), lambda u, v, a, b: np.sin(2.5 * u + a) * np.cos(4.8 * v + b)),
}


def basis(effect: Effect, table: dict, scale: dict, free: dict | None = None) -> np.ndarray:
    """(N, m) what the coefficients multiply; `free` replaces the effect's own nonlinear parameters."""
    p = {**effect.fixed, **(effect.free if free is None else free)}
    names = effect.driver.split("*")
    if effect.odd:
        values = [_unit(table, n, scale) for n in effect.fixed["columns"]]
        return ODD[effect.odd][1](*values, p["a"], p["b"])[:, None]
    v = np.prod([table[n] for n in names], axis=0).astype(float)
    shape = effect.shape
    if shape in ("linear", "reversal"):
        return v[:, None]
    if shape == "polynomial":
        low, high = p["domain"]
        return np.polynomial.legendre.legvander((2 * v - low - high) / (high - low), int(p["degree"]))[:, 1:]
    if shape == "periodic":
        angle = 2 * math.pi * v / p["period"]
        return np.stack([np.sin(angle), np.cos(angle)], axis=1)
    if shape == "approach":
        return (1 - np.exp(-v / p["tau"]))[:, None]
    if shape == "step":
        return (v > p["at"]).astype(float)[:, None]
    if shape == "lag":
        return lag(v, table["t"], p["tau"])[:, None]
    if shape == "power":
        return (np.sign(v) * np.abs(v) ** p["exponent"])[:, None]
    if shape == "hysteresis":
        return play(v, p["width"])[:, None]
    if shape == "saturating":
        return np.tanh(v / p["width"])[:, None]
    if shape == "delayed":
        return np.interp(table["t"] - p["delay"], table["t"], v)[:, None]
    raise ValueError(shape)


def _pick(rng, values):
    return values[int(rng.integers(len(values)))]


def propose(kind: str, rng: np.random.Generator, travel: dict, span: float) -> list[Effect]:
    """One random choice of component, driver and shape parameters; whether the plan can see it is for the caller."""
    axis = _pick(rng, "XYZ")
    other = _pick(rng, [k for k in "XYZ" if k != axis])
    low, turn, move = axis.lower(), _pick(rng, "ABC"), _pick(rng, "XYZ")
    mid = _pick(rng, ("temp_column", "temp_column", "temp_ambient"))
    one = lambda *args, **kw: [Effect(*args, **kw)]  # noqa: E731
    if kind == "column_bend":
        return one(f"E{turn}{axis}", "temp_column", "linear")
    if kind == "thermal_drift":
        return one(f"E{move}{axis}", mid, "linear")
    if kind == "angular_reversal":
        return one(f"E{turn}{axis}", f"dir_{low}", "reversal")
    if kind == "backlash":
        return one(f"E{axis}{axis}", f"dir_{low}", "reversal")
    if kind == "windup":
        return one(f"E{axis}{axis}", f"dir_{low}*{low}", "linear")
    if kind == "thermal_scale":
        return one(f"E{axis}{axis}", "*".join(sorted([low, f"temp_scale_{low}"])), "linear")
    if kind == "spindle_growth":
        return one("EZT", "t", "approach", {"tau": float(rng.uniform(0.08, 0.4) * span)})
    if kind == "drift":
        return one(f"E{_pick(rng, 'XYZABC')}W", "t", "approach", {"tau": float(rng.uniform(0.08, 0.5) * span)})
    if kind == "cyclic":
        return one(f"E{axis}{axis}", low, "periodic", {"period": float(np.exp(rng.uniform(np.log(5), np.log(60))))})
    if kind == "step":
        return one(f"E{_pick(rng, 'XYZABC')}W", "t", "step", {"at": float(rng.uniform(0.15, 0.85) * span)})
    if kind == "mass":
        if rng.random() < 0.5:
            return one(f"E{_pick(rng, 'ABC')}{axis}", "load_table", "linear")
        return one(f"EZ{axis}", "*".join(sorted(["load_table", low])), "linear")
    if kind == "following":
        return one(f"E{axis}{axis}", f"dir_{low}*feed", "linear")
    if kind == "cross_tilt":
        if rng.random() < 0.5:
            return one(f"E{turn}{axis}", other.lower(), "linear")
        known = {"degree": 2, "domain": [float(v) for v in travel[other]]}
        return one(f"E{turn}{axis}", other.lower(), "polynomial", fixed=known)
    if kind == "overhang":
        return one(f"EZ{axis}", "*".join(sorted([low, other.lower()])), "linear")
    if kind == "lag":
        part = f"E{_pick(rng, 'XYZABC')}{_pick(rng, 'XYZ')}"
        source = _pick(rng, ("temp_column", "temp_ambient"))
        return one(part, source, "lag", {"tau": float(rng.uniform(0.04, 0.25) * span)})
    if kind == "spindle_lag":
        return one("EZT", "spindle", "lag", {"tau": float(rng.uniform(0.04, 0.2) * span)})
    if kind == "power":
        return one(f"E{turn}{axis}", "temp_column", "power", {"exponent": float(_pick(rng, (2.0, 2.5, 3.0)))})
    if kind == "hysteresis":
        return one(f"E{axis}{axis}", low, "hysteresis", {"width": float(rng.uniform(0.02, 0.1) * np.ptp(travel[axis]))})
    if kind == "saturating":
        source = _pick(rng, ("temp_column", "temp_ambient", "temp_scale_y", "spindle"))
        widest = {"temp_column": 3.0, "temp_ambient": 1.2, "temp_scale_y": 4.0, "spindle": 12000.0}[source]
        return one(f"E{_pick(rng, 'XYZABC')}{axis}", source, kind, {"width": float(rng.uniform(0.1, 0.4) * widest)})
    if kind == "delayed":
        source = _pick(rng, ("temp_column", "temp_ambient", "temp_scale_y", "spindle"))
        return one(f"E{_pick(rng, 'XYZABC')}{axis}", source, kind, {"delay": float(rng.uniform(0.05, 0.25) * span)})
    if kind == "odd":
        name = _pick(rng, sorted(ODD))
        columns = [{"axis": low, "other": other.lower()}.get(c, c) for c in ODD[name][0]]
        free = {"a": float(rng.uniform(-0.6, 0.6)), "b": float(rng.uniform(-0.6, 0.6))}
        part = f"E{_pick(rng, 'XYZABC')}{axis}"
        return one(part, "*".join(sorted(columns)), "other", free, {"columns": columns}, odd=name)
    raise ValueError(f"unknown kind {kind!r}")
