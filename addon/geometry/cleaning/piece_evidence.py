# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What pieces say about polygons: on which of them each lies, and what class that is."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..criterion import Criterion, classify_by
from ..groups import ranges
from ..primitives.shapes import Kind
from ..surface import Surface
from ..types import Flags, Floats, Indices
from .certainty import curvature_doubts
from .growth import Piece
from .likelihood import CERTAIN, class_costs

#: Price per corner of lying on no piece: that of three standard deviations off.
_STRANGER = 4.5
#: Square of the standard deviations beyond which a point is as far off as can be.
_WORST = 1e6
_RULED = (Kind.PLANE, Kind.CYLINDER, Kind.CONE)
#: Bent by the same everywhere.
_EVEN = (Kind.PLANE, Kind.SPHERE, Kind.CYLINDER)
_CLASSES = 4


@dataclass(frozen=True)
class PieceCosts:
    """What pieces say about the class of polygons.

    Parameters
    ----------
    cost : (m, 4) float64
        Negative logarithm of the probability of the polygon's corners on the best piece of the
        class; infinite without one.
    best : (m, 4) int64
        That piece, by number; -1 without one.
    nearest : (m, 4) int64
        The piece that the polygon's corners fit best of those that have the class there; -1
        without one.
    is_near : (m,) bool
        Polygons on or beside a piece.
    is_settled : (m,) bool
        Polygons whose corners all lie on pieces: what crosses a seam lies on two and fits neither.
    price : (m,) float64
        What it costs to lie on none.
    is_ruled : (p + 1,) bool
        Pieces with straight rulings; False for none.
    pieces : sequence of Piece
    """

    cost: Floats
    best: Indices
    nearest: Indices
    is_near: Flags
    is_settled: Flags
    price: Floats
    is_ruled: Flags
    pieces: Sequence[Piece]

    def has_rulings(self, face_class: Indices) -> Flags:
        """Return which polygons of given classes lie on planes, cylinders and cones, (m,) bool."""
        return self.is_settled & self.is_ruled[self.piece_of(face_class)]

    def combined(self, cost: Floats) -> Floats:
        """Return what classes cost, (m, 4), given what they cost polygons that lie on no piece."""
        either = np.minimum(
            self.cost, np.where(self.is_settled, np.inf, self.price)[:, None] + cost
        )
        least = np.where(self.is_near, either.min(axis=1), 0.0)
        # What crosses a seam is told by how much better one side fits, however badly both do.
        scale = np.minimum(1.0, self.price / np.maximum(least, self.price))
        either = (either - least[:, None]) * scale[:, None]
        return np.where(self.is_near[:, None], np.minimum(either, CERTAIN), cost)

    def piece_of(self, face_class: Indices) -> Indices:
        """Return the piece that polygons of given classes lie on, -1 without, (m,) int64."""
        chosen = np.take_along_axis(self.best, face_class.clip(0)[:, None], axis=1)[:, 0]
        return np.where(face_class >= 0, chosen, -1)


def piece_costs(surface: Surface, pieces: Sequence[Piece], criterion: Criterion) -> PieceCosts:
    """Return what each class costs polygons on or beside pieces.

    Parameters
    ----------
    surface : Surface
    pieces : sequence of Piece
        Members are sectors.
    criterion : Criterion

    Returns
    -------
    PieceCosts
    """
    mesh, sector, start = surface.mesh, surface.corner_sector, surface.mesh.polygon_start[:-1]
    count, corners = len(start), np.diff(mesh.polygon_start)
    cost = np.full((count, _CLASSES), np.inf)
    best = np.full((count, _CLASSES), -1, dtype=np.int64)
    nearest, least = best.copy(), cost.copy()
    is_near = np.zeros(count, dtype=np.bool_)
    order = np.argsort(sector, kind="stable")
    first_of = np.concatenate([[0], np.cumsum(np.bincount(sector))])
    is_on = np.zeros(surface.sector_count, dtype=np.bool_)
    flags = np.zeros(count, dtype=np.bool_)

    def touching(sectors: Indices) -> Indices:
        """Return the polygons with a corner at one of the sectors."""
        flags[mesh.corner_polygon[order[ranges(first_of, sectors)]]] = True
        found = np.flatnonzero(flags)
        flags[found] = False
        return found

    for number, piece in enumerate(pieces):
        is_on[piece.members] = True
        # Members, and one ring around them.
        faces = touching(sector[ranges(mesh.polygon_start, touching(piece.members))])
        corner = ranges(mesh.polygon_start, faces)
        many = corners[faces]
        first = np.cumsum(many) - many
        position = surface.sector_position[sector[corner]]
        members = surface.sector_position[piece.members]
        height = piece.primitive.heights(position) / piece.scatter
        # Beyond a seam heights grow with the square of the distance: the mean of their roots tells
        # on which side the polygon's center lies.
        root = np.add.reduceat(np.sqrt(np.abs(height)), first) / many
        misfit = 0.5 * many * np.minimum(root**4, _WORST)
        center = np.add.reduceat(position, first, axis=0) / many[:, None]
        if piece.primitive.kind in _EVEN:
            center = center[:1]
        k1, k2 = piece.primitive.bends(center)
        # Both are certain; that along rulings decides between single and double.
        doubt = np.full(len(k1), min(curvature_doubts(piece, members)))
        by_class = class_costs(k1, k2, doubt, criterion) + misfit[:, None]
        is_better = by_class < cost[faces]
        best[faces] = np.where(is_better, number, best[faces])
        cost[faces] = np.where(is_better, by_class, cost[faces])
        is_near[faces] = True
        own = classify_by(k1, k2, criterion, np.ones(len(faces), dtype=np.bool_))
        closer = misfit < least[faces, own]
        nearest[faces[closer], own[closer]] = number
        least[faces[closer], own[closer]] = misfit[closer]
    is_settled = np.logical_and.reduceat(is_on[sector], start)
    is_ruled = [piece.primitive.kind in _RULED for piece in pieces]
    return PieceCosts(
        cost=cost,
        best=best,
        nearest=nearest,
        is_near=is_near,
        is_settled=is_settled,
        price=_STRANGER * corners,
        is_ruled=np.array([*is_ruled, False]),
        pieces=pieces,
    )
