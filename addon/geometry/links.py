# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Links between neighbors: polygons at smooth edges, sectors along edges, regions at borders."""

from __future__ import annotations

import numpy as np

from .groups import sum_by_group
from .surface import Surface
from .types import Flags, Floats, Indices


def half_edge_lengths(surface: Surface) -> Floats:
    """Return the length of the edge that starts at every corner, (c,) float64 in meters."""
    position = surface.mesh.vertices[surface.mesh.corner_vertex]
    return np.linalg.norm(position[surface.mesh.next_corner] - position, axis=1)


def smooth_links(surface: Surface) -> tuple[Indices, Floats]:
    """Return the pairs of polygons that smooth edges join, (q, 2), and the edges' lengths in m."""
    mesh, smooth = surface.mesh, surface.edges.smooth
    first = smooth[:, 0]
    ends = np.stack(
        [mesh.corner_vertex[first], mesh.corner_vertex[mesh.next_corner[first]]], axis=1
    )
    return mesh.corner_polygon[smooth], link_lengths(mesh.vertices, ends)


def sector_links(surface: Surface) -> Indices:
    """Return the pairs of sectors that an edge of a triangle joins, (p, 2), each once."""
    triangles = surface.sector_triangles
    ends = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    low, high = ends.min(axis=1), ends.max(axis=1)
    keys = np.unique(low * surface.sector_count + high)
    return np.stack(np.divmod(keys, surface.sector_count), axis=1)


def rim_sectors(surface: Surface) -> Flags:
    """Return the sectors on rims and creases, (s,) bool."""
    is_smooth = np.zeros(len(surface.corner_sector), dtype=np.bool_)
    is_smooth[surface.edges.smooth.reshape(-1)] = True
    corner = np.flatnonzero(~is_smooth)
    rim = np.zeros(surface.sector_count, dtype=np.bool_)
    rim[surface.corner_sector[corner]] = True
    rim[surface.corner_sector[surface.mesh.next_corner[corner]]] = True
    return rim


def joined_links(pairs: Indices, length: Floats, count: int) -> tuple[Indices, Floats]:
    """Return every pair of different items once, smaller number first, with its total length.

    Parameters
    ----------
    pairs : (p, 2) int64
        Items with a common border; pairs of an item with itself do not count.
    length : (p,) float64
    count : int
        Number of items.

    Returns
    -------
    pairs : (q, 2) int64
    length : (q,) float64
    """
    outer = pairs[:, 0] != pairs[:, 1]
    low, high = pairs[outer].min(axis=1), pairs[outer].max(axis=1)
    keys, compact = np.unique(low * max(count, 1) + high, return_inverse=True)
    return (
        np.stack(np.divmod(keys, max(count, 1)), axis=1),
        sum_by_group(compact.reshape(-1), length[outer], len(keys)),
    )


def link_lengths(position: Floats, links: Indices) -> Floats:
    """Return the distance between the ends of links, (p,) float64."""
    square = np.zeros(len(links))
    for axis in range(3):
        values = np.ascontiguousarray(position[:, axis])
        square += (values[links[:, 0]] - values[links[:, 1]]) ** 2
    return np.sqrt(square)


def typical_length(position: Floats, links: Indices) -> float:
    """Return the median length of links between positions; 0 without links."""
    return float(np.median(link_lengths(position, links))) if len(links) else 0.0
