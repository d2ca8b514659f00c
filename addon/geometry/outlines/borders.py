# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Borders between regions, as curves."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..surface import Surface
from ..types import Flags, Indices
from .polylines import Polylines, chain_segments


@dataclass(frozen=True)
class BorderCurves:
    """Where regions meet each other, creases included, and where the surface ends.

    Parameters
    ----------
    curves : Polylines
    regions : (c, 2) int64
        The regions on the two sides, smaller number first; -1 for no region or the outside.
    """

    curves: Polylines
    regions: Indices


def trace_borders(
    surface: Surface, face_region: Indices, include_rims: bool = False, tolerance: float = 0.0
) -> BorderCurves:
    """Chain the edges between regions into curves.

    Every curve separates one pair of regions and ends where a third begins.

    Parameters
    ----------
    surface : Surface
    face_region : (m,) int64
        -1 where undefined.
    include_rims : bool
        Whether the surface's own edges are borders.
    tolerance : float
        How far in meters a curve may be moved to straighten the zigzag of edges; 0 keeps the
        edges. Ends stay where they are, so borders go on meeting.

    Returns
    -------
    BorderCurves
        Longest first.
    """
    mesh = surface.mesh
    polygon = mesh.corner_polygon
    pairs = surface.edges.inner
    sides = np.sort(face_region[polygon[pairs]], axis=1)
    is_border = sides[:, 0] != sides[:, 1]
    half = pairs[is_border, 0]
    sides = sides[is_border]
    if include_rims:
        rim = surface.edges.rim
        half = np.concatenate([half, rim])
        outer = np.stack([np.full(len(rim), -1), face_region[polygon[rim]]], axis=1)
        sides = np.concatenate([sides, outer])
    segments = np.stack(
        [mesh.corner_vertex[half], mesh.corner_vertex[mesh.next_corner[half]]], axis=1
    )
    # One node per vertex and pair of regions, so that a curve never changes its pair; where the
    # pairs at a vertex differ, it ends for all of them.
    pair = np.unique(sides, axis=0, return_inverse=True)[1].reshape(-1)
    key = segments * (int(pair.max(initial=0)) + 1) + pair[:, None]
    names, node = np.unique(key.reshape(-1), return_inverse=True)
    vertex = names // (int(pair.max(initial=0)) + 1)
    if not len(segments):
        empty = Polylines(
            np.zeros((0, 3)), np.zeros(1, np.int64), np.zeros(0, np.bool_), np.zeros(0, np.int64)
        )
        return BorderCurves(empty, np.zeros((0, 2), np.int64))
    curves = chain_segments(node.reshape(-1, 2), mesh.vertices[vertex])
    node_pair = np.empty(len(names), dtype=np.int64)
    node_pair[node.reshape(-1)] = np.repeat(pair, 2)
    first = curves.source[curves.start[:-1]]
    unique_sides = np.unique(sides, axis=0)
    result = BorderCurves(
        Polylines(curves.points, curves.start, curves.is_closed, vertex[curves.source]),
        unique_sides[node_pair[first]],
    )
    if tolerance > 0.0:
        return BorderCurves(straighten(result.curves, tolerance), result.regions)
    return result


def straighten(curves: Polylines, tolerance: float, rounds: int = 30) -> Polylines:
    """Return curves without zigzag, each point within a tolerance of where it was.

    Points move to the middle of their neighbors again and again, but no farther than the
    tolerance from where they started; ends of open curves stay.

    Parameters
    ----------
    curves : Polylines
    tolerance : float
        In meters.
    rounds : int
        How often points are moved.

    Returns
    -------
    Polylines
    """
    before, after, is_free = _neighbors(curves)
    points = curves.points.copy()
    for _ in range(rounds):
        middle = 0.25 * points[before] + 0.5 * points + 0.25 * points[after]
        offset = middle - curves.points
        distance = np.linalg.norm(offset, axis=1)
        offset *= np.minimum(1.0, tolerance / np.maximum(distance, 1e-300))[:, None]
        points = np.where(is_free[:, None], curves.points + offset, points)
    return Polylines(points, curves.start, curves.is_closed, curves.source)


def _neighbors(curves: Polylines) -> tuple[Indices, Indices, Flags]:
    count = len(curves.points)
    before, after = np.arange(count) - 1, np.arange(count) + 1
    first, last = curves.start[:-1], curves.start[1:] - 1
    before[first] = np.where(curves.is_closed, last, first)
    after[last] = np.where(curves.is_closed, first, last)
    is_free = np.ones(count, dtype=np.bool_)
    is_free[first[~curves.is_closed]] = False
    is_free[last[~curves.is_closed]] = False
    return before, after, is_free
