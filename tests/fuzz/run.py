# SPDX-License-Identifier: LGPL-2.1-or-later
"""`make fuzz`: many random changes to valid files, each read and judged; the count is printed.

    python tests/fuzz/run.py [--inputs N] [--seed N] [--keep FOLDER]

Every input that is neither read nor refused properly is kept in FOLDER (default build/fuzz) and printed once per cause;
the exit status is then 1.
"""

from __future__ import annotations

import argparse
import hashlib
import random
import re
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))

from tests.fuzz import mutate, readers  # noqa: E402


def main() -> int:
    """Fuzz until the number of inputs is reached."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--inputs", type=int, default=500_000)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--keep", type=Path, default=ROOT / "build" / "fuzz")
    parser.add_argument("--kind", choices=sorted(mutate.SEEDS))
    given = parser.parse_args()
    kinds = [given.kind] if given.kind else sorted(mutate.SEEDS)
    rng = random.Random(given.seed)
    counts = {kind: [0, 0] for kind in kinds}
    causes: dict[str, int] = {}
    slowest, start = 0.0, time.time()
    shared = "/dev/shm" if Path("/dev/shm").is_dir() else None
    with tempfile.TemporaryDirectory(prefix="sens-fuzz-", dir=shared) as name:
        for i in range(given.inputs):
            kind = kinds[i % len(kinds)]
            data = mutate.changed(rng, rng.choice(mutate.SEEDS[kind]))
            begun = time.process_time()
            try:
                counts[kind][readers.judge(kind, data, Path(name))] += 1
            except readers.Fault as fault:
                cause = re.sub(r"[\d.]+|'.*?'|\".*?\"", "#", str(fault))[:160]
                causes[cause] = causes.get(cause, 0) + 1
                if causes[cause] == 1:
                    given.keep.mkdir(parents=True, exist_ok=True)
                    kept = given.keep / f"{kind.replace(' ', '-')}-{hashlib.sha256(data).hexdigest()[:12]}"
                    kept.write_bytes(data)
                    print(f"FAULT {fault}\n      {kept}", flush=True)
            took = time.process_time() - begun
            if took > slowest:
                slowest = took
                if took > 10:
                    causes[f"{kind}: {took:.0f} s"] = 1
            if (i + 1) % 50_000 == 0:
                print(f"{i + 1} inputs, {len(causes)} causes of faults, {time.time() - start:.0f} s", flush=True)
    for kind, (refused, accepted) in counts.items():
        print(f"{kind}: {accepted} read, {refused} refused")
    print(f"{given.inputs} inputs, seed {given.seed}, slowest {slowest:.2f} s, {sum(causes.values())} faults")
    return int(bool(causes))


if __name__ == "__main__":
    sys.exit(main())
