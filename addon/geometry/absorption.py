# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Regions that are too small to build join a neighbor."""

from __future__ import annotations

import heapq
from collections import defaultdict

import numpy as np

from .groups import sum_by_group
from .regions import Regions, connect_regions, half_edge_lengths
from .surface import Surface
from .types import Indices

_Borders = list[dict[int, float]]


def absorb_small_regions(surface: Surface, face_class: Indices, min_area: float) -> Indices:
    """Give regions below a minimum area the class of the neighbor with the longest shared border.

    Regions that border on nothing but creases and rims stay, however small they are. The smallest
    region goes first; what it joins may grow beyond the minimum by it.

    Parameters
    ----------
    surface : Surface
    face_class : (m,) int64
        Values of `SurfaceClass`.
    min_area : float
        In m²; 0 changes nothing.

    Returns
    -------
    (m,) int64
        The classes with the small regions absorbed.
    """
    if not min_area > 0.0:
        return face_class.copy()
    regions = connect_regions(surface, face_class)
    if not (regions.area < min_area).any():
        return face_class.copy()
    final = _join(regions, _shared_borders(surface, regions), min_area)
    labels = face_class.copy()
    is_defined = regions.face_region >= 0
    labels[is_defined] = regions.region_class[final[regions.face_region[is_defined]]]
    return labels


def _shared_borders(surface: Surface, regions: Regions) -> _Borders:
    """Return the length in meters that each region shares with each of its neighbors."""
    smooth = surface.edges.smooth
    sides = regions.face_region[surface.mesh.corner_polygon[smooth]]
    is_border = (sides[:, 0] != sides[:, 1]) & (sides >= 0).all(axis=1)
    low, high = sides[is_border].min(axis=1), sides[is_border].max(axis=1)
    keys, compact = np.unique(low * regions.count + high, return_inverse=True)
    lengths = half_edge_lengths(surface)[smooth[is_border, 0]]
    shared = sum_by_group(compact.reshape(-1), lengths, len(keys))
    borders: _Borders = [{} for _ in range(regions.count)]
    for key, length in zip(keys.tolist(), shared.tolist(), strict=True):
        one, other = divmod(key, regions.count)
        borders[one][other] = borders[other][one] = length
    return borders


def _join(regions: Regions, borders: _Borders, min_area: float) -> Indices:
    """Return for every region the one that gives it its class in the end."""
    area = regions.area.tolist()
    kind = regions.region_class.tolist()
    leader = list(range(regions.count))
    # Regions are numbered by falling area: of two that are equally small the later goes first.
    queue = [(area[number], -number) for number in range(regions.count) if area[number] < min_area]
    heapq.heapify(queue)
    while queue:
        size, negative = heapq.heappop(queue)
        small = -negative
        if leader[small] != small or area[small] != size or not borders[small]:
            continue
        # With the same length the larger region, which has the smaller number.
        target = max(borders[small], key=lambda other: (borders[small][other], -other))
        _merge(small, target, area, leader, borders)
        # The class of the target may also be that of other neighbors of what it took in.
        for other in [n for n in borders[target] if kind[n] == kind[target]]:
            _merge(other, target, area, leader, borders)
        if area[target] < min_area:
            heapq.heappush(queue, (area[target], -target))
    return np.array([_follow(leader, number) for number in range(regions.count)], dtype=np.int64)


def _merge(
    small: int, target: int, area: list[float], leader: list[int], borders: _Borders
) -> None:
    """Let a region become part of another."""
    leader[small] = target
    area[target] += area[small]
    joined = defaultdict(float, borders[target])
    for other, length in borders[small].items():
        del borders[other][small]
        if other != target:
            joined[other] += length
            borders[other][target] = borders[other].get(target, 0.0) + length
    joined.pop(small, None)
    borders[target] = dict(joined)
    borders[small] = {}


def _follow(leader: list[int], number: int) -> int:
    while leader[number] != number:
        leader[number] = leader[leader[number]]
        number = leader[number]
    return number
