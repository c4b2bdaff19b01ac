# SPDX-License-Identifier: LGPL-2.1-or-later
"""What varies on a machine: its tolerances, its effects and its sources, each independent of all others."""

from __future__ import annotations

from dataclasses import dataclass

from mpmath import mp, mpf

from .indices import moments, size_of


@dataclass(frozen=True)
class Input:
    """label: symbol, or name of the effect or source.  body: that it belongs to; of a source of several its own name.

    law: mean and central moments 2, 3, 4, in um or urad; of a source those of the pure number.  follows: symbol -> um
    or urad of that error per unit of the input.
    """

    label: str
    body: str
    law: tuple
    follows: dict


def inputs(data):
    """Every input of a machine file, in its order: tolerances, effects, sources."""
    found = [Input(s, s[2:], moments(t), {s: mpf(1)}) for s, t in data["tolerances"].items()]
    for effect in data.get("effects", []):
        span = component_range(effect, data)
        if effect.get("enabled", True) and span is not None:
            symbol = effect["component"]
            law = moments({"lower": span[0], "upper": span[1], "unit": "um"})
            found.append(Input(effect["name"], symbol[2:], law, {symbol: mpf(1)}))
    for source in data.get("sources", []):
        law = {"lower": mpf(0), "upper": mpf(0), **source, "unit": "um"}  # "um": as it stands
        if "lower" not in source:  # a normal law of mean 0
            law |= {"lower": -source["sigma"], "upper": source["sigma"]}
        follows = {s: f["value"] * size_of(f["unit"]) for s, f in source["factors"].items()}
        bodies = {s[2:] for s in follows}
        found.append(Input(source["name"], bodies.pop() if len(bodies) == 1 else source["name"], moments(law), follows))
    return found


def component_range(effect, data):
    """(lowest, highest) value of the component of an effect, um or urad; None where its range is not known."""
    given = effect["parameters"]
    if "extent" in given:  # version 1: of the component itself
        scale = size_of(given["extent"]["unit"])
        return tuple(v * scale for v in given["extent"]["value"])
    span = driver_range(effect, data)
    if span is None:
        return None
    low, high = span
    coefficient = given["coefficient"]["value"]
    scale = size_of(given["coefficient"]["unit"].split("/")[0])
    shape = effect["shape"]
    if shape == "periodic":
        if high - low < given["period"]["value"]:
            raise ValueError("less than one period is not part of the set")
        most = mp.sqrt(sum(c * c for c in coefficient)) * scale
        return -most, most
    if shape == "step":
        ends = [mpf(v > given["at"]["value"]) for v in span]
    elif shape == "approach":
        ends = [1 - mp.exp(-v / given["tau"]["value"]) for v in span]
    elif shape == "power":
        ends = [mp.sign(v) * abs(v) ** given["exponent"]["value"] for v in span]
    elif shape == "lag":
        start = given["state0"]["value"] if "state0" in given else mpf(0)
        ends = [min(low, start), max(high, start)]
    elif shape in ("linear", "reversal"):
        ends = [low, high]
    else:
        raise ValueError(f"{shape} is not part of the set")
    ends = [e * coefficient * scale for e in ends]
    return min(ends), max(ends)


def driver_range(effect, data):
    """(lowest, highest) value of the driver: as stated, else the travel of a joint or -1 and 1 of a direction."""
    driver = effect["driver"]
    if effect.get("extent") is not None:
        low, high = effect["extent"]["value"]
        start = 20 if effect["extent"].get("unit") == "C" else 0  # temperatures count from 20 degC
        return low - start, high - start
    if driver.startswith("dir_") and "*" not in driver:
        return mpf(-1), mpf(1)
    for joint in data.get("joints", []):
        if joint["name"].lower() == driver:
            return tuple(joint["travel"] or (mpf(-180), mpf(180)))
    return None
