# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sweep study: one machine in many variants, each judged alone, in the order of the design.

A variant is a machine file with some of its numbers replaced, or a FreeCAD document with other values in cells and
properties.  Variants do not know of each other, so that any executor
may judge them; results come back in the order of the design, whoever judged them, and failures stand in their place.
"""

from __future__ import annotations

import copy
import itertools
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass

import numpy as np

from ..core import workspace
from ..core.machine import Machine
from ..core.refusal import Refused
from ..core.units import um

DESIGNS = ("full", "lhs", "sobol", "list")
OUTPUTS = ("mean_square", "rms", "worst_rms", "variance")
INDICES = ("share", "first", "total")
MOST_VARIANTS = 10_000_000
CHUNK = 16  # variants that a worker judges at a time
AHEAD = 4  # chunks per worker that wait: memory stays flat, and no worker waits
_WORST_GRID = 3

Judged = tuple[list[float] | None, str]  # outputs, or None and what was refused
Judge = Callable[[Sequence[tuple[float, ...]]], list[Judged]]


@dataclass(frozen=True)
class Parameter:
    """path : of a number in the machine's file, such as joints.Z.point.2.  values : to take.  low, high : their
    range."""

    path: str
    values: tuple[float, ...]
    low: float
    high: float


@dataclass(frozen=True)
class Sweep:
    """data : the machine's file, version 2, as plain data.  parameters.  design : one of DESIGNS.  count, seed : of a
    sampled one.  outputs : names of what is judged: OUTPUTS, or INDICES with a component or error, such as share.X.
    document : path of the FreeCAD document whose variants are judged, in place of `data` ("": none).  minimise : what
    the Pareto front is of: parameters and outputs, those to be maximised with "-" before the name."""

    data: Mapping
    parameters: tuple[Parameter, ...]
    design: str
    count: int
    seed: int
    outputs: tuple[str, ...]
    document: str = ""
    minimise: tuple[str, ...] = ()

    @property
    def paths(self) -> tuple[str, ...]:
        """The paths of the parameters."""
        return tuple(p.path for p in self.parameters)

    def size(self) -> int:
        """Number of variants; refuses too many."""
        if self.design == "full":
            size = math.prod(len(p.values) for p in self.parameters)
        elif self.design == "list":
            size = len(self.parameters[0].values)
        else:
            size = self.count
        if not 1 <= size <= MOST_VARIANTS:
            raise Refused("sweep-size", "design", size=size, most=MOST_VARIANTS)
        return size

    def variants(self, start: int = 0) -> Iterator[tuple[float, ...]]:
        """Values of the parameters, variant by variant from number `start` on."""
        if self.design == "full":
            return itertools.islice(itertools.product(*(p.values for p in self.parameters)), start, None)
        if self.design == "list":
            return itertools.islice(zip(*(p.values for p in self.parameters)), start, None)
        low, high = (np.array([getattr(p, k) for p in self.parameters]) for k in ("low", "high"))
        unit = (_latin if self.design == "lhs" else _sobol)(self.count, len(self.parameters), self.seed)
        return (tuple(float(v) for v in low + (high - low) * row) for row in unit[start:])


def _latin(count: int, width: int, seed: int) -> np.ndarray:
    """(count, width) Latin hypercube: each parameter is in every one of `count` equal parts once."""
    rng = np.random.default_rng(seed)
    parts = np.stack([rng.permutation(count) for _ in range(width)], axis=1)
    return (parts + rng.random((count, width))) / count


def _sobol(count: int, width: int, seed: int) -> np.ndarray:
    """(count, width) scrambled Sobol' points, of scipy."""
    try:
        from scipy.stats import qmc
    except ImportError:
        raise Refused("sweep-needs-scipy", "design") from None
    return qmc.Sobol(width, scramble=True, seed=seed).random(count)


# -- one variant -------------------------------------------------------------------------------------------------------
def place_of(data, path: str):
    """(holder, key) of the number at `path` in plain data; an entry of a list is named by its number or its "name"."""
    steps, holder = path.split("."), data
    for i, step in enumerate(steps):
        key = _key(holder, step)
        if key is None:
            known = list(holder)[:12] if isinstance(holder, dict) else [
                e["name"] for e in holder if isinstance(e, dict) and "name" in e
            ] if isinstance(holder, list) else []  # fmt: skip
            raise Refused("sweep-path", "parameters", path=path[:80], step=step[:40], known=known)
        if i == len(steps) - 1:
            if isinstance(holder[key], bool) or not isinstance(holder[key], (int, float)):
                raise Refused("sweep-no-number", "parameters", path=path[:80])
            return holder, key
        holder = holder[key]
    raise Refused("sweep-no-number", "parameters", path=path[:80])


