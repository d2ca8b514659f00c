# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Who is near whom: rings of vertices along edges, as sparse rows and as padded tables.

Rings follow edges, never distance in space, so two sheets of a thin wall do not mix.
"""

from __future__ import annotations

import numpy as np

from ..types import AnyArray, Graph
from .sparse import compressed, pattern

#: Rings are not walked through a vertex of more edges than this (the hub of a fan): the walk would
#: reach everything at once.
HUB_VALENCE = 40
#: Most neighbors a fit is given; a larger set is thinned evenly. Bounds time and memory for any
#: mesh.
MAX_NEIGHBORS = 96


def edges_and_rim(triangles: AnyArray, count: int) -> tuple[AnyArray, AnyArray, AnyArray]:
    """Return the two ends (e,) of every edge, and a (count,) bool of the rim.

    Ends of an edge that does not have exactly two triangles.
    """
    start = triangles.astype(np.int64)
    end = np.roll(start, -1, axis=1)
    key = (np.minimum(start, end) * count + np.maximum(start, end)).ravel()
    key.sort()
    first = np.flatnonzero(np.concatenate([np.ones(min(len(key), 1), bool), key[1:] != key[:-1]]))
    times = np.diff(np.concatenate([first, [len(key)]]))
    low, high = np.divmod(key[first], max(count, 1))
    rim = np.zeros(count, bool)
    rim[low[times != 2]] = True
    rim[high[times != 2]] = True
    return low, high, rim


def adjacency(low: AnyArray, high: AnyArray, count: int) -> Graph:
    """Return the symmetric (count, count) pattern of edges with a full diagonal of ones."""
    low, high = low.astype(np.int32), high.astype(np.int32)
    real = low != high  # a triangle with a repeated corner has an edge to itself
    low, high = low[real], high[real]
    own = np.arange(count, dtype=np.int32)
    rows, columns = np.concatenate([low, high, own]), np.concatenate([high, low, own])
    return pattern(rows, columns, (count, count))


def without_hubs(graph: Graph) -> Graph:
    """Return the graph for walking: rows of hub vertices keep the diagonal only."""
    valence = np.diff(graph.indptr)
    hub = valence > HUB_VALENCE
    if not hub.any():
        return graph
    row = np.repeat(np.arange(len(valence)), valence)
    keep = ~hub[row] | (graph.indices == row)
    indptr = np.concatenate(
        [[0], np.cumsum(np.bincount(row[keep], minlength=len(valence)))]
    ).astype(graph.indptr.dtype)
    return compressed(graph.data[keep], graph.indices[keep], indptr, graph.shape)


def rings(graph: Graph, walk: Graph, vertices: AnyArray | slice, count: int) -> Graph:
    """Return, for chosen vertices, all that lie within `count` edges, as sparse rows."""
    reached = graph[vertices]
    for _ in range(count - 1):
        reached = reached @ walk
        reached.data[:] = 1
    return reached


def padded_table(
    rows: Graph, chosen: AnyArray, centers: AnyArray, limit: int = MAX_NEIGHBORS
) -> tuple[AnyArray, AnyArray]:
    """Return a (width, m) table of neighbor indices and the (m,) number of true entries.

    Parameters
    ----------
    rows : (r, n) sparse
        Neighbors of each row.
    chosen : (m,) int
        Rows to tabulate.
    centers : (m,) int
        What fills the unused entries: a vertex's own index, so that its offset is zero.
    limit : int
        Rows longer than this are thinned evenly.
    """
    start = rows.indptr[chosen].astype(np.int64)
    length = rows.indptr[chosen + 1] - start
    width = int(min(length.max(initial=1), limit))
    used = np.minimum(length, limit)
    slot = np.arange(width)[:, None]
    if length.max(initial=0) > limit:
        stride = np.maximum(length / np.maximum(used, 1), 1.0)
        offset = (slot * stride).astype(np.int64)
    else:
        offset = slot
    inside = slot < used
    table = (
        rows.indices[np.where(inside, start + offset, 0)]
        if len(rows.indices)
        else np.zeros((width, len(chosen)), np.int32)
    )
    return np.where(inside, table, centers), used
