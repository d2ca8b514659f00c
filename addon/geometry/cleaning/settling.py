# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Settling: polygons beside a border go to the side of its line that their center lies on.

Beside a seam two surfaces fit a polygon almost equally well, and noise decides. But once it is
known which surfaces meet there, the line in which they do is known from all of their points.
"""

from __future__ import annotations

import numpy as np

from ..classification import SurfaceClass
from ..criterion import Criterion
from ..groups import sum_by_group
from ..surface import Surface
from ..types import Flags, Indices
from .crossings import find_crossings
from .levels import piece_levels
from .piece_evidence import PieceCosts

#: A polygon moves to a surface unless it fits that one by so much worse than its own.
_WORSE = 3.0
#: Rows of polygons that a border may move by.
_ROWS = 4


def settle_at_seams(
    surface: Surface,
    criterion: Criterion,
    face_class: Indices,
    on_pieces: PieceCosts,
    is_locked: Flags | None = None,
) -> Indices:
    """Return classes whose borders run where pieces meet, or where a piece reaches the limit.

    Parameters
    ----------
    surface : Surface
    criterion : Criterion
    face_class : (m,) int64
        Classes whose borders are about right.
    on_pieces : PieceCosts
    is_locked : (m,) bool, optional
        Polygons that keep their class.

    Returns
    -------
    (m,) int64
    """
    classes = np.array([each for each in SurfaceClass if each >= 0], dtype=np.int64)
    settled = face_class.copy()
    for _ in range(_ROWS):
        crossings = find_crossings(surface, settled, classes, is_locked)
        level, _ = piece_levels(surface, criterion, crossings, on_pieces)
        moves = sum_by_group(crossings.row, level, len(crossings.face)) > 0.0
        cost = on_pieces.cost[crossings.face]
        rows = np.arange(len(cost))
        own, beyond = cost[rows, crossings.own_class], cost[rows, crossings.beyond_class]
        moves &= beyond <= _WORSE * own + on_pieces.price[crossings.face]
        if not moves.any():
            break
        settled[crossings.face[moves]] = crossings.beyond_class[moves]
    return settled
