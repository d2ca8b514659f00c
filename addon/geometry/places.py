# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Places on a surface: which triangle a point lies on, and where in it."""

from __future__ import annotations

import numpy as np

from .libigl import TriangleTree
from .surface import Surface
from .types import Floats, Indices

#: How far inside a triangle a vertex of it is taken to be: there the triangle's own field holds.
_INSIDE = 1e-3


class PlaceFinder:
    """Finds the places on a surface that are nearest to points or hit by rays, many times over.

    Parameters
    ----------
    surface : Surface
    """

    def __init__(self, surface: Surface) -> None:
        mesh = surface.mesh
        triangles = mesh.corner_vertex[mesh.triangle_corner]
        self._corners = mesh.vertices[triangles]
        self._tree = TriangleTree(mesh.vertices, triangles)
        low, high = mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)
        self._middle, self._radius = 0.5 * (low + high), 0.5 * mesh.diagonal

    def nearest(self, points: Floats) -> tuple[Indices, Floats, Floats]:
        """Return the nearest places.

        Parameters
        ----------
        points : (p, 3) float64
            In the mesh's coordinates, in meters.

        Returns
        -------
        triangle : (p,) int64
        barycentric : (p, 3) float64
        distance : (p,) float64
            In meters.
        """
        distance, triangle, nearest = self._tree.nearest(points)
        return triangle, _barycentric(self._corners[triangle], nearest), distance

    def deviation(self, points: Floats) -> float:
        """Return the largest distance of points, (p, 3), from the surface, in meters."""
        return float(self.nearest(points)[2].max()) if len(points) else 0.0

    def seen(self, origin: Floats, direction: Floats) -> tuple[int, Floats] | None:
        """Return the first place that a ray meets, from either side; None where it meets nothing.

        Parameters
        ----------
        origin, direction : (3,) float64
            In the mesh's coordinates, in meters; the direction is of any length.

        Returns
        -------
        triangle : int
        barycentric : (3,) float64
        """
        course = direction / np.linalg.norm(direction)
        ahead = float((self._middle - origin) @ course) - 1.01 * self._radius
        start = origin + max(ahead, 0.0) * course
        triangle = self._tree.first_hit(start, course)
        if triangle < 0:
            return None
        a, b, c = self._corners[triangle]
        normal = np.cross(b - a, c - a)
        place = start + (normal @ (a - start)) / (normal @ course) * course
        return triangle, _barycentric(self._corners[triangle][None], place[None])[0]


def vertex_places(surface: Surface, vertices: Indices) -> tuple[Indices, Floats]:
    """Return a place beside each vertex, on the smooth piece where it has the largest angle.

    Parameters
    ----------
    surface : Surface
    vertices : (n,) int64
        Those without faces have no place.

    Returns
    -------
    triangle : (m,) int64
    barycentric : (m, 3) float64
    """
    wanted = surface.vertex_sector[vertices]
    flat = surface.sector_triangles.ravel()
    first = np.full(surface.sector_count, -1, dtype=np.int64)
    first[flat[::-1]] = np.arange(flat.size)[::-1]
    corner = first[wanted[wanted >= 0]]
    corner = corner[corner >= 0]
    barycentric = np.full((len(corner), 3), _INSIDE)
    barycentric[np.arange(len(corner)), corner % 3] = 1.0 - 2.0 * _INSIDE
    return corner // 3, barycentric


def _barycentric(corners: Floats, points: Floats) -> Floats:
    """Return the place of points in the triangles that hold them, (p, 3)."""
    one, two = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    across = np.cross(one, two)
    size = np.maximum(np.einsum("px,px->p", across, across), 1e-300)
    off = points - corners[:, 0]
    second = np.einsum("px,px->p", np.cross(off, two), across) / size
    third = np.einsum("px,px->p", np.cross(one, off), across) / size
    place = np.clip(np.stack([1.0 - second - third, second, third], axis=1), 0.0, 1.0)
    return place / place.sum(axis=1, keepdims=True)
