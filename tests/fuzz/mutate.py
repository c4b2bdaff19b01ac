# SPDX-License-Identifier: LGPL-2.1-or-later
"""Valid files of every reader, and random changes to them: bytes, lines, cells, numbers, JSON values, encodings."""

from __future__ import annotations

import json
import random

from tests.formats.support import golden

FITTED = {
    "EXX": {"basis": "legendre", "domain": [-300, 300], "coefficients": [0, 1, 2], "unit": "um", "u": [0.1, 0.1, 0.1]},
    "C0Y": {"value": 12, "unit": "urad", "u": 1},
    "alignment": {"EXW": {"value": 1, "unit": "um"}},
    "runs": {"1": [0.1, 0.2, 0.3]},
    "x-ranges": {"x": [-300, 300]},
    "x-tools": [{"offset_mm": [0, 0, 0], "error_um": [0, 0, 0]}],
}
SHAPES = {
    "linear": ("temp_column", {}),
    "reversal": ("dir_x", {}),
    "polynomial": ("x", {"degree": 3, "domain": [-300, 300]}),
    "periodic": ("x", {"period": {"value": 47, "unit": "mm"}}),
    "approach": ("t", {"tau": {"value": 800, "unit": "s"}}),
    "step": ("t", {"at": {"value": 905, "unit": "s"}}),
    "lag": ("temp_column", {"tau": {"value": 300, "unit": "s"}}),
    "power": ("temp_column", {"exponent": 2.5}),
    "hysteresis": ("y", {"width": {"value": 20, "unit": "mm"}}),
}


def _effects() -> list[dict]:
    found = []
    for shape, (driver, parameters) in SHAPES.items():
        size = 3 if shape == "polynomial" else 2 if shape == "periodic" else None
        value = 1.0 if size is None else [1.0] * size
        entry = {"name": f"e {shape}", "component": "EXX", "driver": driver, "shape": shape}
        found.append(entry | {"parameters": {"coefficient": {"value": value}, **parameters}, "enabled": True})
    return found


def _joints() -> dict:
    data = golden()
    del data["axes"]
    directions = {"X": [1, 0, 0], "Y": [0, 1, 0], "Z": [0, 0, 1]}
    joints = [
        {"name": k, "kind": "linear", "direction": d, "point": [0, 0, 0], "travel": [-100, 100], "unit": "mm"}
        for k, d in directions.items()
    ]
    joints.append(
        {"name": "C", "kind": "rotary", "direction": [0, 0, 1], "point": [0, 0, 0], "travel": None, "unit": "deg"}
    )
    return data | {"version": 2, "joints": joints, "workpiece_chain": ["C"]}


def _machine(**changes) -> str:
    return json.dumps(golden(**changes), indent=1)


_ROWS = "".join(f"{x},{y},{-z},{t},{d},{20 + t / 9},{x / 9},{y / 9},1\n" for t, (x, y, z, d) in enumerate(
    [(10 * i % 300, 7 * i % 200, 5 * i % 250, (-1) ** i) for i in range(14)]
))  # fmt: skip
_HEAD = "# sign: error\n# frame: tool_relative_to_workpiece\nx_mm,y_mm,z_mm,t_s,dir_x,temp_column_C,ex_um,ey_um,ez_um\n"
_FCM = {
    "machine": {
        "name": "m",
        "units": "metric",
        "axes": {
            k: {"type": "linear", "role": "head_linear", "sequence": i, "parent": None,
                "joint": {"origin": [0, 0, 0], "axis": d}, "limits": {"min": -100, "max": 100}}
            for i, (k, d) in enumerate({"X": [1, 0, 0], "Y": [0, 1, 0], "Z": [0, 0, 1]}.items())
        },
    },
    "version": 1,
}  # fmt: skip
_SUM = 64 * "0"
PROGRAM = """%
O1000 (a part)
N10 G21 G17 G90 G40 G80
N20 T1 M6
N30 G0 G54 G43 H1 X0 Y0 Z20 S3000 M3
N40 G1 Z-1. F200
N50 G41 D1 G1 X20 Y0 F300 (feature: edge)
N60 X40
N70 G3 X40 Y20 I0 J10
N80 G40 G1 X0 Y40
N90 G18 G2 X10 Z-11 I0 K-10
N95 G17 G3 X10 Y40 Z-15 I-8 J0 F100
N100 G0 Z20
N110 G98 G83 X5 Y5 Z-8 R2 Q1 F50
N120 G91 X10 L3
N130 G80 G90 G20 G0 X0 Z1
N140 G55
M30
"""

