# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Curvature by hand, where a test is about what is made of it and not about the estimator."""

from __future__ import annotations

import numpy as np
from architectural_curvature.addon.geometry.curvature import Curvature
from architectural_curvature.addon.geometry.surface import Surface
from numpy.typing import ArrayLike


def given_curvature(
    surface: Surface, face_k1: ArrayLike, face_k2: ArrayLike, *, is_defined: bool = True
) -> Curvature:
    """Return curvature with chosen values per polygon, all of it defined or none.

    Sectors have the value of one of their polygons, and no directions.
    """
    one, other = (
        np.broadcast_to(np.asarray(values, dtype=np.float64), surface.mesh.polygon_count)
        for values in (face_k1, face_k2)
    )
    count = surface.sector_count
    k1, k2, none = np.zeros(count), np.zeros(count), np.zeros(count)
    k1[surface.corner_sector] = one[surface.mesh.corner_polygon]
    k2[surface.corner_sector] = other[surface.mesh.corner_polygon]
    flags = np.full(count, is_defined)
    return Curvature(
        k1=k1,
        k2=k2,
        direction_1=np.zeros((count, 3)),
        direction_2=np.zeros((count, 3)),
        normal=np.zeros((count, 3)),
        uncertainty=none,
        is_defined=flags,
        is_smoothed=~flags & flags,
        is_doubtful=~flags & flags,
        face_k1=one.copy(),
        face_k2=other.copy(),
        is_face_defined=np.full(len(one), is_defined),
    )
