# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""How far points reach along a primitive, measured on its surface."""

from __future__ import annotations

import numpy as np

from ..types import Floats
from .shapes import Kind, Primitive


def narrowest_extent(primitive: Primitive, points: Floats) -> float:
    """Return the width of the strip that points on a primitive fill, in meters.

    Along and around the axis, around the pipe of a torus, and in any direction of plane and sphere.
    Points spread evenly over a width w have a standard deviation of w / √12.

    Parameters
    ----------
    primitive : Primitive
    points : (n, 3) float64
        In meters.
    """
    local = (points - primitive.origin) @ primitive.frame.T
    if primitive.kind in (Kind.PLANE, Kind.SPHERE):
        local = local - local.mean(axis=0)
        square = float(np.linalg.eigvalsh(local.T @ local / len(local))[1])
        return float(np.sqrt(12.0 * max(square, 0.0)))
    x, y, z = local.T
    rho = np.hypot(x, y)
    around = _arc(x, y) * float(rho.mean())
    if primitive.kind is Kind.TORUS:
        along = _arc(rho - primitive.sizes[0], z) * abs(primitive.sizes[1])
    elif primitive.kind is Kind.CONE:
        along = float(z.std()) / max(abs(np.cos(primitive.sizes[1])), 1e-300)
    else:
        along = float(z.std())
    return float(np.sqrt(12.0) * min(around, along))


def _arc(x: Floats, y: Floats) -> float:
    """Return the standard deviation of the angles of points around the origin."""
    size = np.maximum(np.hypot(x, y), 1e-300)
    cosine, sine = x / size, y / size
    middle_x, middle_y = cosine.mean(), sine.mean()
    # Angles from the middle: an arc across the branch cut is one arc.
    angle = np.arctan2(sine * middle_x - cosine * middle_y, cosine * middle_x + sine * middle_y)
    return float(np.std(angle))
