# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The index that everything at creases has together.

Around an area that reaches a crease one cannot walk: beyond the crease directions begin anew. But
around all creases of a closed surface, and the areas beside them, one can: what isolated points and
areas leave of the Euler characteristic is their joint index.
"""

from __future__ import annotations

import numpy as np

from ..groups import connected_groups, sum_by_group
from ..types import Flags, Floats, Indices


def with_joint_index(
    triangles: Indices,
    points: tuple[Indices, Floats],
    areas: tuple[Indices, Floats, Floats],
    is_open: Flags,
    has_outline: Flags,
) -> tuple[Floats, Floats]:
    """Return index and size of areas, the joint index with the largest area at the creases.

    Where a component has creases but no area at any, the creases themselves are one more, of size
    0, if directions turn along them.

    Parameters
    ----------
    triangles : (t, 3) int64
        Vertices, joined across creases.
    points : pair of (u,) arrays
        Triangle and index of isolated umbilics.
    areas : triangle_area (t,), area_index (a,), area_size (a,)
        As in `Umbilics`.
    is_open : (a,) bool
        Areas that reach a crease or a rim, with the index 0.
    has_outline : (t,) bool
        Triangles with a side at a crease or a rim.

    Returns
    -------
    area_index, area_size : (a,) or longer float64
        Changed on closed components without edges of more than two triangles.
    """
    triangle_area, area_index, area_size = areas
    if not has_outline.any():
        return area_index, area_size
    vertex_count = int(triangles.max()) + 1
    ends = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    keys, often = np.unique(ends.min(axis=1) * vertex_count + ends.max(axis=1), return_counts=True)
    edges = np.stack(np.divmod(keys, vertex_count), axis=1)
    component = connected_groups(edges, vertex_count)
    count = int(component.max()) + 1
    of_triangle, of_edge = component[triangles[:, 0]], component[edges[:, 0]]
    is_closed = np.bincount(of_edge, often != 2, count) == 0
    vertices = np.bincount(component[np.unique(triangles)], minlength=count)
    rest = vertices - np.bincount(of_edge, minlength=count)
    rest = rest + np.bincount(of_triangle, minlength=count).astype(np.float64)
    rest -= sum_by_group(of_triangle[points[0]], points[1], count)
    # An area lies in one component, but scraps, which stand together, in that of the last of them.
    inside = np.flatnonzero(triangle_area >= 0)
    of_area = np.zeros(len(area_index), dtype=np.int64)
    of_area[triangle_area[inside]] = of_triangle[inside]
    rest -= sum_by_group(of_area, area_index, count)
    result = area_index.copy()
    candidates = np.flatnonzero(is_open & is_closed[of_area])
    candidates = candidates[np.argsort(area_size[candidates], kind="stable")]
    largest = np.full(count, -1, dtype=np.int64)
    largest[of_area[candidates]] = candidates
    rest = 0.5 * np.round(2.0 * rest)
    chosen = np.flatnonzero(largest >= 0)
    result[largest[chosen]] = rest[chosen]
    is_creased = np.bincount(of_triangle, has_outline, count) > 0.0
    alone = rest[is_closed & is_creased & (largest < 0) & (rest != 0.0)]
    return np.concatenate([result, alone]), np.concatenate([area_size, np.zeros(len(alone))])
