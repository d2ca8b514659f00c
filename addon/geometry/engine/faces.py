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

from ..types import AnyArray, Graph
from .estimator import Estimate
from .normals import tangent_frame
from .sparse import pattern
from .tensors import from_principal, to_principal
from .turning import Turn, turn_of_polygons

#: Corners that differ by more than this factor belong to different surfaces.
SEAM = 1.8
#: A face beside a seam turns by less than the first share of its most bent corner if it is the flat
#: one, and by more than the second if it is the bent one.
FLAT_SIDE, BENT_SIDE = 0.4, 0.6
#: Corners whose normals lean from the face's by more than this cosine are turned into its plane.
LEANING = 1 - 1e-5


@dataclass
class _Polygons:
    """Which vertices each of f polygons has, and how it lies.

    Attributes
    ----------
    member : (f, n) sparse
        1 for each corner that counts, once however its triangles lie, 0 for the others.
    total : (f,) float64
        Corners that count.
    turn : Turn
    """

    member: Graph
    total: AnyArray
    turn: Turn


def polygon_curvature(
    positions: AnyArray, triangles: AnyArray, polygons: AnyArray, curvature: Estimate
) -> tuple[AnyArray, AnyArray]:
    """Return k1 >= k2 of every polygon, (f,) each, in 1/m; 0 for a polygon without area.

    Parameters
    ----------
    positions : (s, 3) float64
    triangles : (t, 3) int
    polygons : (t,) int
        The polygon of each triangle.
    curvature : Estimate
        The estimate at the vertices. Singular and undefined vertices do not count.
    """
    count = int(polygons.max(initial=-1)) + 1
    if not count:
        return np.zeros(0), np.zeros(0)
    turn = turn_of_polygons(positions, triangles, polygons, count)
    rows = np.repeat(polygons, 3)
    member = pattern(rows, triangles.ravel(), (count, len(positions)))
    member.sum_duplicates()
    member.data = (curvature.quality >= 0).astype(float)[member.indices]
    total = np.asarray(member.sum(axis=1)).ravel()
    each = _Polygons(member, total, turn)
    k1, k2 = _mean_of_corners(each, curvature)
    _judge_seams(each, curvature, k1, k2)
    none = (turn.area <= 0) | (total == 0)
    k1[none], k2[none] = 0.0, 0.0
    return k1, k2


def _mean_of_corners(each: _Polygons, curvature: Estimate) -> tuple[AnyArray, AnyArray]:
    tensor = from_principal(
        curvature.k1, curvature.k2, curvature.direction_1, curvature.direction_2
    )
    mean = (each.member @ tensor.T).T / np.maximum(each.total, 1)
    k1, k2, *_ = to_principal(mean, each.turn.normal)
    # a tensor seen from a leaning plane is foreshortened: on coarse meshes corners are turned into
    # the face's plane first
    owner = np.repeat(np.arange(len(k1)), np.diff(each.member.indptr))
    corner = each.member.indices
    facing = np.einsum("ij,ij->i", each.turn.normal[owner], curvature.normals[corner])
    leans = (facing < LEANING) & (each.member.data > 0) & (facing > -0.5)
    coarse = np.zeros(len(k1), bool)
    coarse[owner[leans]] = True
    pair = np.flatnonzero(coarse[owner] & (each.member.data > 0) & (facing > -0.5))
    if len(pair):
        place = np.cumsum(coarse) - 1
        values = _turned_mean(each, curvature, owner[pair], corner[pair], facing[pair], place)
        k1[coarse], k2[coarse] = values
    return k1, k2


def _turned_mean(
    each: _Polygons,
    curvature: Estimate,
    owner: AnyArray,
    corner: AnyArray,
    facing: AnyArray,
    place: AnyArray,
) -> tuple[AnyArray, AnyArray]:
    """Return k1, k2 of the mean of corners' tensors, each turned by the shortest way."""
    normal = each.turn.normal[owner]
    first, second = tangent_frame(normal)
    direction = curvature.direction_1[corner]
    slope = np.einsum("ij,ij->i", normal, direction) / (1 + facing)
    direction = direction - slope[:, None] * (normal + curvature.normals[corner])
    x, y = (np.einsum("ij,ij->i", direction, axis) for axis in (first, second))
    mean, half = (0.5 * (curvature.k1 + sign * curvature.k2)[corner] for sign in (1, -1))
    at = place[owner]
    many = np.maximum(np.bincount(at), 1)
    trace, cosine, sine = (
        np.bincount(at, values) / many
        for values in (mean, half * (x * x - y * y), half * 2 * x * y)
    )
    gap = np.hypot(cosine, sine)
    return trace + gap, trace - gap


def _judge_seams(each: _Polygons, curvature: Estimate, k1: AnyArray, k2: AnyArray) -> None:
    """Overwrite the curvature of polygons beside seams by that of their own side."""
    member, turn = each.member, each.turn
    start = member.indptr[:-1]
    filled = np.diff(member.indptr) > 0
    size = np.maximum(np.abs(curvature.k1), np.abs(curvature.k2))[member.indices]
    counts = member.data > 0
    least, most = np.zeros(len(k1)), np.zeros(len(k1))
    least[filled] = np.minimum.reduceat(np.where(counts, size, np.inf), start[filled])
    most[filled] = np.maximum.reduceat(np.where(counts, size, 0.0), start[filled])
    least[each.total == 0] = 0.0
    t1, t2, *_ = to_principal(turn.tensor, turn.normal)
    flatness = np.maximum(np.abs(t1), np.abs(t2))
    many_sided = np.diff(member.indptr) > 3
    seam = turn.is_planar & (most > SEAM * least) & (each.total > 0)
    flat_side = seam & (flatness < FLAT_SIDE * most)
    # a single triangle's turn says little
    bent_side = seam & many_sided & (flatness > BENT_SIDE * most)
    owner = np.repeat(np.arange(len(k1)), np.diff(member.indptr))
    for side, extreme in ((flat_side, least), (bent_side, most)):
        hit = side[owner] & counts & (size == extreme[owner])
        k1[owner[hit]] = curvature.k1[member.indices[hit]]
        k2[owner[hit]] = curvature.k2[member.indices[hit]]
    # at a rim a polygon is seen to turn at its inner sides only
    whole = flatness * np.where(turn.is_open, 2.0, 1.0)
    quiet = turn.is_planar & many_sided & (SEAM * whole < least)
    k1[quiet], k2[quiet] = t1[quiet], t2[quiet]
