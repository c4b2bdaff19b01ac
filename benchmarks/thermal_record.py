# SPDX-License-Identifier: LGPL-2.1-or-later
"""A real record: 46 h of a spindle at a fixed position, traced on its first 60 % and judged on its last 40 %.

Prints for each displacement channel what was named, the verdict, and the plain rms of what is left on both parts.  The
record is not part of the project: give its path, or keep it in ../shared/data.

    python benchmarks/thermal_record.py [--channels 1 2 3 4 5] [--record fl_thermal_60s.csv]
"""

from __future__ import annotations

import argparse
import sys
import time
from dataclasses import replace
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from sensworkbench.closedloop.predict import predict  # noqa: E402
from sensworkbench.closedloop.trace import trace  # noqa: E402
from sensworkbench.core.joints import linear  # noqa: E402
from sensworkbench.core.machine import Machine  # noqa: E402
from sensworkbench.formats import readings_csv  # noqa: E402

RECORD = ROOT.parent / "shared" / "data" / "fl_thermal_60s.csv"
TRAINED = 0.6


def machine() -> Machine:
    """Any machine will do: the spindle stands still, and only what moves it along the channel shows."""
    axes = {k: linear(k, tuple(np.eye(3)[i]), (0.0, 0.0, 0.0), (-300.0, 300.0)) for i, k in enumerate("XYZ")}
    return Machine("fixed spindle", ("X",), ("Y", "Z"), axes, (0.0, 0.0, 0.0))


def load(record, channel: int):
    """Readings of one displacement channel along z, with every temperature and the spindle speed as columns."""
    mapping = {"x_mm": 0.0, "y_mm": 0.0, "z_mm": 0.0, "nx": 0.0, "ny": 0.0, "nz": 1.0}
    mapping |= {"reading_um": f"ch{channel}_um", "t_s": "time_s", "spindle_rpm": "spindle_rpm"}
    mapping |= {f"temp_t{i}_C": f"t{i}_degC" for i in range(1, 17)}
    readings = readings_csv.load(record, mapping)
    columns = {k: v for k, v in readings.columns.items() if not k.startswith("ch")}  # the other channels drive nothing
    return replace(readings, columns=columns)


def judge(record, channel: int) -> dict:
    """Trace the first part, predict the whole record (a lag needs its history), judge both parts (um)."""
    readings = load(record, channel)
    count = int(TRAINED * readings.points)
    begin = time.perf_counter()
    result = trace(machine(), readings.select(np.arange(count)))
    seconds = time.perf_counter() - begin
    left = 1e3 * (readings.value - predict(result.machine, readings)[readings.point, 2])
    rms = lambda v: float(np.sqrt((v**2).mean()))  # noqa: E731
    return {
        "channel": channel,
        "verdict": result.verdict,
        "effects": [f"{e.effect.component} by {e.effect.driver} ({e.effect.shape.name})" for e in result.effects],
        "spread_um": float(1e3 * readings.value.std()),
        "train_um": rms(left[:count]),
        "test_um": rms(left[count:]),
        "test_about_mean_um": float(left[count:].std()),
        "seconds": seconds,
    }


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--channels", type=int, nargs="*", default=[1, 2, 3, 4, 5])
    parser.add_argument("--record", type=Path, default=RECORD)
    options = parser.parse_args()
    if not options.record.exists():
        print(f"{options.record.name} is not here: give its path with --record")
        return 2
    print("channel  spread  train   test  about its mean    s  verdict            effects")
    for channel in options.channels:
        r = judge(options.record, channel)
        print(
            f"{channel:7d} {r['spread_um']:7.2f} {r['train_um']:6.2f} {r['test_um']:6.2f} "
            f"{r['test_about_mean_um']:15.2f} {r['seconds']:4.0f}  {r['verdict']:17s}  {'; '.join(r['effects']) or '-'}"
        )
    return 0


if __name__ == "__main__":
    sys.exit(main())
