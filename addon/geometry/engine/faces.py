# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Curvature of polygons, for their class: what the face shows, not a blunt average of its corners.

Where nothing happens, a face has the mean of its corners' tensors. At the seam of a fillet and a
flat the surface has two curvatures, and a corner there shows something between. There the turn of
the face decides, half the dihedral angle at each of its edges over its own width: a face that
hardly turns is as flat as its flattest corner, one that turns as its most bent corner says belongs
to the fillet. A large n-gon that hardly turns is flat though all its corners lie on fillets.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..groups import sum_by_group
from ..types import AnyArray, Graph
from .estimate import Estimate
from .normals import tangent_frame
from .sparse import compressed
from .tensors import eigenvalues_in_plane, from_principal, to_principal
from .turning import Facets, turn_of_polygons

#: Corners that differ by more than this factor belong to different surfaces.
SEAM = 1.8
#: A face beside a seam turns by less than the first share of its most bent corner if it is the flat
#: one, and by more than the second if it is the bent one.
FLAT_SIDE, BENT_SIDE = 0.4, 0.6
#: Polygons over which the circle of their most bent corner turns by less than this (radians) are
#: seen by their corners without foreshortening to speak of.
EVEN = 0.01
#: Polygons over which the circle of their least bent corner turns by less than this are no plates
#: between fillets (radians).
PLATE = 0.1


@dataclass
class _Polygons:
    """Which vertices each of f polygons has, and how it lies.

    Attributes
    ----------
    member : (f, n) sparse
        1 for each corner that counts, 0 for the others.
    total : (f,) float64
        Corners that count.
    least, most : (f,) float64
        Larger absolute curvature of the flattest and of the most bent corner (1/m).
    facets : Facets
    """

    member: Graph
    total: AnyArray
    least: AnyArray
    most: AnyArray
    facets: Facets


def polygon_curvature(
    positions: AnyArray,
    corners: tuple[AnyArray, AnyArray],
    triangles: tuple[AnyArray, AnyArray],
    facets: Facets,
    curvature: Estimate,
    wanted: AnyArray | None = None,
) -> tuple[AnyArray, AnyArray]:
    """Return k1 >= k2 of every polygon, (f,) each, in 1/m; 0 for a polygon without area.

    Parameters
    ----------
    positions : (s, 3) float64
    corners : (c,) int, (f + 1,) int
        The vertex of each corner, polygon by polygon, and where polygons start.
    triangles : (t, 3) int, (t,) int
        The vertices of the triangles that fill the polygons, and the polygon of each.
    facets : Facets
    curvature : Estimate
        The estimate at the vertices. Singular and undefined vertices do not count.
    wanted : (f,) bool, optional
        Polygons that are asked for; what is returned for others has no meaning.
    """
    vertex, start = corners
    counts = (curvature.quality >= 0)[vertex]
    size = np.maximum(np.abs(curvature.k1), np.abs(curvature.k2))[vertex]
    least = np.minimum.reduceat(np.where(counts, size, np.inf), start[:-1])
    total = np.add.reduceat(counts.astype(float), start[:-1])
    each = _Polygons(
        member=compressed(counts.astype(float), vertex, start, (len(start) - 1, len(positions))),
        total=total,
        least=np.where(total > 0, least, 0.0),
        most=np.maximum.reduceat(np.where(counts, size, 0.0), start[:-1]),
        facets=facets,
    )
    if wanted is None:
        wanted = np.ones(len(total), dtype=bool)
    k1, k2 = _mean_of_corners(each, curvature, wanted)
    _judge_seams(each, positions, triangles, curvature, (k1, k2), wanted)
    none = (facets.area <= 0) | (total == 0)
    k1[none], k2[none] = 0.0, 0.0
    return k1, k2


