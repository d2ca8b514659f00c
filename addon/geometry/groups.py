# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Groups of items: connected ones found, their values summed."""

from __future__ import annotations

import numpy as np

from .types import Floats, Indices


def connected_groups(pairs: Indices, count: int) -> Indices:
    """Return the connected component of every item.

    Parameters
    ----------
    pairs : (p, 2) int64
        Items that are linked.
    count : int
        Number of items.

    Returns
    -------
    (count,) int64
        Components are numbered by their first item.
    """
    # scipy takes a noticeable part of a second to load, which Blender's start must not pay for.
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    links = coo_array(
        (np.ones(len(pairs), dtype=np.int8), (pairs[:, 0], pairs[:, 1])), (count, count)
    )
    return np.asarray(connected_components(links, directed=False)[1], dtype=np.int64)


def sum_by_group(groups: Indices, values: Floats, count: int) -> Floats:
    """Return the sum of the values of every group, (count,) float64."""
    return np.bincount(groups, values, count).astype(np.float64, copy=False)


def ranges(start: Indices, chosen: Indices) -> Indices:
    """Return all numbers from start[i] to start[i + 1] of chosen i, one after the other.

    Parameters
    ----------
    start : (n + 1,) int64
        Where the rows of a table of different lengths start.
    chosen : (c,) int64
        Rows.
    """
    many = start[chosen + 1] - start[chosen]
    return np.arange(int(many.sum())) + np.repeat(start[chosen] - np.cumsum(many) + many, many)
