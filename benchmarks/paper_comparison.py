# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the paper prints and what is right, in numbers: eq. (18), and its finding under both conventions of squareness.

Run `python benchmarks/paper_comparison.py`; docs/theory.md quotes what it prints.  The machine is a C-frame vertical
machining centre of usual size; the paper's own offsets exist only as a picture, so its Fig. 3 cannot be repeated
digit for digit.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from sensworkbench.core import sobol, synthesis, workspace
from sensworkbench.core.distributions import Tolerance, moments
from sensworkbench.core.joints import linear
from sensworkbench.core.machine import Machine, structure_chains

SMALL = np.array([[1, -1 / 5, 0], [0, 1 / 10, 1], [0, 0, 0]])  # T1 = X1 - X2/5, T2 = X2/10 + X3
LIMITS = {"symmetric": ((-1, -20, -5), (1, 20, 5)), "asymmetric": ((0, -10, -5), (2, 30, 5))}
SQUARENESS, STRAIGHTNESS = ("C0Y", "A0Z", "B0Z"), ("EYX", "EZX", "EXY", "EZY", "EXZ", "EYZ")
KINDS = {
    "squareness": SQUARENESS,
    "angular": tuple(f"E{a}{k}" for k in "XYZ" for a in "ABC"),
    "straightness": STRAIGHTNESS,
    "linear displacement": ("EXX", "EYY", "EZZ"),
    "spindle": ("EXT", "EYT", "EZT"),
}


def machine(squareness: str) -> Machine:
    """XYFZ: table X on saddle Y, head Z on a column behind the table; the paper's tolerances by default."""
    workpiece_chain, tool_chain = structure_chains("XYFZ")
    axes = {
        "X": linear("X", (1, 0, 0), (0, 0, -120), (-300, 300)),  # guide blocks under the table
        "Y": linear("Y", (0, 1, 0), (0, 0, -250), (-200, 200)),  # guide blocks under the saddle
        "Z": linear("Z", (0, 0, 1), (0, 450, 500), (-150, 150)),  # guide blocks on the column's face
    }
    return Machine("C frame", workpiece_chain, tool_chain, axes, (0, 0, 200), squareness=squareness)


def small_problem() -> list[str]:
    lines = ["T1 = X1 - X2/5, T2 = X2/10 + X3, Y = T1^2 + T2^2"]
    for name, (lower, upper) in LIMITS.items():
        right = sobol.indices(SMALL, moments([Tolerance(a, b) for a, b in zip(lower, upper)]))
        printed, variance = sobol.paper_eq18(SMALL, lower, upper)
        rest = right.variance[0] * (1 - right.total[0])  # V(E(Y|X_~j))
        lines += [
            "",
            f"{name}: X1, X2, X3 uniform on " + ", ".join(f"[{a:g}, {b:g}]" for a, b in zip(lower, upper)),
            f"  V(Y) = {right.variance[0]:.4f}; eq. (15a) gives {variance:.4f}",
            f"  {'':4}{'S':>10}{'S^T':>10}{'V(E(Y|X_~j))':>16}{'eq. (18)':>12}",
        ]
        for j in range(3):
            s, t, p = right.first[0, j], right.total[0, j], printed[j]
            lines.append(f"  X{j + 1:<3}{s:10.4f}{t:10.4f}{rest[j]:16.4f}{p:12.4f}")
    lower, upper = LIMITS["asymmetric"]
    only_t1 = SMALL * np.array([[1], [0], [0]])
    right = sobol.indices(only_t1, moments([Tolerance(a, b) for a, b in zip(lower, upper)]))
    printed, variance = sobol.paper_eq18(only_t1, lower, upper)
    own, half = right.first[0, 1] * right.variance[0], (1 - printed[1]) * variance
    lines += ["", f"asymmetric, T1 alone: V(E(T1^2|X2)) = {own:.4f}; eq. (16b) gives {half:.4f}"]
    return lines


def at_a_position(q=(200.0, 150.0, -100.0)) -> list[str]:
    """Printed and right total indices of the 24 errors at one position, largest first."""
    m = machine("direction")
    table = m.all_tolerances
    omega = synthesis.omega(m, list(table), q)[0]
    right = sobol.indices(omega, moments(table.values()))
    lower, upper = ([getattr(t, k) for t in table.values()] for k in ("lower", "upper"))
    printed, variance = sobol.paper_eq18(omega, lower, upper)
    order = np.argsort(-right.total[0])
    place = np.empty(len(order), dtype=int)
    place[np.argsort(-printed, kind="stable")] = np.arange(1, len(order) + 1)
    lines = [
        f"The machine at {q}, squareness as direction: V by eq. (15a) is {variance / right.variance[0]:.4f} of V(Y);",
        f"the sum of S is {right.first[0].sum():.4f}: nearly all variance is interaction",
        "",
        f"  {'place':>5} {'error':8}{'S':>10}{'S^T':>10}{'eq. (18)':>12}{'its place there':>18}",
    ]
    for i in [*range(6), *range(len(order) - 3, len(order))]:
        j = order[i]
        numbers = f"{right.first[0, j]:10.4f}{right.total[0, j]:10.4f}{printed[j]:12.4f}{place[j]:18d}"
        lines.append(f"  {i + 1:5d} {list(table)[j]:8}{numbers}")
    return lines


def finding() -> list[str]:
    """The paper's finding over the workspace, with both conventions."""
    results = {c: workspace.sensitivity(machine(c)) for c in ("direction", "carried")}
    lines = ["Mean S^T over the workspace (quadrature of 8 x 8 x 8), paper's tolerances", ""]
    lines.append(f"  {'':4}{'squareness as direction (ISO)':32}{'squareness carried'}")
    ranked = {c: sorted(zip(r.total, r.symbols), reverse=True) for c, r in results.items()}
    for i in range(8):
        cells = [f"{s:6}{t:8.4f}" for t, s in (ranked[c][i] for c in results)]
        lines.append(f"  {i + 1:<4}{cells[0]:32}{cells[1]}")
    lines += ["", f"  {'largest of its kind':24}{'direction':>20}{'carried':>20}"]
    for kind, symbols in KINDS.items():
        cells = []
        for r in results.values():
            table = dict(zip(r.symbols, r.total))
            best = max(symbols, key=table.get)
            cells.append(f"{best} {table[best]:.4f}")
        lines.append(f"  {kind:24}{cells[0]:>20}{cells[1]:>20}")
    errors = ", ".join(f"{c} {r.estimated_error:.0e}" for c, r in results.items())
    return [*lines, "", f"  estimated error of these means: {errors}"]


def main() -> int:
    parts = (("1. A small problem", small_problem), ("2. At one position", at_a_position), ("3. The finding", finding))
    print("\n\n".join("\n".join([title, "-" * len(title), *part()]) for title, part in parts))
    return 0


if __name__ == "__main__":
    sys.exit(main())
