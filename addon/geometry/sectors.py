# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Smooth sectors: the fans of faces at a vertex that creases and rims separate."""

from __future__ import annotations

import numpy as np

from .groups import connected_groups, sum_by_group
from .mesh import PolygonMesh
from .types import Floats, Indices


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
        Sector of every corner. Sectors are numbered in the order of their vertices.
    sector_vertex : (s,) int64
        Vertex of every sector; vertices without faces have none.
    """
    one, other = smooth_edges[:, 0], smooth_edges[:, 1]
    following = mesh.next_corner
    # Half-edges u->v and v->u: the corner at u of one polygon continues in the corner at u of the
    # other, which is the one after its half-edge's start.
    tails = np.concatenate([one, following[one]])
    heads = np.concatenate([following[other], other])
    label = connected_groups(np.stack([tails, heads], axis=1), len(mesh.corner_vertex))
    sector_count = int(label.max()) + 1
    vertex = np.empty(sector_count, dtype=np.int64)
    vertex[label] = mesh.corner_vertex
    order = np.argsort(vertex, kind="stable")
    rank = np.empty(sector_count, dtype=np.int64)
    rank[order] = np.arange(sector_count)
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
