# SPDX-License-Identifier: LGPL-2.1-or-later
"""Effects of machine.json: units are converted or refused where they stand, parameters are checked on reading."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from sensworkbench.closedloop.predict import predict
from sensworkbench.closedloop.readings import Readings
from sensworkbench.core import workspace
from sensworkbench.core.effects import Effect
from sensworkbench.core.fitted import FittedModel
from sensworkbench.core.refusal import Refused
from sensworkbench.core.shapes import SHAPES, Linear, Smooth, shape_class
from sensworkbench.core.unit_text import conversion
from sensworkbench.formats import effects_json, machine_json, sensitivity_csv, sensitivity_json
from sensworkbench.formats.sensitivity_html import sensitivity_report
from sensworkbench.studies.sensitivity import SensitivityRequest, sensitivity_study

EXAMPLES = Path(__file__).resolve().parents[2] / "resources" / "examples"
BASE = {
    1: json.loads((EXAMPLES / "vertical_machining_centre.json").read_text(encoding="utf-8")),
    2: json.loads((EXAMPLES / "trunnion.json").read_text(encoding="utf-8")),
}


def entry(component="EXX", driver="dir_x", shape="reversal", extent=None, **parameters) -> dict:
    found = {"name": "e", "component": component, "driver": driver, "shape": shape, "parameters": parameters}
    return found if extent is None else found | {"extent": extent}


def machine(*effects, version=1):
    return machine_json.loads(json.dumps(BASE[version] | {"effects": list(effects)}), "m.json")


def read(*args, version=1, **kwargs) -> Effect:
    return machine(entry(*args, **kwargs), version=version).effects[0]


def refused(*args, version=1, **kwargs) -> Refused:
    with pytest.raises(Refused) as found:
        machine(entry(*args, **kwargs), version=version)
    assert found.value.where.startswith("m.json, line ") or "effects[0]" in found.value.where
    return found.value


# -- units -----------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize(
    ("component", "driver", "shape", "unit", "factor"),
    [
        ("EXX", "dir_x", "reversal", "mm", 1.0),
        ("EXX", "dir_x", "reversal", "um", 1e-3),
        ("EXX", "dir_x", "reversal", "in", 25.4),
        ("EAZ", "temp_a", "linear", "urad/K", 1e-6),
        ("EAZ", "temp_a", "linear", "rad/K", 1.0),
        ("EAZ", "temp_a", "linear", "arcsec/K", math.pi / 648000),
        ("EAZ", "temp_a", "linear", "urad/°C", 1e-6),
        ("EAZ", "temp_a", "linear", "urad/degF", 1.8e-6),
        ("EAZ", "temp_a", "linear", "um/m/K", 1e-6),
        ("EXX", "temp_a*x", "linear", "um/(K*mm)", 1e-3),
        ("EXX", "temp_a*x", "linear", "um/(m*K)", 1e-6),
        ("EXX", "temp_a*x", "linear", "um/K/mm", 1e-3),
        ("EXX", "x*z", "linear", "um/mm^2", 1e-3),
        ("EXX", "feed", "linear", "um/mm/min", 1e-3),  # as it was written until now
        ("EXX", "feed", "linear", "um/(mm/min)", 1e-3),
        ("EXX", "feed", "linear", "um/(m/min)", 1e-6),
        ("EXX", "spindle", "linear", "um/rpm", 1e-3),
        ("EXX", "load_table", "linear", "um/kg", 1e-3),
        ("EXX", "t", "linear", "um/min", 1e-3 / 60),
        ("EXX", "gap", "linear", "um/mm", 1e-3),
        ("EXX", "gap", "linear", "um/um", 1.0),
        ("EXX", "pressure", "linear", "mm/bar", 1.0),  # nobody knows what the column holds
        ("C0Y", "temp_a", "linear", "mrad/K", 1e-3),
    ],
)
def test_the_unit_of_a_coefficient_counts(component, driver, shape, unit, factor):
    for value, u in (([3.0], [0.5]), (3.0, 0.5)):
        effect = read(component, driver, shape, coefficient={"value": value, "unit": unit, "u": u})
        assert effect.coefficients == pytest.approx((3 * factor,), rel=1e-12)
        assert effect.u == pytest.approx((0.5 * factor,), rel=1e-12)


@pytest.mark.parametrize(
    ("component", "driver", "shape", "unit", "code"),
    [
        ("EXX", "dir_x", "reversal", "furlong", "unit-unknown"),
        ("EXX", "dir_x", "reversal", "urad", "unit-of-another-kind"),
        ("EXX", "dir_x", "reversal", "um/K", "unit-of-another-kind"),
        ("EAZ", "temp_a", "linear", "um/K", "unit-of-another-kind"),
        ("EAZ", "temp_a", "linear", "urad", "unit-of-another-kind"),
        ("EAZ", "temp_a", "linear", "nonsense", "unit-unknown"),
        ("EAZ", "temp_a", "linear", "urad/(K", "unit-unknown"),
        ("EAZ", "temp_a", "linear", "urad/K" * 40, "unit-unknown"),
        ("EXX", "gap", "linear", "furlong/mm", "unit-unknown"),
        ("EXX", "temp_a*x", "linear", "um/K", "unit-of-another-kind"),
    ],
)
def test_a_unit_of_another_kind_is_refused_with_its_place(component, driver, shape, unit, code):
    found = refused(component, driver, shape, coefficient={"value": 1, "unit": unit})
    assert found.code == code and found.where.endswith("effects[0].parameters.coefficient.unit")
    for language in ("de", "ko"):
        assert found.text(language) != found.text("en")


def test_a_bare_number_counts_in_um_or_urad():
    assert read("EAZ", "temp_a", "linear", coefficient=2.5).coefficients == pytest.approx((2.5e-6,), rel=1e-15)
    assert read("EXX", "temp_a", "linear", coefficient={"value": 2.5}).coefficients == (2.5e-3,)


@pytest.mark.parametrize(
    ("driver", "shape", "name", "given", "expected"),
    [
        ("t", "approach", "tau", {"value": 1, "unit": "min"}, 60.0),
        ("t", "approach", "tau", {"value": 1, "unit": "h"}, 3600.0),
        ("temp_a", "lag", "tau", {"value": 1, "unit": "min"}, 60.0),
        ("x", "periodic", "period", {"value": 1, "unit": "in"}, 25.4),
        ("x", "periodic", "period", {"value": 10}, 10.0),
        ("x", "periodic", "period", 10, 10.0),
        ("x", "hysteresis", "width", {"value": 20, "unit": "um"}, 0.02),
        ("t", "step", "at", {"value": 2, "unit": "h"}, 7200.0),
        ("temp_a", "step", "at", {"value": 25, "unit": "C"}, 5.0),  # a temperature, counted from 20 degC
        ("temp_a", "step", "at", {"value": 77, "unit": "°F"}, 5.0),
        ("temp_a", "step", "at", {"value": 5, "unit": "K"}, 5.0),
        ("temp_a", "hysteresis", "width", {"value": 9, "unit": "°F"}, 5.0),  # a difference
        ("temp_a", "power", "exponent", {"value": 1.5}, 1.5),
        ("temp_a", "polynomial", "domain", {"value": [20, 30], "unit": "degC"}, (0.0, 10.0)),
        ("x", "polynomial", "domain", {"value": [-0.2, 0.2], "unit": "m"}, (-200.0, 200.0)),
        ("gap", "periodic", "period", {"value": 2, "unit": "um"}, 0.002),
    ],
)
def test_the_unit_of_a_parameter_of_a_shape_counts(driver, shape, name, given, expected):
    size = 2 if shape in ("periodic", "polynomial") else 1
    effect = read("EXX", driver, shape, coefficient={"value": [1.0] * size}, **{name: given})
    assert effect.shape.values[name] == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize(
    ("driver", "shape", "name", "unit"),
    [
        ("t", "approach", "tau", "mm"),
        ("temp_a", "lag", "tau", "K"),
        ("x", "periodic", "period", "s"),
        ("x", "periodic", "period", "cubit"),
        ("temp_a", "power", "exponent", "K"),
        ("x", "step", "at", "C"),
    ],
)
def test_a_parameter_in_a_unit_of_another_kind_is_refused_with_its_place(driver, shape, name, unit):
    found = refused("EXX", driver, shape, coefficient={"value": [1.0]}, **{name: {"value": 1, "unit": unit}})
    assert found.code.startswith("unit-") and found.where.endswith(f"effects[0].parameters.{name}.unit")


def test_the_range_of_a_component_has_a_unit_too():
    assert read(coefficient=1, extent=None) and read(coefficient=1).range is None
    given = entry(coefficient=1)
    given["parameters"]["extent"] = {"value": [-1, 2], "unit": "mm"}
    assert machine(given).effects[0].range == (-1, 2)
    given["parameters"]["extent"] = {"value": [-1, 2], "unit": "urad"}
    with pytest.raises(Refused) as found:
        machine(given)
    assert found.value.where.endswith("parameters.extent.unit")


def test_a_conversion_is_exact_where_the_numbers_are():
    assert [conversion(u, "mm/K") for u in ("um/K", "mm/K", "nm/K")] == [1e-3, 1.0, 1e-6]
    assert conversion("um/(mm/min)", "mm/(mm/min)") == 1e-3 and conversion("urad/rpm", "rad/rpm") == 1e-6


# -- bounds ----------------------------------------------------------------------------------------------------------
HOSTILE = [
    ("x", "periodic", {"period": 0}),
    ("x", "periodic", {"period": [1, 2]}),
    ("t", "approach", {"tau": 0}),
    ("t", "approach", {"tau": {"value": -0.01}}),
    ("temp_a", "lag", {"tau": {"value": 0, "unit": "s"}}),
    ("temp_a", "lag", {"tau": 3, "state0": [1, 2]}),
    ("temp_a", "power", {"exponent": -1}),
    ("temp_a", "power", {"exponent": 1000}),
    ("x", "polynomial", {"degree": 1, "domain": [1, 1]}),
    ("x", "polynomial", {"degree": 1, "domain": 5}),
    ("x", "polynomial", {"degree": 1, "domain": [1]}),
    ("x", "polynomial", {"degree": 1000000000, "domain": [0, 1]}),
    ("x", "polynomial", {"degree": -1, "domain": [0, 1]}),
    ("x", "polynomial", {"degree": [2, 3], "domain": [0, 1]}),
    ("x", "step", {"at": [1, 2]}),
    ("x", "step", {}),
    ("x", "hysteresis", {"width": []}),
    ("x", "smooth", {"domains": 5, "bumps": [1]}),
    ("x", "smooth", {"domains": [1, 2, 3], "bumps": [2]}),
    ("x", "smooth", {"domains": [0, 1], "bumps": 10**9}),
    ("x*y", "smooth", {"domains": [0, 1], "bumps": [1]}),
    ("x", "linear", {"coefficient": 1e308}),
    ("x", "linear", {"coefficient": [1, 2]}),
    ("x", "linear", {"period": 3}),
    ("x", "linear", {"coefficient": {"value": 1, "u": -1}}),
    ("*".join("x" * 300), "linear", {}),
]


@pytest.mark.parametrize(("driver", "shape", "parameters"), HOSTILE)
def test_impossible_parameters_are_refused_on_reading(driver, shape, parameters):
    found = refused("EXX", driver, shape, **({"coefficient": 1} | parameters))
    assert "effects[0]" in found.where
    assert (found.code == "parameter-unknown") == (shape == "linear" and "period" in parameters)


def test_a_name_stands_for_one_effect():
    with pytest.raises(Refused) as found:
        machine(entry(coefficient=1), entry(coefficient=2))
    assert found.value.code == "effect-name-taken" and found.value.where.endswith("effects[1].name")


# -- there and back --------------------------------------------------------------------------------------------------
WRITTEN = {
    "linear": ("temp_a*x", {"coefficient": {"value": 0.1 + 0.2, "unit": "um/(K*mm)", "u": 0.01}}),
    "reversal": ("dir_x", {"coefficient": {"value": -4.0, "unit": "um"}}),
    "polynomial": (
        "temp_a",
        {
            "coefficient": {"value": [1.0, 2.0, -3.0], "unit": "um", "u": [0.1, None, 0.3]},
            "degree": {"value": 3.0},
            "domain": {"value": [-5.0, 5.0], "unit": "K"},
        },
    ),
    "periodic": ("x", {"coefficient": {"value": [1.0, 2.0], "unit": "um"}, "period": {"value": 12.7, "unit": "mm"}}),
    "approach": (
        "t",
        {"coefficient": {"value": 12.0, "unit": "um"}, "tau": {"value": 900.0, "unit": "s", "u": 30.0}},
    ),
    "step": ("t", {"coefficient": {"value": 12.0, "unit": "um"}, "at": {"value": 905.5, "unit": "s"}}),
    "lag": (
        "temp_a",
        {
            "coefficient": {"value": 12.0, "unit": "um/K"},
            "tau": {"value": 900.0, "unit": "s"},
            "state0": {"value": 0.5, "unit": "K"},
        },
    ),
    "power": ("temp_a", {"coefficient": {"value": 12.0, "unit": "um/(K)^1.5"}, "exponent": {"value": 1.5}}),
    "hysteresis": ("x", {"coefficient": {"value": 12.0, "unit": "um/mm"}, "width": {"value": 0.25, "unit": "mm"}}),
    "smooth": (
        "temp_a*x",
        {
            "coefficient": {"value": [1.0, 2.0, 3.0, 4.0, 5.0, 6.0], "unit": "um"},
            "bumps": {"value": [2.0, 3.0]},
            "domains": {"value": [-3.0, 3.0, -200.0, 200.0]},
        },
    ),
}


@pytest.mark.parametrize("shape", SHAPES)
def test_what_is_written_in_its_own_units_comes_back_as_it_stands(shape):
    driver, parameters = WRITTEN[shape]
    given = entry("EXX", driver, shape) | {"enabled": True}
    given["parameters"] = parameters | {"extent": {"value": [-1.5, 2.5], "unit": "um"}}
    found = machine(given)
    assert machine_json.to_dict(found)["effects"] == [given]
    assert machine_json.loads(machine_json.dumps(found)) == found


def test_columns_of_a_smooth_form_may_be_written_in_any_order():
    heights = np.arange(6.0)
    straight = read("EXX", "temp_a*x", "smooth", coefficient=heights.tolist(), bumps=[2, 3], domains=[-3, 3, -200, 200])
    turned = read(
        "EXX", "x*temp_a", "smooth", coefficient=heights.reshape(2, 3).T.ravel().tolist(), bumps=[3, 2],
        domains=[-200, 200, -3, 3],
    )  # fmt: skip
    assert straight == turned and isinstance(straight.shape, Smooth)


def test_a_number_that_um_cannot_hold_exactly_is_written_in_mm():
    for value in np.random.default_rng(1).normal(size=300):
        effect = Effect("e", "EXX", "temp_a", Linear(), (float(value),), u=(abs(float(value)) / 7,))
        found = replace(machine(), effects=(effect,))
        assert machine_json.loads(machine_json.dumps(found)).effects == (effect,)


# -- what a prediction makes of it -------------------------------------------------------------------------------------
def test_four_thousandths_of_a_millimetre_are_four_micrometres():
    q = np.array([[10.0, 5.0, -1.0]])
    at = Readings.from_vectors(q, np.full((1, 3), np.nan), {"dir_x": np.array([-1.0]), "temp_column": np.array([1.0])})
    found = [
        predict(replace(machine(entry(coefficient=c)), fitted=FittedModel()), at)
        for c in ({"value": 0.004, "unit": "mm"}, {"value": 4, "unit": "um"}, 4)
    ]
    assert found[0][0, 0] == pytest.approx(-4e-3) and np.array_equal(found[0], found[1])
    assert np.array_equal(found[1], found[2])


def test_an_effect_without_a_coefficient_is_read_but_not_predicted():
    found = replace(machine(entry()), fitted=FittedModel())
    at = Readings.from_vectors(np.zeros((1, 3)), np.full((1, 3), np.nan), {"dir_x": np.ones(1)})
    with pytest.raises(Refused) as refusal:
        predict(found, at)
    assert refusal.value.code == "effect-without-coefficient"


# -- the range and the ranking -----------------------------------------------------------------------------------------
def test_an_effect_without_a_range_is_listed_and_the_rest_is_as_before():
    bare, with_ = machine(), machine(entry(coefficient=4))
    one, two = (workspace.sensitivity(m, workspace.grid(m, 2)) for m in (bare, with_))
    assert two.without_extent == ("e",) and one.without_extent == ()
    assert two.symbols == one.symbols and np.array_equal(two.total, one.total)


def test_every_output_of_a_sensitivity_lists_an_effect_without_a_range():
    study = sensitivity_study(machine(entry(coefficient=4)), SensitivityRequest(grid=2))
    data = sensitivity_json.to_dict(study)
    [row] = data["without_extent"]
    assert (row["effect"], row["owner"], row["text"]) == ("e", "X", "no extent, not in the ranking")
    assert all(r["symbol"] != "e" for r in data["errors"])
    last = sensitivity_csv.dumps(data).splitlines()[-1]
    assert last.startswith(",e,") and "no extent, not in the ranking" in last
    assert "e: no extent, not in the ranking" in sensitivity_report(study)
    assert "e: kein Bereich, nicht in der Rangfolge" in sensitivity_report(study, language="de")
    assert sensitivity_json.to_dict(sensitivity_study(machine(), SensitivityRequest(grid=2)))["without_extent"] == []


def test_version_2_wants_the_range_of_a_driver_that_is_no_joint():
    coefficient = {"value": 2.0, "unit": "um/K"}
    found = refused("EXX", "temp_a", "linear", version=2, coefficient=coefficient)
    assert found.code == "effect-extent-missing" and found.where.endswith("effects[0]")
    extent = {"value": [18.0, 24.0], "unit": "C"}
    effect = read("EXX", "temp_a", "linear", extent=extent, version=2, coefficient=coefficient)
    assert effect.extent == (-2.0, 4.0) and effect.range == pytest.approx((-4e-3, 8e-3))
    product = read("EXX", "temp_a*x", "linear", extent=[-1, 1], version=2, coefficient=1)
    assert product.range == pytest.approx((-1e-3, 1e-3))
    unknown = machine(entry("EXX", "temp_a", "linear", coefficient=1) | {"extent": None}, version=2)
    assert workspace.error_table(unknown).without_extent == ("e",)
    assert machine_json.loads(machine_json.dumps(unknown)).effects == unknown.effects


def test_version_2_knows_the_range_of_a_joint_and_of_a_direction():
    turning = machine(
        entry("EAC", "c", "periodic", coefficient=[3, 4], period={"value": 360, "unit": "deg"}), version=2
    )
    effect = turning.effects[0]
    assert effect.extent == pytest.approx((-180, 180)) and effect.driver_unit == "deg"
    assert effect.range == pytest.approx((-5e-6, 5e-6), rel=1e-9)
    assert "e" in workspace.error_table(turning).labels
    assert "extent" not in machine_json.to_dict(turning)["effects"][0]
    assert read("EXX", "dir_x", "reversal", version=2, coefficient=2).range == pytest.approx((-2e-3, 2e-3))
    along = read("EXX", "x", "linear", version=2, coefficient={"value": 1, "unit": "um/m"})
    low, high = next(j for j in turning.joints if j.name == "X").travel
    assert along.range == pytest.approx((1e-6 * low, 1e-6 * high))


def test_version_1_and_version_2_each_state_their_own_range():
    given = entry("EXX", "temp_a", "linear", coefficient=2, extent=[-1, 1])
    given["parameters"]["extent"] = [-1, 1]
    with pytest.raises(Refused) as found:
        machine(given, version=2)
    assert found.value.code == "effect-extent-place"
    with pytest.raises(Refused):
        machine(entry("EXX", "temp_a", "linear", coefficient=2, extent=[-1, 1]))


@pytest.mark.parametrize(
    ("driver", "shape", "more"),
    [("temp_a", "linear", {}), ("dir_x", "reversal", {}), ("temp_a", "approach", {"tau": 3.0})],
)
def test_a_lifted_effect_keeps_its_range(driver, shape, more):
    given = entry("EXX", driver, shape, coefficient=2, **more)
    given["parameters"]["extent"] = {"value": [-1.0, 3.0], "unit": "um"}
    one = machine(given)
    if shape == "approach":  # the range of its driver cannot be told from that of the component ...
        with pytest.raises(Refused) as found:
            machine_json.dumps(replace(one, version=2))
        assert found.value.code == "effect-extent-missing"
        one = replace(one, fitted=FittedModel(ranges={"temp_a": (-1.0, 5.0)}))  # ... but from the readings
    two = machine_json.loads(machine_json.dumps(replace(one, version=2)))
    expected = (-1e-3, 3e-3)
    if shape == "approach":
        expected = tuple(2e-3 * (1 - math.exp(-v / 3)) for v in (-1, 5))
    assert two.effects[0].range == pytest.approx(expected)


def test_an_effect_of_a_document_is_read_as_version_1():
    effect = effects_json.of_parameters(
        "e", "EZT", "t", "approach", {"coefficient": 12, "tau": {"value": 15, "unit": "min"}}
    )
    assert effect.shape == shape_class("approach")(tau=900.0) and effect.coefficients == (12e-3,)
    with pytest.raises(Refused) as found:
        effects_json.of_parameters("e", "EZT", "t", "approach", {"tau": 0}, where="Growth")
    assert found.value.where.startswith("Growth, parameters.tau")
