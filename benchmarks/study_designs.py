# SPDX-License-Identifier: LGPL-2.1-or-later
"""The designs of the tracing study: small sets of readings with nothing to find, or with one effect of known size.

Errors are the exact product of tests/simulator, which shares no code with the package.  The same seed and design give
the same readings.  Lengths mm, angles rad.
"""

from __future__ import annotations

import json
import zlib
from collections.abc import Callable
from dataclasses import dataclass, field, replace

import numpy as np

from sensworkbench.closedloop.readings import Readings
from sensworkbench.core.machine import Machine
from sensworkbench.formats import machine_json
from tests.simulator import kinematics, plans
from tests.simulator.effects import Effect, driver_table
from tests.simulator.effects import basis as shape_basis
from tests.simulator.oracle import complement, declared_columns, effect_columns

STRUCTURES = ("FXYZ", "XYFZ", "YFXZ", "XFYZ")
SIGMA = 0.4e-3  # mm, noise of one reading
SIZES = (0.08, 0.12, 0.18, 0.25, 0.35, 0.5, 0.8, 1.3)  # rms per reading over its noise, beside the declared model


@dataclass
class Session:
    """What was measured: the simulated machine, positions (P, 3), driver columns, and the noise to come (P, 3) mm."""

    rng: np.random.Generator
    machine: kinematics.Machine
    q: np.ndarray
    columns: dict
    noise: np.ndarray
    run: np.ndarray | None = None
    alignment: str = ""
    sensed: tuple[int, ...] = (0, 1, 2)

    @property
    def count(self) -> int:
        """Number of places."""
        return len(self.q)


@dataclass(frozen=True)
class Design:
    """One kind of null: its readings hold the declared errors, a set-up and noise, and nothing else.

    stationary : the noise is the same all the time and everywhere, so that `nothing_to_explain` is the right verdict.
    """

    name: str
    words: str
    change: Callable[[Session], None]
    places: tuple[int, int] = (110, 170)
    stationary: bool = True
    plan: str = "random"


@dataclass
class Case:
    """machine and readings for the trace; truth: the effect that is in them, or None, with its size over the noise."""

    machine: Machine
    readings: Readings
    session: Session
    truth: Effect | None = None
    size: float = 0.0
    note: dict = field(default_factory=dict)


# -- the session --
def _machine(rng) -> kinematics.Machine:
    code = STRUCTURES[int(rng.integers(len(STRUCTURES)))]
    travel = {k: (-v, v) for k, v in zip("XYZ", rng.choice([150.0, 200.0, 250.0, 300.0], 3).tolist())}
    stack = code.split("F")[1]
    reference = {
        k: np.round([*rng.uniform(-250, 250, 2), rng.uniform(500, 850) if k in stack else rng.uniform(50, 300)], 1)
        for k in "XYZ"
    }
    return kinematics.Machine(
        code, {k: v.tolist() for k, v in reference.items()}, travel, (*rng.uniform(-80, 80, 2), rng.uniform(350, 450))
    )


def _session(rng, plan: str, places: tuple[int, int]) -> Session:
    machine = _machine(rng)
    q = np.round(plans.places(plan, machine.travel, rng, int(rng.integers(*places))), 3)
    table = driver_table(plans.conditions(len(q), rng) | plans.vary(len(q), rng, True))
    table |= {f"dir_{k}": v for k, v in zip("xyz", plans.directions(q).T)}
    return Session(rng, machine, q, table, SIGMA * rng.normal(size=q.shape))


def _declared(s: Session) -> dict:
    """Declared errors of usual size at the places: 18 cubics and the squareness."""
    values = {name: float(s.rng.normal()) * 12e-6 for name in kinematics.SQUARENESS}
    for i, axis in enumerate("XYZ"):
        low, high = s.machine.travel[axis]
        for motion in "XYZABC":
            height = s.rng.normal(size=4) * (1.2e-3 if motion in "XYZ" else 6e-6) * [0, 1, 0.8, 0.5]
            if motion in "XYZ" and motion != axis:
                height[1] = 0.0
            values[f"E{motion}{axis}"] = np.polynomial.legendre.legval(
                (2 * s.q[:, i] - low - high) / (high - low), height
            )
    return values


