# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Flat, single-curved or double-curved: the class of a face or point at a curvature limit."""

from __future__ import annotations

from enum import IntEnum

import numpy as np

from .types import Flags, Floats, Indices


class SurfaceClass(IntEnum):
    """What a panel on this part of the surface has to be."""

    UNDEFINED = -1
    FLAT = 0
    SINGLE = 1
    ELLIPTIC = 2
    HYPERBOLIC = 3


class PointType(IntEnum):
    """Type of a surface point by its osculating paraboloid."""

    UNDEFINED = -1
    FLAT = 0
    PARABOLIC = 1
    ELLIPTIC = 2
    HYPERBOLIC = 3


def classify(k1: Floats, k2: Floats, curvature_limit: float, is_defined: Flags) -> Indices:
    """Return the class of every face or point.

    With k_big >= k_small the absolute principal curvatures: flat if k_big <= limit, single-curved
    if k_small <= limit < k_big, else double-curved: elliptic (a dome) if k1 k2 > 0, hyperbolic (a
    saddle) if k1 k2 < 0. The classes do not depend on the side that the normals point to.

    Parameters
    ----------
    k1, k2 : (m,) float64
        Principal curvatures in 1/m.
    curvature_limit : float
        In 1/m; see `Tolerance.curvature_limit`.
    is_defined : (m,) bool
        Where the curvatures mean something.

    Returns
    -------
    (m,) int64
        Values of `SurfaceClass`; a `PointType` has the same numbers.
    """
    size_1, size_2 = np.abs(k1), np.abs(k2)
    is_big = np.maximum(size_1, size_2) > curvature_limit
    is_double = np.minimum(size_1, size_2) > curvature_limit
    double = np.where(k1 * k2 > 0.0, SurfaceClass.ELLIPTIC, SurfaceClass.HYPERBOLIC)
    labels = np.where(is_double, double, np.where(is_big, SurfaceClass.SINGLE, SurfaceClass.FLAT))
    return np.where(is_defined, labels, SurfaceClass.UNDEFINED).astype(np.int64)
