# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The only door to libigl: its functions under our names, types and conventions."""

from __future__ import annotations

import numpy as np

from .types import Flags, Floats, Indices


def misoriented_triangles(triangles: Indices) -> Flags:
    """Return which triangles would have to turn for the winding to agree.

    Parameters
    ----------
    triangles : (t, 3) int64

    Returns
    -------
    (t,) bool
        In every piece of the surface the fewer triangles. Pieces that cannot be oriented, such as
        a Moebius strip, keep a seam whichever triangles turn.
    """
    # Together with scipy, libigl takes long to load; Blender's start must not pay for it.
    import igl  # pyright: ignore[reportMissingTypeStubs] – it does not declare its types

    result = igl.bfs_orient(np.ascontiguousarray(triangles, dtype=np.int64))
    oriented, piece = (np.asarray(each, dtype=np.int64) for each in result)
    is_turned = (oriented != triangles).any(axis=1)
    patch = piece.reshape(-1)
    share = np.bincount(patch, is_turned) / np.maximum(np.bincount(patch), 1)
    return is_turned != (share > 0.5)[patch]


class TriangleTree:
    """Triangles in an order in which those nearest to points, or hit by a ray, are found fast.

    Parameters
    ----------
    vertices : (n, 3) float64
    triangles : (t, 3) int64
    """

    def __init__(self, vertices: Floats, triangles: Indices) -> None:
        import igl  # pyright: ignore[reportMissingTypeStubs] – it does not declare its types

        self._mesh = (
            np.ascontiguousarray(vertices, dtype=np.float64),
            np.ascontiguousarray(triangles, dtype=np.int64),
        )
        self._tree = igl.AABB()
        self._tree.init(*self._mesh)

    def nearest(self, points: Floats) -> tuple[Floats, Indices, Floats]:
        """Return what of the triangles is nearest to points.

        Parameters
        ----------
        points : (p, 3) float64

        Returns
        -------
        distance : (p,) float64
        triangle : (p,) int64
        nearest : (p, 3) float64
        """
        found = self._tree.squared_distance(
            *self._mesh, np.ascontiguousarray(points, dtype=np.float64)
        )
        squared, triangle, nearest = found
        return (
            np.sqrt(np.asarray(squared, dtype=np.float64).reshape(-1)),
            np.asarray(triangle, dtype=np.int64).reshape(-1),
            np.asarray(nearest, dtype=np.float64).reshape(-1, 3),
        )

    def first_hit(self, origin: Floats, direction: Floats) -> int:
        """Return the first triangle that a ray meets, -1 for none.

        Parameters
        ----------
        origin : (3,) float64
            Not many sizes of the model away: libigl compares distances in single precision.
        direction : (3,) float64
        """
        start, course = np.ascontiguousarray(origin[None]), np.ascontiguousarray(direction[None])
        found = self._tree.intersect_ray_first(*self._mesh, start, course)[0]
        return int(np.asarray(found, dtype=np.int64)[0])
