# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Vertex normals and tangent frames to start a fit from."""

from __future__ import annotations

import numpy as np

from ..groups import sum_by_group
from ..types import AnyArray, Coordinates

#: A triangle flatter than this (double area over the longest squared edge) has no normal to speak
#: of.
FLAT_TRIANGLE = 1e-10
#: Triangles whose normals agree to this lie in one plane (radians).
ONE_PLANE = 3e-5


class TriangleGeometry:
    """Cross products and squared edge lengths of t triangles, computed once for all.

    Attributes
    ----------
    corners : three (t,) int
    cross : three (t,) float64
        Components of (b - a) x (c - a) (m²).
    lengths : three (t,) float64
        Squared lengths of the edges opposite to the corners (m²).
    double_area : (t,) float64
    """

    def __init__(self, coordinates: Coordinates, triangles: AnyArray) -> None:
        self.corners = tuple(np.ascontiguousarray(triangles[:, i]) for i in range(3))
        a, b, c = ([x[i] for x in coordinates] for i in self.corners)
        u = [q - p for p, q in zip(a, b, strict=True)]
        v = [q - p for p, q in zip(a, c, strict=True)]
        w = [q - p for p, q in zip(b, c, strict=True)]
        self.cross = (
            u[1] * v[2] - u[2] * v[1],
            u[2] * v[0] - u[0] * v[2],
            u[0] * v[1] - u[1] * v[0],
        )
        self.lengths = tuple(e[0] * e[0] + e[1] * e[1] + e[2] * e[2] for e in (w, v, u))
        self.double_area = np.sqrt(self.cross[0] ** 2 + self.cross[1] ** 2 + self.cross[2] ** 2)


def first_normals(geometry: TriangleGeometry, count: int) -> tuple[AnyArray, AnyArray]:
    """Return (n, 3) unit normals, and which vertices have triangles in one plane only (n,) bool.

    Face cross products over squared edge lengths (exact on spheres); zero where no face has area.

    Triangles without area weigh nothing.

    References
    ----------
    .. [1] Max (1999). Weights for computing vertex normals from facet normals. Journal of Graphics
           Tools 4(2).
    """
    normals = np.zeros((count, 3))
    total = np.zeros(count)
    sound = geometry.double_area > FLAT_TRIANGLE * np.maximum(
        np.maximum(*geometry.lengths[:2]), geometry.lengths[2]
    )
    for i, corner in enumerate(geometry.corners):
        product = geometry.lengths[i - 1] * geometry.lengths[i - 2]
        weight = np.divide(1.0, product, out=np.zeros(len(corner)), where=sound)
        for axis in range(3):
            normals[:, axis] += sum_by_group(corner, weight * geometry.cross[axis], count)
        total += sum_by_group(corner, weight * geometry.double_area, count)
    length = np.linalg.norm(normals, axis=1)
    normals /= np.where(length > 0, length, 1.0)[:, None]
    # a sum of vectors is as long as all of them only where they have one direction
    return normals, length > (1 - 0.5 * ONE_PLANE**2) * total


def angle_sums(geometry: TriangleGeometry, count: int) -> AnyArray:
    """Return the sum of the triangle angles at every vertex, (n,) in radians."""
    total = np.zeros(count)
    for i, corner in enumerate(geometry.corners):
        cosine = 0.5 * (geometry.lengths[i - 1] + geometry.lengths[i - 2] - geometry.lengths[i])
        total += sum_by_group(corner, np.arctan2(geometry.double_area, cosine), count)
    return total


def tangent_frame(normals: AnyArray) -> tuple[AnyArray, AnyArray]:
    """Return two (n, 3) unit vectors that complete unit normals to right-handed frames.

    References
    ----------
    .. [1] Duff et al. (2017). Building an orthonormal basis, revisited. JCGT 6(1).
    """
    x, y, z = normals[:, 0], normals[:, 1], normals[:, 2]
    sign = np.where(z >= 0, 1.0, -1.0)
    a = -1.0 / (sign + z)
    b = x * y * a
    first = np.stack([1.0 + sign * x * x * a, sign * b, -sign * x], axis=1)
    second = np.stack([b, sign + y * y * a, -y], axis=1)
    return first, second
