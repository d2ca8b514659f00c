# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The unit sphere in quads of nearly one size: a cube whose sides are blown up."""

from __future__ import annotations

from math import hypot, pi, tan

from .patches import Point, spread

_SIDES = (
    ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
    ((-1, 0, 0), (0, -1, 0), (0, 0, 1)),
    ((0, 1, 0), (-1, 0, 0), (0, 0, 1)),
    ((0, -1, 0), (1, 0, 0), (0, 0, 1)),
    ((0, 0, 1), (0, 1, 0), (-1, 0, 0)),
    ((0, 0, -1), (0, 1, 0), (1, 0, 0)),
)
"""Middle, right and up of the cube's sides seen from outside."""


def sphere_sides(count: int) -> list[list[list[Point]]]:
    """Return the six sides, each a grid of count × count quads.

    The grid is even in the angles about the cube's axes, so that it divides the great circles
    through the sides' middles evenly.
    """
    steps = [tan(angle) for angle in spread(-pi / 4, pi / 4, count)]
    return [
        [[_on_sphere(middle, right, up, a, b) for b in steps] for a in steps]
        for middle, right, up in _SIDES
    ]


def _on_sphere(middle: Point, right: Point, up: Point, a: float, b: float) -> Point:
    x, y, z = (m + a * r + b * u for m, r, u in zip(middle, right, up, strict=True))
    length = hypot(x, y, z)
    return (x / length, y / length, z / length)
