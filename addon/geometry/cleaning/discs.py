# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Discs: seeds of pieces that no class shows.

Fillets of few edges form a net around the walls. Noise or the reach of the estimate leaves no class
a region of its own there, but two dozen points are enough to tell a cylinder, and fewer a sphere.
"""

from __future__ import annotations

import numpy as np

from ..nearest import nearest_along
from ..types import Flags, Floats, Indices, Progress
from .certainty import certain_piece
from .growth import FEWEST, Piece, Places

#: Points of a disc; corners that are too small for the larger ones come last, when all around them
#: is known.
_SIZES = (24, 16)
#: Discs in a row without a piece after which no other is asked; most of them in all.
_HOPELESS, _MOST = 24, 1000
#: As in `pieces`, but where no class shows a piece, chance finds some on gradual surfaces.
_HIDDEN = 1.0 / 24.0


def pieces_from_discs(
    places: Places,
    net: tuple[Indices, Floats],
    taken: Flags,
    limit: float,
    on_progress: Progress,
) -> list[Piece]:
    """Return the pieces that grow from small discs between those known, and mark what they take.

    Parameters
    ----------
    places : Places
    net : (p, 2) int64 and (p,) float64
        Neighbors, each pair once, and how far apart they are in meters.
    taken : (s,) bool
        Places on pieces.
    limit : float
        Curvature in 1/m that matters.
    on_progress : callable
        Receives the share of the work that is done; may raise to stop it.

    Returns
    -------
    list of Piece
    """
    pieces: list[Piece] = []

    def is_free(chosen: Indices) -> Flags:
        return ~taken[chosen]

    asked = 0
    for many in _SIZES:
        depth, _ = nearest_along(*net, np.flatnonzero(taken), len(taken), np.inf)
        is_asked = taken | ~np.isfinite(depth)
        in_vain = 0
        unasked = np.flatnonzero(~is_asked)
        order: list[int] = unasked[np.argsort(-depth[unasked], kind="stable")].tolist()
        for deepest in order:
            if in_vain >= _HOPELESS or asked >= _MOST:
                break
            if is_asked[deepest] or taken[deepest]:
                continue
            seed = places.spread(np.array([deepest]), is_free, many)
            off = ((places.position[seed] - places.position[deepest]) ** 2).sum(axis=1)
            seed = seed[np.argsort(off, kind="stable")[:many]]
            is_asked[seed] = True
            if len(seed) < FEWEST:
                continue
            on_progress(asked / _MOST)
            asked += 1
            in_vain += 1
            piece = certain_piece(places, seed, limit, _HIDDEN)
            if piece is not None:
                taken[piece.members] = True
                pieces.append(piece)
                in_vain = 0
    return pieces
