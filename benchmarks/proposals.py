# SPDX-License-Identifier: LGPL-2.1-or-later
"""How often the proposal of a machine is right, silent or wrong, over machines of unlike kinds written in unlike ways.

Inside FreeCAD:
    freecadcmd -c "import sys, runpy; sys.argv = ['p', '--ways', 'flat,numbers'];
        runpy.run_path('benchmarks/proposals.py', run_name='__main__')"
Options: --kinds A,B  --ways A,B  --seeds 0,1  --quiet.

right: structure and directions are those of the machine.  silent: nothing is claimed that is wrong, and a person is
asked.  wrong: an axis or the chain is another one; sure: wrong with a confidence above 0.8.
"""

from __future__ import annotations

import argparse
import importlib.util
import random
import sys
import tempfile
import time
import traceback
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))

import FreeCAD as App  # noqa: E402
import numpy as np  # noqa: E402

from sensworkbench.document.propose import engine  # noqa: E402
from tests.document.machines import joined, kinds, spoilt, unlike, writers  # noqa: E402

HAS_JOINTS = importlib.util.find_spec("UtilsAssembly") is not None
WAYS = {**writers.WRITERS, **spoilt.SPOILT, **(joined.JOINED if HAS_JOINTS else {})}
TURNS = {**writers.TURNS, **spoilt.TURNED}


def judged(kind, found, turn) -> tuple[str, str]:
    """("right", "silent", "wrong" or "sure", why)."""
    truth = kind.truth
    true = {a: np.array(tuple(turn.multVec(App.Vector(*u)))) for a, u in truth.axes.items()}
    false = [a for a, axis in found.axes.items() if a not in true or abs(axis.u @ true[a]) < 0.999]
    top = max((found.axes[a].confidence for a in found.axes), default=0.0)
    if truth.structure is None:
        ok = not found.complete and not false
    else:
        ok = found.structure in (truth.structure, *truth.either) and found.complete and not false
    axes = [f"{a}({','.join(f'{v + 0.0:.2g}' for v in k.u)}){k.confidence:.2f}" for a, k in found.axes.items()]
    seen = " ".join([str(found.structure), "complete" if found.complete else "open", *axes])
    if ok and (truth.structure is None or len(found.axes) == len(true)):
        return "right", seen
    if not found.axes:
        return "silent", f"{[m.code for m in found.remarks]}"
    nested = truth.structure is not None and _fits(found.structure, (truth.structure, *truth.either))
    if not false and not found.complete and (nested or truth.structure is None):
        return "silent", seen
    if truth.structure is not None and top < 0.5:
        return "asked", seen  # wrong, but said to be unsure of
    return ("sure" if _surest(found, truth, false) > 0.8 else "wrong"), seen


def _surest(found, truth, false) -> float:
    """The highest confidence of an axis whose direction, or what carries it, is wrong."""
    wrong = set(false)
    true = next((t for t in (truth.structure, *truth.either) if t), "")
    for a in found.axes:
        if true and found.structure and a in true and _carrier(found.structure, a) != _carrier(true, a):
            wrong.add(a)
    return max((found.axes[a].confidence for a in wrong), default=0.0)


def _carrier(structure: str, axis: str) -> str:
    at, bed = structure.index(axis), structure.index("F")
    return structure[at + 1] if at < bed else structure[at - 1]


def _fits(structure, truths) -> bool:
    """Whether a structure is a true one of which some axes were not found."""
    return structure is not None and any(
        "".join(c for c in t if c in structure) == structure for t in truths)  # fmt: skip


def made(name: str, seed: int):
    """A machine by name: of `unlike` with sizes of a seed, else of `kinds`."""
    if name in unlike.UNLIKE:
        return unlike.UNLIKE[name](random.Random(seed * 1000 + len(name)))
    return kinds.KINDS[name]()


def main(argv=None) -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--kinds", default=",".join(unlike.UNLIKE))
    parser.add_argument("--ways", default=",".join(WAYS))
    parser.add_argument("--seeds", default="0")
    parser.add_argument("--quiet", action="store_true")
    args = parser.parse_args(argv)
    table: dict[str, Counter] = {}
    ways: dict[str, Counter] = {}
    slowest = (0.0, "")
    for name in args.kinds.split(","):
        for way in args.ways.split(","):
            for seed in map(int, args.seeds.split(",")):
                kind = made(name, seed)
                before = set(App.listDocuments())
                doc = App.newDocument("SensProposal")
                with tempfile.TemporaryDirectory() as folder:
                    try:
                        WAYS[way](doc, kind, Path(folder))
                        doc.recompute()
                        began = time.process_time()
                        found = engine.propose(doc)
                        took = time.process_time() - began
                        verdict, seen = judged(kind, found, TURNS.get(way, App.Rotation()))
                    except Exception:  # noqa: BLE001 - counted, and shown
                        verdict, seen, took = "error", traceback.format_exc()[-400:], 0.0
                    for other in set(App.listDocuments()) - before:
                        App.closeDocument(other)
                table.setdefault(name, Counter())[verdict] += 1
                ways.setdefault(way, Counter())[verdict] += 1
                slowest = max(slowest, (took, f"{name} {way}"))
                if verdict != "right" and not args.quiet:
                    row = f"{verdict:7}{name:18}{way:20}{seed:3} {took:5.1f}s  {kind.truth.structure} <> {seen}"
                    print(row, flush=True)
    heads = ("right", "silent", "asked", "wrong", "sure", "error")
    for rows in (table, ways):
        print("\n" + " " * 22 + "".join(f"{h:>8}" for h in heads))
        total: Counter = Counter()
        for row, counts in rows.items():
            total += counts
            print(f"{row:22}" + "".join(f"{counts[h]:8}" for h in heads))
        print(f"{'all':22}" + "".join(f"{total[h]:8}" for h in heads), flush=True)
    print(f"slowest: {slowest[0]:.1f} s of the processor, {slowest[1]}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
