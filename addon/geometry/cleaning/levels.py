# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Levels: how far beyond a border between classes the corners of polygons beside it are.

A level changes sign where the border should run: where a curvature reaches its limit, or in the
seam of two surfaces. It is linear enough to be interpolated between corners.
"""

from __future__ import annotations

import numpy as np

from ..classification import SurfaceClass
from ..criterion import Criterion
from ..curvature import Curvature
from ..groups import sum_by_group
from ..primitives.shapes import Kind
from ..surface import Surface
from ..types import Flags, Floats, Indices
from .crossings import Crossings
from .piece_evidence import PieceCosts

#: Surfaces on which a limit may be reached.
_VARIED = (Kind.CONE, Kind.TORUS)


def corner_levels(
    surface: Surface,
    curvature: Curvature,
    criterion: Criterion,
    crossings: Crossings,
    on_pieces: PieceCosts,
) -> Floats:
    """Return how far corners are beyond the border, by pieces where they are known.

    Returns
    -------
    (k,) float64
        For the corners of `crossings`: negative on the polygon's own side, positive beyond the
        border, in whatever unit each polygon's border has; NaN where nothing is known.
    """
    sector = surface.corner_sector[crossings.corner]
    rows = np.arange(len(sector))
    level = _beyond_limit(curvature.k1[sector], curvature.k2[sector], crossings, criterion, rows)
    level[~curvature.is_defined[sector]] = np.nan
    by_pieces, is_beside = piece_levels(surface, criterion, crossings, on_pieces)
    return np.where(is_beside, by_pieces, level)


def _beyond_limit(
    k1: Floats, k2: Floats, crossings: Crossings, criterion: Criterion, chosen: Indices
) -> Floats:
    """Return by how much chosen corners are beyond the limit between two classes."""
    row = crossings.row[chosen]
    own, beyond = crossings.own_class[row], crossings.beyond_class[row]
    flat, single = int(SurfaceClass.FLAT), int(SurfaceClass.SINGLE)
    # The more curved class of the two, and on which side of the limit it lies.
    higher, lower = np.maximum(own, beyond), np.minimum(own, beyond)
    bend, twist = _quantities(k1, k2, criterion)
    sign = np.where(higher == SurfaceClass.HYPERBOLIC, -1.0, 1.0)
    twist_limit = (
        criterion.curvature_limit if criterion.gaussian_limit is None else criterion.gaussian_limit
    )
    above = np.select(
        [(lower == flat) & (higher == single), lower <= single],
        [bend - criterion.curvature_limit, sign * twist - twist_limit],
        sign * twist,
    )
    return np.where(beyond > own, above, -above)


def _quantities(k1: Floats, k2: Floats, criterion: Criterion) -> tuple[Floats, Floats]:
    """Return what tells bent from flat, and, positive for domes, double-curved from single-curved.

    Both have the unit of their limit: 1/m, but 1/m² for |K|.
    """
    if criterion.gaussian_limit is not None:
        return np.abs(0.5 * (k1 + k2)), k1 * k2
    size_1, size_2 = np.abs(k1), np.abs(k2)
    return np.maximum(size_1, size_2), np.sign(k1 * k2) * np.minimum(size_1, size_2)


def piece_levels(
    surface: Surface, criterion: Criterion, crossings: Crossings, on_pieces: PieceCosts
) -> tuple[Floats, Flags]:
    """Return levels by the surfaces that meet in the border, or the one that it runs across.

    Returns
    -------
    (k,) float64
        As `corner_levels`; NaN where pieces do not tell.
    (k,) bool
        Corners of polygons on or beside a piece: where the other side of the border is none, its
        curvature is blurred by the piece, and tells nothing.
    """
    level = np.full(len(crossings.corner), np.nan)
    nearest = on_pieces.nearest[crossings.face]
    rows = np.arange(len(crossings.face))
    own, beyond = nearest[rows, crossings.own_class], nearest[rows, crossings.beyond_class]
    is_seam = ((own >= 0) & (beyond >= 0))[crossings.row]
    is_on = on_pieces.is_settled[crossings.face][crossings.row]
    own, beyond = own[crossings.row], beyond[crossings.row]
    position = surface.sector_position[surface.corner_sector[crossings.corner]]
    sides = [(own, *_nothing(len(own))), (beyond, *_nothing(len(own)))]
    used: list[int] = np.unique(np.concatenate([own, beyond])).tolist()
    for number in [each for each in used if each >= 0]:
        primitive = on_pieces.pieces[number].primitive
        for piece, height, normal in sides:
            chosen = np.flatnonzero(is_seam & (piece == number))
            height[chosen] = primitive.heights(position[chosen])
            normal[chosen] = primitive.normals(position[chosen])
        if primitive.kind not in _VARIED:
            continue
        inside = np.flatnonzero(~is_seam & is_on & ((own == number) | (beyond == number)))
        k1, k2 = primitive.bends(position[inside])
        level[inside] = _beyond_limit(k1, k2, crossings, criterion, inside)
    across = _way_across(crossings, position)[crossings.row]
    level[is_seam] = _beyond_seam(sides[0][1:], sides[1][1:], across)[is_seam]
    return level, (own >= 0) | (beyond >= 0)


def _nothing(count: int) -> tuple[Floats, Floats]:
    return np.zeros(count), np.zeros((count, 3))


def _way_across(crossings: Crossings, position: Floats) -> Floats:
    """Return the way from each polygon to the border beside it, (q, 3) float64.

    NaN where all corners lie on the border.
    """
    count = len(crossings.face)
    ways: list[Floats] = []
    for chosen in (crossings.is_border, ~crossings.is_border):
        row = crossings.row[chosen]
        many = np.bincount(row, minlength=count).astype(np.float64)
        many[many == 0] = np.nan
        ways.append(
            np.stack([sum_by_group(row, axis, count) / many for axis in position[chosen].T], axis=1)
        )
    return ways[0] - ways[1]


def _beyond_seam(
    own: tuple[Floats, Floats], beyond: tuple[Floats, Floats], across: Floats
) -> Floats:
    """Return by how much points are beyond the seam in which two surfaces touch.

    The gap between the surfaces grows with the square of the distance from the seam, on both sides
    of it: its root is linear, and it widens in the direction that leads away from the seam. Noise
    moves a point along the normal, which changes neither.
    """
    (height, normal), (other_height, other_normal) = own, beyond
    # Surfaces may have their outer sides on opposite sides.
    turn = np.where(np.einsum("ij,ij->i", normal, other_normal) < 0.0, -1.0, 1.0)
    gap = height - turn * other_height
    widening = np.sign(gap)[:, None] * (normal - turn[:, None] * other_normal)
    side = np.einsum("ij,ij->i", widening, across)
    # Between two bends of the border there may be no way across; then the nearer surface counts.
    side = np.where(np.isnan(side), np.abs(height) - np.abs(other_height), side)
    return np.sqrt(np.abs(gap)) * np.sign(side)
