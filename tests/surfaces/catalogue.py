# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces by formula, about two meters in size, with features of about one."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import pi

import numpy as np

from .forms import Shape, shape_from_derivatives
from .taylor import Array, Taylor, cos, cosh, sin, variables

Formula = Callable[[Taylor, Taylor], tuple[Taylor, Taylor, Taylor]]


@dataclass(frozen=True)
class Patch:
    """A parametrized surface.

    Parameters
    ----------
    formula : callable
        From u and v to x, y and z.
    u, v : (float, float)
        Where the parameters start and end.
    is_closed : (bool, bool)
        Whether the surface closes in u and in v.
    is_flipped : bool
        Whether normals point against the cross product of the derivatives by u and v.
    """

    formula: Formula
    u: tuple[float, float]
    v: tuple[float, float]
    is_closed: tuple[bool, bool] = (False, False)
    is_flipped: bool = False

    def shape(self, u: Array, v: Array) -> Shape:
        """Return the exact shape at parameters (n,)."""
        return shape_from_derivatives(self.derivatives(u, v), self.is_flipped)

    def derivatives(self, u: Array, v: Array) -> Array:
        """Return position and derivatives by u, v, uu, uv, vv, (6, n, 3)."""
        return np.stack([axis.parts for axis in self.formula(*variables(u, v))], axis=2)


def _height(function: Callable[[Taylor, Taylor], Taylor]) -> Formula:
    return lambda u, v: (u, v, function(u, v))


def _revolved(radius: Callable[[Taylor], Taylor], axis: Callable[[Taylor], Taylor]) -> Formula:
    return lambda u, v: (radius(v) * cos(u), radius(v) * sin(u), axis(v))


def _enneper(u: Taylor, v: Taylor) -> tuple[Taylor, Taylor, Taylor]:
    return (
        u - u * u * u / 3.0 + u * v * v,
        v - v * v * v / 3.0 + v * u * u,
        u * u - v * v,
    )


def _tangents_of_helix(u: Taylor, v: Taylor) -> tuple[Taylor, Taylor, Taylor]:
    return cos(u) - v * sin(u), sin(u) + v * cos(u), 0.5 * (u + v)


_TURN = (0.0, 2.0 * pi)
_AROUND = (True, False)

TORUS_RING, TORUS_TUBE = 1.0, 0.4
CONE_SLOPE = 1.5

PATCHES = {
    "plane": Patch(_height(lambda u, v: 0.3 * u + 0.2 * v), (-1.0, 1.0), (-1.0, 1.0)),
    "sphere zone": Patch(_revolved(cos, sin), _TURN, (-1.0, 1.0), _AROUND),
    "cylinder": Patch(_revolved(lambda v: 0.0 * v + 1.0, lambda v: v), _TURN, (-1.5, 1.5), _AROUND),
    "barrel vault": Patch(
        lambda u, v: (v, sin(u), cos(u)), (-1.2, 1.2), (-1.5, 1.5), is_flipped=True
    ),
    "cone": Patch(
        _revolved(lambda v: v, lambda v: -CONE_SLOPE * v),
        _TURN,
        (0.4, 1.4),
        _AROUND,
        is_flipped=True,
    ),
    "torus": Patch(
        _revolved(lambda v: TORUS_RING + TORUS_TUBE * cos(v), lambda v: TORUS_TUBE * sin(v)),
        _TURN,
        _TURN,
        (True, True),
    ),
    "catenoid": Patch(_revolved(cosh, lambda v: v), _TURN, (-1.0, 1.0), _AROUND),
    "helicoid": Patch(lambda u, v: (v * cos(u), v * sin(u), 0.6 * u), (-2.5, 2.5), (-1.2, 1.2)),
    "enneper": Patch(_enneper, (-0.8, 0.8), (-0.8, 0.8)),
    "monkey saddle": Patch(
        _height(lambda u, v: 0.5 * (u * u * u - 3.0 * u * v * v)), (-1.0, 1.0), (-1.0, 1.0)
    ),
    "hyperbolic paraboloid": Patch(_height(lambda u, v: u * v), (-1.0, 1.0), (-1.0, 1.0)),
    "elliptic paraboloid": Patch(
        _height(lambda u, v: -0.4 * u * u - 0.15 * v * v), (-1.0, 1.0), (-1.5, 1.5)
    ),
    "waves": Patch(
        _height(lambda u, v: 0.25 * sin(2.2 * u + 0.4) * cos(1.7 * v)), (-1.5, 1.5), (-1.5, 1.5)
    ),
    "tangent developable": Patch(_tangents_of_helix, (0.0, 2.5), (0.7, 2.2)),
}

DEVELOPABLE = ("plane", "cylinder", "barrel vault", "cone", "tangent developable")
"""Patches with K = 0 everywhere."""

MINIMAL = ("catenoid", "helicoid", "enneper")
"""Patches with H = 0 everywhere."""
