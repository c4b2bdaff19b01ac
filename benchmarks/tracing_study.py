# SPDX-License-Identifier: LGPL-2.1-or-later
"""How often a trace names something that is not there, and how small an effect it still names: docs/tracing-study.md.

Run `python -m benchmarks.tracing_study` (2,240 nulls, 840 effects: about an hour and a half of one core), or with
`--nulls 6 --each 1` for a short one; `--table` prints the tables of what is there.  One line of JSON per case is
appended to the file `--out`; a case that stands there is not computed again, so a study that was stopped goes on.  The
designs are in benchmarks/study_designs.py.
"""

from __future__ import annotations

import argparse
import datetime
import json
import math
import os
import re
import subprocess
import sys
import time
import traceback
from pathlib import Path

for _name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ.setdefault(_name, "1")

import numpy as np  # noqa: E402

ROOT = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT), str(ROOT / "tests")]

from benchmarks.study_designs import DESIGNS, EFFECTS, SIGMA, SIZES, Case, null, with_effect  # noqa: E402
from sensworkbench import __version__  # noqa: E402
from sensworkbench.closedloop.bank import log_tail  # noqa: E402
from sensworkbench.closedloop.problem import Problem  # noqa: E402
from sensworkbench.closedloop.result import EXPLAINED, NOTHING, PARTLY, UNEXPLAINED  # noqa: E402
from sensworkbench.closedloop.trace import trace  # noqa: E402
from tests.simulator.effects import Effect  # noqa: E402
from tests.simulator.oracle import left_over  # noqa: E402

ALPHA = 0.01
SIGNIFICANT = (0.01, 0.05, 0.1)


# -- one case --
def jobs(nulls: int, each: int, seed: int) -> list[tuple[str, float, int]]:
    """(design or effect, size or 0, seed) of every case, in an order in which all designs and sizes grow alike.

    nulls : of each design.  each : of every effect and size.
    """
    out, done = [], 0
    for i in range(max(nulls, each)):
        if i < nulls:
            out += [(name, 0.0, seed + i) for name in DESIGNS]
        due = math.ceil((i + 1) * each / max(nulls, each))
        out += [(name, size, seed + k) for k in range(done, due) for name in EFFECTS for size in SIZES]
        done = due
    return out


def run(name: str, size: float, seed: int) -> dict:
    """Make, trace and score one case."""
    row = {"case": name, "size": size, "seed": seed, "version": __version__}
    case = with_effect(name, size, seed) if size else null(name, seed)
    begin = time.process_time()
    try:
        found = trace(case.machine, case.readings, seed=seed)
    except Exception:  # noqa: BLE001 - a study goes on, and counts it
        return row | {"failed": traceback.format_exc(limit=4), "seconds": time.process_time() - begin}
    row |= {
        "places": case.readings.points,
        "verdict": found.verdict,
        "p": strongest(found.log),
        "named": [[e.effect.component, str(e.effect.driver), e.effect.shape.name] for e in found.effects],
        "hidden": found.hidden.motion.symbol if found.hidden else "",
        "left": [found.left.p, round(found.left.size, 3)],
        "refused": [[r.component, r.driver, r.shape, r.why.code] for r in found.refused],
        "seconds": round(time.process_time() - begin, 2),
    }
    return row | (score(case, found) if size else {})


def strongest(log) -> float:
    """Family-wise p of the strongest candidate: of the first that was judged, 1 where none came near."""
    first = re.search(r"\bp (\d\.\d+)", log[0]) if log else None
    return float(first.group(1)) if first else 1.0


def triple(component: str, driver: str, shape: str) -> tuple[str, str, str]:
    """Component, driver and shape; the sign of travel counts as a linear driver."""
    return component, "*".join(sorted(driver.split("*"))), "linear" if shape == "reversal" else shape


def score(case: Case, found) -> dict:
    """named : the effect, or one that lists it as a rival, is named and nothing else is.  wrong : something else is.

    tie : of the wrong ones, those whose names fit as well (chi-square of the true effect that remains is below 9).
    """
    true = triple(case.truth.component, case.truth.driver, case.truth.shape)
    said = [triple(e.effect.component, str(e.effect.driver), e.effect.shape.name) for e in found.effects]
    listed = [{triple(r.component, r.driver, r.shape) for r in e.rivals} for e in found.effects]
    right = [s == true or true in rivals for s, rivals in zip(said, listed)]
    wrong = [s for s, good in zip(said, right) if not good]
    out = {"right": any(right) and not wrong, "wrong": bool(wrong), "candidates": candidates(case)}
    if wrong:
        out["tie"] = remains(case, found) < 9
    return out