SEEDS: dict[str, list[str]] = {
    "program": [PROGRAM, "G0 X0 Y0 Z0\nG19 G2 Y10 Z10 R10 F9\nG1 X1e Y2\n".replace("e", "")],
    "features": [
        json.dumps(
            {
                "format": "sens-features",
                "version": 1,
                "work_offsets": {"G54": [0, 0, 0]},
                "tools": {"1": {"length_mm": 5, "radius_mm": 3, "end": "ball"}},
                "features": [
                    {"name": "a", "kind": "roundness", "lines": [3, 9], "limit_um": 5},
                    {"name": "b", "of": "a", "blocks": [[10, 20], [40, 50]], "datum": "a"},
                ],
            },
            indent=1,
        )
    ],
    "path points": ["x_mm,y_mm,z_mm,feature,kind,limit_um,nx,ny,nz\n" + 6 * "1,2,-3,a,flatness,5,0,0,1\n"],
    "conditions": ["t_s,temp_column_C\n0,20\n60,21.5\n", "block;temp_a_C;load_b_kg\n1;20,5;3\n9;21;4\n"],
    "machine": [
        _machine(),
        _machine(fitted=FITTED),
        _machine(fitted=FITTED, effects=_effects(), declared={"EXX": {"shape": "polynomial", "degree": 3}}),
        _machine(tolerances={"EXX": {"lower": -1, "upper": 1, "unit": "um", "distribution": "normal", "sigma": 0.3}}),
        json.dumps(_joints(), indent=1),
    ],
    "readings": [_HEAD + _ROWS, (_HEAD + _ROWS).replace(",", ";").replace(".", ",")],
    "vector readings": ["x_mm,y_mm,z_mm,nx,ny,nz,reading_um,u_um,run\n" + 14 * "1,2,-3,0,0,1,4,.5,a\n"],
    "positions": [_HEAD + _ROWS, "# positions: table X\nx_mm;y_mm;z_mm;tool_dx_mm\n1,5;2;-3;0\n4;5;-6;70\n"],
    "mapping": ['{"x_mm": "Pos X", "z_mm": 7, "ignore": ["Remark"], "header": {"sign": "error"}}'],
    "tolerances": [
        "symbol,lower,upper,unit,distribution,sigma\nEXX,-1,1,um,uniform,\nEAX,-4,4,arcsec,normal,1\n",
        "symbol;lower;upper\nEXX;-0,5;0,5\nEYY;-1 um;2 um\n",
        '{"format": "sens-tolerances", "version": 1, "tolerances": {"EXX": {"lower": -1, "upper": 1, "unit": "um"}}}',
    ],
    "isg": ["X EXX EYX\n-200 0 0\n0 0.001 0\n200 0.002 0\n#\nC0Y A0Z B0Z\n1e-5 0 2e-5\n"],
    "etalon": ["[EXX]\nGridpoints = {\n-200 0\n200 0.002\n}\n[C0Y]\nVALUE = 1e-5\n"],
    "fcm": [json.dumps(_FCM, indent=1)],
    "manifest": [
        json.dumps({"format": "sens-manifest", "version": 1, "sets": [
            {"verb": "sensitivity", "made_by": "x", "command": ["sensitivity", "m.json"], "seed": None,
             "conventions": {}, "inputs": [{"path": "m.json", "sha256": _SUM, "bytes": 5}],
             "files": [{"name": "a/b.json", "sha256": _SUM, "bytes": 5}]}]}, indent=1)
    ],
}  # fmt: skip
NUMBERS = ("0", "-1", "1e308", "-1e308", "1e-320", "nan", "inf", "1e999", "1_0", "1,5", "0.1.2", "", "true", "null",
           "9" * 400, "1e160", "1000000000", "-0", "0x10", "١")  # fmt: skip
