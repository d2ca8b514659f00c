# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""How wide the points on a primitive spread, along and around it."""

from __future__ import annotations

import numpy as np

from ..types import Floats
from .shapes import Kind, Primitive

#: Length of the mean of unit vectors that go all around.
_WHOLE = 1e-6


def narrowest_extent(primitive: Primitive, points: Floats, weight: Floats) -> float:
    """Return the width of the straight strip that points on a primitive fill, in meters.

    Along and around the axis, around the pipe of a torus, and in any direction of plane and sphere.
    Points spread evenly over a width w have a standard deviation of w / √12. Strips that bend or
    run askew are narrower than they seem.

    Parameters
    ----------
    primitive : Primitive
    points : (n, 3) float64
        In meters.
    weight : (n,) float64
        What each point stands for, such as its area.
    """
    weight = weight / weight.sum()
    local = (points - primitive.origin) @ primitive.frame.T
    if primitive.kind in (Kind.PLANE, Kind.SPHERE):
        local = local - weight @ local
        square = float(np.linalg.eigvalsh((weight[:, None] * local).T @ local)[1])
        return float(np.sqrt(12.0 * max(square, 0.0)))
    x, y, z = local.T
    rho = np.hypot(x, y)
    around = _arc(x, y, weight) * float(weight @ rho)
    if primitive.kind is Kind.TORUS:
        along = _arc(rho - primitive.sizes[0], z, weight) * abs(primitive.sizes[1])
    else:
        along = float(np.sqrt(weight @ (z - weight @ z) ** 2))
        if primitive.kind is Kind.CONE:
            along /= max(abs(float(np.cos(primitive.sizes[1]))), 1e-300)
    return float(np.sqrt(12.0) * min(around, along))


def _arc(x: Floats, y: Floats, weight: Floats) -> float:
    """Return the standard deviation of the angles of points around the origin."""
    size = np.maximum(np.hypot(x, y), 1e-300)
    cosine, sine = x / size, y / size
    middle_x, middle_y = float(weight @ cosine), float(weight @ sine)
    if np.hypot(middle_x, middle_y) < _WHOLE:
        return 2.0 * np.pi / float(np.sqrt(12.0))
    # Angles from the middle: an arc across the branch cut is one arc.
    angle = np.arctan2(sine * middle_x - cosine * middle_y, cosine * middle_x + sine * middle_y)
    return float(np.sqrt(weight @ (angle - weight @ angle) ** 2))
