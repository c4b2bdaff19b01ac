# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every shape against its formula, written out row by row; drivers as values; no other module knows a shape's name."""

from __future__ import annotations

import ast
import math
from pathlib import Path

import numpy as np
import pytest

import sensworkbench
from sensworkbench.core.driver import Driver
from sensworkbench.core.effects import Effect
from sensworkbench.core.refusal import Refused
from sensworkbench.core.shapes import SHAPES, Linear, Regressor, Varying, shape_class

V = np.array([-4.0, -0.5, 0.0, 0.25, 3.0, 9.0, 2.0, 2.0, -7.0])
T = np.array([0.0, 3.0, 4.0, 60.0, 61.0, 200.0, 900.0, 900.0, 2500.0])


def legendre(n: int, x: float) -> float:
    """Bonnet's recursion."""
    a, b = 1.0, x
    for k in range(1, n):
        a, b = b, ((2 * k + 1) * x * b - k * a) / (k + 1)
    return b


def lagged(tau, state0):
    out = [state0]
    for i in range(1, len(V)):
        keep = math.exp(-(T[i] - T[i - 1]) / tau)
        out.append(V[i] * (1 - keep) + out[-1] * keep)
    return [[y] for y in out]


def played(width):
    out, nut = [], V[0]
    for v in V:
        nut = v - width if v - nut > width else v + width if nut - v > width else nut
        out.append([v - nut])
    return out


def bumped(count, low, high):
    rows = []
    for v in V:
        x = min(max((v - low) / (high - low), 0.0), 1.0)
        rows.append([math.exp(-(((x - k / (count - 1)) * (count - 1)) ** 2) / 2) for k in range(count)])
    return rows


FORMULAS = {
    "linear": ({}, [[v] for v in V]),
    "reversal": ({}, [[v] for v in V]),
    "polynomial": ({"degree": 4, "domain": (-7, 9)}, [[legendre(n, (v + 7) / 8 - 1) for n in (1, 2, 3, 4)] for v in V]),
    "periodic": ({"period": 5.0}, [[math.sin(2 * math.pi * v / 5), math.cos(2 * math.pi * v / 5)] for v in V]),
    "approach": ({"tau": 3.0}, [[1 - math.exp(-v / 3)] for v in V]),
    "step": ({"at": 2.0}, [[1.0 if v > 2 else 0.0] for v in V]),
    "lag": ({"tau": 150.0, "state0": 1.5}, lagged(150.0, 1.5)),
    "power": ({"exponent": 1.5}, [[math.copysign(abs(v) ** 1.5, v)] for v in V]),
    "hysteresis": ({"width": 1.25}, played(1.25)),
    "smooth": ({"bumps": (4,), "domains": ((-5.0, 5.0),)}, bumped(4, -5.0, 5.0)),
}


def test_every_shape_has_a_formula_here():
    assert set(FORMULAS) == set(SHAPES)


@pytest.mark.parametrize("name", FORMULAS)
def test_a_shape_is_its_formula(name):
    parameters, expected = FORMULAS[name]
    found = Regressor.make("v", name, **parameters)
    assert found.vectors({"v": V, "t": T}) == pytest.approx(np.array(expected), rel=1e-12, abs=1e-12)
    assert found.size == len(expected[0])
    assert set(found.columns) == ({"v", "t"} if name == "lag" else {"v"})
    assert found.shape == shape_class(name)(**parameters) and hash(found.shape) == hash(shape_class(name)(**parameters))


@pytest.mark.parametrize("name", FORMULAS)
def test_the_extremes_of_a_shape_hold_what_it_gives_over_a_range(name):
    parameters, expected = FORMULAS[name]
    shape = shape_class(name)(**parameters)
    coefficients = np.arange(1.0, shape.size + 1) * (-1) ** np.arange(shape.size)
    low, high = shape.extremes(coefficients, -7.0, 9.0)
    values = np.array(expected) @ coefficients
    slack = 0.01 * (high - low)
    assert low - slack <= values.min() and values.max() <= high + slack
    if not shape.memory:
        dense = Regressor(Driver(("v",)), shape).vectors({"v": np.linspace(-7, 9, 4001)}) @ coefficients
        assert (low, high) == pytest.approx((dense.min(), dense.max()), abs=slack)


@pytest.mark.parametrize(
    ("name", "parameters", "code"),
    [
        ("periodic", {"period": 0.0}, "parameter-not-above"),
        ("approach", {"tau": -0.01}, "parameter-not-above"),
        ("lag", {"tau": 0.0}, "parameter-not-above"),
        ("lag", {"tau": math.nan}, "parameter-not-finite"),
        ("power", {"exponent": 1000.0}, "parameter-out-of-range"),
        ("power", {"exponent": -1.0}, "parameter-not-above"),
        ("polynomial", {"degree": 31, "domain": (0, 1)}, "parameter-out-of-range"),
        ("polynomial", {"degree": 2.5, "domain": (0, 1)}, "parameter-not-whole"),
        ("polynomial", {"degree": 2, "domain": (1, 1)}, "parameter-no-length"),
        ("polynomial", {"degree": 2, "domain": (0, 1e-320)}, "parameter-no-length"),
        ("smooth", {"bumps": (200, 200), "domains": ((0, 1), (0, 1))}, "smooth-bumps"),
        ("smooth", {"bumps": (5, 5), "domains": ((0, 1),)}, "smooth-columns"),
        ("step", {}, "parameter-missing"),
        ("linear", {"tau": 3.0}, "parameter-unknown"),
        ("step", {"at": "x"}, "parameter-no-number"),
    ],
)
def test_parameters_out_of_bounds_are_refused(name, parameters, code):
    with pytest.raises(Refused) as refused:
        shape_class(name)(**parameters)
    assert refused.value.code == code