def _read(s: Session, extra: dict | None = None) -> tuple[Machine, Readings]:
    values = _declared(s)
    for name, v in (extra or {}).items():
        values[name] = values.get(name, 0.0) + v
    error = kinematics.exact_error(s.machine, s.q, values) + s.noise
    unseen = [i for i in range(3) if i not in s.sensed]
    error[:, unseen] = np.nan
    columns = dict(zip("xyz", s.q.T)) | s.columns
    readings = Readings.from_vectors(s.q, error, columns, run=s.run)
    machine = machine_json.loads(json.dumps(s.machine.as_dict()))
    return machine, replace(readings, alignment=s.alignment)


# -- noise --
def _white(s: Session) -> None:
    pass


def _remembers(s: Session) -> None:
    """First-order autoregressive noise, correlation .3 to .7."""
    phi = s.rng.uniform(0.3, 0.7)
    for i in range(1, s.count):
        s.noise[i] = phi * s.noise[i - 1] + np.sqrt(1 - phi**2) * s.noise[i]


def _uneven(s: Session) -> None:
    """Noise that grows over the travel of one axis, 1 : 2 to 1 : 6."""
    axis, ratio = int(s.rng.integers(3)), s.rng.uniform(2, 6)
    low, high = s.machine.travel["XYZ"[axis]]
    s.noise *= (1 + (ratio - 1) * (s.q[:, axis] - low) / (high - low))[:, None]


def _radius(s: Session) -> None:
    """Noise that grows with the distance from one corner, up to 1 : 10, as that of an instrument does."""
    far = np.linalg.norm(s.q - np.array([s.machine.travel[k][0] for k in "XYZ"]), axis=1)
    s.noise *= (0.2 + (s.rng.uniform(1, 3)) * far / far.max())[:, None]


def _heavy(s: Session) -> None:
    """Student's t with three degrees of freedom."""
    s.noise[:] = SIGMA * s.rng.standard_t(3, size=s.q.shape) / np.sqrt(3)


def _rounded(s: Session) -> None:
    """A display whose last digit is one half to two and a half standard deviations of the noise."""
    s.columns["_digit"] = SIGMA * s.rng.uniform(0.5, 2.5)


def _level(s: Session) -> None:
    """Noise whose level drifts by a factor of 2 to 5 during the session."""
    ratio = s.rng.uniform(2, 5)
    rising = np.linspace(0, 1, s.count)[:: int(s.rng.choice([-1, 1]))]
    s.noise *= (ratio**rising)[:, None]


def _outliers(s: Session) -> None:
    """Two in a hundred places are grossly wrong."""
    bad = s.rng.random(s.count) < 0.02
    s.noise[bad] += SIGMA * s.rng.uniform(10, 40, (int(bad.sum()), 3)) * s.rng.choice([-1, 1], (int(bad.sum()), 3))


def _runs(s: Session) -> None:
    """Three to seven runs; each is set up afresh (offset and tilt) and has one temperature of its own."""
    count = int(s.rng.integers(3, 8))
    run = np.arange(s.count) * count // s.count
    s.run = run + 1
    centre = s.q - s.q.mean(axis=0)
    for i in range(count):
        here = run == i
        s.noise[here] += 3e-3 * s.rng.normal(size=3) + np.cross(8e-6 * s.rng.normal(size=3), centre[here])
    for name in [n for n in s.columns if n.startswith("temp_")]:
        del s.columns[name]
    s.columns["temp_room"] = (s.rng.permutation(np.linspace(0, 30, count)) + s.rng.normal(size=count))[run]
    s.columns["temp_frame"] = s.rng.normal(size=count)[run] * 3
    s.alignment = str(s.rng.choice(["", "per run"]))


def _walk(rng, count: int) -> np.ndarray:
    return np.cumsum(rng.normal(size=count)) / np.sqrt(count)


def _idle(s: Session) -> None:
    """Thirty further temperatures, random walks, that drive nothing."""
    for i in range(30):
        s.columns[f"temp_idle{i}"] = 3 * _walk(s.rng, s.count)


def _wandering(s: Session) -> None:
    """The set-up wanders in each direction by a random walk of 1 to 3 standard deviations that nobody logged; six
    further temperatures are random walks too.
    """
    for i in range(6):
        s.columns[f"temp_idle{i}"] = 3 * _walk(s.rng, s.count)
    for k in range(3):
        s.noise[:, k] += SIGMA * s.rng.uniform(1, 3) * _walk(s.rng, s.count) * 2


def _laser(s: Session) -> None:
    """One direction is sensed, as a laser does."""
    s.sensed = (int(s.rng.integers(3)),)


