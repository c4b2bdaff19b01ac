# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hundreds of random machines with a known answer, traced, and what came out: the study behind docs/tracing-study.md.

Run `python benchmarks/tracing.py --cases 100`.  Cases come from tests/simulator, which shares no code with the package,
and pass through the files of the specification.  Seeds below 10000 are for development; the table that is reported uses
seeds from 100000 on.  Details of every case are kept in build/.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
import tempfile
import time
import traceback
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

for _name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ.setdefault(_name, "1")

import numpy as np  # noqa: E402

ROOT = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT), str(ROOT / "tests")]

from simulator import KINDS, make_case, write_case  # noqa: E402
from simulator.effects import Effect  # noqa: E402
from simulator.oracle import left_over  # noqa: E402

from sensworkbench.closedloop.predict import predict  # noqa: E402
from sensworkbench.closedloop.trace import trace  # noqa: E402
from sensworkbench.formats import machine_json, readings_csv, trace_json  # noqa: E402

OUTCOMES = ("right", "rival", "same", "tie", "verdict", "part", "missed", "false", "failed")
LIMIT = 1.2  # of the bound, as the cases are judged


def triple(entry) -> tuple[str, str, str]:
    """Component, driver and shape, with the sign of travel as a linear driver."""
    driver = "*".join(sorted(entry["driver"].split("*")))
    shape = "linear" if entry["shape"] == "reversal" else entry["shape"]
    return entry["component"], driver, shape


def score(case, said: dict) -> dict:
    """Outcome of one case.

    right: verdict and every effect, by its name or one with the same trace; rival: the truth stands among the listed
    rivals; same: other names whose functions are the true ones in these readings; tie: names that these readings cannot
    tell from the truth (chi-square < 9), which is not among the rivals; verdict: effects right, verdict not; part: some
    of the effects; missed: nothing false, nothing found; false: something named that is not there.
    """
    truth = case.truth
    found = [triple(e) for e in said["effects"]]
    listed = [{triple(r) for r in e.get("rivals", ())} for e in said["effects"]]
    verdict = said["verdict"] in truth["expect"]
    nameless = truth["missing"] or truth["unlogged"] or truth["kind"] == "odd"
    matched, by_rival, literal, used = 0, 0, 0, set()
    for effect in [] if nameless else truth["effects"]:
        own = triple(effect)
        same = {own} | {triple(e) for e in effect.get("equals", ())}
        direct = [i for i, f in enumerate(found) if f in same and i not in used]
        near = [i for i, f in enumerate(found) if i not in used and listed[i] & same]
        if direct:
            matched += 1
            literal += own == found[direct[0]] or own in listed[direct[0]]
            used.add(direct[0])
        elif near:
            by_rival += 1
            literal += own in listed[near[0]]
            used.add(near[0])
    false = [f for i, f in enumerate(found) if i not in used and not _tolerated(truth, f)]
    wanted = 0 if nameless else len(truth["effects"])
    left = remains(case, said["effects"]) if found and not nameless else []
    if false and len(found) <= wanted + 1 and left and max(v["share"] for v in left) < 1e-3:
        outcome = "same"
    elif false and len(found) == wanted and left and max(v["chi2"] for v in left) < 9:
        outcome = "tie"
    elif false:
        outcome = "false"
    elif matched + by_rival < wanted:
        outcome = "part" if matched + by_rival else "missed"
    elif not verdict:
        outcome = "missed" if nameless else "verdict"
    else:
        outcome = "rival" if by_rival else "right"
    columns = {e["column"] for e in said.get("depends_on", ()) if e["p"] < 0.01}
    driven = {c for e in truth["effects"] for c in e["driver"].split("*")}
    return {
        "outcome": outcome,
        "left": left,
        "verdict_right": verdict,
        "literal": bool(wanted) and literal == wanted,
        "false_names": false,
        "rivals_listed": [len(e.get("rivals", ())) for e in said["effects"]],
        "rivals_expected": [len(e["equals"]) + len(e["rivals"]) - 1 for e in truth["effects"] if "equals" in e],
        "depends_found": sorted(columns & driven),
        "depends_missed": sorted(driven - columns - {m.rsplit("_", 1)[0] for m in truth["missing"]}),
    }


