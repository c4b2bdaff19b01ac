# SPDX-License-Identifier: LGPL-2.1-or-later
"""Readings and a machine -> design matrices: the declared error functions, the set-up's nuisance, and lever arms.

Every column is Omega's column of a component times what drives it, seen along each reading's direction of sensing; the
declared functions are Legendre polynomials of their own axis position over the travel.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..core.errors import AXES, COMPONENTS, component
from ..core.machine import Machine
from ..core.shapes import legendre
from ..core.synthesis import omega
from ..messages import Message, Refused
from .readings import Readings

ALL_SYMBOLS = tuple(COMPONENTS)
ALIGNMENT = ("EXW", "EYW", "EZW", "EAW", "EBW", "ECW")


@dataclass(frozen=True)
class Term:
    """One column of the declared design.  group : "declared", "alignment", "run" or "tool"; order : Legendre order."""

    group: str
    symbol: str
    order: int = 0

    @property
    def angular(self) -> bool:
        """Is it in rad?  Of a run, orders 3 to 5 are tilts."""
        if self.group in ("run", "tool"):
            return self.order > 2
        return component(self.symbol).angular

    @property
    def label(self) -> str:
        """Its name for a reader, in English."""
        return str(self.title)

    @property
    def title(self) -> str | Message:
        """Its name in any language; a symbol is the same in all."""
        if self.group == "declared" and not component(self.symbol).line:
            return Message("term-order", symbol=self.symbol, order=self.order)
        if self.group == "run":
            return Message("term-run-tilt" if self.angular else "term-run-offset", run=self.symbol)
        if self.group == "tool":
            return Message("term-tool-offset", tool=self.symbol)
        return self.symbol


def lever_columns(machine: Machine, readings: Readings, symbols=ALL_SYMBOLS) -> np.ndarray:
    """(R, n) what a unit (1 mm or 1 rad) of each component shows in each reading, mm."""
    return np.einsum(
        "ran,ra->rn", omega(machine, symbols, readings.q, readings.tool_offset)[readings.point], readings.sense
    )


def alike(lever: np.ndarray) -> list[list[int]]:
    """Groups of components (indices) that show the same in every reading, as translations of all bodies do.

    lever : (R, n).  Components that show nowhere form no group.
    """
    size = np.linalg.norm(lever, axis=0)
    largest = float(size.max(initial=0.0))
    groups: list[list[int]] = []
    for i in range(lever.shape[1]):
        if size[i] <= 1e-12 * max(largest, 1e-300):
            continue
        for group in groups:
            if np.linalg.norm(lever[:, i] - lever[:, group[0]]) <= 1e-9 * size[i]:
                group.append(i)
                break
        else:
            groups.append([i])
    return groups


def declared_orders(machine: Machine, symbol: str) -> range:
    """Legendre orders of a declared function: no constant (alignment, squareness), no slope of a straightness."""
    c = machine.component(symbol)
    degree = machine.declared_degree(symbol)
    if c.line:
        return range(0, 1) if degree else range(0)
    straight = not c.angular and c.axis != c.along
    return range(2 if straight else 1, degree + 1)


def declared_terms(machine: Machine) -> list[Term]:
    """Return the terms of the errors that the machine declares, with their orders."""
    return [Term("declared", s, k) for s in machine.declared_symbols for k in declared_orders(machine, s)]


def declared_columns(machine: Machine, terms, q) -> np.ndarray:
    """(P, n) value of each declared term's function at positions q (squareness: 1)."""
    out = np.ones((len(q), len(terms)))
    cache = {}
    for j, term in enumerate(terms):
        if term.order:
            k = machine.component(term.symbol).body
            if k not in cache:
                degree = max(t.order for t in terms if t.group == "declared")
                cache[k] = _functions(machine, k, q, degree)
            out[:, j] = cache[k][:, term.order]
    return out


def _functions(machine: Machine, name: str, q, degree: int) -> np.ndarray:
    """(P, degree + 1) Legendre functions of a joint's position over its travel, both as shown (mm, degrees)."""
    joint = machine.joint(name)
    place, (low, high) = q[:, machine.names.index(name)], joint.span
    return legendre(joint.to_shown(place), degree, (joint.to_shown(low), joint.to_shown(high)), start=0)


def run_labels(readings: Readings) -> list[str]:
    """Return the labels of the runs, sorted; none if the readings name no runs."""
    return [] if readings.run is None else sorted({str(r) for r in readings.run})


def tool_labels(readings: Readings) -> list[tuple[float, float, float]]:
    """Return the tool offsets that occur, mm, sorted; none if the readings state no tool."""
    if readings.tool_offset is None or len(readings.tool_offset) == 0:
        return []
    return sorted({tuple(float(v) for v in t) for t in np.round(readings.tool_offset, 4)})


@dataclass(frozen=True)
class Design:
    """terms (n), matrix (R, n): mm per mm or rad of each term; lever (R, 33): of every component (ALL_SYMBOLS)."""

    terms: tuple[Term, ...]
    matrix: np.ndarray
    lever: np.ndarray


def check_three_axes(machine: Machine) -> None:
    """Refuse a machine whose axes are not X, Y and Z, linear: readings are fitted and traced on such machines only."""
    if machine.names != AXES or not all(j.slides for j in machine.joints):
        raise Refused("readings-of-three-axes", machine.name, axes=list(machine.names))


def design(machine: Machine, readings: Readings) -> Design:
    """The declared model of these readings: declared errors, alignment of the set-up, an offset per further tool.

    Each further run has an offset of its own, or with `alignment` "per run" its own shifts and tilts, or with "once"
    none.  Refuses a machine of other axes than three linear ones.
    """
    check_three_axes(machine)
    lever = lever_columns(machine, readings)
    terms = declared_terms(machine)
    at = {s: i for i, s in enumerate(ALL_SYMBOLS)}
    values = declared_columns(machine, terms, readings.q)
    blocks = [values[readings.point] * lever[:, [at[t.symbol] for t in terms]]]
    for symbol in ALIGNMENT:
        terms.append(Term("alignment", symbol))
    blocks.append(lever[:, [at[s] for s in ALIGNMENT]])
    runs = run_labels(readings)
    for label in runs[1:]:
        mask = np.array([str(r) == label for r in readings.run])[readings.point]
        count = {"once": 0, "per run": 6}.get(readings.alignment, 3)
        terms += [Term("run", label, i) for i in range(count)]
        shown = readings.sense if count <= 3 else lever[:, [at[s] for s in ALIGNMENT]]
        blocks.append(shown[:, :count] * mask[:, None])
    tools = tool_labels(readings)
    if len(tools) > 1:
        rounded = np.round(readings.tool_offset, 4)
        for number, tool in enumerate(tools[1:], start=2):
            mask = (rounded == np.array(tool)).all(axis=1)[readings.point]
            terms += [Term("tool", str(number), i) for i in range(3)]
            blocks.append(readings.sense * mask[:, None])
    return Design(tuple(terms), np.concatenate(blocks, axis=1), lever)