def _mean_of_corners(
    each: _Polygons, curvature: Estimate, wanted: AnyArray
) -> tuple[AnyArray, AnyArray]:
    tensor = from_principal(
        curvature.k1, curvature.k2, curvature.direction_1, curvature.direction_2
    )
    # an umbilic has no directions, but it bends: the same in all of its tangent plane
    umbilic = np.flatnonzero(~curvature.direction_1.any(axis=1) & (curvature.k1 != 0))
    x, y, z = curvature.normals[umbilic].T
    entries = np.stack([1 - x * x, 1 - y * y, 1 - z * z, -x * y, -x * z, -y * z])
    tensor[:, umbilic] = 0.5 * (curvature.k1 + curvature.k2)[umbilic] * entries
    mean = (each.member @ tensor.T).T / np.maximum(each.total, 1)
    k1, k2 = eigenvalues_in_plane(mean)
    # a tensor seen from a leaning plane is foreshortened: on coarse meshes corners are turned into
    # the face's plane first
    coarse = (each.most * np.sqrt(each.facets.area) > EVEN) & (each.total > 0)
    coarse = np.flatnonzero(coarse & wanted)
    if len(coarse):
        k1[coarse], k2[coarse] = _turned_mean(each, curvature, coarse)
    return k1, k2


def _entries(each: _Polygons, polygons: AnyArray) -> tuple[AnyArray, AnyArray]:
    """Return the place in a list of chosen polygons and the vertex of each corner that counts."""
    rows = each.member[polygons]
    place = np.repeat(np.arange(len(polygons)), np.diff(rows.indptr))
    counts = rows.data > 0
    return place[counts], rows.indices[counts]


def _turned_mean(
    each: _Polygons, curvature: Estimate, polygons: AnyArray
) -> tuple[AnyArray, AnyArray]:
    """Return k1, k2 of the mean of corners' tensors, each turned by the shortest way."""
    place, corner = _entries(each, polygons)
    normal = each.facets.normal[polygons][place]
    first, second = tangent_frame(normal)
    direction, leaning = curvature.direction_1[corner], curvature.normals[corner]
    # a corner that looks the other way cannot be turned by the shortest way: there is none
    facing = np.maximum(np.einsum("ij,ij->i", normal, leaning), -0.5)
    slope = np.einsum("ij,ij->i", normal, direction) / (1 + facing)
    direction = direction - slope[:, None] * (normal + leaning)
    x, y = (np.einsum("ij,ij->i", direction, axis) for axis in (first, second))
    mean, half = (0.5 * (curvature.k1 + sign * curvature.k2)[corner] for sign in (1, -1))
    many = np.maximum(each.total[polygons], 1)
    trace, cosine, sine = (
        sum_by_group(place, values, len(polygons)) / many
        for values in (mean, half * (x * x - y * y), half * 2 * x * y)
    )
    gap = np.hypot(cosine, sine)
    return trace + gap, trace - gap


def _judge_seams(
    each: _Polygons,
    positions: AnyArray,
    triangles: tuple[AnyArray, AnyArray],
    curvature: Estimate,
    k: tuple[AnyArray, AnyArray],
    wanted: AnyArray,
) -> None:
    """Overwrite the curvature k1, k2 of polygons beside seams by that of their own side."""
    k1, k2 = k
    least, most, facets = each.least, each.most, each.facets
    # a single triangle's turn says little
    many_sided = np.diff(each.member.indptr) > 3
    seam = facets.is_planar & (most > SEAM * least) & (each.total > 0)
    plate = facets.is_planar & many_sided & (least * np.sqrt(facets.area) > PLATE)
    chosen = np.flatnonzero((seam | plate) & wanted)
    if not len(chosen):
        return
    tensor, is_open = turn_of_polygons(positions, *triangles, facets, chosen)
    seam, plate, many_sided = seam[chosen], plate[chosen], many_sided[chosen]
    least, most = least[chosen], most[chosen]
    t1, t2, *_ = to_principal(tensor, facets.normal[chosen])
    flatness = np.maximum(np.abs(t1), np.abs(t2))
    place, corner = _entries(each, chosen)
    size = np.maximum(np.abs(curvature.k1), np.abs(curvature.k2))[corner]
    flat_side = seam & (flatness < FLAT_SIDE * most)
    bent_side = seam & many_sided & (flatness > BENT_SIDE * most)
    for side, extreme in ((flat_side, least), (bent_side, most)):
        hit = side[place] & (size == extreme[place])
        k1[chosen[place[hit]]] = curvature.k1[corner[hit]]
        k2[chosen[place[hit]]] = curvature.k2[corner[hit]]
    # at a rim a polygon is seen to turn at its inner sides only
    quiet = plate & (SEAM * flatness * np.where(is_open, 2.0, 1.0) < least)
    k1[chosen[quiet]], k2[chosen[quiet]] = t1[quiet], t2[quiet]