def test_an_unknown_shape_is_refused_with_the_known_ones():
    with pytest.raises(Refused) as refused:
        shape_class("magic", "here")
    assert (refused.value.code, refused.value.where) == ("shape-unknown", "here") and "linear" in refused.value.do


def test_a_shape_and_a_driver_do_not_change():
    with pytest.raises(AttributeError):
        shape_class("periodic")(period=3.0).period = 4.0
    with pytest.raises(AttributeError):
        Driver(("x",)).columns = ("y",)


# -- drivers ---------------------------------------------------------------------------------------------------------
def test_a_driver_is_a_value_whatever_the_order_of_its_columns():
    a, b = Driver.parse("x*temp_a*x"), Driver(("temp_a", "x", "x"))
    assert a == b and hash(a) == hash(b) and str(a) == "temp_a*x*x"
    assert (a.factors, a.names, a.repeats) == (3, ("temp_a", "x"), True)
    assert a.values({"x": np.array([2.0, 3.0]), "temp_a": np.array([5.0, -1.0])}).tolist() == [20, -9]
    assert (a.unit(), a.kinds, a.axes) == ("K*mm^2", {"temp", "place"}, {"X"})
    assert "x" in a and "y" not in a
    assert Driver.parse("gap*x").unit({"gap": "um"}) == "um*mm" and not Driver.parse("gap*x").known()


@pytest.mark.parametrize("text", ["", "a**b", " a", "a *b", "*".join(["x"] * 300)])
def test_what_is_no_driver_is_refused(text):
    with pytest.raises(Refused) as refused:
        Driver.parse(text, "there")
    assert refused.value.code in ("driver-column-name", "driver-factors") and refused.value.where == "there"


def test_a_missing_column_is_named():
    with pytest.raises(Refused) as refused:
        Driver.parse("temp_b*x").values({"x": V})
    assert (refused.value.code, refused.value.fields["column"]) == ("driver-column-missing", "temp_b")


# -- effects ---------------------------------------------------------------------------------------------------------
def test_an_effect_checks_the_number_of_its_coefficients():
    with pytest.raises(Refused) as refused:
        Effect("e", "EXX", "x", shape_class("periodic")(period=3.0), (1.0,))
    assert refused.value.code == "effect-coefficients-count"
    for value in (math.inf, math.nan, 1e300):
        with pytest.raises(Refused) as refused:
            Effect("e", "EXX", "x", Linear(), (value,))
        assert refused.value.code == "effect-coefficient-too-large"


def test_the_range_of_an_effect_is_as_stated_or_over_the_extent_of_its_driver():
    assert Effect("e", "EXX", "temp_a", Linear(), (2e-3,)).range is None
    assert Effect("e", "EXX", "temp_a", Linear(), (-2e-3,), extent=(-1, 4)).range == pytest.approx((-8e-3, 2e-3))
    assert Effect("e", "EXX", "temp_a", Linear(), (2e-3,), extent=(-1, 4), reach=(0, 1e-3)).range == (0, 1e-3)


def test_a_scan_takes_only_columns_that_vary():
    seen = Varying({"x": V, "t": T, "temp_a": V**2}, ["x", "temp_a"])
    for shape in SHAPES.values():
        for driver, start in shape.scan(seen):
            assert set(driver.columns) <= {"x", "temp_a"} and isinstance(start, shape)


# -- nobody asks by name ---------------------------------------------------------------------------------------------
PACKAGE = Path(sensworkbench.__file__).parent
OWN = PACKAGE / "core" / "shapes"


def asked_by_name(text: str):
    """(line, name) of comparisons, membership tests and look-ups of a shape's name."""
    for node in ast.walk(ast.parse(text)):
        sides = []
        if isinstance(node, ast.Compare):
            sides = [node.left, *node.comparators]
        elif isinstance(node, ast.Subscript) and "SHAPES" in ast.unparse(node.value):
            sides = [node.value, node.slice]
        elif isinstance(node, ast.Match):
            sides = [node.subject, *(c.pattern.value for c in node.cases if isinstance(c.pattern, ast.MatchValue))]
        if "shape" not in " ".join(ast.unparse(s) for s in sides).lower():
            continue
        for side in sides:
            for part in side.elts if isinstance(side, (ast.Tuple, ast.List, ast.Set)) else [side]:
                if isinstance(part, ast.Constant) and part.value in SHAPES:
                    yield node.lineno, part.value


def test_a_comparison_with_the_name_of_a_shape_is_found():
    assert list(asked_by_name("if c.shape.name == 'lag':\n  pass")) == [(1, "lag")]
    assert list(asked_by_name("if effect.shape in ('linear', 'reversal'):\n  pass")) == [(1, "linear"), (1, "reversal")]
    assert list(asked_by_name("SHAPES['step']")) == [(1, "step")]
    assert not list(asked_by_name("if kind == 'linear':\n  pass"))  # of a joint


def test_no_other_module_compares_the_name_of_a_shape():
    found = [
        f"{path.relative_to(PACKAGE)}:{line} {name}"
        for path in sorted(PACKAGE.rglob("*.py"))
        if OWN not in path.parents
        for line, name in asked_by_name(path.read_text(encoding="utf-8"))
    ]
    assert found == []


def test_only_the_driver_takes_its_text_apart():
    found = [
        str(path.relative_to(PACKAGE))
        for path in sorted(PACKAGE.rglob("*.py"))
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, ast.Call) and ast.unparse(node.func).endswith((".split", ".partition"))
        if node.args and isinstance(node.args[0], ast.Constant) and node.args[0].value == "*"
    ]
    assert set(found) == {"core/driver.py"}
