# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Principal curvatures from the fundamental forms of a surface."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .taylor import Array


@dataclass(frozen=True)
class Shape:
    """What is exact at points of a surface.

    Parameters
    ----------
    position, normal : (n, 3) float64
    k1, k2 : (n,) float64
        k1 >= k2, positive where the surface bends away from the normal.
    direction_1, direction_2 : (n, 3) float64
        Unit vectors; any tangents at right angles where k1 = k2.
    """

    position: Array
    normal: Array
    k1: Array
    k2: Array
    direction_1: Array
    direction_2: Array


def shape_from_derivatives(derivatives: Array, is_flipped: bool) -> Shape:
    """Return the shape of a parametrized surface.

    Parameters
    ----------
    derivatives : (6, n, 3) float64
        Position and its derivatives by u, v, uu, uv, vv.
    is_flipped : bool
        Whether the normals point against the cross product of the derivatives by u and v.
    """
    position, by_u, by_v, by_uu, by_uv, by_vv = derivatives
    normal = _unit(np.cross(by_u, by_v))
    if is_flipped:
        normal = -normal
    # Tangents at right angles, in which the derivatives are u a and p a + q b.
    a = _unit(by_u)
    b = np.cross(normal, a)
    u, p, q = _dot(by_u, a), _dot(by_v, a), _dot(by_v, b)
    bend_uu, bend_uv, bend_vv = (-_dot(second, normal) for second in (by_uu, by_uv, by_vv))
    aa = bend_uu / u**2
    ab = (bend_uv - p / u * bend_uu) / (u * q)
    bb = (bend_vv - 2.0 * p / u * bend_uv + (p / u) ** 2 * bend_uu) / q**2
    return shape_from_bending(position, normal, a, aa, ab, bb)


def shape_from_bending(
    position: Array, normal: Array, tangent: Array, aa: Array, ab: Array, bb: Array
) -> Shape:
    """Return the shape given the second fundamental form in a tangent and the one left of it.

    Parameters
    ----------
    position, normal, tangent : (n, 3) float64
        Normal and tangent are unit vectors at right angles.
    aa, ab, bb : (n,) float64
        Normal curvature along the tangent, the twist, and the normal curvature across.
    """
    across = np.cross(normal, tangent)
    mean, half = 0.5 * (aa + bb), 0.5 * (aa - bb)
    radius = np.hypot(half, ab)
    angle = 0.5 * np.arctan2(ab, half)[:, None]
    direction_1 = np.cos(angle) * tangent + np.sin(angle) * across
    return Shape(
        position, normal, mean + radius, mean - radius, direction_1, np.cross(normal, direction_1)
    )


def _dot(a: Array, b: Array) -> Array:
    return np.einsum("ij,ij->i", a, b)


def _unit(vectors: Array) -> Array:
    return vectors / np.linalg.norm(vectors, axis=1)[:, None]
