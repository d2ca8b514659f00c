# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Nearest points in space."""

from __future__ import annotations

from typing import Any

import numpy as np

from .threads import WORKERS
from .types import AnyArray, Floats, Indices

#: Places from which on several threads look for them.
_MANY = 10_000


class PointFinder:
    """Finds the points that are nearest to places, many times over.

    Parameters
    ----------
    points : (n, 3) float64
        At least one.
    """

    def __init__(self, points: Floats) -> None:
        # scipy takes a noticeable part of a second to load, which Blender's start must not pay for.
        from scipy.spatial import cKDTree

        self._tree: Any = cKDTree(points)

    def nearest(self, places: Floats, count: int, reach: float) -> tuple[Floats, Indices]:
        """Return the points nearest to places.

        Parameters
        ----------
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
        distance, index = self._tree.query(
            places,
            k=list(range(1, min(count, self._tree.n) + 1)),
            distance_upper_bound=reach,
            workers=WORKERS if len(places) > _MANY else 1,
        )
        return distance, np.where(np.isfinite(distance), index, 0).astype(np.int64)


def nearest(points: Floats, places: Floats, count: int, reach: float) -> tuple[Floats, Indices]:
    """Return the points nearest to places, see `PointFinder.nearest`."""
    return PointFinder(points).nearest(places, count, reach)


def close_pairs(points: Floats, reach: float) -> Indices:
    """Return the pairs of points, (p, 2) int64, that are no farther apart than a distance."""
    from scipy.spatial import cKDTree

    pairs: AnyArray = cKDTree(points).query_pairs(reach, output_type="ndarray")
    return pairs.astype(np.int64).reshape(-1, 2)


def nearest_along(
    links: Indices, lengths: Floats, seeds: Indices, count: int, reach: float
) -> tuple[Floats, Indices]:
    """Return how far along links the nearest seed is, and which it is.

    Parameters
    ----------
    links : (p, 2) int64
        Each once.
    lengths : (p,) float64
    seeds : (s,) int64
    count : int
        Number of nodes.
    reach : float
        Seeds farther away are not found.

    Returns
    -------
    distance : (count,) float64
        Infinite where no seed is in reach.
    seed : (count,) int64
        Negative there.
    """
    from scipy.sparse import csr_matrix
    from scipy.sparse.csgraph import dijkstra

    # A length of zero would be no link at all.
    graph = csr_matrix((np.maximum(lengths, 1e-300), links.T), shape=(count, count))
    distance, _, seed = dijkstra(
        graph,
        directed=False,
        indices=seeds,
        limit=reach,
        min_only=True,
        return_predecessors=True,
    )
    return np.asarray(distance, np.float64), np.asarray(seed, np.int64)
