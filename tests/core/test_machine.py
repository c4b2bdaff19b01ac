# SPDX-License-Identifier: LGPL-2.1-or-later
"""Impossible machines are refused with what is wrong, where, and what to do; names of errors and units."""

from __future__ import annotations

import math

import numpy as np
import pytest

from sensworkbench.core import units
from sensworkbench.core.errors import COMPONENTS, DECLARED_SYMBOLS, PAPER_SYMBOLS, component
from sensworkbench.core.joints import linear
from sensworkbench.core.machine import Machine
from sensworkbench.core.refusal import Refused
from tests.core.support import machine


def axis(name="X", direction=(1, 0, 0), reference=(0, 0, 0), travel=(0, 100)):
    return linear(name, direction, reference, travel)


def assert_refused(make, words, where):
    with pytest.raises(Refused) as refusal:
        make()
    assert words in refusal.value.what
    assert refusal.value.where == where
    assert refusal.value.message.startswith(f"{where}: ") and refusal.value.message.endswith((".", "!", "?"))


@pytest.mark.parametrize(
    "change, words, where",
    [
        ({"name": "U"}, "the name U is taken", "axis U"),
        ({"name": "XX"}, "'XX' is not the name of an axis", "axis XX"),
        ({"direction": (2, 0, 0)}, "has length 2", "axis X, direction"),
        ({"direction": (0, 0, 0)}, "has length 0", "axis X, direction"),
        ({"direction": (0.99, 0, 0)}, "has length 0.99", "axis X, direction"),
        ({"direction": (math.nan, 0, 1)}, "is not finite", "axis X, direction"),
        ({"direction": (1, 0)}, "is not a vector of three numbers", "axis X, direction"),
        ({"direction": "100"}, "is not a vector of three numbers", "axis X, direction"),
        ({"direction": (True, 0, 0)}, "is not a vector of three numbers", "axis X, direction"),
        ({"direction": None}, "is not a vector of three numbers", "axis X, direction"),
        ({"direction": 5}, "is not a vector of three numbers", "axis X, direction"),
        ({"reference": (0, math.inf, 0)}, "is not finite", "axis X, reference"),
        ({"reference": ("a", 0, 0)}, "is not a vector of three numbers", "axis X, reference"),
        ({"travel": (100, 100)}, "travel from 100 to 100 mm has no length", "axis X, travel"),
        ({"travel": (100, 0)}, "travel from 100 to 0 mm has no length", "axis X, travel"),
        ({"travel": (0, math.inf)}, "travel is not finite", "axis X, travel"),
        ({"travel": (math.nan, 1)}, "travel is not finite", "axis X, travel"),
        ({"travel": (0, 1, 2)}, "is not [lowest, highest]", "axis X, travel"),
        ({"travel": None}, "is not [lowest, highest]", "axis X, travel"),
    ],
)
def test_impossible_axes_are_refused(change, words, where):
    assert_refused(lambda: axis(**change), words, where)


AXES = {
    "X": axis(),
    "Y": axis("Y", (0, 1, 0)),
    "Z": axis("Z", (0, 0, 1)),
}
CHAINS = "workpiece_chain / tool_chain"


def build(workpiece=("Y", "X"), tool=("Z",), axes=None, tool_point=(0, 0, 0), **more):
    return Machine("test", workpiece, tool, AXES if axes is None else axes, tool_point, **more)


@pytest.mark.parametrize(
    "change, words, where",
    [
        ({"workpiece": ("Y", "X"), "tool": ("X", "Z")}, "axis X appears twice", CHAINS),
        ({"workpiece": ("Y", "Y"), "tool": ("X", "Z")}, "axis Y appears twice", CHAINS),
        ({"workpiece": ("Y",), "tool": ("Z",)}, "axis X is in neither chain", CHAINS),
        ({"workpiece": (), "tool": ()}, "axis X is in neither chain", CHAINS),
        ({"workpiece": ("Y", "X", "C")}, "unknown axis 'C' in a chain", CHAINS),
        ({"axes": {k: AXES[k] for k in "XY"}}, "unknown axis 'Z' in a chain", CHAINS),
        ({"tool_point": (0, 0, math.nan)}, "is not finite", "tool_point"),
        ({"tool_point": None}, "is not a vector of three numbers", "tool_point"),
        ({"spindle_reference": (0, 0)}, "is not a vector of three numbers", "spindle_reference"),
        ({"workpiece_reference": (0, math.inf, 0)}, "is not finite", "workpiece_reference"),
        ({"squareness": "rotation"}, "unknown convention 'rotation'", "squareness"),
    ],
)
def test_impossible_machines_are_refused(change, words, where):
    assert_refused(lambda: build(**change), words, where)