PIECES = ('"', "{", "}", "[", "]", ",", ":", ";", "\t", "\n", "\r", "\0", "#", "# sign: ,", "\ufeff", "é", "\u202e",
          "\\ud800", "'", "=1+1", "<script>", "//", "a" * 300, " " * 300, "_", "*", "x-", "nan", "None")  # fmt: skip
VALUES = (None, True, [], {}, "", "x", 0, -1, 1e308, -1e308, 10**9, [1, 2], {"value": [1, 2]},
          {"value": 1, "unit": "furlong"}, [1e308, 1e308], "nan", {"x": 1}, 1e-320, 0.5)  # fmt: skip


def changed(rng: random.Random, text: str) -> bytes:
    """A text with one to four random changes, as bytes."""
    for _ in range(rng.choice((1, 1, 1, 2, 4))):
        text = rng.choice((_characters, _lines, _number, _value, _pieces))(rng, text)
    data = text.encode("utf-8", "surrogatepass")
    if rng.random() < 0.12:
        data = _bytes(rng, data)
    if rng.random() < 0.02:
        data = text.encode(rng.choice(("utf-16", "latin-1", "utf-32")), "replace")
    return data


def _characters(rng, text):
    at = rng.randrange(len(text) + 1)
    return text[:at] + text[at + rng.choice((1, 2, 5, 50)) :]


def _pieces(rng, text):
    at = rng.randrange(len(text) + 1)
    return text[:at] + rng.choice(PIECES) + text[at + rng.choice((0, 0, 1, 3)) :]


def _lines(rng, text):
    lines = text.split("\n")
    i, j = rng.randrange(len(lines)), rng.randrange(len(lines))
    kind = rng.randrange(3)
    if kind == 0:
        del lines[i]
    elif kind == 1:
        lines.insert(j, lines[i])
    else:
        lines[i], lines[j] = lines[j], lines[i]
    return "\n".join(lines)


def _number(rng, text):
    """One number replaced by another."""
    import re

    found = list(re.finditer(r"-?\d+(\.\d+)?", text))
    if not found:
        return text
    match = rng.choice(found)
    return text[: match.start()] + rng.choice(NUMBERS) + text[match.end() :]


def _value(rng, text):
    """One value of a JSON text replaced, removed or doubled under another name."""
    try:
        data = json.loads(text)
    except ValueError:
        return _number(rng, text)
    places = []

    def walk(value):
        keys = value.keys() if isinstance(value, dict) else range(len(value)) if isinstance(value, list) else ()
        for key in keys:
            places.append((value, key))
            walk(value[key])

    walk(data)
    if not places:
        return text
    holder, key = rng.choice(places)
    kind = rng.randrange(6)
    if kind == 0:
        del holder[key]
    elif kind == 1 and isinstance(holder, dict):
        holder[rng.choice(("x-a", "", "é", key.swapcase(), "unit", "value"))] = holder[key]
    else:
        other, other_key = rng.choice(places)
        holder[key] = rng.choice(
            (
                rng.choice(VALUES),
                rng.choice(VALUES),
                json.loads(json.dumps(other.get(other_key) if isinstance(other, dict) else None)),
            )
        )
    return json.dumps(data, indent=1)


def _bytes(rng, data):
    data = bytearray(data)
    for _ in range(rng.choice((1, 3))):
        if data:
            data[rng.randrange(len(data))] = rng.randrange(256)
    return bytes(data)
