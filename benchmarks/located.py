# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is located is modelled: effects that are hard to name, and how well fresh places are then predicted.

Run `python -m benchmarks.located`.  Four kinds, on some 200 places each: an effect that saturates, one that follows its
driver after a dead time, a small lag beside outliers and roughness, and a small cyclic error.  An answer is *named*
(the effect, or a name of identical trace, or it stands among the rivals), *modelled* (no such name, and the error at
fresh places is at most twice that of a fit that knows the effect and must still estimate it), or neither.  Cases come
from tests/simulator, which shares no code with the package.
"""

from __future__ import annotations

import argparse
import os
import sys

for _name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ.setdefault(_name, "1")

import numpy as np  # noqa: E402

from benchmarks.tracing import run  # noqa: E402

WITHIN = 2.0  # of the error of the fit that knows the effect
PLACES = (180, 241)
# kind of case, level of tests/simulator: 1 large, 2 small (.35 to .55 of the noise) and dirty, 3 as large as the noise
SETS = {
    "saturating": ("saturating", 1),
    "saturating, of the size of the noise": ("saturating", 3),
    "dead time": ("delayed", 1),
    "dead time, of the size of the noise": ("delayed", 3),
    "small lag, outliers, roughness": ("lag", 2),
    "small cyclic": ("cyclic", 2),
}


def one(kind: str, level: int, seed: int) -> dict:
    """The row of one case, with `answer`: named, modelled or neither."""
    count = int(np.random.default_rng(seed).integers(*PLACES))
    row = run((seed, kind, level, {"count": count, "extras": False, "with_rivals": kind in ("lag", "cyclic")}))
    good = row["outcome"] in ("right", "rival", "same", "tie", "verdict")
    known = kind in ("lag", "cyclic")
    row["answer"] = "named" if known and good else "modelled" if row.get("ratio", np.inf) <= WITHIN else "neither"
    return row


def main(argv=None) -> int:
    """Run, print one line of each case and the table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--cases", type=int, default=12, help="of each set")
    parser.add_argument("--seed", type=int, default=1, help="first seed; below 100000 develop, from there on report")
    parser.add_argument("--only", nargs="*", default=list(SETS), help="sets")
    options = parser.parse_args(argv)
    lines = []
    for words in options.only:
        rows = []
        for seed in range(options.seed, options.seed + options.cases):
            row = one(*SETS[words], seed)
            rows.append(row)
            said, t = row.get("said", {}), row["truth"]
            names = "; ".join(f"{e['component']} {e['driver']} {e['shape']}" for e in said.get("effects", ()))
            truth = "; ".join(f"{e['component']} {e['driver']} {e['shape']}" for e in t["effects"])
            print(
                f"{row['answer']:8s} {row['outcome']:7s} {words}, seed {seed}, {t['plan']}, N {t['N']}: {truth} -> "
                f"{said.get('verdict', row.get('why', '').strip()[-200:])}: {names or '-'}; "
                f"{row.get('fresh_um', np.nan):.2f} um, bound {t['fresh_bound_um']:.2f}, "
                f"ratio {row.get('ratio', np.nan):.2f} ({row['seconds']:.1f} s)",
                flush=True,
            )
        count = [sum(r["answer"] == a for r in rows) for a in ("named", "modelled", "neither")]
        false = sum(r["outcome"] == "false" for r in rows)
        ratio = [r.get("ratio", np.inf) for r in rows]
        lines.append((words, len(rows), *count, false, f"{np.median(ratio):.2f}", f"{max(ratio):.2f}"))
    head = ("set", "cases", "named", "modelled", "neither", "other names", "median ratio", "largest")
    print("\n| " + " | ".join(head) + " |\n" + "|---" * len(head) + "|")
    for line in lines:
        print("| " + " | ".join(map(str, line)) + " |")
    return 0


if __name__ == "__main__":
    sys.exit(main())
