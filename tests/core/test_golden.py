# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers known exactly: two small problems in fractions, the golden points, and the paper's tolerances at a point."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from numpy.testing import assert_allclose

from sensworkbench.core import sobol, synthesis
from sensworkbench.core.distributions import moments, paper_tolerance
from sensworkbench.core.errors import PAPER_SYMBOLS
from tests.core.support import UM, URAD, machine, uniform

# T1 = X1 - X2/5, T2 = X2/10 + X3
SMALL = np.array([[1, -1 / 5, 0], [0, 1 / 10, 1], [0, 0, 0]])
F = Fraction


@pytest.mark.parametrize(
    "lower, upper, mean, variance, first, total",
    [
        (
            (-1, -20, -5),
            (1, 20, 5),
            F(46, 3),
            F(6424, 45),
            (F(1, 1606), F(200, 803), F(625, 1606)),
            (F(81, 1606), F(490, 803), F(1125, 1606)),
        ),
        (
            (0, -10, -5),
            (2, 30, 5),
            None,
            F(10144, 45),
            (F(2, 317), F(235, 634), F(125, 317)),
            (F(12, 317), F(190, 317), F(375, 634)),
        ),
    ],
    ids=["symmetric", "asymmetric"],
)
def test_indices_are_the_exact_fractions(lower, upper, mean, variance, first, total):
    found = sobol.indices(SMALL, moments(uniform(lower, upper)))
    assert_allclose(found.first[0], [float(f) for f in first], rtol=1e-13)
    assert_allclose(found.total[0], [float(f) for f in total], rtol=1e-13)
    assert found.variance[0] == pytest.approx(float(variance), rel=1e-13)
    if mean is not None:
        assert found.mean[0] == pytest.approx(float(mean), rel=1e-14)


def test_mean_of_the_asymmetric_problem_is_the_sum_of_squares_of_means_and_variances():
    # E[T1] = 1 - 2, V(T1) = 1/3 + (1/25) 400/3; E[T2] = 1, V(T2) = (1/100) 400/3 + 25/3
    exact = F(1) + F(1, 3) + F(1, 25) * F(400, 3) + F(1) + F(4, 3) + F(25, 3)
    found = sobol.indices(SMALL, moments(uniform((0, -10, -5), (2, 30, 5))))
    assert found.mean[0] == pytest.approx(float(exact), rel=1e-14)


# -- golden points --------------------------------------------------------------
Q = (200.0, 150.0, -100.0)
VALUES = {
    **{"EXX": 1, "EYX": 5, "EZX": -3, "EXY": 4, "EYY": -1, "EZY": 2, "EXZ": -2, "EYZ": 3, "EZZ": 0.5},
    **{"EAX": 10, "EBX": -15, "ECX": 20, "EAY": -5, "EBY": 12, "ECY": 8, "EAZ": 6, "EBZ": -9, "ECZ": 4},
    **{"C0Y": 20, "A0Z": -15, "B0Z": 10},
}
IN_MM_AND_RAD = {s: v * (UM if s[1] in "XYZ" else URAD) for s, v in VALUES.items()}
REFERENCES = {"X": (30, -180, 200), "Y": (-60, -200, 100), "Z": (15, 100, 600)}
GOLDEN = {
    ("FXYZ", False): (-1.260, 7.970, 0.900),
    ("YFXZ", False): (0.540, 9.570, -3.750),
    ("XYFZ", False): (-2.460, 11.970, 3.150),
    ("XFYZ", False): (-1.260, 11.970, 3.900),
    ("FXYZ", True): (1.140, 12.890, -0.205),
    ("YFXZ", True): (2.940, 14.490, -4.855),
    ("XYFZ", True): (-0.060, 16.890, 2.045),
    ("XFYZ", True): (1.140, 16.890, 2.795),
}


@pytest.mark.parametrize("code, with_references", GOLDEN)
def test_volumetric_error_at_the_golden_point(code, with_references):
    m = machine(code, (10, -20, -150), REFERENCES if with_references else {})
    found = synthesis.volumetric_error(m, IN_MM_AND_RAD, Q)[0]
    assert_allclose(found / UM, GOLDEN[code, with_references], atol=1e-9)


