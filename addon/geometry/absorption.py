# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Regions that are too small to build join a neighbor."""

from __future__ import annotations

import heapq
from collections import defaultdict

import numpy as np

from .links import joined_links, smooth_links
from .regions import Regions, connect_regions
from .surface import Surface
from .types import Flags, Indices

_Borders = list[dict[int, float]]

#: Areas that differ by no more than this share are equal: sums carry rounding.
_TIE = 1e-9


def absorb_small_regions(
    surface: Surface, face_class: Indices, min_area: float, is_kept: Flags | None = None
) -> Indices:
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
    is_kept : (m,) bool, optional
        Polygons whose regions stay, however small they are.

    Returns
    -------
    (m,) int64
        The classes with the small regions absorbed.
    """
    if not min_area > 0.0:
        return face_class.copy()
    regions = connect_regions(surface, face_class)
    # An area of just the minimum must not depend on rounding.
    is_small = regions.area < (1.0 - _TIE) * min_area
    if is_kept is not None:
        kept = regions.face_region[is_kept]
        is_small[kept[kept >= 0]] = False
    if not is_small.any():
        return face_class.copy()
    final = _join(regions, _shared_borders(surface, regions), min_area, is_small)
    labels = face_class.copy()
    is_defined = regions.face_region >= 0
    labels[is_defined] = regions.region_class[final[regions.face_region[is_defined]]]
    return labels


def _shared_borders(surface: Surface, regions: Regions) -> _Borders:
    """Return the length in meters that each region shares with each of its neighbors."""
    links, length = smooth_links(surface)
    sides = regions.face_region[links]
    known = (sides >= 0).all(axis=1)
    pairs, shared = joined_links(sides[known], length[known], regions.count)
    borders: _Borders = [{} for _ in range(regions.count)]
    for (one, other), border in zip(pairs.tolist(), shared.tolist(), strict=True):
        borders[one][other] = borders[other][one] = border
    return borders


def _join(regions: Regions, borders: _Borders, min_area: float, is_small: Flags) -> Indices:
    """Return for every region the one that gives it its class in the end."""
    area: list[float] = regions.area.tolist()
    kind = regions.region_class.tolist()
    leader = list(range(regions.count))
    # Regions are numbered by falling area: of two that are equally small the later goes first.
    queue: list[tuple[float, int]] = [
        (area[number], -number) for number in np.flatnonzero(is_small).tolist()
    ]
    may_go: list[bool] = is_small.tolist()
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
            may_go[target] = may_go[target] and may_go[other]
            _merge(other, target, area, leader, borders)
        if may_go[target] and area[target] < (1.0 - _TIE) * min_area:
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
