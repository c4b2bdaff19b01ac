# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measured data as rows of one kind: a place, a direction of sensing, a displacement and its conditions.

A laser, a ballbar, a step diagonal, a tracker and a probe all give displacements along unit vectors, so each reading
is one row; a tracker's vector is three rows of one *point*.  Points keep the order of the file (time order).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from ..messages import Message


@dataclass(frozen=True)
class Remark:
    """Something noticed while reading: severity "error" | "warning" | "info", code, message (English where it is
    only read as text), line (0: whole file)."""

    severity: str
    code: str
    message: Message | str
    line: int = 0

    def text(self, language: str = "en") -> str:
        """The message in `language`."""
        return self.message.text(language) if isinstance(self.message, Message) else self.message


@dataclass(frozen=True)
class Readings:
    """P points with R >= P rows of displacement.

    q : (P, n) programmed positions of the machine's joints, mm or rad.  point : (R,) the point of each row.
    sense : (R, 3) unit vector of sensing, in
    the machine frame.  value : (R,) error = actual - commanded along `sense`, mm.  u : (R,) standard uncertainty, mm
    (NaN: not stated).  columns : driver columns by name, (P,), in internal units (mm, s, kelvin from 20 degC, -1/0/+1,
    others as written); always holds the positions by the joints' columns (mm, degrees).  units : unit of each driver
    column ("" where unknown).
    categories : text columns, (P,).  run : (P,) labels.  tool_offset : (P, 3) mm, or None.  line : (P,) in the file.
    alignment : of the set-up: "once", "offset per run", "per run", or "" where the file does not say.
    records : what the file states of machine, instrument and session, by key (see `formats.readings_records`).
    kind : (R,) 0, 1, 2 for ex, ey, ez and 3 for a reading along its own vector - noise is estimated per kind.
    """

    q: np.ndarray
    point: np.ndarray
    sense: np.ndarray
    value: np.ndarray
    u: np.ndarray
    kind: np.ndarray
    columns: Mapping[str, np.ndarray]
    units: Mapping[str, str] = field(default_factory=dict)
    categories: Mapping[str, np.ndarray] = field(default_factory=dict)
    run: np.ndarray | None = None
    tool_offset: np.ndarray | None = None
    line: np.ndarray | None = None
    remarks: tuple[Remark, ...] = ()
    records: Mapping[str, str] = field(default_factory=dict)
    alignment: str = ""

    @property
    def points(self) -> int:
        """Number of places, P."""
        return len(self.q)

    @property
    def rows(self) -> int:
        """Number of displacements, R."""
        return len(self.value)

    def select(self, points) -> Readings:
        """The readings of a subset of points (a boolean mask or sorted indices), order kept."""
        keep = np.zeros(self.points, dtype=bool)
        keep[points] = True
        number = np.cumsum(keep) - 1
        rows = keep[self.point]
        part = lambda a: None if a is None else a[keep]  # noqa: E731
        return Readings(
            q=self.q[keep],
            point=number[self.point[rows]],
            sense=self.sense[rows],
            value=self.value[rows],
            u=self.u[rows],
            kind=self.kind[rows],
            columns={k: v[keep] for k, v in self.columns.items()},
            units=self.units,
            categories={k: v[keep] for k, v in self.categories.items()},
            run=part(self.run),
            tool_offset=part(self.tool_offset),
            line=part(self.line),
            remarks=self.remarks,
            alignment=self.alignment,
            records=self.records,
        )

    @classmethod
    def from_vectors(cls, q, error, columns=None, *, u=None, run=None, tool_offset=None, units=None) -> Readings:
        """Readings of full vectors: q (P, n) mm or rad, error (P, 3) mm (NaN: not read), u (P,) mm or None.

        columns : driver columns; the positions of the joints are to be among them (default: those of x, y, z).
        """
        q, error = np.asarray(q, dtype=float), np.asarray(error, dtype=float)
        count = len(q)
        point, kind = np.divmod(np.arange(3 * count), 3)
        given = np.isfinite(error.ravel())
        spread = np.full(count, np.nan) if u is None else np.broadcast_to(np.asarray(u, dtype=float), count)
        table = dict(zip("xyz", q.T)) if q.shape[1] == 3 and "x" not in (columns or {}) else {}
        table |= dict(columns or {})
        return cls(
            q=q,
            point=point[given],
            sense=np.eye(3)[kind[given]],
            value=error.ravel()[given],
            u=spread[point[given]],
            kind=kind[given],
            columns=table,
            units=dict(units or {}),
            run=None if run is None else np.asarray(run),
            tool_offset=None if tool_offset is None else np.asarray(tool_offset, dtype=float).reshape(-1, 3),
            line=np.arange(2, count + 2),
        )