def remains(case: Case, found) -> float:
    """Chi-square of the true effect that is left beside what is named; infinite where the simulator lacks a shape."""
    s = case.session
    table = dict(zip("xyz", s.q.T)) | s.columns
    own = [
        Effect(
            e.effect.component,
            str(e.effect.driver),
            e.effect.shape.name,
            fixed={k: v for k, v in e.effect.shape.values.items() if k != "coefficient"},
        )
        for e in found.effects
    ]
    try:
        return left_over(s.machine, [case.truth], own, (s.q, table, {}, 0.0, None, (), ()), SIGMA)[0]["chi2"]
    except (KeyError, ValueError, TypeError):
        return math.inf


def candidates(case: Case) -> list[int]:
    """[number of candidates that are scanned, number of displacements]."""
    p = Problem(case.machine, case.readings)
    return [len(p.bank) * len(p.component_indices), case.readings.rows]


# -- tables --
def upper(hits: int, count: int, level: float = 0.95) -> float:
    """One-sided upper limit of a proportion (Clopper and Pearson 1934)."""
    if hits >= count:
        return 1.0
    low, high = hits / count, 1.0
    for _ in range(60):
        p = (low + high) / 2
        terms = (math.lgamma(count + 1) - math.lgamma(k + 1) - math.lgamma(count - k + 1) for k in range(hits + 1))
        below = sum(math.exp(c + k * math.log(p) + (count - k) * math.log1p(-p)) for k, c in enumerate(terms))
        low, high = (p, high) if below > 1 - level else (low, p)
    return high


def null_table(rows) -> str:
    """The nulls: names, verdicts, and how often the p of the strongest candidate is small."""
    head = (
        "design | nulls | named | nothing | explained | partly | unexplained | failed | p ≤ .01 | p ≤ .05 | p ≤ .1 | s"
    )
    lines = [f"| {head} |", "|---" * 12 + "|"]
    groups = [(d.words, [r for r in rows if r["case"] == d.name]) for d in DESIGNS.values()]
    still = [r for r in rows if r["case"] in DESIGNS and DESIGNS[r["case"]].stationary]
    groups += [("**stationary noise**", still), ("**all**", rows)]
    for words, part in groups:
        if not part:
            continue
        good = [r for r in part if "failed" not in r]
        share = [f"{np.mean([r['p'] <= a for r in good]):.3f}" if good else "-" for a in SIGNIFICANT]
        verdicts = [sum(r["verdict"] == v for r in good) for v in (NOTHING, EXPLAINED, PARTLY, UNEXPLAINED)]
        cells = [words, len(part), sum(bool(r["named"]) for r in good), *verdicts, len(part) - len(good), *share]
        lines.append("| " + " | ".join(map(str, [*cells, f"{np.mean([r['seconds'] for r in part]):.1f}"])) + " |")
    good = [r for r in rows if "failed" not in r]
    hits = sum(bool(r["named"]) for r in good)
    calm = [r["verdict"] == NOTHING for r in still if "failed" not in r]
    if good and calm:
        lines += [
            "",
            f"Names: {hits} of {len(good)} nulls, {100 * hits / len(good):.2f} %, one-sided 95 % limit "
            f"{100 * upper(hits, len(good)):.2f} %.  `nothing_to_explain`: {100 * np.mean(calm):.1f} % of {len(calm)} "
            "with stationary noise.",
        ]
    return "\n".join(lines)


def half_power(rows) -> float:
    """Size at which half of the cases are named: where straight lines between the shares (made monotone) cross .5."""
    sizes = sorted({r["size"] for r in rows})
    share = [np.mean([r["right"] for r in rows if r["size"] == s]) for s in sizes]
    count = [sum(r["size"] == s for r in rows) for s in sizes]
    blocks = [[s, c] for s, c in zip(share, count)]
    pooled: list[list[float]] = []
    for value, n in blocks:  # pool adjacent violators
        pooled.append([value, n, 1])
        while len(pooled) > 1 and pooled[-2][0] > pooled[-1][0]:
            b, a = pooled.pop(), pooled.pop()
            pooled.append([(a[0] * a[1] + b[0] * b[1]) / (a[1] + b[1]), a[1] + b[1], a[2] + b[2]])
    smooth = [value for value, _, width in pooled for _ in range(width)]
    for i, s in enumerate(smooth):
        if s >= 0.5:
            if i == 0:
                return sizes[0]
            ratio = (0.5 - smooth[i - 1]) / (s - smooth[i - 1])
            return float(math.exp(math.log(sizes[i - 1]) + ratio * math.log(sizes[i] / sizes[i - 1])))
    return math.nan


