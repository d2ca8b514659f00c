# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces that no constant of the estimator was chosen on."""

from __future__ import annotations

from math import pi

from .catalogue import Patch
from .taylor import Taylor, cos, sin

_TURN = (0.0, 2.0 * pi)


def _canal(u: Taylor, v: Taylor) -> tuple[Taylor, Taylor, Taylor]:
    tube = 0.1 * sin(2.0 * u) + 0.4
    return (tube * cos(v) + 1.5) * cos(u), (tube * cos(v) + 1.5) * sin(u), tube * sin(v)


def _oblique_cone(u: Taylor, v: Taylor) -> tuple[Taylor, Taylor, Taylor]:
    return v * (1.3 * cos(u) + 0.3), 0.7 * v * sin(u), -1.1 * v


def _hyperboloid(u: Taylor, v: Taylor) -> tuple[Taylor, Taylor, Taylor]:
    # By its rulings: straight lines that turn around the axis.
    return cos(u) - v * sin(u), sin(u) + v * cos(u), 1.2 * v


PATCHES = {
    "hyperboloid": Patch(_hyperboloid, _TURN, (-1.0, 1.0), (True, False)),
    "canal": Patch(_canal, _TURN, _TURN, (True, True)),
    "oblique cone": Patch(_oblique_cone, _TURN, (0.5, 1.5), (True, False), is_flipped=True),
    "conoid": Patch(lambda u, v: (u, v, 0.5 * u * sin(1.3 * v)), (0.3, 2.0), (-1.2, 1.2)),
    "sine cylinder": Patch(lambda u, v: (u, v, 0.3 * sin(2.0 * u)), (-2.0, 2.0), (-1.0, 1.0)),
    "quartic roof": Patch(
        lambda u, v: (u, v, 0.15 * u * v - 0.1 * u * u * u * u - 0.2 * v * v + 0.5),
        (-1.4, 1.4),
        (-1.2, 1.2),
    ),
    "gridshell": Patch(
        lambda u, v: (u, v, 1.2 * cos(0.8 * u) * cos(0.6 * v) + 0.1 * sin(1.5 * u + v)),
        (-1.6, 1.6),
        (-2.0, 2.0),
    ),
    "long ellipsoid zone": Patch(
        lambda u, v: (0.7 * cos(u) * cos(v), 0.7 * sin(u) * cos(v), 1.5 * sin(v)),
        _TURN,
        (-1.1, 1.1),
        (True, False),
    ),
}

DEVELOPABLE = ("oblique cone", "sine cylinder")
"""Patches with K = 0 everywhere."""