DESIGNS = {
    d.name: d
    for d in (
        Design("white", "white noise, scattered places", _white),
        Design("grid", "white noise, a grid measured to and fro", _white, plan="grid", places=(250, 251)),
        Design("memory", "first-order autoregressive noise, .3 to .7", _remembers),
        Design("uneven", "noise grows along one axis, 1:2 to 1:6", _uneven, stationary=False),
        Design("radius", "noise grows with the distance, to 1:10", _radius, stationary=False),
        Design("heavy", "Student's t, 3 degrees of freedom", _heavy),
        Design("rounded", "rounded to .5 to 2.5 of the noise", _rounded),
        Design("level", "level of the noise drifts, 1:2 to 1:5", _level, stationary=False),
        Design("outliers", "2 % gross outliers", _outliers),
        Design("runs", "3 to 7 runs, each set up afresh, one temperature each", _runs),
        Design("idle", "30 idle temperatures, random walks", _idle),
        Design("wandering", "the set-up wanders, unlogged; idle random walks", _wandering, stationary=False),
        Design("few", "30 to 50 places", _white, places=(30, 51)),
        Design("laser", "one direction sensed", _laser, places=(180, 241)),
    )
}


def null(design: str, seed: int) -> Case:
    """Readings of a design in which nothing is to be found."""
    d = DESIGNS[design]
    rng = np.random.default_rng([seed, zlib.crc32(design.encode())])
    s = _session(rng, d.plan, d.places)
    d.change(s)
    digit = s.columns.pop("_digit", None)
    machine, readings = _read(s)
    if digit:
        readings = replace(readings, value=np.round(readings.value / digit) * digit)
    return Case(machine, readings, s)


# -- one effect of known size --
def _bend(rng, axis, travel, span) -> Effect:
    return Effect(f"E{rng.choice(list('ABC'))}{axis}", "temp_column", "linear")


def _backlash(rng, axis, travel, span) -> Effect:
    return Effect(f"E{axis}{axis}", f"dir_{axis.lower()}", "reversal")


def _scale(rng, axis, travel, span) -> Effect:
    low = axis.lower()
    return Effect(f"E{axis}{axis}", f"temp_scale_{low}*{low}", "linear")


def _cyclic(rng, axis, travel, span) -> Effect:
    return Effect(
        f"E{axis}{axis}", axis.lower(), "periodic", {"period": float(np.exp(rng.uniform(np.log(8), np.log(60))))}
    )


def _mass(rng, axis, travel, span) -> Effect:
    return Effect(f"E{rng.choice(list('ABC'))}{axis}", "load_table", "linear")


def _following(rng, axis, travel, span) -> Effect:
    return Effect(f"E{axis}{axis}", f"dir_{axis.lower()}*feed", "linear")


def _warm_up(rng, axis, travel, span) -> Effect:
    return Effect("EZT", "t", "approach", {"tau": float(rng.uniform(0.1, 0.3) * span)})


EFFECTS = {
    "bend": _bend,
    "backlash": _backlash,
    "thermal_scale": _scale,
    "cyclic": _cyclic,
    "mass": _mass,
    "following": _following,
    "warm_up": _warm_up,
}


def with_effect(kind: str, size: float, seed: int) -> Case:
    """Readings in white noise with one effect whose rms per reading, beside the declared model, is `size` x noise."""
    rng = np.random.default_rng([seed, zlib.crc32(kind.encode()), round(1000 * size)])
    while True:
        s = _session(rng, "random", (140, 181))
        if kind == "following":
            s.columns["feed"] = rng.choice([500.0, 2000.0, 6000.0], size=s.count)
        table = dict(zip("xyz", s.q.T)) | s.columns
        effect = EFFECTS[kind](rng, str(rng.choice(list("XYZ"))), s.machine.travel, float(s.columns["t"][-1]))
        x = effect_columns(s.machine, effect, s.q, table, {})
        phase = rng.uniform(0, 2 * np.pi)
        effect.coefficient = np.array([np.cos(phase), np.sin(phase)]) if x.shape[1] == 2 else rng.choice([-1.0, 1.0], 1)
        signal = x @ effect.coefficient
        seen = float(np.sqrt(np.mean(complement(declared_columns(s.machine, s.q))(signal) ** 2)))
        if seen > 0.2 * float(np.sqrt(np.mean(signal**2))):
            break
    effect.coefficient = effect.coefficient * size * SIGMA / seen
    motion = shape_basis(effect, table, {}) @ effect.coefficient
    machine, readings = _read(s, {effect.component: motion})
    return Case(machine, readings, s, effect, size)