def known_form(count: int, rows: int, width: int) -> float:
    """Size at which a fit that knows the effect finds it in half the runs, at .01 over all candidates (Bonferroni)."""
    wanted = math.log10(count / ALPHA)
    low, high = 0.0, 400.0
    for _ in range(60):
        x = (low + high) / 2
        low, high = (x, high) if float(log_tail(np.array(x), width)) < wanted else (low, x)
    return math.sqrt(max(high - width + 1, 0.0) / rows)


def effect_table(rows) -> str:
    """The effects: named / abstained / wrong (of these, ties) at each size, and the size found in half of the runs."""
    sizes = sorted({r["size"] for r in rows})
    lines = [
        "| effect | " + " | ".join(f"{s:g}" for s in sizes) + " | half at | Bonferroni | ratio |",
        "|---|" + "---|" * (len(sizes) + 3),
    ]
    for name in EFFECTS:
        mine = [r for r in rows if r["case"] == name and "failed" not in r]
        if not mine:
            continue
        cells = []
        for size in sizes:
            part = [r for r in mine if r["size"] == size]
            right, wrong = sum(r["right"] for r in part), sum(r["wrong"] for r in part)
            ties = sum(r.get("tie", False) for r in part)
            cells.append(f"{right}/{len(part) - right - wrong}/{wrong}" + (f" ({ties})" if ties else ""))
        width = 2 if name == "cyclic" else 1
        count, displacements = np.median([r["candidates"] for r in mine], axis=0)
        half, allowed = half_power(mine), known_form(int(count), int(displacements), width)
        lines.append(f"| {name} | " + " | ".join(cells) + f" | {half:.2f} | {allowed:.2f} | {half / allowed:.2f} |")
    return "\n".join(lines)


def report(rows) -> str:
    """Both tables, with what they were made with."""
    nulls, effects = ([r for r in rows if bool(r["size"]) == kind] for kind in (False, True))
    failed = sum("failed" in r for r in rows)
    seeds = sorted(r["seed"] for r in rows)
    commits = sorted({r.get("commit") or "unknown" for r in rows})
    head = (
        f"{datetime.date.today().isoformat()}, version {__version__}, commit {', '.join(commits)}, seeds {seeds[0]} to "
        f"{seeds[-1]}: {len(nulls)} nulls, {len(effects)} effects, {failed} failed."
    )
    return "\n\n".join([head, null_table(nulls), effect_table(effects)])


def read(path: Path) -> list[dict]:
    """The cases in a file, a last line that was cut off left out."""
    rows = []
    for line in path.read_text(encoding="utf-8").splitlines() if path.exists() else ():
        try:
            rows.append(json.loads(line))
        except ValueError:
            continue
    return rows


def commit() -> str:
    """Short name of the commit, or ""."""
    done = subprocess.run(
        ["git", "rev-parse", "--short", "HEAD"], cwd=ROOT, capture_output=True, text=True, check=False
    )
    return done.stdout.strip()


def main(argv=None) -> int:
    """Compute the cases that are missing, print the tables."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--nulls", type=int, default=160, help="of each design")
    parser.add_argument("--each", type=int, default=15, help="of each effect and size")
    parser.add_argument("--seed", type=int, default=1, help="first seed; below 10000 develop, from 100000 on report")
    parser.add_argument("--only", nargs="*", default=None, help="designs or effects")
    parser.add_argument("--seconds", type=float, default=math.inf, help="begin no case after so many seconds")
    parser.add_argument("--out", type=Path, default=ROOT / "build" / "tracing-study.jsonl")
    parser.add_argument("--table", action="store_true", help="print the tables of the file, compute nothing")
    options = parser.parse_args(argv)
    rows = read(options.out)
    if not options.table:
        known = {(r["case"], r["size"], r["seed"]) for r in rows}
        options.out.parent.mkdir(parents=True, exist_ok=True)
        if options.out.exists() and not options.out.read_bytes().endswith(b"\n"):  # stopped within a line
            with options.out.open("a", encoding="utf-8") as stream:
                stream.write("\n")
        begin, mark = time.monotonic(), commit()
        for name, size, seed in jobs(options.nulls, options.each, options.seed):
            if (name, size, seed) in known or (options.only and name not in options.only):
                continue
            if time.monotonic() - begin > options.seconds:
                break
            row = run(name, size, seed) | {"commit": mark}
            rows.append(row)
            with options.out.open("a", encoding="utf-8") as stream:
                stream.write(json.dumps(row) + "\n")
    if rows:
        print(report(rows))
    return 0


if __name__ == "__main__":
    sys.exit(main())
