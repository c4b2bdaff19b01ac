# SPDX-License-Identifier: LGPL-2.1-or-later
"""Machines 51 to 60 of the set: endless joints, sources, effects, and directions that form a left-handed triad."""

from __future__ import annotations

import math
import random

from .machines import _joint, _leaning, _vector

# code from workpiece to tool, joints in the order of the file, and what is special
FURTHER = [
    ("CAYFXZ", "XYZAC", {"endless": "C"}),
    ("CXFYZB", "XYZBC", {"endless": "BC"}),
    ("CF", "C", {"endless": "C"}),
    ("XYFZ", "XYZ", {"version": 1, "sources": 3}),
    ("CAXFYZ", "XYZAC", {"sources": 4}),
    ("FXZY", "XYZ", {"sources": 2, "leaning": True}),
    ("YFXZ", "XYZ", {"version": 1, "effects": 1}),
    ("CYFXZ", "XYZC", {"endless": "C", "effects": 2}),
    ("FYXZ", "XYZ", {"version": 1, "backwards": "Z", "leaning": True}),
    ("CAYFXZ", "XYZAC", {"backwards": "X", "endless": "C", "leaning": True, "sources": 2, "effects": 3}),
]
LAWS = (
    {"distribution": "uniform", "lower": -1, "upper": 1},
    {"distribution": "normal", "sigma": 0.5},
    {"distribution": "truncated_normal", "lower": -1.5, "upper": 2.5, "sigma": 1.2},
    {"distribution": "u_shaped", "lower": -0.5, "upper": 2},
)


def _value(value, unit=""):
    return {"value": value} | ({"unit": unit} if unit else {})


def _effect(name, component, driver, shape, of_driver=None, enabled=True, **parameters):
    """An effect; of_driver: the range of its driver, as version 2 states it."""
    data = {"name": name, "component": component, "driver": driver, "shape": shape, "parameters": parameters,
            "enabled": enabled}  # fmt: skip
    return data | ({"extent": of_driver} if of_driver else {})


EFFECTS = {
    1: [  # version 1: the range of the component, if any is known
        _effect("backlash", "EXX", "dir_x", "reversal", coefficient=_value(3, "um"), extent=_value([-3, 3], "um")),
        _effect("column", "EAZ", "temp_column", "linear", coefficient=_value(4.2, "urad/K"),
                extent=_value([-2.1, 14.7], "arcsec")),
        _effect("growth", "EZT", "t", "approach", coefficient=_value(18, "um"), tau=_value(1500, "s"),
                extent=_value([0, 0.0165], "mm")),
        _effect("no range", "EYY", "temp_bed", "linear", coefficient=_value(2, "um/K")),
        _effect("switched off", "EYX", "dir_x", "reversal", enabled=False, coefficient=_value(30, "um"),
                extent=_value([-30, 30], "um")),
    ],
    2: [  # version 2: the range of the driver
        _effect("backlash", "EXX", "dir_x", "reversal", coefficient=_value(-2.5, "um")),
        _effect("turns", "ECC", "c", "linear", coefficient=_value(0.07, "arcsec/deg")),
        _effect("column", "EAZ", "temp_column", "linear", _value([18, 29.5], "C"), coefficient=_value(3.1, "urad/K")),
        _effect("scale", "EYY", "temp_scale*y", "linear", _value([-900, 1700], "K*mm"),
                coefficient=_value(0.0115, "um/(K*mm)")),
        _effect("growth", "EZT", "t", "approach", _value([0, 5400], "s"), coefficient=_value(21, "um"),
                tau=_value(1800, "s")),
        _effect("draw", "EXT", "spindle", "power", _value([0, 12000], "rpm"), coefficient=_value(4e-6, "um/rpm^1.5"),
                exponent=_value(1.5)),
        _effect("slip", "EYW", "t", "step", _value([0, 5400], "s"), coefficient=_value(-7, "um"), at=_value(3000, "s")),
        _effect("ball screw", "EZZ", "z", "periodic", coefficient=_value([1.2, -0.7], "um"), period=_value(10, "mm")),
        _effect("oil", "EBX", "temp_oil", "lag", _value([1, 9], "K"), coefficient=_value(-1.9, "urad/K"),
                tau=_value(700, "s"), state0=_value(-0.5, "K")),
        _effect("not known", "EXZ", "temp_hall", "linear", coefficient=_value(2, "um/K")) | {"extent": None},
        _effect("switched off", "EYX", "x", "linear", enabled=False, coefficient=_value(1, "um/mm")),
    ],
    3: [
        _effect("backlash", "EYY", "dir_y", "reversal", coefficient=_value(1.5, "um")),
        _effect("table sinks", "EAA", "a", "linear", coefficient=_value(0.2, "urad/deg")),
        _effect("hall", "EBZ", "temp_hall", "linear", _value([-1, 4], "K"), coefficient=_value(5, "urad/K")),
    ],
}  # fmt: skip


def _sources(rng, symbols, count):
    """Sources with factors on errors of several bodies; the last one on two errors of one body alone."""
    found = []
    for n in range(count):
        if n == count - 1:
            body = rng.choice(symbols)[2:]
            picked = rng.sample([s for s in symbols if s[2:] == body], 2)
        else:
            picked = rng.sample(symbols, 5 - n)
        factors = {}
        for s in picked:
            angular = s[0] in "ABC" or (s[0] == "E" and s[1] in "ABC")
            unit = rng.choice(["urad", "arcsec"]) if angular else "um"
            factors[s] = {"value": rng.choice([-1, 1]) * round(rng.uniform(1, 12), 2), "unit": unit}
        found.append({"name": f"source {n + 1}", **LAWS[n % len(LAWS)], "factors": factors})
    return found


def further_machines(symbols_of):
    """10 machines as machine.json data, without tolerances.

    symbols_of : from the data of a machine the symbols of its errors.  The members of `sources` are drawn from them.
    """
    for n, (code, order, special) in enumerate(FURTHER):
        rng = random.Random(5000 + n)
        at = code.index("F")
        joints = [_joint(rng, k, size=400.0) for k in order]
        for j in joints:
            if j["name"] in special.get("endless", ""):
                j["travel"] = None
            if special.get("leaning") and j["kind"] == "linear":
                j["direction"] = _leaning(rng, "XYZ".index(j["name"]), 1.5)
            if j["name"] in special.get("backwards", ""):
                j["direction"] = [-v for v in j["direction"]]
        if special.get("backwards"):  # the machine does not stand along the axes of the file
            c, s = math.cos(0.3), math.sin(0.3)
            for j in joints:
                x, y, z = j["direction"]
                j["direction"] = [round(v, 15) for v in (c * x - s * y, s * x + c * y, z)]
        data = {
            "format": "sens-machine", "version": special.get("version", 2), "name": f"{code}, number {51 + n}",
            "workpiece_chain": list(reversed(code[:at])), "tool_chain": list(code[at + 1 :]), "joints": joints,
            "tool_point": _vector(rng, 400), "squareness": "carried" if n % 3 == 1 else "direction",
        }  # fmt: skip
        if n % 3 == 2:
            data |= {"spindle_reference": _vector(rng, 400), "workpiece_reference": _vector(rng, 400)}
        if data["version"] == 1:
            data["axes"] = {j["name"]: {"direction": j["direction"], "reference": j["point"], "travel": j["travel"]}
                            for j in data.pop("joints")}  # fmt: skip
        if "effects" in special:
            data["effects"] = EFFECTS[special["effects"]]
        if "sources" in special:
            data["sources"] = _sources(rng, symbols_of(data), special["sources"])
        yield data