@pytest.mark.parametrize("code", ["FXYZ", "YFXZ", "XYFZ", "XFYZ"])
def test_carried_squareness_adds_the_turn_of_what_the_guide_carries(code):
    """+s x r for an axis on the tool side, -s x r for one on the workpiece side, and nothing else."""
    tilt = machine(code, (10, -20, -150), REFERENCES)
    carried = machine(code, (10, -20, -150), REFERENCES, squareness="carried")
    expected = synthesis.volumetric_error(tilt, IN_MM_AND_RAD, Q)[0]
    s = {"Y": (0, 0, 20 * URAD), "Z": (-15 * URAD, 10 * URAD, 0)}
    for k in "YZ":
        side = -1 if k in tilt.workpiece_chain else 1
        expected = expected + side * np.cross(s[k], tilt.lever_arms(Q)[k][0])
    assert_allclose(synthesis.volumetric_error(carried, IN_MM_AND_RAD, Q)[0], expected, atol=1e-15)


def test_carried_squareness_in_numbers():
    """FXYZ, references at 0: Z carries t = (10, -20, -150); Y carries t and z: (10, -20, -250)."""
    m = machine("FXYZ", (10, -20, -150), squareness="carried")
    # C0Y (0,0,20) x (10,-20,-250) = (400, 200, 0); (A0Z, B0Z) (-15,10,0) x (10,-20,-150) = (-1500, -2250, 200) nm
    found = synthesis.volumetric_error(m, IN_MM_AND_RAD, Q)[0] / UM
    assert_allclose(found, np.add((-1.260, 7.970, 0.900), (0.4 - 1.5, 0.2 - 2.25, 0.2)), atol=1e-9)


@pytest.mark.parametrize("name", ["E_C0Y", "s_xy", "E_C(0X)Y", "c0y"])
def test_squareness_goes_by_several_names(name):
    m = machine("FXYZ")
    assert_allclose(synthesis.omega(m, [name], Q), synthesis.omega(m, ["C0Y"], Q))


# -- the paper's tolerances at one point --------------------------------------------------------------
BOTH = {  # S, S^T
    ("EAX",): (0.0144, 0.1874),
    ("EXY", "EBX", "EBY", "EXZ"): (0.0078, 0.1801),
    ("EAY", "EYZ", "EYX"): (0.0078, 0.1522),
    ("ECX", "EBZ", "C0Y"): (0.0010, 0.0720),
}
TOTAL_ONLY = {
    ("EZX", "EZY"): 0.0625,
    ("EAZ",): 0.0619,
    ("B0Z", "EXT"): 0.0330,
    ("A0Z", "EYT"): 0.0285,
    ("EXX",): 0.0084,
    ("EYY",): 0.0073,
    ("EZZ",): 0.0037,
    ("EZT",): 0.0009,
    ("ECY", "ECZ"): 0.0,
}


@pytest.fixture(scope="module")
def at_the_point():
    law = moments([paper_tolerance(s) for s in PAPER_SYMBOLS])
    return sobol.indices(synthesis.omega(machine("FXYZ"), PAPER_SYMBOLS, Q), law)


def test_paper_tolerances_at_one_point(at_the_point):
    first, total = (dict(zip(PAPER_SYMBOLS, x[0])) for x in (at_the_point.first, at_the_point.total))
    assert at_the_point.mean[0] == pytest.approx(1.0475e-4, rel=1e-7)
    assert at_the_point.variance[0] == pytest.approx(7.154850e-9, rel=1e-6)
    assert sum(first.values()) == pytest.approx(0.0891, abs=5e-5)
    for symbols, (s, st) in BOTH.items():
        for symbol in symbols:
            assert first[symbol] == pytest.approx(s, abs=5e-5), symbol
            assert total[symbol] == pytest.approx(st, abs=5e-5), symbol
    for symbols, st in TOTAL_ONLY.items():
        for symbol in symbols:
            assert total[symbol] == pytest.approx(st, abs=5e-5), symbol


def test_the_table_covers_all_24_errors():
    named = [s for group in [*BOTH, *TOTAL_ONLY] for s in group]
    assert sorted(named) == sorted(PAPER_SYMBOLS)


def test_nearly_all_variance_is_interaction_there(at_the_point):
    assert at_the_point.total[0].sum() > 20 * at_the_point.first[0].sum()
