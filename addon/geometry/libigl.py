# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The only door to libigl: its functions under our names, types and conventions."""

from __future__ import annotations

import numpy as np

from .types import Flags, Indices


def misoriented_triangles(triangles: Indices) -> Flags:
    """Return which triangles would have to turn for the winding to agree.

    Parameters
    ----------
    triangles : (t, 3) int64

    Returns
    -------
    (t,) bool
        In every piece of the surface the fewer triangles. Pieces that cannot be oriented, such as
        a Moebius strip, keep a seam whichever triangles turn.
    """
    # Together with scipy, libigl takes long to load; Blender's start must not pay for it.
    import igl  # pyright: ignore[reportMissingTypeStubs] – it does not declare its types

    result = igl.bfs_orient(np.ascontiguousarray(triangles, dtype=np.int64))
    oriented, piece = (np.asarray(each, dtype=np.int64) for each in result)
    is_turned = (oriented != triangles).any(axis=1)
    patch = piece.reshape(-1)
    share = np.bincount(patch, is_turned) / np.maximum(np.bincount(patch), 1)
    return is_turned != (share > 0.5)[patch]
