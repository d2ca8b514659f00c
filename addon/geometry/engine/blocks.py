# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fits at many vertices: in blocks, by the length of their rows, on several threads."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..threads import in_parallel
from ..types import AnyArray, Coordinates, Graph, Progress
from .jet_fit import UNDETERMINED, JetOptions, fit_jets, shape_operator
from .neighborhoods import padded_table, rings

#: Vertices whose rings are walked together: bounds the memory of the rows.
ROWS = 10_000
#: Table entries (neighbors times vertices) worked on at once: what stays in the processor's cache.
ENTRIES = 60_000


@dataclass
class NarrowFit:
    """Values at n vertices.

    Attributes
    ----------
    k1, k2 : (n,), direction_1, direction_2, normals : (n, 3)
    residual : (n,)
        RMS misfit of the heights (m).
    variance : (n,)
        Variance of the curvature for unit variance of the heights (1/m⁴).
    condition : (n,)
        How well the neighbors determine the curvature; `UNDETERMINED` where they are fewer than
        the unknowns.
    radius : (n,)
        RMS distance of the neighbors (m).
    """

    k1: AnyArray
    k2: AnyArray
    direction_1: AnyArray
    direction_2: AnyArray
    normals: AnyArray
    residual: AnyArray
    variance: AnyArray
    condition: AnyArray
    radius: AnyArray


def empty_fit(normals: AnyArray) -> NarrowFit:
    """Return a fit that says nothing yet."""
    n = len(normals)
    zero = [
        np.zeros(n),
        np.zeros(n),
        np.zeros((n, 3)),
        np.zeros((n, 3)),
        normals.copy(),
        np.zeros(n),
        np.zeros(n),
        np.full(n, UNDETERMINED),
        np.zeros(n),
    ]
    return NarrowFit(*zero)


def fit_into(
    fit: NarrowFit,
    coordinates: Coordinates,
    graph: Graph,
    walk: Graph,
    normals: AnyArray,
    vertices: AnyArray,
    ring: int,
    options: JetOptions,
    on_progress: Progress | None = None,
) -> None:
    """Fit the chosen vertices over so many rings and store what was found.

    Blocks of vertices are independent: two or more processors share them.
    """

    def work(start: int) -> None:
        if on_progress:
            on_progress(start / len(vertices))
        block = vertices[start : start + ROWS]
        _fit_block(fit, coordinates, rings(graph, walk, block, ring), normals, block, options)

    in_parallel(work, range(0, len(vertices), ROWS))


def _fit_block(
    fit: NarrowFit,
    coordinates: Coordinates,
    rows: Graph,
    normals: AnyArray,
    block: AnyArray,
    options: JetOptions,
) -> None:
    length = np.diff(rows.indptr)
    order = np.argsort(length, kind="stable")
    position = 0
    while position < len(order):
        # rows are sorted by length, so a chunk is padded to its last row's
        size = max(64, ENTRIES // max(int(length[order[position]]), 8))
        chosen = order[position : position + size]
        position += size
        centers = block[chosen]
        table, used = padded_table(rows, chosen, centers)
        jet = fit_jets(coordinates, table, used, centers, normals[centers], options)
        k1, k2, direction_1, direction_2, normal = shape_operator(jet)
        fit.k1[centers], fit.k2[centers], fit.normals[centers] = k1, k2, normal
        fit.direction_1[centers], fit.direction_2[centers] = direction_1, direction_2
        fit.residual[centers], fit.variance[centers] = jet.residual, jet.variance
        fit.condition[centers], fit.radius[centers] = jet.condition, jet.radius
