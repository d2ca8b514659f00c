# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Curvature per polygon of the user's mesh, from the sectors at its corners."""

from __future__ import annotations

import numpy as np

from .curvature import Curvature
from .surface import Surface
from .types import Flags, Floats


def face_curvature(surface: Surface, curvature: Curvature) -> tuple[Floats, Floats, Flags]:
    """Return the mean principal curvatures of the corners of every polygon.

    Each corner counts with the sector on the polygon's own side of creases.

    Parameters
    ----------
    surface : Surface
    curvature : Curvature
        On the sectors of the surface.

    Returns
    -------
    k1, k2 : (m,) float64
        In 1/m, k1 >= k2; zero where undefined.
    is_defined : (m,) bool
        False for polygons without area or without any defined corner.
    """
    sector, start = surface.corner_sector, surface.mesh.polygon_start[:-1]
    weight = curvature.is_defined[sector].astype(np.float64)
    total = np.add.reduceat(weight, start)
    is_defined = (total > 0.0) & ~surface.is_degenerate
    scale = np.where(is_defined, 1.0 / np.maximum(total, 1.0), 0.0)
    k1 = np.add.reduceat(curvature.k1[sector] * weight, start) * scale
    k2 = np.add.reduceat(curvature.k2[sector] * weight, start) * scale
    return k1, k2, is_defined