def remains(case, entries) -> list[dict]:
    """Chi-square and share of each true effect that remains beside what was said."""
    machine, effects, measured = case.inside
    said = []
    for e in entries:
        number = {k: v["value"] if isinstance(v, dict) else v for k, v in e.get("parameters", {}).items()}
        number.pop("coefficient", None)
        said.append(Effect(e["component"], e["driver"], e["shape"], fixed=number))
    try:
        return left_over(machine, effects, said, measured, 1e-3 * case.truth["sigma_um"])
    except (KeyError, ValueError):  # a shape or a column that the simulator has not
        return []


def _tolerated(truth: dict, found) -> bool:
    """Where the driver is not logged, the component that moves, or time in place of the driver, is no false name."""
    component, driver, shape = found
    if truth["unlogged"]:
        return shape in ("unlogged", "random", "smooth")
    if truth["missing"]:
        return "t" in driver.split("*") or shape in ("unlogged", "random", "smooth")
    return shape == "smooth"


def run(job) -> dict:
    """Make, write, trace, predict and score one case."""
    seed, kind, level, options = job
    case = make_case(seed, kind, level, **options)
    truth = case.truth
    row = {"seed": seed, "kind": kind, "level": level, "truth": truth}
    with tempfile.TemporaryDirectory() as folder:
        write_case(folder, case)
        machine = machine_json.load(Path(folder) / "machine.json")
        readings = readings_csv.load(Path(folder) / "measured.csv")
        positions = readings_csv.load_positions(Path(folder) / "positions.csv")
    begin = time.perf_counter()
    try:
        result = trace(machine, readings, seed=seed)
        row["seconds"] = time.perf_counter() - begin
        said = as_answer(result)
        guess = 1e3 * np.asarray(predict_at(result, positions))
    except Exception:  # noqa: BLE001 - a study goes on, and counts it
        row |= {"outcome": "failed", "seconds": time.perf_counter() - begin, "why": traceback.format_exc()}
        return row
    error = float(np.sqrt(np.mean(np.sum((guess - case.fresh_truth) ** 2, axis=1))))
    row |= score(case, said)
    row["aliased"] = any(e.get("alias_periods") for e in truth["effects"])
    row["alias_said"] = "alias" in json.dumps(said, default=str).lower()
    row |= {"said": said, "fresh_um": error, "ratio": error / truth["fresh_bound_um"]}
    errors = said.get("error", {})
    if "augmented" in errors and "declared" in errors:
        before, after = (errors[k]["held_out"]["rms_um"] for k in ("declared", "augmented"))
        row["held_out_gain"] = 1 - after / before if before else 0.0
    return row


def as_answer(result) -> dict:
    """The result as trace.json holds it."""
    return trace_json.to_dict(result)


def predict_at(result, positions) -> np.ndarray:
    """(P, 3) mm at the fresh positions by the augmented machine."""
    return predict(result.machine, positions)


def _named(entry) -> str:
    own = {k: v["value"] if isinstance(v, dict) else v for k, v in entry.get("parameters", {}).items()}
    shown = [f"{k} {own[k]:.4g}" for k in ("tau", "period", "at", "exponent", "width", "degree") if k in own]
    return "·".join(triple(entry)) + (f" ({', '.join(shown)})" if shown else "")


def _short(row) -> str:
    truth = ", ".join(_named(e) for e in row["truth"]["effects"]) or "-"
    if row["outcome"] == "failed":
        said = row["why"].strip().splitlines()[-1]
    else:
        names = ", ".join(_named(e) for e in row["said"]["effects"]) or "-"
        said = f"{row['said']['verdict']}: {names}"
    visible = "/".join(f"{e['visible_rms_over_sigma']:.2f}" for e in row["truth"]["effects"])
    t = row["truth"]
    return (
        f"{row['outcome']:8s} {row['kind']:16s} L{row['level']} seed {row['seed']} {t['structure']} {t['plan']} "
        f"N={t['N']} visible {visible or '-'}  true {truth}  said {said}  ratio {row.get('ratio', float('nan')):.2f} "
        f"({row['seconds']:.1f} s)"
        + "".join(
            "  aliases " + "/".join(f"{p:.3g}" for p in e["alias_periods"][:4])
            for e in row["truth"]["effects"]
            if e.get("alias_periods")
        )
        + "".join(f"  left chi2 {v['chi2']:.1f} share {v['share']:.4f}" for v in row.get("left", ()))
    )


