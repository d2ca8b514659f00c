# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A ring torus."""

from __future__ import annotations

from math import cos, pi, sin

from .patches import Patches, spread

RING = 6.0
"""Radius in meters of the circle that the tube's middle runs along."""

TUBE = 2.5
"""Radius of the tube in meters."""


def torus() -> Patches:
    """Return the torus around the z axis; its middle is in the origin."""
    patches = Patches("Torus with the radii 6 and 2.5 m")
    patches.add(
        [
            [
                (
                    (RING + TUBE * cos(v)) * cos(u),
                    (RING + TUBE * cos(v)) * sin(u),
                    TUBE * sin(v),
                )
                for v in spread(0.0, 2.0 * pi, 40)
            ]
            for u in spread(0.0, 2.0 * pi, 96)
        ]
    )
    return patches
