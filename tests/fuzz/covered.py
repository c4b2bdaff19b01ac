# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bytes chosen by the branches that they reach (atheris), for every reader; part of `make fuzz` where it is installed.

    python tests/fuzz/covered.py [--runs N] [--seed N] [--kind KIND]

It begins with the valid files of `mutate` and the corpus.  The first byte of an input says which reader it is for.  An
input that is neither read nor refused properly ends the run with status 77 and is kept in build/fuzz.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))


def main() -> int:
    """Fuzz until the number of runs is reached; 0 with a word where atheris is not installed."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--runs", type=int, default=100_000)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--kind", help="of the files, as in mutate.SEEDS (default: all)")
    given = parser.parse_args()
    try:
        import atheris
    except ImportError:
        print("bytes by branches: left out, atheris is not installed")
        return 0
    with atheris.instrument_imports(include=["sensworkbench"]):
        from tests.fuzz import mutate, readers
    kinds = [given.kind] if given.kind else sorted(mutate.SEEDS)
    kept = ROOT / "build" / "fuzz"
    kept.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix="sens-fuzz-") as name:
        folder, begin = Path(name), Path(name) / "begin"
        begin.mkdir()
        for k, kind in enumerate(kinds):
            for i, data in enumerate(mutate.SEEDS[kind]):
                data = data if isinstance(data, bytes) else data.encode()
                (begin / f"{k}-{i}").write_bytes(bytes([k]) + data)

        def judged(data: bytes) -> None:
            if data:
                readers.judge(kinds[data[0] % len(kinds)], data[1:], folder)

        options = [f"-runs={given.runs}", f"-seed={given.seed or 1}", "-max_len=20000", "-timeout=20"]
        atheris.Setup([sys.argv[0], *options, f"-artifact_prefix={kept}/", str(begin)], judged)
        atheris.Fuzz()
    return 0


if __name__ == "__main__":
    sys.exit(main())