def table(rows) -> str:
    """Kind x level: outcomes; `literal`: every true name is said or listed as a rival, word for word; prediction within
    the limit (where no period is aliased); rivals listed and expected; gain; time."""
    head = [
        "kind",
        "level",
        "n",
        *OUTCOMES,
        "literal",
        "fresh<=1.2",
        "ratio50",
        "ratio90",
        "rivals",
        "expected",
        "gain",
        "s",
    ]
    lines = [head]
    keys = sorted({(r["kind"], r["level"]) for r in rows}, key=lambda k: (KINDS.index(k[0]), k[1]))
    groups = [(k, lvl, [r for r in rows if (r["kind"], r["level"]) == (k, lvl)]) for k, lvl in keys]
    for lvl in sorted({r["level"] for r in rows}):
        groups.append(("all", lvl, [r for r in rows if r["level"] == lvl]))
    for kind, lvl, part in groups:
        ratio = np.array([r["ratio"] for r in part if "ratio" in r and not r["aliased"]] or [np.nan])
        mean = lambda key, part=part: np.mean([v for r in part for v in r.get(key, ())] or [np.nan])  # noqa: E731
        gain = np.mean([r["held_out_gain"] for r in part if "held_out_gain" in r] or [np.nan])
        lines.append(
            [kind, str(lvl), str(len(part)), *[str(sum(r["outcome"] == o for r in part)) for o in OUTCOMES]]
            + [
                str(sum(bool(r.get("literal")) for r in part)),
                f"{int(np.sum(ratio <= LIMIT))}/{len(ratio)}",
                f"{np.median(ratio):.2f}",
                f"{np.quantile(ratio, 0.9):.2f}",
            ]
            + [f"{mean('rivals_listed'):.1f}", f"{mean('rivals_expected'):.1f}", f"{gain:.2f}"]
            + [f"{np.median([r['seconds'] for r in part]):.1f}"]
        )
    width = [max(len(line[i]) for line in lines) for i in range(len(head))]
    return "\n".join(
        "  ".join(c.rjust(w) if i else c.ljust(w) for i, (c, w) in enumerate(zip(x, width))) for x in lines
    )


def main(argv=None) -> int:
    """Parse, run, print the table, keep the details."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--cases", type=int, default=42, help="how many cases; kinds and levels take turns")
    parser.add_argument("--seed", type=int, default=1, help="first seed; below 10000 develop, from 100000 on report")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--kinds", nargs="*", default=list(KINDS), choices=KINDS)
    parser.add_argument("--levels", nargs="*", type=int, default=[1, 2], help="1 plain, 2 small and dirty (odd: 3)")
    parser.add_argument("--structure", default=None)
    parser.add_argument("--plan", default=None)
    parser.add_argument("--plain", action="store_true", help="no tools, runs or stated uncertainty")
    parser.add_argument("--out", default=None, help="where the details go; default build/tracing-SEED.json")
    options = parser.parse_args(argv)
    combinations = [(k, v) for k in options.kinds for v in ([3] if k == "odd" else options.levels)]
    extra = {"structure": options.structure, "plan": options.plan, "extras": not options.plain}
    jobs = [(options.seed + i, *combinations[i % len(combinations)], extra) for i in range(options.cases)]
    rows = []
    if options.jobs > 1:
        with ProcessPoolExecutor(options.jobs) as pool:
            for row in pool.map(run, jobs):
                rows.append(row)
                print(_short(row), flush=True)
    else:
        for job in jobs:
            rows.append(run(job))
            print(_short(rows[-1]), flush=True)
    target = Path(options.out) if options.out else ROOT / "build" / f"tracing-{options.seed}.json"
    target.parent.mkdir(parents=True, exist_ok=True)
    temporary = target.with_suffix(".part")
    temporary.write_text(json.dumps(rows, indent=1, default=str), encoding="utf-8")
    os.replace(temporary, target)
    print()
    print(table(rows))
    named = [r for r in rows if r["kind"] == "none" and r.get("said", {}).get("effects")]
    print(f"\nnull cases on which something was named: {len(named)} of {sum(r['kind'] == 'none' for r in rows)}")
    aliased = [r for r in rows if r.get("aliased")]
    print(f"aliased periods, and the answer says so: {sum(r['alias_said'] for r in aliased)} of {len(aliased)}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
