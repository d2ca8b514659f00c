# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Curvature of flat strips that meet in rulings: exact where the strips are chords of a circle.

CAD programs tessellate cylinders, cones and fillets like this. At a vertex all folds lie along one
line, the ruling. Across it the surface is a polyline, and the circle through three of its corners
turns by the fold: k = 2 sin(fold) / (distance of the outer two).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..groups import sum_by_group
from ..types import AnyArray, Coordinates
from .normals import FLAT_TRIANGLE

#: Part of a vertex's folds that may lie off the ruling.
ASTRAY = 1e-3
#: Folds that add up to less than this are none (radians).
UNFOLDED = 1e-4
#: Strips whose outer sides are nearer to each other than this share of their widths lie upon each
#: other.
FOLDED_BACK = 0.1
#: Neighbors across count by their offset along the ruling, in units of their distance across.
ALONG = 0.1


@dataclass
class Strips:
    """Curvature at m chosen vertices; see `strips_at`.

    Attributes
    ----------
    bend : (m,) float64
        Normal curvature across the ruling (1/m), positive where the surface bends away from the
        normals.
    ruling, normal : (m, 3) float64
        Unit vectors.
    is_found : (m,) bool
        Vertices with strips on both sides and no folds but along the ruling.
    is_flat : (m,) bool
        Vertices without folds.
    """

    bend: AnyArray
    ruling: AnyArray
    normal: AnyArray
    is_found: AnyArray
    is_flat: AnyArray


def strips_at(
    coordinates: Coordinates, triangles: AnyArray, vertices: AnyArray, least: float = UNFOLDED
) -> Strips:
    """Measure the fold, and the strips beside it, at chosen vertices.

    Parameters
    ----------
    coordinates : three (n,) float64
    triangles : (t, 3) int
    vertices : (m,) int
        Distinct.
    least : float
        Folds at a vertex that add up to less than this are too small to read (radians).
    """
    many = len(vertices)
    place = np.full(len(coordinates[0]), -1)
    place[vertices] = np.arange(many)
    triangles = triangles[(place[triangles] >= 0).any(axis=1)]
    position = np.stack(coordinates, axis=1)
    corner = position[triangles]
    cross = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
    double_area = np.linalg.norm(cross, axis=1)
    longest = np.max(np.sum((corner - np.roll(corner, 1, axis=1)) ** 2, axis=2), axis=1, initial=0)
    good = double_area > FLAT_TRIANGLE * longest
    triangles, normal = triangles[good], cross[good] / double_area[good][:, None]
    ruling, turn, total = _folds(position, triangles, normal, place, many)
    is_straight = (total > max(least, UNFOLDED)) & (turn != 0)
    width, side_normal = _widths(position, triangles, normal, place, ruling)
    is_flat = total <= UNFOLDED
    one, other = width
    chord = np.sqrt(np.maximum(one**2 + other**2 + 2 * one * other * np.cos(turn), 0))
    is_found = is_straight & (width > 0).all(axis=0) & (chord > FOLDED_BACK * (one + other))
    bend = np.where(is_found, 2 * np.sin(turn) / np.where(is_found, chord, 1.0), 0.0)
    # the circle's normal at the vertex leans from the strip's by half the strip's own arc
    lean = np.arcsin(np.clip(0.5 * bend * one, -1, 1))[:, None]
    leaning = np.cos(lean) * side_normal - np.sin(lean) * np.cross(side_normal, ruling)
    leaning -= np.einsum("ij,ij->i", leaning, ruling)[:, None] * ruling
    length = np.linalg.norm(leaning, axis=1)
    is_found &= length > 0.5
    leaning /= np.where(is_found, length, 1.0)[:, None]
    return Strips(bend, ruling, leaning, is_found, is_flat)


def _folds(
    position: AnyArray, triangles: AnyArray, normal: AnyArray, place: AnyArray, many: int
) -> tuple[AnyArray, AnyArray, AnyArray]:
    """Return rulings (m, 3), the signed fold across them (m,) and the sum of all folds (m,).

    The fold is zero where folds do not lie along one line.
    """
    start, end = triangles.ravel(), np.roll(triangles, -1, axis=1).ravel()
    low, high = np.minimum(start, end), np.maximum(start, end)
    order = np.lexsort((high, low))
    same = (low[order][1:] == low[order][:-1]) & (high[order][1:] == high[order][:-1])
    one, other = order[:-1][same], order[1:][same]
    edge = position[end[one]] - position[start[one]]
    edge /= np.maximum(np.linalg.norm(edge, axis=1), 1e-300)[:, None]
    n1, n2 = normal[one // 3], normal[other // 3]
    fold = np.arctan2(np.einsum("ij,ij->i", np.cross(n1, n2), edge), np.einsum("ij,ij->i", n1, n2))
    at = place[np.concatenate([start[one], end[one]])]
    edge, fold = np.concatenate([edge, -edge]), np.concatenate([fold, fold])
    edge, fold, at = edge[at >= 0], fold[at >= 0], at[at >= 0]
    tensor = np.empty((many, 3, 3))
    for i in range(3):
        for j in range(3):
            tensor[:, i, j] = sum_by_group(at, np.abs(fold) * edge[:, i] * edge[:, j], many)
    values, vectors = np.linalg.eigh(tensor)
    ruling = np.ascontiguousarray(vectors[:, :, 2])
    total = np.trace(tensor, axis1=1, axis2=2)
    astray = total - values[:, 2] > ASTRAY * total
    ahead = np.einsum("ij,ij->i", edge, ruling[at]) > 0
    sums = [sum_by_group(at[part], fold[part], many) for part in (ahead, ~ahead)]
    present = sum((np.abs(part) > 0.5 * UNFOLDED).astype(float) for part in sums)
    turn = np.where(astray, 0.0, (sums[0] + sums[1]) / np.maximum(present, 1))
    return ruling, turn, total


def _widths(
    position: AnyArray, triangles: AnyArray, normal: AnyArray, place: AnyArray, ruling: AnyArray
) -> tuple[AnyArray, AnyArray]:
    """Return the widths of the strips to either side (2, m), 0 if none, and one's normal (m, 3)."""
    many = len(ruling)
    corner = np.repeat(np.arange(3), 2)
    others = np.array([1, 2, 2, 0, 0, 1])
    at = place[triangles[:, corner]].ravel()
    owner = np.repeat(np.arange(len(triangles)), 6)
    offset = (position[triangles[:, others]] - position[triangles[:, corner]]).reshape(-1, 3)
    used = at >= 0
    at, owner, offset = at[used], owner[used], offset[used]
    across = np.einsum("ij,ij->i", offset, np.cross(normal[owner], ruling[at]))
    along = np.einsum("ij,ij->i", offset, ruling[at])
    sides = across > 1e-6 * np.abs(along), across < -1e-6 * np.abs(along)
    width = np.zeros((2, many))
    for row, beside in enumerate(sides):
        reach = np.abs(across[beside])
        weight = reach**2 / (along[beside] ** 2 + (ALONG * reach) ** 2)
        total = sum_by_group(at[beside], weight, many)
        width[row] = sum_by_group(at[beside], weight * reach, many)
        width[row] /= np.where(total > 0, total, 1.0)
    where, leaning = at[sides[0]], normal[owner[sides[0]]]
    side = np.stack([sum_by_group(where, leaning[:, i], many) for i in range(3)], axis=1)
    side /= np.maximum(np.linalg.norm(side, axis=1), 1e-300)[:, None]
    return width, side
