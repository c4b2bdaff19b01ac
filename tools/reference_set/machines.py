# SPDX-License-Identifier: LGPL-2.1-or-later
"""Machines 1 to 50 of the reference set, as machine.json data: drawn with fixed seeds, rounded to few digits."""

from __future__ import annotations

import itertools
import math
import random

LAWS = ("uniform", "normal", "truncated_normal", "triangular", "u_shaped", "point")
SIZES = (1.0, 30.0, 400.0, 3000.0, 30000.0)  # mm of travel


def _vector(rng, size):
    return [round(rng.uniform(-size, size), 3) for _ in range(3)]


def _leaning(rng, axis, skew_deg):
    """A unit vector near an axis, to 15 digits."""
    a, b = (math.radians(rng.uniform(-skew_deg, skew_deg)) for _ in range(2))
    v = [0.0, 0.0, 0.0]
    v[axis], v[(axis + 1) % 3], v[(axis + 2) % 3] = math.cos(a) * math.cos(b), math.sin(a), math.cos(a) * math.sin(b)
    return [round(x, 15) for x in v]


def _tolerance(rng, angular, law):
    middle = 0.0 if rng.random() < 0.5 else round(rng.uniform(-6, 6), 1)
    half = round(rng.uniform(0.5, 12), 1)
    entry = {"lower": round(middle - half, 1), "upper": round(middle + half, 1), "unit": "urad" if angular else "um",
             "distribution": law}  # fmt: skip
    if angular and rng.random() < 0.2:
        entry["unit"] = "arcsec"
    if law in ("normal", "truncated_normal") and rng.random() < 0.5:
        entry["sigma"] = round(half * rng.uniform(0.1, 1.5), 2)
    return entry


def tolerances(rng, symbols, plain):
    """A tolerance for each error: of every law in turn, or all uniform."""
    start = rng.randrange(len(LAWS))
    return {
        s: _tolerance(rng, s[0] in "ABC" or (s[0] == "E" and s[1] in "ABC"),
                      "uniform" if plain else LAWS[(start + i) % len(LAWS)])
        for i, s in enumerate(symbols)
    }  # fmt: skip


def three_axes():
    """24 machines of version 1, one for every order of X, Y, Z and place of the bed."""
    codes = ["".join(o[:k]) + "F" + "".join(o[k:]) for o in itertools.permutations("XYZ") for k in range(4)]
    for n, code in enumerate(codes):
        rng = random.Random(1000 + n)
        size = SIZES[n % len(SIZES)]
        left, right = code.split("F")
        axes = {}
        for i, k in enumerate("XYZ"):
            low = round(-size * rng.uniform(0.2, 1), 2)
            direction = _leaning(rng, i, 4.5 / math.sqrt(2) / 2) if n % 3 else [int(i == j) for j in range(3)]
            axes[k] = {
                "direction": direction,
                "reference": _vector(rng, 2 * size),
                "travel": [low, round(low + size, 2)],
            }
        data = {
            "format": "sens-machine", "version": 1, "name": f"three axes {code}",
            "workpiece_chain": list(reversed(left)), "tool_chain": list(right), "axes": axes,
            "tool_point": _vector(rng, size), "squareness": "carried" if n % 2 else "direction",
        }  # fmt: skip
        if n % 4 == 1:
            data |= {"spindle_reference": _vector(rng, size), "workpiece_reference": _vector(rng, size)}
        yield data


def _joint(rng, name, axis=None, travel=None, size=400.0, point=None, direction=None):
    rotary = name[0] in "ABC"
    axis = "XYZXYZXYZ".index(name[0]) if axis is None and name[0] in "XYZ" else axis
    if axis is None:
        axis = "ABCUVW".index(name[0]) % 3
    low = round(-size * rng.uniform(0.3, 1), 1)
    return {
        "name": name, "kind": "rotary" if rotary else "linear",
        "direction": direction or [int(axis == j) for j in range(3)], "point": point or _vector(rng, size),
        "travel": travel or ([-90, 120] if rotary else [low, round(low + size, 1)]), "unit": "deg" if rotary else "mm",
    }  # fmt: skip


# code from workpiece to tool, and what is special
OTHERS = [
    ("CAYFXZ", {}), ("CBXFYZ", {}), ("CAFXYZ", {}), ("YFXZAC", {}), ("FXYZBC", {}), ("FXYZAC", {}),
    ("CYFXZB", {}), ("CXFYZA", {}), ("BYFXZA", {}), ("CAXYFZ", {}), ("BAXYFZ", {}), ("CFXYZB", {}),
    ("CB1YFXZ", {"inclined": "B1"}), ("YFXZCB", {"inclined": "B"}), ("XFYZB", {}), ("AXYFZ", {}),
    ("ZFX", {"order": "ZX"}), ("FZX", {"order": "XZ"}), ("CFZX", {"order": "ZXC"}), ("CZFXYB", {}),
    ("C", {"end": "F"}), ("CA", {"end": "F"}), ("XFYZ", {"far": True}),
    ("U1FXYZ", {"frame": ["U1", "Y"]}), ("CXYFZW1", {}),
    ("CAXFYZ", {"far": True, "reverse": True}),
]  # fmt: skip


def other_machines():
    """26 machines of version 2: five axes, inclined axes, lathes, rotary tables, secondary axes, far references."""
    for n, (code, special) in enumerate(OTHERS):
        rng = random.Random(2000 + n)
        code += special.get("end", "")
        names = []
        for letter in code:
            if letter.isdigit():
                names[-1] += letter
            else:
                names.append(letter)
        at = names.index("F")
        order = list(special.get("order", "")) or sorted(x for x in names if x != "F")
        size = SIZES[1:][n % 4]
        joints = []
        for k in order:
            more = {}
            if special.get("inclined") == k:
                more["direction"] = [0, round(math.cos(0.7), 15), round(math.sin(0.7), 15)]
            if special.get("far"):
                more["point"] = [round(v + 1e6, 1) for v in _vector(rng, 1000)] if k in "XA" else None
            joints.append(_joint(rng, k, size=size, **more))
        if special.get("reverse"):  # X and Y count backwards: still right-handed
            for j in joints:
                if j["name"] in "XY":
                    j["direction"] = [-v for v in j["direction"]]
        data = {
            "format": "sens-machine", "version": 2, "name": f"{code}" + (" inclined" if "inclined" in special else ""),
            "workpiece_chain": list(reversed(names[:at])), "tool_chain": names[at + 1 :], "joints": joints,
            "tool_point": _vector(rng, size), "squareness": "carried" if n % 3 == 1 else "direction",
        }  # fmt: skip
        if "frame" in special:
            data["frame"] = dict(zip(("primary", "secondary"), special["frame"]))
        if n % 3 == 2:
            data |= {"spindle_reference": _vector(rng, size), "workpiece_reference": _vector(rng, size)}
        yield data
