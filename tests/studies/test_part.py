# SPDX-License-Identifier: LGPL-2.1-or-later
"""Features of a part against closed forms worked by hand, and against the exact product of matrices."""

from __future__ import annotations

import json

import numpy as np
import pytest

from sensworkbench.core import elements
from sensworkbench.core.refusal import Refused
from sensworkbench.core.synthesis import exact_error
from sensworkbench.core.workspace import Cancelled
from sensworkbench.formats import machine_json, path_csv
from sensworkbench.studies.part import FeatureRequest, PartRequest, part_study
from sensworkbench.studies.part_path import Conditions, of_points

UM = 1e-3
TOOL = -150.0
TURN = np.arange(720) * np.pi / 360


def machine(**fitted):
    """The golden machine with fitted errors: {"C0Y": 20} um or urad, or ([low, high], [coefficients])."""
    data = {
        "format": "sens-machine", "version": 1, "name": "m", "workpiece_chain": [], "tool_chain": ["X", "Y", "Z"],
        "axes": {k: {"direction": np.eye(3)[i].tolist(), "reference": [0, 0, 0], "travel": [-300, 300]}
                 for i, k in enumerate("XYZ")},
        "tool_point": [0, 0, TOOL],
    }  # fmt: skip
    effects = fitted.pop("effects", None)
    out = {}
    for symbol, value in fitted.items():
        unit = "urad" if symbol[1] in "ABC" or symbol[1] == "0" else "um"
        if isinstance(value, tuple):
            out[symbol] = {"basis": "legendre", "domain": value[0], "coefficients": value[1], "unit": unit,
                           "u": [0.1 * abs(c) for c in value[1]]}  # fmt: skip
        else:
            out[symbol] = {"value": value, "unit": unit, "u": 0.05 * abs(value)}
    data["fitted"] = out
    if effects:
        data["effects"] = effects
    return machine_json.loads(json.dumps(data), "m")


def study(model, points, kind, normal=None, columns=None, **more):
    """Judge one feature of points (P, 3)."""
    from sensworkbench.closedloop.readings import Readings

    points = np.asarray(points, dtype=float)
    place = dict(zip("xyz", points.T)) | (columns or {})
    rows = Readings.from_vectors(points, np.full((len(points), 3), np.nan), place)
    normal = None if normal is None else np.broadcast_to(np.asarray(normal, dtype=float), points.shape)
    labels = more.pop("labels", None) or {"f": np.arange(len(points))}
    path = of_points(model, rows, normal, labels, more.pop("conditions", Conditions()))
    features = more.pop("features", None) or (FeatureRequest("f", kind),)
    return part_study(model, path, PartRequest(features, **more))


def circle(radius, centre=(10, 20, -30)):
    return np.stack([radius * np.cos(TURN), radius * np.sin(TURN), 0 * TURN], axis=1) + centre


def grid(x, y, z=-30.0):
    x, y = np.meshgrid(x, y)
    return np.stack([x.ravel(), y.ravel(), np.full(x.size, z)], axis=1)


# -- closed forms ------------------------------------------------------------------------------------------------------
def test_a_circle_under_squareness_is_out_of_round_by_radius_times_angle():
    found = study(machine(C0Y=20), circle(50), "roundness").features[0]
    assert found.value == pytest.approx(50 * 20e-6, rel=1e-9)
    assert found.least_squares == pytest.approx(50 * 20e-6, rel=1e-9)
    assert found.u == pytest.approx(0.05 * found.value, rel=1e-9)
    assert found.rms == pytest.approx(50 * 20e-6 / np.sqrt(8), rel=1e-9)
    assert found.shares.sum() == pytest.approx(1, abs=1e-12)


def test_a_circle_under_a_scale_of_x_is_an_ellipse():
    scale = 30e-6  # EXX = scale * x: P1 over 300 mm
    found = study(machine(EXX=([-300, 300], [0, 300 * scale / UM])), circle(40), "roundness").features[0]
    assert found.value == pytest.approx(40 * scale, rel=1e-9)  # radii 40 (1 + scale) and 40


