# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The triangles of a cut surface with what walking over them needs: neighbors and frames."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..surface import Surface
from ..types import Flags, Floats, Indices
from .vectors import cross, dot, unit

#: Double area over squared longest side below which a triangle is taken for a segment.
_THINNEST = 1e-12


@dataclass(frozen=True)
class Triangulation:
    """Triangles between the sectors of a surface.

    Side i of a triangle lies opposite to its corner i and runs from corner i + 1 to corner i + 2.
    On it the barycentric coordinate i is zero.

    Parameters
    ----------
    position : (s, 3) float64
        Of the sectors, from the middle of the bounding box, in meters.
    offset : (3,) float64
        What to add to positions to get back to the mesh.
    triangles : (t, 3) int64
        Sectors at the corners, counter-clockwise seen from outside.
    neighbor : (t, 3) int64
        Triangle beyond each side, -1 at creases and rims.
    neighbor_side : (t, 3) int64
        The same side, as the neighbor numbers it.
    is_rim : (t, 3) bool
        Sides that no other polygon shares; other sides without neighbor are creases.
    """

    position: Floats
    offset: Floats
    triangles: Indices
    neighbor: Indices
    neighbor_side: Indices
    is_rim: Flags

    @cached_property
    def frame(self) -> Floats:
        """(t, 3, 3) right-handed orthonormal rows: along side 2, across it, normal."""
        a, b, c = (self.position[self.triangles[:, i]] for i in range(3))
        normal = cross(b - a, c - a)
        length = np.sqrt((normal**2).sum(axis=1))
        first = b - a
        size = np.sqrt((first**2).sum(axis=1))
        first = first / np.where(size > 0.0, size, 1.0)[:, None]
        first[size == 0.0] = (1.0, 0.0, 0.0)
        normal = normal / np.where(length > 0.0, length, 1.0)[:, None]
        normal[length == 0.0] = _across(first[length == 0.0])
        return np.stack([first, cross(normal, first), normal], axis=1)

    @cached_property
    def gradient(self) -> Floats:
        """(t, 3, 3) gradients of the three barycentric coordinates, as vectors in space, 1/m."""
        a, b, c = (self.position[self.triangles[:, i]] for i in range(3))
        sides = np.stack([c - b, a - c, b - a], axis=1)
        longest = (sides**2).sum(axis=2).max(axis=1)
        area = np.maximum(self.double_area, _THINNEST * longest + 1e-300)
        return cross(self.frame[:, None, 2], sides) / area[:, None, None]

    @cached_property
    def double_area(self) -> Floats:
        """(t,) twice the areas of the triangles in m²."""
        a, b, c = (self.position[self.triangles[:, i]] for i in range(3))
        normal = cross(b - a, c - a)
        return np.sqrt(dot(normal, normal))

    @cached_property
    def edge_length(self) -> float:
        """Median length of the sides of triangles that have area, in meters."""
        a, b = self.position[self.triangles[:, 0]], self.position[self.triangles[:, 1]]
        return float(np.median(np.sqrt(dot(b - a, b - a))))

    @property
    def sector_count(self) -> int:
        """Number of sectors."""
        return len(self.position)

    def points(self, triangle: Indices, barycentric: Floats) -> Floats:
        """Return points in the mesh's coordinates, (p, 3) in meters."""
        corner = self.position[self.triangles[triangle]]
        return np.einsum("pc,pcx->px", barycentric, corner) + self.offset


def triangulate(surface: Surface) -> Triangulation:
    """Return the triangles that fill a surface's polygons, joined across smooth edges only.

    Parameters
    ----------
    surface : Surface

    Returns
    -------
    Triangulation
    """
    mesh = surface.mesh
    triangles = surface.sector_triangles
    label, is_rim = _side_labels(surface)
    order = np.argsort(label, kind="stable")
    ordered = label[order]
    first = np.flatnonzero(ordered[1:] == ordered[:-1])
    one, other = order[first], order[first + 1]
    beyond = np.full(label.size, -1, dtype=np.int64)
    beyond[one], beyond[other] = other, one
    position = mesh.vertices[surface.sector_vertex]
    return Triangulation(
        position=surface.sector_position,
        offset=0.5 * (position.min(axis=0) + position.max(axis=0)),
        triangles=triangles,
        neighbor=np.where(beyond >= 0, beyond // 3, -1).reshape(-1, 3),
        neighbor_side=np.where(beyond >= 0, beyond % 3, -1).reshape(-1, 3),
        is_rim=is_rim.reshape(-1, 3),
    )


def _side_labels(surface: Surface) -> tuple[Indices, Flags]:
    """Return a number per side, equal for the two sides to be joined, and which are rims, (3t,)."""
    mesh = surface.mesh
    corner = mesh.triangle_corner
    start, end = np.roll(corner, -1, axis=1).ravel(), np.roll(corner, -2, axis=1).ravel()
    count = len(mesh.corner_vertex)
    # A diagonal lies inside a polygon: there its two corners name it.
    label = count + np.minimum(start, end) * count + np.maximum(start, end)
    is_outline = mesh.next_corner[start] == end
    half_edge = np.arange(count)
    inner = surface.edges.smooth
    half_edge[inner[:, 1]] = inner[:, 0]
    label[is_outline] = half_edge[start[is_outline]]
    is_rim_corner = np.zeros(count, dtype=np.bool_)
    is_rim_corner[surface.edges.rim] = True
    return label, is_outline & is_rim_corner[start]


def _across(vectors: Floats) -> Floats:
    """Return unit vectors at right angles to unit vectors, (n, 3)."""
    axis = np.eye(3)[np.argmin(np.abs(vectors), axis=1)]
    return unit(cross(vectors, axis))
