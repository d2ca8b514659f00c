# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""An ellipsoid with three different axes."""

from __future__ import annotations

from .patches import Patches
from .sphere import sphere_sides

AXES = (9.0, 6.0, 4.0)
"""Half axes in meters."""


def ellipsoid() -> Patches:
    """Return the sphere, stretched along the axes; its middle is in the origin."""
    a, b, c = AXES
    patches = Patches("Ellipsoid with the half axes 9, 6 and 4 m")
    for side in sphere_sides(24):
        patches.add([[(a * x, b * y, c * z) for x, y, z in row] for row in side])
    return patches
