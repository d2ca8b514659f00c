# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Nearest points in space."""

from __future__ import annotations

from typing import Any

import numpy as np

from .types import AnyArray, Floats, Indices


def nearest(points: Floats, places: Floats, count: int, reach: float) -> tuple[Floats, Indices]:
    """Return the points nearest to places.

    Parameters
    ----------
    points : (n, 3) float64
        At least one.
    places : (p, 3) float64
    count : int
        How many points are asked for per place.
    reach : float
        What is farther does not count; in the points' unit.

    Returns
    -------
    distance : (p, c) float64
        Nearest first, c = min(count, n); infinite where there are fewer within reach.
    index : (p, c) int64
        Points; 0 where the distance is infinite.
    """
    # scipy takes a noticeable part of a second to load, which Blender's start must not pay for.
    from scipy.spatial import cKDTree

    tree: Any = cKDTree(points)
    distance, index = tree.query(
        places, k=list(range(1, min(count, len(points)) + 1)), distance_upper_bound=reach
    )
    return distance, np.where(np.isfinite(distance), index, 0).astype(np.int64)


def close_pairs(points: Floats, reach: float) -> Indices:
    """Return the pairs of points, (p, 2) int64, that are no farther apart than a distance."""
    from scipy.spatial import cKDTree

    pairs: AnyArray = cKDTree(points).query_pairs(reach, output_type="ndarray")
    return pairs.astype(np.int64).reshape(-1, 2)
