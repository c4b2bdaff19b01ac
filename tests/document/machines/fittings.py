# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rails, blocks, wheels, tubes, motors and dovetails of any size, for the machines of `unlike`."""

from __future__ import annotations

import Part

from . import BLOCK, RAIL, V, bored, box, fused, profile, rod, section
from . import wheel as v_wheel

UNIT = {"x": V(1, 0, 0), "y": V(0, 1, 0), "z": V(0, 0, 1)}


def rail(along, at, low, high, up="z", sign=1, k=1.0):
    """A profile rail, 20 mm wide times k, on its seat."""
    return profile(section([(a * k, h * k) for a, h in RAIL], along, at, up, sign), along, low, high)


def block(along, at, centre, half=30, up="z", sign=1, k=1.0):
    """A block on `rail`, 28 mm high times k above the seat."""
    outline = section([(a * k, h * k) for a, h in BLOCK], along, at, up, sign)
    return profile(outline, along, centre - half, centre + half)


def _line(along, at, up, sign, height):
    centre = dict(zip("xyz", at))
    centre[up] += sign * height
    return centre


def sbr_rail(along, at, low, high, up="z", sign=1, k=1.0):
    """A round rail of 16 mm times k on its foot, the middle of the rod 25 mm times k above the seat."""
    foot = [(-20, 0), (20, 0), (20, 5), (6, 5), (4, 20), (-4, 20), (-6, 5), (-20, 5)]
    foot = profile(section([(a * k, h * k) for a, h in foot], along, at, up, sign), along, low, high)
    centre = _line(along, at, up, sign, 25 * k)
    centre[along] = low
    return foot.fuse(rod(tuple(centre.values()), along, high - low, 8 * k))


def sbr_block(along, at, centre, up="z", sign=1, k=1.0):
    """The open block on `sbr_rail`, 45 mm long times k."""
    outline = [(-22, 12), (22, 12), (22, 45), (-22, 45)]
    low, high = centre - 22.5 * k, centre + 22.5 * k
    shape = profile(section([(a * k, h * k) for a, h in outline], along, at, up, sign), along, low, high)
    slot = section([(a * k, h * k) for a, h in ((-6, 0), (6, 0), (6, 20), (-6, 20))], along, at, up, sign)
    shape = shape.cut(profile(slot, along, low - 1, high + 1))
    line = _line(along, at, up, sign, 25 * k)
    line[along] = low - 1
    return bored(shape, tuple(line.values()), along, high - low + 2, 8 * k)


def dove(along, at, outline, low, high):
    """A dovetail's tongue on a surface that looks upwards."""
    return profile(section(outline, along, at, "z"), along, low, high)


def tube(at, along, length, radius, wall=1.5):
    """A conduit."""
    return bored(rod(at, along, length, radius), tuple(V(*at) - UNIT[along]), along, length + 2, radius - wall)


def bearing(at, axis, radius, width=7, bore=4):
    """A ball bearing with its middle at a point."""
    start = V(*at) - UNIT[axis] * (width / 2)
    return Part.makeCylinder(radius, width, start, UNIT[axis]).cut(Part.makeCylinder(bore, width, start, UNIT[axis]))


def motor(at, axis, length, half=21):
    """A square motor with its shaft from a point along an axis; a negative length goes the other way."""
    ranges = {n: (v - half, v + half) for n, v in zip("xyz", at)}
    start = dict(zip("xyz", at))[axis]
    ranges[axis] = tuple(sorted((start, start + length)))
    return box(*ranges.values())


def wheels(at, along, reach, axis, radius=12):
    """Two V-wheels about a point, `reach` to either side along the way that they roll.  axis : that they turn about."""
    made = []
    for s in (-1, 1):
        centre = dict(zip("xyz", at))
        centre[along] += s * reach
        made.append(v_wheel(tuple(centre.values()), axis, radius))
    return made


__all__ = ["bearing", "block", "dove", "fused", "motor", "rail", "sbr_block", "sbr_rail", "tube", "wheels"]
