# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Group the vertices of a graph into connected clusters, and the clusters into larger ones."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..types import AnyArray, Graph
from .sparse import pattern


@dataclass
class Clusters:
    """One level of clustering of n vertices into m connected groups.

    Attributes
    ----------
    owner : (n,) int
        The cluster of each vertex.
    roots : (m,) int
        A vertex that stands for the cluster.
    graph : (m, m) sparse
        Which clusters touch, with a full diagonal.
    members : (m, n) sparse
        The vertices of each cluster.
    """

    owner: AnyArray
    roots: AnyArray
    graph: Graph
    members: Graph


def _neighbor_maximum(graph: Graph, values: AnyArray) -> AnyArray:
    return np.maximum.reduceat(values[graph.indices], graph.indptr[:-1])


def independent_roots(graph: Graph, rank: AnyArray) -> AnyArray:
    """Return a bool mask of a maximal independent set.

    No two adjacent, everyone else beside one (Luby's method, greedy by rank).

    The graph has a full diagonal; ranks are distinct and positive.
    """
    alive = np.ones(len(rank), bool)
    root = np.zeros(len(rank), bool)
    while alive.any():
        current = np.where(alive, rank, 0)
        new = alive & (_neighbor_maximum(graph, current) == rank)
        root |= new
        alive &= _neighbor_maximum(graph, new.astype(np.int8)) == 0
    return root


def first_level(graph: Graph) -> Clusters:
    """Return the trivial clustering: every vertex its own group."""
    count = int(graph.shape[0])
    index = np.arange(count)
    alone = pattern(index, index, (count, count))
    return Clusters(index, index, graph, alone)


def coarsen(level: Clusters, priority: AnyArray) -> Clusters:
    """Merge clusters around a maximal independent set of them, about 3 to 4 into one.

    Parameters
    ----------
    level : Clusters
    priority : (n,) float64
        A number per vertex, arbitrary but independent of the order of vertices, so that the result
        is too.
    """
    graph = level.graph
    rank = np.empty(len(level.roots), np.int64)
    order = np.argsort(priority[level.roots], kind="stable")
    rank[order] = np.arange(1, len(order) + 1)
    root = independent_roots(graph, rank)
    best = _neighbor_maximum(graph, np.where(root, rank, 0))
    number = np.full(len(rank) + 1, -1, np.int64)
    number[rank[root]] = np.arange(root.sum())
    parent = number[best]
    count = int(root.sum())
    lift = pattern(parent, np.arange(len(parent)), (count, len(parent)))
    coarse = (lift @ graph @ lift.T).tocsr()
    coarse.data[:] = 1
    owner = parent[level.owner]
    members = pattern(owner, np.arange(len(owner)), (count, len(owner)))
    return Clusters(owner, level.roots[root], coarse, members)