def test_an_edge_along_x_is_bent_by_roll_over_the_lever_arm():
    """EAX = a P2(x): at the tool, 150 mm below, the edge moves across by -(-150) a P2; P2 has the range 3/2."""
    x = np.linspace(-300, 300, 601)
    edge = np.stack([x, 0 * x, 0 * x], axis=1)
    found = study(machine(EAX=([-300, 300], [0, 0, 10])), edge, "straightness", (0, 1, 0)).features[0]
    assert found.value == pytest.approx(1.5 * 10e-6 * abs(TOOL), rel=1e-9)
    assert found.shares.tolist() == [1.0]


def test_a_plane_under_squareness_of_z_stays_flat():
    top = grid(np.linspace(-100, 100, 21), np.linspace(-50, 50, 11))
    found = study(machine(A0Z=20, C0Y=20), top, "flatness").features[0]
    assert found.value == pytest.approx(0, abs=1e-15) and found.shares.tolist() == [0, 0]


def test_a_twisted_plane_has_the_width_of_its_corners():
    """EAX = a x/300 lifts the point at y by a x y / 300: +-a 100 50 / 300 at the corners."""
    top = grid(np.linspace(-100, 100, 21), np.linspace(-50, 50, 11))
    found = study(machine(EAX=([-300, 300], [0, 20])), top, "flatness").features[0]
    assert found.value == pytest.approx(2 * 20e-6 * 100 * 50 / 300, rel=1e-9)


def test_a_scale_lengthens_a_distance_and_moves_a_bore():
    scale = 30e-6
    model = machine(EXX=([-300, 300], [0, 300 * scale / UM]), C0Y=20)
    points = np.concatenate([circle(5, (-80, 0, 0)), circle(5, (120, 60, 0))])
    labels = {"a": np.arange(720), "b": np.arange(720, 1440)}
    features = (FeatureRequest("far", "distance", "a", label="b"), FeatureRequest("place", "position", label="b"))
    far, place = study(model, points, None, labels=labels, features=features).features
    along = np.array([200, 60]) / np.hypot(200, 60)
    change = np.array([scale * 200 - 20e-6 * 60, 0.0])  # C0Y turns y: x moves by -C0Y y
    assert far.value == pytest.approx(float(change @ along), rel=1e-9)
    assert place.value == pytest.approx(2 * abs(scale * 120 - 20e-6 * 60), rel=1e-9)
    assert far.shares.sum() == pytest.approx(1) and place.shares.sum() == pytest.approx(1)


def test_two_edges_of_a_square_are_out_of_square_by_the_squareness():
    x = np.linspace(-50, 50, 101)
    low, left = np.stack([x, 0 * x - 50, 0 * x], 1), np.stack([0 * x - 50, x, 0 * x], 1)
    normal = np.concatenate([np.tile([0.0, -1, 0], (101, 1)), np.tile([-1.0, 0, 0], (101, 1))])
    labels = {"low": np.arange(101), "left": np.arange(101, 202)}
    features = (FeatureRequest("left", "perpendicularity", "low"),)
    found = study(machine(C0Y=20), np.concatenate([low, left]), None, normal, labels=labels, features=features)
    assert found.features[0].value == pytest.approx(100 * 20e-6, rel=1e-9)
    parallel = (FeatureRequest("left", "parallelism", "low"),)
    with pytest.raises(Refused) as refused:
        study(machine(C0Y=20), np.concatenate([low, left]), None, normal, labels=labels, features=parallel)
    assert refused.value.code == "feature-not-so"


def test_two_faces_of_a_step_with_the_same_bow_are_out_of_parallel_by_it():
    """EZX = c P2(x/300): over x = +-100 the bow of each face is 3/2 c/9, and symmetric, so the datum is not tilted."""
    x = np.linspace(-100, 100, 41)
    high, low = grid(x, np.linspace(0, 50, 6), 0.0), grid(x, np.linspace(60, 90, 4), -40.0)
    labels = {"high": np.arange(len(high)), "low": np.arange(len(high), len(high) + len(low))}
    features = (FeatureRequest("low", "parallelism", "high"),)
    model = machine(EZX=([-300, 300], [0, 0, 6]))
    found = study(model, np.concatenate([high, low]), None, labels=labels, features=features).features[0]
    assert found.value == pytest.approx(1.5 * 6 * UM / 9, rel=1e-9)


