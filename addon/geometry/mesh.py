# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A polygon mesh as arrays: what the user modeled, checked but not yet interpreted."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from .errors import InvalidMeshError
from .types import Flags, Floats, Indices


@dataclass(frozen=True)
class PolygonMesh:
    """Vertices and polygons of any size, with the triangles that fill the polygons.

    A *corner* is a vertex of a polygon; corners are numbered polygon by polygon, in order around
    each polygon, counter-clockwise seen from outside.

    Parameters
    ----------
    vertices : (n, 3) float64
        Positions in meters.
    corner_vertex : (c,) int64
        Vertex of every corner.
    polygon_start : (m + 1,) int64
        First corner of every polygon, and the number of corners at the end.
    corner_edge : (c,) int64
        Edge from every corner to the next one of its polygon, numbered from 0.
    edge_is_sharp : (e,) bool
        Edges that the user marked as creases.
    triangle_corner : (t, 3) int64
        Corners of the triangles that fill the polygons, in the polygons' winding.
    triangle_polygon : (t,) int64
        Polygon that each triangle belongs to, in rising order.
    resolution : float
        Rounding step of the coordinates in meters (Blender stores 32-bit floats), or 0.
    """

    vertices: Floats
    corner_vertex: Indices
    polygon_start: Indices
    corner_edge: Indices
    edge_is_sharp: Flags
    triangle_corner: Indices
    triangle_polygon: Indices
    resolution: float = field(default=0.0)

    def __post_init__(self) -> None:
        """Refuse what cannot be analyzed at all."""
        _check_vertices(self.vertices)
        _check_polygons(self)

    @property
    def vertex_count(self) -> int:
        """Number of vertices, unused ones included."""
        return len(self.vertices)

    @property
    def polygon_count(self) -> int:
        """Number of polygons."""
        return len(self.polygon_start) - 1

    @cached_property
    def corner_polygon(self) -> Indices:
        """(c,) polygon of every corner."""
        return np.repeat(np.arange(self.polygon_count), np.diff(self.polygon_start))

    @cached_property
    def next_corner(self) -> Indices:
        """(c,) following corner of the same polygon."""
        return _following(self.polygon_start)

    @property
    def previous_corner(self) -> Indices:
        """(c,) preceding corner of the same polygon."""
        preceding = np.arange(-1, len(self.corner_vertex) - 1)
        preceding[self.polygon_start[:-1]] = self.polygon_start[1:] - 1
        return preceding

    @property
    def diagonal(self) -> float:
        """Diagonal of the bounding box of the used vertices, in meters."""
        is_used = np.zeros(self.vertex_count, dtype=np.bool_)
        is_used[self.corner_vertex] = True
        used = self.vertices[is_used]
        return float(np.linalg.norm(used.max(axis=0) - used.min(axis=0)))


def mesh_from_polygons(
    vertices: Floats,
    polygons: Sequence[Sequence[int]] | Indices,
    sharp_edges: Sequence[tuple[int, int]] = (),
    resolution: float = 0.0,
) -> PolygonMesh:
    """Return a mesh from a list of polygons, which are filled by fans of triangles.

    Parameters
    ----------
    vertices : (n, 3) array_like
        Positions in meters.
    polygons : (m, k) int array, or a sequence of sequences of vertex numbers
        Counter-clockwise seen from outside; n-gons should be convex.
    sharp_edges : sequence of pairs of vertex numbers
        Edges that count as creases whatever their angle.
    resolution : float
        Rounding step of the coordinates in meters, or 0.

    Returns
    -------
    PolygonMesh

    Raises
    ------
    InvalidMeshError
        If the mesh is empty, an index is out of range or a coordinate is not finite.
    """
    sizes, corner_vertex = _corners(polygons)
    start = np.concatenate([[0], np.cumsum(sizes)]).astype(np.int64)
    positions = np.array(vertices, dtype=np.float64).reshape(-1, 3)
    _check_sizes(sizes)
    following = corner_vertex[_following(start)]
    corner_edge, edges = number_edges(corner_vertex, following, len(positions))
    marked = np.sort(np.array(sharp_edges, dtype=np.int64).reshape(-1, 2), axis=1)
    edge_keys = edges[:, 0] * len(positions) + edges[:, 1]
    triangle_polygon = np.repeat(np.arange(len(sizes)), sizes - 2)
    first = start[:-1][triangle_polygon]
    step = np.arange(len(triangle_polygon)) - np.concatenate([[0], np.cumsum(sizes - 2)])[
        triangle_polygon
    ].astype(np.int64)
    return PolygonMesh(
        vertices=positions,
        corner_vertex=corner_vertex,
        polygon_start=start,
        corner_edge=corner_edge,
        edge_is_sharp=np.isin(edge_keys, marked[:, 0] * len(positions) + marked[:, 1]),
        triangle_corner=np.stack([first, first + step + 1, first + step + 2], axis=1),
        triangle_polygon=triangle_polygon,
        resolution=resolution,
    )


