# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Curvature of polygons, for their class.

What the face itself shows, not a blunt average of its corners.

At the seam of a fillet and a flat the surface has two curvatures, and a vertex there shows
something between. Two readings are compared per face and
the flatter is taken where they tell of such a seam:

- the corner that bends least (a strip of a flat beside a fillet has corners that know they are
flat), and
- the turn of the face: half the dihedral angle at each of its edges, over its own width (a large
flat n-gon hardly turns, though all its corners
  lie on fillets).
"""

from __future__ import annotations

import numpy as np
from scipy import sparse

from ..types import AnyArray
from .estimator import Estimate
from .tensors import from_principal, to_principal

#: Corners that differ by more than this factor belong to different surfaces.
SEAM = 1.8
#: A face beside a seam turns by less than this share of its most bent corner if it is the flat one.
TURNING = 0.4
#: A polygon is planar if its triangles' normals agree to this (radians).
PLANAR = 1e-3


def _polygon_normals(
    positions: AnyArray, triangles: AnyArray, polygons: AnyArray, count: int
) -> tuple[AnyArray, AnyArray, AnyArray]:
    """Return area vectors (f, 3), unit normals (f, 3) and whether a polygon is planar (f,)."""
    corner = positions[triangles]
    cross = 0.5 * np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
    area = np.stack([np.bincount(polygons, cross[:, i], minlength=count) for i in range(3)], axis=1)
    total = np.bincount(polygons, np.linalg.norm(cross, axis=1), minlength=count)
    length = np.linalg.norm(area, axis=1)
    unit = area / np.maximum(length, 1e-300)[:, None]
    return total, unit, length > (1 - PLANAR**2) * total


def turn_tensor(
    positions: AnyArray, triangles: AnyArray, polygons: AnyArray, unit: AnyArray, area: AnyArray
) -> AnyArray:
    """Return the (6, f) tensor by which a polygon turns.

    Half of each edge's dihedral angle, along the edge, over the polygon's area.

    For a strip of width w between equal bends b this is b / w across the strip. The edges' halves
    of a dihedral angle follow Cohen-Steiner & Morvan.
    Edges inside a polygon and edges of one polygon turn nothing.

    References
    ----------
    .. [1] Cohen-Steiner, Morvan (2003). Restricted Delaunay triangulations and normal cycle. SoCG.
    """
    count = len(unit)
    start, end = triangles.ravel(), np.roll(triangles, -1, axis=1).ravel()
    owner = np.repeat(polygons, 3)
    low, high = np.minimum(start, end), np.maximum(start, end)
    order = np.lexsort((high, low))
    same = (low[order][1:] == low[order][:-1]) & (high[order][1:] == high[order][:-1])
    a, b = order[:-1][same], order[1:][same]
    outside = owner[a] != owner[b]
    a, b = a[outside], b[outside]
    edge = positions[end[a]] - positions[start[a]]
    length = np.linalg.norm(edge, axis=1)
    edge = edge / np.maximum(length, 1e-300)[:, None]
    na, nb = unit[owner[a]], unit[owner[b]]
    # positive where the surface bends away from the normals
    angle = np.arctan2(np.einsum("ij,ij->i", np.cross(na, nb), edge), np.einsum("ij,ij->i", na, nb))
    tensor = np.zeros((6, count))
    for side in (a, b):
        face = owner[side]
        across = np.cross(edge, unit[face])
        weight = 0.5 * angle * length
        for row, (i, j) in enumerate(((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))):
            tensor[row] += np.bincount(face, weight * across[:, i] * across[:, j], minlength=count)
    return tensor / np.maximum(area, 1e-300)


def polygon_curvature(
    positions: AnyArray, triangles: AnyArray, polygons: AnyArray | None, curvature: Estimate
) -> tuple[AnyArray, AnyArray]:
    """Return k1 >= k2 of every polygon, (f,) each, in 1/m; 0 for a polygon without area.

    Parameters
    ----------
    positions : (s, 3) float64
    triangles : (t, 3) int
    polygons : (t,) int or None
        The polygon of each triangle; each triangle its own if None.
    curvature : Estimate
        The estimate at the vertices. Singular and undefined vertices do not count.
    """
    polygons = np.arange(len(triangles)) if polygons is None else np.asarray(polygons)
    count = int(polygons.max(initial=-1)) + 1
    area, unit, planar = _polygon_normals(positions, triangles, polygons, count)
    tensor = from_principal(
        curvature.k1, curvature.k2, curvature.direction_1, curvature.direction_2
    )
    good = (curvature.quality >= 0).astype(float)
    rows = np.repeat(polygons, 3)
    # a corner counts once per polygon, however its triangles lie
    member = sparse.csr_matrix(
        (np.ones(len(rows)), (rows, triangles.ravel())), shape=(count, len(positions))
    )
    member.sum_duplicates()
    member.data = good[member.indices]
    total = np.asarray(member.sum(axis=1)).ravel()
    mean = (member @ tensor.T).T / np.maximum(total, 1)
    k1, k2, *_ = to_principal(mean, np.where(area[:, None] > 0, unit, [0.0, 0.0, 1.0]))
    size = np.maximum(np.abs(curvature.k1), np.abs(curvature.k2))
    size = np.where(good > 0, size, np.inf)
    filled = np.diff(member.indptr) > 0
    start = member.indptr[:-1][filled]
    if not len(start):
        return np.zeros(count), np.zeros(count)
    least, most = np.full(count, np.inf), np.zeros(count)
    least[filled] = np.minimum.reduceat(size[member.indices], start)
    most[filled] = np.maximum.reduceat(np.where(np.isfinite(size), size, 0)[member.indices], start)
    least = np.where(np.isfinite(least), least, 0)
    # the flattest corner's own values
    entry = np.repeat(np.arange(count), np.diff(member.indptr))
    winner = np.full(count, -1)
    hit = size[member.indices] == least[entry]
    winner[entry[hit]] = member.indices[hit]
    turning = turn_tensor(positions, triangles, polygons, unit, area)
    t1, t2, *_ = to_principal(turning, np.where(area[:, None] > 0, unit, [0.0, 0.0, 1.0]))
    flatness = np.maximum(np.abs(t1), np.abs(t2))
    # the first strip of a fillet has a flat corner too, but turns as the others do
    seam = planar & (most > SEAM * least) & (winner >= 0) & (flatness < TURNING * most)
    # bends along the rim are not seen by the turn: it only ever speaks for flatness, of polygons
    # with more than three sides
    sides = np.diff(member.indptr)
    quiet = planar & (sides > 3) & (SEAM * flatness < least)
    k1 = np.where(seam, curvature.k1[winner], k1)
    k2 = np.where(seam, curvature.k2[winner], k2)
    k1, k2 = np.where(quiet, t1, k1), np.where(quiet, t2, k2)
    none = (area <= 0) | (total == 0)
    return np.where(none, 0.0, k1), np.where(none, 0.0, k2)