def test_a_bore_along_z_is_tilted_by_squareness_of_z_and_not_out_of_cylinder():
    height = np.repeat(np.linspace(0, -60, 7), 720)
    bore = np.tile(circle(12, (30, 40, 0)), (7, 1)) + np.stack([0 * height, 0 * height, height], axis=1)
    top = grid(np.linspace(0, 60, 7), np.linspace(0, 80, 9), 0.0)
    labels = {"bore": np.arange(len(bore)), "top": np.arange(len(bore), len(bore) + len(top))}
    features = (
        FeatureRequest("form", "cylindricity", label="bore"),
        FeatureRequest("square", "perpendicularity", "top", label="bore"),
    )
    points = np.concatenate([bore, top])
    form, square = study(machine(B0Z=20), points, None, labels=labels, features=features).features
    assert form.value == pytest.approx(0, abs=1e-13)
    assert square.value == pytest.approx(60 * 20e-6, rel=1e-9)


def test_a_drilled_hole_is_a_line_whose_tube_is_its_tilt():
    z = np.linspace(0, -60, 61)
    hole = np.stack([0 * z + 30, 0 * z + 40, z], axis=1)
    found = study(machine(B0Z=20, A0Z=10), hole, "straightness").features[0]
    assert found.value == pytest.approx(0, abs=1e-13)
    place = study(machine(B0Z=20, A0Z=10), hole, "position").features[0]
    assert place.value == pytest.approx(2 * 30 * np.hypot(20e-6, 10e-6), rel=1e-9)  # at half its depth


# -- the exact product, effects, tolerances ----------------------------------------------------------------------------
def test_values_are_those_of_the_exact_product_to_a_tenth_of_a_micrometre():
    rng = np.random.default_rng(3)
    wanted = {}
    for k in "XYZ":
        for i, motion in enumerate("XYZABC"):
            size = 5 if i < 3 else 20
            wanted[f"E{motion}{k}"] = ([-300, 300], [0, *(size * rng.normal(size=3) / 2)])
    model = machine(**wanted, C0Y=20, A0Z=-15, B0Z=10)
    points = circle(100)
    found = study(model, points, "roundness").features[0]
    shown = {s: model.fitted.values(s, points[:, "XYZ".index(model.component(s).body)]) for s in model.fitted.symbols}
    exact, _ = exact_error(model, shown, points)
    made = points + exact
    fit = elements.circle(made)
    radius = np.hypot(*(made - fit.centre)[:, :2].T)
    assert found.least_squares == pytest.approx(np.ptp(radius), abs=1e-4)
    assert found.shares.sum() == pytest.approx(1, abs=1e-12)


def test_an_effect_by_temperature_acts_while_it_is_warm():
    effect = {"name": "growth", "component": "EZT", "driver": "temp_column", "shape": "linear",
              "parameters": {"coefficient": {"value": 2.0, "unit": "um/K"}}, "enabled": True}  # fmt: skip
    model = machine(C0Y=0, effects=[effect])
    top = grid(np.linspace(-50, 50, 11), np.linspace(-50, 50, 11))
    with pytest.raises(Refused) as refused:
        study(model, top, "flatness")
    assert refused.value.code == "driver-column-missing"
    line = 2 + np.arange(len(top))
    warmer = Conditions(np.array([0.0, float(line[60])]), "block", {"temp_column": np.array([0.0, 3.0])})
    found = study(model, top, "flatness", conditions=warmer)
    rise = found.error[:, 2]
    assert rise[:60] == pytest.approx(0) and rise[60:] == pytest.approx(6 * UM)
    assert dict(zip(found.labels, found.features[0].shares))["growth"] == pytest.approx(1)


def test_of_tolerances_the_mean_square_and_its_shares_are_exact():
    """Only C0Y and B0Z vary, uniformly: each has one value for the part, so E<R_i, R> is a sum of two terms."""
    model = machine_json.loads(json.dumps(_toleranced({"C0Y": 20, "EXT": 3})), "m")
    found = study(model, circle(50), "roundness")
    feature = found.features[0]
    assert found.model == "tolerances"
    variance = (40e-6) ** 2 / 12
    assert feature.rms == pytest.approx(np.sqrt(variance) * 50 / np.sqrt(8), rel=1e-9)
    assert feature.value == pytest.approx(50 * 20e-6 / 2, rel=2e-3)  # E|C0Y| R
    assert dict(zip(found.labels, feature.shares))["C0Y"] == pytest.approx(1, abs=1e-12)
    assert feature.quantile == pytest.approx(0.95 * 50 * 20e-6, rel=1e-2)
    expected = np.sqrt(variance * (circle(50)[:, 1] ** 2) + (6 * UM) ** 2 / 12)
    assert found.expected == pytest.approx(expected, rel=1e-9)
    assert found.quantile_error < 0.1