def _key(holder, step: str):
    if isinstance(holder, dict):
        return step if step in holder else None
    if isinstance(holder, list):
        named = [i for i, e in enumerate(holder) if isinstance(e, dict) and e.get("name") == step]
        if named:
            return named[0]
        if step.isascii() and step.isdigit() and int(step) < len(holder):
            return int(step)
    return None


def check_output(name: str, machine: Machine) -> str:
    """The name of an output; refuses one that is not known on this machine."""
    kind, _, label = name.partition(".")
    table = workspace.error_table(machine)
    if name in OUTPUTS or (kind in INDICES and (label in table.labels or label in machine.bodies)):
        return name
    raise Refused("sweep-output", "outputs", name=repr(name)[:60], known=[*OUTPUTS, *(f"{k}.NAME" for k in INDICES)])


def judged(machine: Machine, outputs: Sequence[str]) -> list[float]:
    """The outputs of a machine: means in um² and um, variance in um⁴, indices as they are."""
    found = workspace.sensitivity(machine, estimate=False)
    out = []
    for name in outputs:
        kind, _, label = name.partition(".")
        if kind == "mean_square":
            out.append(um(um(found.mean_square)))
        elif kind == "rms":
            out.append(um(math.sqrt(found.mean_square)))
        elif kind == "variance":
            out.append(found.variance * 1e12)
        elif kind == "worst_rms":
            out.append(_worst(machine))
        elif label in found.bodies:
            values = {"share": found.component_share, "first": found.component_first, "total": found.component_total}
            out.append(float(values[kind][found.bodies.index(label)]))
        elif label in found.symbols:
            values = {"share": found.share, "first": found.first, "total": found.total}
            out.append(float(values[kind][found.symbols.index(label)]))
        else:
            out.append(0.0)  # a component that nothing moves in this variant
    return out


def _worst(machine: Machine) -> float:
    from ..core.distributions import moments
    from ..core.sobol import indices
    from ..core.synthesis import omega

    table = workspace.error_table(machine)
    q = workspace.grid(machine, _WORST_GRID).q
    found = indices(table.mixed(omega(machine, table.symbols, q)), moments(table.laws))
    return um(math.sqrt(float(found.mean.max())))


@dataclass(frozen=True)
class FileJudge:
    """Judges variants of a machine's file.  Plain data and a function of a module: any worker can have it.

    read : machine of plain data.  data : the machine's file.  paths, outputs : as in `Sweep`.
    """

    read: Callable[[dict], Machine]
    data: Mapping
    paths: tuple[str, ...]
    outputs: tuple[str, ...]

    def __call__(self, rows) -> list[Judged]:
        results: list[Judged] = []
        for values in rows:
            variant = copy.deepcopy(dict(self.data))
            for path, value in zip(self.paths, values):
                holder, key = place_of(variant, path)
                holder[key] = value
            try:
                results.append((judged(self.read(variant), self.outputs), ""))
            except Refused as refused:
                results.append((None, refused.message))
        return results


# -- all variants ------------------------------------------------------------------------------------------------------
def run_sweep(
    sweep: Sweep,
    judge: Judge,
    executor: Executor | None = None,
    workers: int = 1,
    start: int = 0,
    progress=None,
    chunk: int = CHUNK,
) -> Iterator[tuple[int, tuple[float, ...], list[float] | None, str]]:
    """(number, values, outputs or None, what was refused) of each variant from `start` on, in order.

    judge : of a list of variants; workers must be able to have it.  executor : None judges here.  A worker that dies is
    not the end: its chunk is judged here.  progress : called with the part done; false cancels.  chunk : variants that
    a worker gets at a time.
    """
    size = sweep.size()
    chunks = _chunks(sweep.variants(start), chunk)
    waiting: list[tuple[list, object]] = []
    number = start

    def submit():
        rows = next(chunks, None)
        if rows is not None:
            work = None
            if executor is not None:
                try:
                    work = executor.submit(judge, rows)
                except RuntimeError:  # the executor broke
                    work = None
            waiting.append((rows, work))

    for _ in range(1 if executor is None else AHEAD * workers):
        submit()
    while waiting:
        rows, work = waiting.pop(0)
        results = None
        if work is not None:
            try:
                results = work.result()
            except Refused:
                raise
            except Exception:  # noqa: BLE001 - a worker was lost, whatever its library calls that
                results = None
        if results is None:
            results = judge(rows)
        submit()
        for values, (outputs, words) in zip(rows, results):
            yield number, values, outputs, words
            number += 1
        if progress is not None and not progress(number / size):
            raise workspace.Cancelled("cancelled")


def _chunks(variants, size: int) -> Iterator[list[tuple[float, ...]]]:
    while rows := list(itertools.islice(variants, size)):
        yield rows
