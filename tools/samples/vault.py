# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A barrel vault with an apse at either end: half a cylinder between two quarters of a sphere."""

from __future__ import annotations

from collections.abc import Iterator
from math import cos, pi, sin

from .patches import Patches, Point, spread
from .sphere import sphere_sides

RADIUS = 5.0
"""Of vault and apses, in meters."""

LENGTH = 12.0
"""Of the vault without its apses, in meters."""

#: Quads along half a side of the sphere.
_HALF = 10


def barrel_vault() -> Patches:
    """Return the vault along the x axis, standing on the plane z = 0."""
    patches = Patches("Barrel vault with apses, radius 5 m, length 12 m between the apses")
    patches.add(
        [
            [(x, RADIUS * cos(angle), RADIUS * sin(angle)) for angle in spread(pi, 0.0, 4 * _HALF)]
            for x in spread(-LENGTH / 2, LENGTH / 2, 24)
        ]
    )
    for rows in _upper_quarters():
        shift = LENGTH / 2 if rows[_HALF // 2][_HALF // 2][0] > 0.0 else -LENGTH / 2
        patches.add(
            [[(shift + RADIUS * x, RADIUS * y, RADIUS * z) for x, y, z in row] for row in rows]
        )
    return patches


def _upper_quarters() -> Iterator[list[list[Point]]]:
    """Yield the quarters of the sphere's sides above the ground, all on one side of x = 0."""
    halves = (slice(0, _HALF + 1), slice(_HALF, 2 * _HALF + 1))
    for side in sphere_sides(2 * _HALF):
        for across in halves:
            for upward in halves:
                quarter = [row[upward] for row in side[across]]
                if quarter[_HALF // 2][_HALF // 2][2] > 0.0:
                    yield quarter
