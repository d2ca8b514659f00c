# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Certainty: whether noise leaves no doubt on which side of the limit a piece is curved.

A primitive that leaves nothing but noise may still not be the surface: curvature that changes
gradually hides in the noise. The wider a piece, the less can hide.
"""

from __future__ import annotations

import numpy as np

from ..primitives.shapes import Kind
from ..types import Floats, Indices
from .growth import FEWEST, Piece, Places, grow_piece

#: Variance of a second derivative that is fitted to n points spread evenly over a length l, in
#: units of s² / (n l⁴) with s the standard deviation of a point.
_SECOND = 720.0


def certain_piece(places: Places, seed: Indices, limit: float, most_doubt: float) -> Piece | None:
    """Return the piece that grows from a seed, if its class is certain.

    Parameters
    ----------
    places : Places
    seed : (n,) int64
    limit : float
        Curvature in 1/m that matters.
    most_doubt : float
        Standard deviation of a curvature, as a share of its distance from the limit, that leaves no
        doubt.
    """
    piece = grow_piece(places, seed) if len(seed) >= FEWEST else None
    if piece is None or not _is_certain(piece, places.position[piece.members], limit, most_doubt):
        return None
    return piece


def curvature_doubts(piece: Piece, points: Floats) -> tuple[float, float]:
    """Return the standard deviations in 1/m of a piece's curvatures.

    Parameters
    ----------
    piece : Piece
    points : (c, 3) float64
        Of its members, in meters.

    Returns
    -------
    tuple of float
        In the order of `Primitive.bends`. Straight rulings are as long as the piece, however narrow
        it is.
    """
    local = points - points.mean(axis=0)
    square = local.T @ local / len(local)
    across = along = float(np.linalg.eigvalsh(square)[1])
    if piece.primitive.kind in (Kind.CYLINDER, Kind.CONE):
        axis = piece.primitive.frame[2]
        along = max(along, float(axis @ square @ axis))
    most = piece.scatter * float(np.sqrt(_SECOND / len(points))) / 12.0
    return most / max(across, 1e-300), most / max(along, 1e-300)


def _is_certain(piece: Piece, points: Floats, limit: float, most_doubt: float) -> bool:
    """Return whether a piece's principal curvatures are beyond doubt above or below the limit.

    Those of cones and tori may cross it; what counts is most of the piece.
    """
    doubts = np.array(curvature_doubts(piece, points))
    apart = np.median(np.abs(np.abs(np.stack(piece.primitive.bends(points))) - limit), axis=1)
    return bool((doubts <= most_doubt * apart).all())