def test_machine_that_can_be_is_accepted():
    assert build().structure == "XYFZ"


def test_an_outer_place_is_put_before_the_inner_one():
    refusal = Refused("sigma-not-positive", "axis X", sigma=-1).at("machine.json")
    assert refusal.message == "machine.json: axis X: sigma -1 is not positive. Give a number above zero."


# -- names --------------------------------------------------------------
def test_there_are_21_declared_errors_and_24_of_the_paper_and_33_in_all():
    assert (len(DECLARED_SYMBOLS), len(PAPER_SYMBOLS), len(COMPONENTS)) == (21, 24, 33)


@pytest.mark.parametrize(
    "alias, symbol",
    [
        ("delta_xx", "EXX"),
        ("δ_zy", "EZY"),
        ("epsilon_yz", "EBZ"),
        ("ε_xx", "EAX"),
        ("δ_yt", "EYT"),
        ("XT", "EXT"),
        ("s_xz", "B0Z"),
        ("s_yz", "A0Z"),
        ("S_XY", "C0Y"),
        ("E_B0Z", "B0Z"),
        (" eax ", "EAX"),
    ],
)
def test_aliases_of_the_paper_and_of_the_standard(alias, symbol):
    assert component(alias).symbol == symbol


def test_no_alias_stands_for_two_errors():
    aliases = [c.alias for c in COMPONENTS.values() if c.alias]
    assert len(set(aliases)) == len(aliases)


@pytest.mark.parametrize("symbol", ["", "EAQ", "EX", "EXXX", "A0Y", "E_", "nan", None, 3])
def test_unknown_errors_are_refused_by_name(symbol):
    assert_refused(lambda: component(symbol, "tolerances"), f"unknown error {symbol!r}", "tolerances")


def test_descriptions_tell_all_errors_apart():
    texts = {str(c.title) for c in COMPONENTS.values()}
    assert len(texts) == len(COMPONENTS)
    assert str(component("EAX").title) == "roll of X about X"
    assert str(component("EYX").title) == "straightness of X along Y"
    assert str(component("A0Z").title) == "squareness of Z to Y"


# -- units --------------------------------------------------------------
@pytest.mark.parametrize(
    "text, angular, value",
    [
        ("5 µm", False, 5e-3),
        ("5um", False, 5e-3),
        ("-0.5", False, -0.5e-3),
        ("1,5 mm", False, 1.5),
        ("2e-3 mm", False, 2e-3),
        ("0.001 in", False, 0.0254),
        ("20 urad", True, 2e-5),
        ("20 µrad", True, 2e-5),
        ("1 arcsec", True, math.pi / 648000),
        ("+3", True, 3e-6),
        ("20 um/m", True, 2e-5),
        (".1 deg", True, math.pi / 1800),
    ],
)
def test_numbers_with_units(text, angular, value):
    default = "urad" if angular else "um"
    assert units.parse(text, angular=angular, default_unit=default) == pytest.approx(value, rel=1e-14)
    for unit in units.ANGLE if angular else units.LENGTH:
        shown = units.shown(value, unit, angular=angular)
        assert shown * units.factor(unit, angular=angular) == pytest.approx(value, rel=1e-14)


@pytest.mark.parametrize(
    "text, angular",
    [("5 mm", True), ("5 urad", False), ("five", False), ("", False), ("1e999", False), ("nan", False)],
)
def test_numbers_that_are_not_are_refused_in_place(text, angular):
    with pytest.raises(Refused) as refusal:
        units.parse(text, angular=angular, default_unit="um", where="row 3")
    assert refusal.value.where == "row 3"


def test_machine_given_by_lists_and_arrays_is_the_same_machine():
    by_array = machine("XYFZ", tool_point=np.array([0, 0, -150.0]))
    assert by_array == machine("XYFZ", tool_point=[0, 0, -150])
    assert by_array.tool_point == (0.0, 0.0, -150.0)