def _toleranced(half):
    data = json.loads(machine_json.dumps(machine(C0Y=0)))
    data.pop("fitted", None)
    symbols = [f"E{m}{k}" for k in "XYZ" for m in "XYZABC"] + ["C0Y", "A0Z", "B0Z", "EXT", "EYT", "EZT"]
    angle = lambda s: s[1] in "ABC" or s[1] == "0"  # noqa: E731
    data["tolerances"] = {
        s: {"lower": -half.get(s, 0), "upper": half.get(s, 0), "unit": "urad" if angle(s) else "um"} for s in symbols
    }
    return data


def test_straightness_of_a_tolerance_is_seen_by_a_feature_and_shares_add_to_one():
    model = machine_json.loads(json.dumps(_toleranced({"EYX": 5, "ECX": 20, "C0Y": 10})), "m")
    x = np.linspace(-300, 300, 601)
    found = study(model, np.stack([x, 0 * x, 0 * x], axis=1), "straightness", (0, 1, 0))
    shares = dict(zip(found.labels, found.features[0].shares))
    assert shares["EYX"] > 0.2 and shares["C0Y"] == 0 and sum(shares.values()) == pytest.approx(1, abs=1e-12)
    assert found.features[0].quantile > found.features[0].value > 0


# -- what is refused ---------------------------------------------------------------------------------------------------
@pytest.mark.parametrize(
    "points, kind, code",
    [
        (circle(5)[:3], "roundness", "feature-too-few-points"),
        (circle(5)[:3], "flatness", "feature-too-few-points"),
        (np.zeros((5, 3)), "straightness", "feature-too-few-points"),
        (np.stack([np.arange(5.0)] * 3, axis=1), "flatness", "feature-too-few-points"),
        (circle(5), "straightness", "feature-not-on-element"),
        (circle(5), "distance", "feature-without-datum"),
        (circle(5), "beauty", "feature-kind-unknown"),
        (np.random.default_rng(0).normal(size=(20, 3)), None, "feature-no-element"),
    ],
)
def test_features_that_cannot_be_judged_are_refused(points, kind, code):
    with pytest.raises(Refused) as refused:
        study(machine(C0Y=20), points, kind)
    assert refused.value.code == code and refused.value.do


def test_a_study_is_cancelled():
    model, points = machine(C0Y=20), circle(5)
    rows = path_csv.Readings.from_vectors(points, np.full((720, 3), np.nan))
    path = of_points(model, rows, None, {})
    with pytest.raises(Cancelled):
        part_study(model, path, progress=lambda part: False)


def test_the_uncertainty_of_a_value_keeps_the_correlations_of_the_fit():
    """Roundness under C0Y and a scale of x: u of a sum of two coefficients that are correlated at -0.9."""
    from dataclasses import replace

    from sensworkbench.core.fitted import Uncertainty

    model = machine(EXX=([-300, 300], [0, 6]), EYY=([-300, 300], [0, -4]))
    su, sv, rho = 0.3e-3, 0.2e-3, -0.9
    factor = ((su,), (rho * sv, sv * np.sqrt(1 - rho**2)))
    known = Uncertainty((("declared", "EXX", 1), ("declared", "EYY", 1)), factor)
    model = replace(model, fitted=replace(model.fitted, uncertainty=known))
    found = study(model, circle(50, (0, 0, 0)), "roundness").features[0]
    # the ellipse: radii 50 (1 + a) and 50 (1 + b), so its width is 50 |a - b| with a, b the slopes over 300 mm
    assert found.value == pytest.approx(50 * 10e-3 / 300, rel=1e-9)
    assert found.u == pytest.approx(50 / 300 * np.sqrt(su**2 + sv**2 - 2 * rho * su * sv), rel=1e-6)