def number_edges(
    start_vertex: Indices, end_vertex: Indices, vertex_count: int
) -> tuple[Indices, Indices]:
    """Return the undirected edge of every half-edge, and the edges' sorted end vertices.

    Parameters
    ----------
    start_vertex, end_vertex : (c,) int64
        Ends of the half-edges.
    vertex_count : int
        Number of vertices.

    Returns
    -------
    half_edge_edge : (c,) int64
        Number of the undirected edge.
    edges : (e, 2) int64
        Smaller and larger vertex of every edge.
    """
    low = np.minimum(start_vertex, end_vertex)
    high = np.maximum(start_vertex, end_vertex)
    keys, half_edge_edge = np.unique(low * vertex_count + high, return_inverse=True)
    return half_edge_edge.reshape(-1), np.stack(np.divmod(keys, max(vertex_count, 1)), axis=1)


def _corners(polygons: Sequence[Sequence[int]] | Indices) -> tuple[Indices, Indices]:
    """Return the number of corners of every polygon, and the vertices of all corners."""
    if isinstance(polygons, np.ndarray) and polygons.ndim == 2:
        sizes = np.full(len(polygons), polygons.shape[1], dtype=np.int64)
        return sizes, polygons.astype(np.int64).ravel()
    sizes = np.array([len(polygon) for polygon in polygons], dtype=np.int64)
    if not len(sizes):
        return sizes, np.empty(0, dtype=np.int64)
    return sizes, np.concatenate([np.asarray(polygon, dtype=np.int64) for polygon in polygons])


def _following(polygon_start: Indices) -> Indices:
    """Return the corner after every corner of its polygon, (c,) int64."""
    following = np.arange(1, int(polygon_start[-1]) + 1)
    following[polygon_start[1:] - 1] = polygon_start[:-1]
    return following


def _check_vertices(vertices: Floats) -> None:
    if vertices.ndim != 2 or vertices.shape[1] != 3:
        raise InvalidMeshError(f"vertices must have the shape (n, 3), not {vertices.shape}")
    is_bad = ~np.isfinite(vertices).all(axis=1)
    if is_bad.any():
        raise InvalidMeshError(
            f"{is_bad.sum()} of {len(vertices)} vertices have coordinates that are not finite "
            f"(the first is vertex {int(np.argmax(is_bad))}): delete or move them"
        )


def _check_sizes(sizes: Indices) -> None:
    if len(sizes) == 0:
        raise InvalidMeshError("the mesh has no faces: add faces, or choose another object")
    if sizes.min() < 3:
        raise InvalidMeshError(
            f"face {int(np.argmin(sizes))} has {sizes.min()} corners: a face needs at least three"
        )


def _check_polygons(mesh: PolygonMesh) -> None:
    _check_sizes(np.diff(mesh.polygon_start))
    low, high = int(mesh.corner_vertex.min()), int(mesh.corner_vertex.max())
    if low < 0 or high >= len(mesh.vertices):
        raise InvalidMeshError(
            f"a face uses vertex {low if low < 0 else high}, "
            f"but the mesh has the vertices 0 to {len(mesh.vertices) - 1}"
        )
