# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""By how much a polygon turns: half of the fold at each of its edges.

References
----------
.. [1] Cohen-Steiner, Morvan (2003). Restricted Delaunay triangulations and normal cycle. SoCG.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..groups import sum_by_group
from ..types import AnyArray

#: A polygon is planar if its triangles' normals agree to this (radians).
PLANAR = 1e-3


@dataclass
class Facets:
    """How f polygons lie.

    Attributes
    ----------
    area : (f,) float64
        Area (m²).
    normal : (f, 3) float64
        Unit normals; z where there is no area.
    is_planar : (f,) bool
    """

    area: AnyArray
    normal: AnyArray
    is_planar: AnyArray


def facets_of_polygons(vector: AnyArray, area: AnyArray) -> Facets:
    """Return how polygons lie, given their vector areas (f, 3) and areas (f,) in m²."""
    length = np.sqrt(np.einsum("ij,ij->i", vector, vector))
    normal = vector / np.where(length > 0, length, 1.0)[:, None]
    normal[length == 0] = [0.0, 0.0, 1.0]
    return Facets(area, normal, (length > (1 - PLANAR**2) * area) & (length > 0))


def turn_of_polygons(
    positions: AnyArray, triangles: AnyArray, polygons: AnyArray, facets: Facets, chosen: AnyArray
) -> tuple[AnyArray, AnyArray]:
    """Return by how much chosen polygons turn, and which of them lie on the rim.

    Parameters
    ----------
    positions : (n, 3) float64
    triangles : (t, 3) int
    polygons : (t,) int
    facets : Facets
        Of all polygons.
    chosen : (m,) int

    Returns
    -------
    tensor : (6, m) float64
        xx, yy, zz, xy, xz, yz: half of each edge's fold times its length, across the edge, over
        the polygon's area (1/m). For a strip of width w between equal folds b this is b / w across
        the strip.
    is_open : (m,) bool
        Polygons with an edge that no other polygon has.
    """
    count = len(facets.area)
    is_chosen = np.zeros(count, bool)
    is_chosen[chosen] = True
    # only what shares an edge with a chosen polygon matters, so what has two of its vertices
    is_near = np.zeros(len(positions), bool)
    is_near[triangles[is_chosen[polygons]]] = True
    used = np.flatnonzero(is_near[triangles].sum(axis=1) > 1)
    triangles, polygons = triangles[used], polygons[used]
    start, end = triangles.ravel(), np.roll(triangles, -1, axis=1).ravel()
    key = np.minimum(start, end).astype(np.int64) * len(positions) + np.maximum(start, end)
    order = np.argsort(key, kind="stable")
    ordered = key[order]
    same = ordered[1:] == ordered[:-1]
    owner = np.repeat(polygons, 3)
    is_alone = np.ones(len(key), bool)
    is_alone[1:] &= ~same
    is_alone[:-1] &= ~same
    is_open = np.zeros(count, bool)
    is_open[owner[order[is_alone]]] = True
    one, other = order[:-1][same], order[1:][same]
    # edges inside a polygon turn nothing
    outside = owner[one] != owner[other]
    one, other = one[outside], other[outside]
    edge = positions[end[one]] - positions[start[one]]
    size = np.linalg.norm(edge, axis=1)
    edge /= np.where(size > 0, size, 1.0)[:, None]
    n1, n2 = facets.normal[owner[one]], facets.normal[owner[other]]
    # positive where the surface bends away from the normals
    fold = np.arctan2(np.einsum("ij,ij->i", np.cross(n1, n2), edge), np.einsum("ij,ij->i", n1, n2))
    tensor = np.zeros((6, count))
    for side in (one, other):
        face = owner[side]
        across = np.cross(edge, facets.normal[face])
        weight = 0.5 * fold * size
        for row, (i, j) in enumerate(((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))):
            tensor[row] += sum_by_group(face, weight * across[:, i] * across[:, j], count)
    area = facets.area[chosen]
    return tensor[:, chosen] / np.where(area > 0, area, 1.0), is_open[chosen]
