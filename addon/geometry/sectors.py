# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Smooth sectors: the fans of faces at a vertex that creases and rims separate."""

from __future__ import annotations

import numpy as np

from .groups import connected_groups, sum_by_group
from .mesh import PolygonMesh
from .types import Flags, Floats, Indices

#: Fans of more corners than this are not walked but searched.
_LONGEST_WALK = 12


def smooth_sectors(mesh: PolygonMesh, smooth_edges: Indices) -> tuple[Indices, Indices]:
    """Split every vertex into one sector per fan of faces that smooth edges connect.

    Parameters
    ----------
    mesh : PolygonMesh
    smooth_edges : (q, 2) int64
        The two half-edges of every smooth edge, which run in opposite directions.

    Returns
    -------
    corner_sector : (c,) int64
        Sector of every corner. Sectors are numbered in the order of their vertices, those of one
        vertex in the order of their first corners.
    sector_vertex : (s,) int64
        Vertex of every sector; vertices without faces have none.
    """
    following = mesh.next_corner
    # Half-edges u->v and v->u: the corner at u of one polygon continues in the corner at u of the
    # other, which is the one after its half-edge's start.
    corner_count = len(mesh.corner_vertex)
    turn = np.full(corner_count, -1, dtype=np.int64)
    turn[smooth_edges[:, 0]] = following[smooth_edges[:, 1]]
    turn[smooth_edges[:, 1]] = following[smooth_edges[:, 0]]
    is_whole = _closed_fans(mesh, turn)[mesh.corner_vertex]
    label = np.empty(corner_count, dtype=np.int64)
    # Few vertices lie on creases and rims, and only there is there anything to search.
    label[is_whole] = mesh.corner_vertex[is_whole]
    if is_whole.all():
        sector_vertex = np.flatnonzero(np.bincount(mesh.corner_vertex))
        number = np.empty(mesh.vertex_count, dtype=np.int64)
        number[sector_vertex] = np.arange(len(sector_vertex))
        return number[mesh.corner_vertex], sector_vertex
    rest = np.flatnonzero(~is_whole)
    label[rest] = mesh.vertex_count + _fans(turn, rest)
    return _numbered(label, mesh.corner_vertex)


def _closed_fans(mesh: PolygonMesh, turn: Indices) -> Flags:
    """Return the vertices whose corners all lie in one fan that closes, (n,) bool.

    Parameters
    ----------
    mesh : PolygonMesh
    turn : (c,) int64
        The corner beyond each corner's half-edge, at the same vertex; -1 at creases and rims.
    """
    valence = np.bincount(mesh.corner_vertex, minlength=mesh.vertex_count)
    inner = np.bincount(mesh.corner_vertex[turn >= 0], minlength=mesh.vertex_count)
    is_closed = (valence == inner) & (valence > 0) & (valence <= _LONGEST_WALK)
    start = np.empty(mesh.vertex_count, dtype=np.int64)
    start[mesh.corner_vertex] = np.arange(len(mesh.corner_vertex))
    # Where two closed fans meet in one vertex, the walk comes back too early.
    vertices = np.flatnonzero(is_closed)
    first = start[vertices]
    here = turn[first]
    for steps in range(1, _LONGEST_WALK + 1):
        is_back = here == first
        is_closed[vertices[is_back]] = valence[vertices[is_back]] == steps
        vertices, first, here = vertices[~is_back], first[~is_back], turn[here[~is_back]]
        if not len(vertices):
            break
    is_closed[vertices] = False
    return is_closed


def _fans(turn: Indices, corners: Indices) -> Indices:
    """Return the fan of every chosen corner, numbered from 0; whole vertices are chosen."""
    place = np.full(len(turn), -1, dtype=np.int64)
    place[corners] = np.arange(len(corners))
    linked = corners[turn[corners] >= 0]
    pairs = np.stack([place[linked], place[turn[linked]]], axis=1)
    return connected_groups(pairs, len(corners))


def _numbered(label: Indices, corner_vertex: Indices) -> tuple[Indices, Indices]:
    """Return labels of corners numbered by vertex and first corner, and the vertex of each."""
    first = np.full(int(label.max()) + 1, -1, dtype=np.int64)
    first[label[::-1]] = np.arange(len(label))[::-1]
    used = np.flatnonzero(first >= 0)
    vertex = corner_vertex[first[used]]
    order = np.lexsort((first[used], vertex))
    rank = np.empty(len(first), dtype=np.int64)
    rank[used[order]] = np.arange(len(used))
    return rank[label], vertex[order]


def leading_sectors(
    sector_vertex: Indices, corner_sector: Indices, angles: Floats, vertex_count: int
) -> Indices:
    """Return the sector with the largest angle at every vertex.

    Parameters
    ----------
    sector_vertex : (s,) int64
        Vertex of every sector.
    corner_sector : (c,) int64
        Sector of every corner.
    angles : (c,) float64
        Interior angles of the corners in radians.
    vertex_count : int

    Returns
    -------
    (n,) int64
        Sector of every vertex, -1 for a vertex without faces.
    """
    sector_angle = sum_by_group(corner_sector, angles, len(sector_vertex))
    # Angles that differ by rounding only must not decide: then the first sector leads.
    order = np.lexsort((-np.arange(len(sector_vertex)), np.round(sector_angle, 9)))
    leading = np.full(vertex_count, -1, dtype=np.int64)
    leading[sector_vertex[order]] = order
    return leading
