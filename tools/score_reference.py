# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scores the answers of any program against the reference set: `python tools/score_reference.py ANSWERS.json`.

`--ours FILE` first writes the answers of this package to FILE.  What an answer file holds is in docs/reference-set.md.
Exit status 0: everything asked for is there and within the tolerance; 1: not.
"""

from __future__ import annotations

import argparse
import json
import math
import sys
from dataclasses import dataclass
from pathlib import Path

FOLDER = Path(__file__).resolve().parents[1] / "resources" / "reference"
RELATIVE, ABSOLUTE = 1e-12, 1e-14  # of an index; of other numbers RELATIVE alone


@dataclass(frozen=True)
class Score:
    """compared, missing, outside: how many numbers; worst: largest difference in units of what is allowed, and where.

    Each is of one kind of number: "indices", "moments", "errors".
    """

    compared: int
    missing: int
    outside: int
    worst: float
    where: str


def references(folder: Path = FOLDER) -> dict[str, dict]:
    """Name of the machine file -> its reference."""
    found = {}
    for path in sorted(folder.glob("*.reference.json")):
        data = json.loads(path.read_text(encoding="utf-8"))
        found[data["machine"]] = data
    return found


def _numbers(reference: dict, answer: dict):
    """(kind, where, wanted, got or None, what is allowed) of every number of one machine."""
    for symbol, law in reference["inputs"].items():
        got = _at(answer, "inputs", symbol)
        for key, value in law.items():
            size = abs(value) if key != "third" else law["variance"] ** 1.5
            yield "moments", f"inputs.{symbol}.{key}", value, _at(got, key), RELATIVE * size
    for n, case in enumerate(reference["cases"]):
        got = _at(answer, "cases", n)
        spread = math.sqrt(case["variance"])
        yield "moments", f"cases.{n}.mean", case["mean"], _at(got, "mean"), RELATIVE * max(abs(case["mean"]), spread)
        yield "moments", f"cases.{n}.variance", case["variance"], _at(got, "variance"), RELATIVE * case["variance"]
        for group in ("errors", "components"):
            for name, indices in case[group].items():
                for key, value in indices.items():
                    where = f"cases.{n}.{group}.{name}.{key}"
                    yield "indices", where, value, _at(got, group, name, key), max(RELATIVE * value, ABSOLUTE)
    for n, one in enumerate(reference["volumetric"]):
        for key in ("error_um", "rotation_urad"):
            size = math.hypot(*one[key])
            for i, value in enumerate(one[key]):
                got = _at(answer, "volumetric", n, key, i)
                yield "errors", f"volumetric.{n}.{key}.{i}", value, got, RELATIVE * size


def _at(data, *path):
    """The member at the path, or None where there is none."""
    for key in path:
        listed = isinstance(data, list) and isinstance(key, int) and key < len(data)
        if not listed and not (isinstance(data, dict) and key in data):
            return None
        data = data[key]
    return data


def score(answers: dict, folder: Path = FOLDER) -> dict[str, dict[str, Score]]:
    """Machine -> kind of number -> its score.  answers : machine file -> what docs/reference-set.md describes."""
    found = {}
    for machine, reference in references(folder).items():
        kinds: dict[str, list] = {}
        for kind, where, wanted, got, allowed in _numbers(reference, answers.get(machine, {})):
            row = kinds.setdefault(kind, [0, 0, 0, 0.0, ""])
            row[0] += 1
            if not isinstance(got, (int, float)) or isinstance(got, bool):
                row[1] += 1
                continue
            difference = abs(got - wanted)
            ratio = 0.0 if difference == 0 else difference / allowed if allowed else math.inf
            if not ratio <= 1:
                row[2] += 1
            if not ratio <= row[3]:
                row[3], row[4] = ratio, where
        found[machine] = {kind: Score(*row) for kind, row in kinds.items()}
    return found


def main() -> int:
    """Print one line for each machine, and the sums."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("answers", help="JSON file with the answers")
    parser.add_argument("--ours", action="store_true", help="first write this package's own answers to the file")
    arguments = parser.parse_args()
    path = Path(arguments.answers)
    if arguments.ours:
        sys.path.insert(0, str(Path(__file__).resolve().parent))
        sys.path.insert(0, str(FOLDER.parents[1]))
        from reference_answers import answers

        path.write_text(json.dumps({"format": "sens-reference-answers", "version": 1, "program": "Sens Workbench",
                                    "machines": answers(FOLDER)}), encoding="utf-8")  # fmt: skip
    data = json.loads(path.read_text(encoding="utf-8"))
    found = score(data["machines"])
    bad = 0
    print(f"{'machine':18} {'kind':9} {'numbers':>8} {'missing':>8} {'outside':>8}  worst, in units of the allowed")
    for machine, kinds in found.items():
        for kind, s in kinds.items():
            bad += s.missing + s.outside
            print(f"{machine:18} {kind:9} {s.compared:8} {s.missing:8} {s.outside:8}  {s.worst:.3g} {s.where}")
    everything = sum(s.compared for kinds in found.values() for s in kinds.values())
    print(f"{everything} numbers of {len(found)} machines, {bad} missing or outside the tolerance")
    return 0 if bad == 0 else 1


if __name__ == "__main__":
    sys.exit(main())
