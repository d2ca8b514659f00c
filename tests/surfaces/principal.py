# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces whose parameter lines are their principal curvature lines, and others' in closed form.

Meshes of quads along the parameter lines of the former are principal meshes, as designers lay out
planar panels: pieces between two neighboring lines of a family are developable in the limit.
"""

from __future__ import annotations

from math import pi

from .catalogue import PATCHES, Patch
from .taylor import Taylor, cos, sin

_TURN = (0.0, 2.0 * pi)


def _moulding(u: Taylor, v: Taylor) -> tuple[Taylor, Taylor, Taylor]:
    """A profile led along a plane curve at right angles to it, after Monge.

    The curve is given by its support function h: its point with the normal (cos u, sin u) is
    h (cos u, sin u) + h' (-sin u, cos u). The profile goes outward and up.
    """
    support, slope = 1.2 + 0.2 * cos(2.0 * u), -0.4 * sin(2.0 * u)
    out = support + 0.5 * sin(v)
    return out * cos(u) - slope * sin(u), out * sin(u) + slope * cos(u), 0.9 * v


def _spherical_cone(u: Taylor, v: Taylor) -> tuple[Taylor, Taylor, Taylor]:
    """A cone over a wavy curve on a sphere around its apex, by the distance from there."""
    lean = 0.2 * sin(3.0 * u) - 0.5
    return v * cos(lean) * cos(u), v * cos(lean) * sin(u), v * sin(lean)


def _involutes_of_helix(u: Taylor, v: Taylor) -> tuple[Taylor, Taylor, Taylor]:
    """The tangents of a helix of speed one, by the length of a thread unwound from it."""
    bend, rise = 0.8, 0.6
    reach = v - u
    return (
        bend * cos(u / bend) - reach * sin(u / bend),
        bend * sin(u / bend) + reach * cos(u / bend),
        rise * v,
    )


PRINCIPAL = {
    "catenoid": PATCHES["catenoid"],
    "half a torus": Patch(PATCHES["torus"].formula, _TURN, (-1.3, 1.3), (True, False)),
    "enneper": PATCHES["enneper"],
    "moulding": Patch(_moulding, (0.0, 1.5 * pi), (-0.9, 0.9)),
    "cone": Patch(_spherical_cone, _TURN, (0.6, 1.6), (True, False), is_flipped=True),
    "tangents of a helix": Patch(_involutes_of_helix, (0.0, 1.5), (2.2, 3.2)),
    "barrel vault": PATCHES["barrel vault"],
    "waved vault": Patch(lambda u, v: (u, v, 0.3 * sin(2.0 * u)), (-2.0, 2.0), (-1.0, 1.0)),
}
"""Patches on which both u and v are constant along principal curvature lines."""


def ellipsoid_zone(axes: tuple[float, float, float]) -> Patch:
    """Return an ellipsoid without its ends in y, with all umbilics if y is the middle axis."""
    a, b, c = axes
    return Patch(
        lambda u, v: (a * cos(u) * cos(v), b * sin(v), c * sin(u) * cos(v)),
        _TURN,
        (-1.1, 1.1),
        (True, False),
        is_flipped=True,
    )
