# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes resources/reference: the machines, and for each its reference numbers.  `python tools/reference_set/make.py`.

With `--digits N` the numbers are computed with N digits and a smaller step, and compared with the files instead: the
largest relative difference is printed.
"""

from __future__ import annotations

import argparse
import itertools
import json
import random
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from mpmath import mp, mpf

from reference_set import kinematics
from reference_set.further import further_machines
from reference_set.indices import Objective
from reference_set.inputs import inputs
from reference_set.kinematics import Machine
from reference_set.machines import other_machines, three_axes, tolerances

FOLDER = Path(__file__).resolve().parents[2] / "resources" / "reference"
WRITTEN = 30  # digits
UM, URAD = mpf(1) / 1000, mpf(10) ** -6
MORE = [  # objectives beside the plain one, in turn
    {"name": "mean_square", "output": "position", "weights": [1, 1, 0]},
    {"name": "mean_square", "output": "position", "weights": [0.5, 2, 3]},
    {"name": "mean_square", "output": "orientation", "weights": [1, 1, 1]},
    {"name": "signed", "output": "position", "weights": [1, -0.5, 0.25]},
    {"name": "mean_square", "output": "orientation", "weights": [1, 0, 2]},
    {"name": "signed", "output": "orientation", "weights": [0, 1, 0]},
]
PLAIN = {"name": "mean_square", "output": "position", "weights": [1, 1, 1]}


def columns_at(machine, symbols, q):
    """(position, orientation) columns of each error, um or urad per um or urad of the error."""
    found = {}
    for s in symbols:
        position, turn = machine.column(s, q)
        angular = s[0] in "ABC" or (s[0] == "E" and s[1] in "ABC")
        scale = 1000 * URAD if angular else mpf(1)  # um per urad; um per um
        found[s] = [v * scale for v in position], [v * (1 if angular else 1000) for v in turn]
    return found


def reference(path, number):
    """The reference numbers of one machine."""
    machine = Machine(path)
    rng = random.Random(3000 + number)
    varying = inputs(machine.data)
    symbols = list(dict.fromkeys([*machine.data["tolerances"], *(s for x in varying for s in x.follows)]))
    joints = len(machine.names)
    span = [(float(low), float(high)) for low, high in machine.travel]
    turns = [3 if endless else 1 for endless in machine.endless]  # positions beyond the turn about 0, too
    places = [[round(rng.uniform(low, high) * n, 2) for (low, high), n in zip(span, turns)] for _ in range(2)]
    counts = [3 if joints <= 3 or endless else 2 for endless in machine.endless]
    axes = [[low + (high - low) * i / (n - 1) for i in range(n)] for (low, high), n in zip(machine.travel, counts)]
    grid = list(itertools.product(*axes))
    extra = MORE[number % len(MORE)]
    known = {}

    def columns(q):
        key = tuple(q)
        if key not in known:
            known[key] = columns_at(machine, symbols, [mpf(str(v)) if isinstance(v, float) else v for v in q])
        return known[key]

    cases = []
    for objective, kind, points in [
        (PLAIN, {"kind": "at", "position": places[0]}, [places[0]]),
        (PLAIN, {"kind": "grid", "counts": counts}, grid),
        (extra, {"kind": "at", "position": places[1]}, [places[1]]),
    ]:
        case = _case(objective, kind, [columns(q) for q in points], varying, machine)
        if case:
            cases.append(case)
    volumetric = []
    for q in places:
        values = {s: round(rng.uniform(-20, 20), 1) for s in symbols}
        found, position, turn = columns(q), [mpf(0)] * 3, [mpf(0)] * 3
        for s, value in values.items():
            position = [a + mpf(str(value)) * c for a, c in zip(position, found[s][0])]
            turn = [a + mpf(str(value)) * c for a, c in zip(turn, found[s][1])]
        volumetric.append({"position": q, "errors": values, "error_um": position, "rotation_urad": turn})
        norms = [mp.sqrt(sum(v * v for v in x)) for x in (position, turn)]
        volumetric[-1]["error_um"] = [_clean(v, norms[0]) for v in position]
        volumetric[-1]["rotation_urad"] = [_clean(v, norms[1]) for v in turn]
    laws = {
        x.label: {"mean": m, "variance": v, "third": _clean(third, v ** mpf(1.5)), "fourth": fourth}
        for x, (m, v, third, fourth) in ((x, x.law) for x in varying)
    }
    return {"format": "sens-reference", "version": 1, "machine": path.name, "inputs": laws, "cases": cases,
            "volumetric": volumetric}  # fmt: skip


def _case(objective, kind, found, varying, machine):
    """Indices over positions: means, and the largest total; None where nothing varies."""
    output = int(objective["output"] == "orientation")
    weights = [mpf(str(w)) for w in objective["weights"]]
    owners = [x.body for x in varying]
    bodies = [b for b in dict.fromkeys([*machine.names, "T", "W", *owners]) if b in owners]
    groups = [[i for i, owner in enumerate(owners) if owner == b] for b in bodies]
    n, count = len(varying), len(found)
    first, total, largest = [mpf(0)] * n, [mpf(0)] * n, [mpf(0)] * n
    parts = [[mpf(0), mpf(0)] for _ in bodies]
    mean, variance = mpf(0), mpf(0)
    for columns in found:
        mixed = [[sum(f * columns[s][output][a] for s, f in x.follows.items()) for a in range(3)] for x in varying]
        here = Objective(mixed, [x.law for x in varying], weights, objective["name"] == "signed")
        if here.variance == 0:
            return None
        for i, (f, t) in enumerate(here.each()):
            first[i] += f / count
            total[i] += t / count
            largest[i] = max(largest[i], t)
        for part, members in zip(parts, groups):
            f, t = here.group(members)
            part[0] += f / count
            part[1] += t / count
        mean += here.expected / count
        variance += here.variance / count
    return {
        "objective": objective, "positions": kind, "mean": mean, "variance": variance,
        "errors": {x.label: {"first": _clean(first[i], 1), "total": _clean(total[i], 1),
                             "total_max": _clean(largest[i], 1)} for i, x in enumerate(varying)},
        "components": {b: {"first": _clean(p[0], 1), "total": _clean(p[1], 1)} for b, p in zip(bodies, parts)},
    }  # fmt: skip


def text(value, depth=0):
    """JSON with every digit that is stated."""
    if isinstance(value, mpf):
        return mp.nstr(value, WRITTEN, min_fixed=-3, max_fixed=6, strip_zeros=True) if value else "0"
    if isinstance(value, dict):
        inner = [f"{json.dumps(k)}: {text(v, depth + 1)}" for k, v in value.items()]
        return _listed("{", inner, "}", depth, any(isinstance(v, (dict, list, tuple)) for v in value.values()))
    if isinstance(value, (list, tuple)):
        inner = [text(v, depth + 1) for v in value]
        return _listed("[", inner, "]", depth, any(isinstance(v, (dict, list, tuple)) for v in value))
    return json.dumps(value)


def _listed(left, inner, right, depth, broken):
    if not broken:
        return left + ", ".join(inner) + right
    indent = "\n" + " " * (depth + 1)
    return left + indent + ("," + indent).join(inner) + indent[:-1] + right


def _clean(value, size):
    """0 for what is nothing but rounding: below 1e-35 of the size that it could have."""
    return value if abs(value) > size * mpf(10) ** -35 else mpf(0)


def write_machines(only=None):
    """The machine files (or those of the numbers `only`), with a tolerance for every error."""
    FOLDER.mkdir(parents=True, exist_ok=True)

    def symbols_of(data):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "machine.json"
            path.write_text(json.dumps(data), encoding="utf-8")
            return Machine(path).symbols()

    for n, data in enumerate([*three_axes(), *other_machines(), *further_machines(symbols_of)], start=1):
        if only and n not in only:
            continue
        used = [s for s in symbols_of(data) if n % 2 or s[2:] not in ("W",)]  # every second machine: an ideal workpiece
        followed = list(dict.fromkeys(s for source in data.get("sources", []) for s in source["factors"]))
        used = [s for s in used if s not in followed[::2]]  # what follows a source has a part of its own, or none
        data["tolerances"] = tolerances(random.Random(4000 + n), used, plain=n % 5 == 0)
        path = FOLDER / f"{n:02d}.machine.json"
        path.write_text(json.dumps(data, indent=1) + "\n", encoding="utf-8")


def main() -> int:
    """Write the files, or compare them with a computation of more digits."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--digits", type=int, help="compute again with so many digits and compare")
    parser.add_argument("--machine", type=int, action="append", help="only the machine with this number")
    arguments = parser.parse_args()
    if not arguments.digits:
        write_machines(arguments.machine)
    if arguments.digits:
        mp.dps, kinematics.STEP = arguments.digits, mpf(10) ** -(arguments.digits // 3)
    worst = mpf(0)
    for path in sorted(FOLDER.glob("*.machine.json")):
        number = int(path.name[:2])
        if arguments.machine and number not in arguments.machine:
            continue
        found = reference(path, number)
        target = path.with_name(f"{number:02d}.reference.json")
        if arguments.digits:
            worst = max(worst, difference(found, json.loads(target.read_text(), parse_float=mpf, parse_int=mpf)))
        else:
            target.write_text(text(found) + "\n", encoding="utf-8")
    if arguments.digits:
        print(f"largest difference: {mp.nstr(worst, 3)} relative to the largest number of its kind in the case")
    return 0


def difference(a, b):
    """Largest relative difference of the numbers in two of the structures."""
    if isinstance(a, dict):
        return max((difference(a[k], b[k]) for k in a), default=mpf(0))
    if isinstance(a, (list, tuple)):
        size = max((abs(x) for x in b if isinstance(x, mpf)), default=mpf(0))
        return max((abs(x - y) / size if isinstance(x, mpf) and size else difference(x, y) for x, y in zip(a, b)),
                   default=mpf(0))  # fmt: skip
    if isinstance(a, mpf):
        return abs(a - b) / abs(b) if b else abs(a)
    return mpf(0)


if __name__ == "__main__":
    sys.exit(main())
