# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sparse patterns: the one place of the engine that builds them.

scipy takes a noticeable part of a second to load, which Blender's start must not pay for.
"""

from __future__ import annotations

import numpy as np

from ..types import AnyArray, Graph


def pattern(rows: AnyArray, columns: AnyArray, shape: tuple[int, int]) -> Graph:
    """Return a matrix with a one for each pair of a row and a column, in compressed rows."""
    from scipy.sparse import csr_matrix

    return csr_matrix((np.ones(len(rows), np.float32), (rows, columns)), shape=shape)


def compressed(
    data: AnyArray, indices: AnyArray, indptr: AnyArray, shape: tuple[int, int]
) -> Graph:
    """Return a matrix from its own three arrays."""
    from scipy.sparse import csr_matrix

    return csr_matrix((data, indices, indptr), shape=shape)


def pieces(graph: Graph) -> AnyArray:
    """Return the connected component of every vertex of a graph, (n,) int."""
    from scipy.sparse.csgraph import connected_components

    return connected_components(graph, directed=False)[1]
