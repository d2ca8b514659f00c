# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sides: on which side of a border between classes the polygons beside it lie.

Once labels are about right, the surface on each side of a border is known without what lies
beyond: points two edges away from the border and farther are on one side for certain. Continued
towards the border, the two surfaces part where curvature jumps, and every place in between is
asked which of the two it lies on. Where curvature changes gradually the two agree, and what the
curvature itself says stays.
"""

from __future__ import annotations

import itertools

import numpy as np

from ..curvature import Curvature
from ..groups import connected_groups, ranges
from ..links import link_lengths
from ..surface import Surface
from ..types import Flags, Floats, Indices
from .continuation import size_of_bend
from .side_points import Field, Side

#: Edges on each side of a border where places are asked.
RINGS = 1
#: How far points of a side may be, in edges.
_REACH = 8.0
#: Second derivatives of the two sides must differ by this many limits, and standard deviations.
_JUMP, _SIGNIFICANT = 0.75, 4.0
#: They must differ by more than they change on the way, and by this share of themselves.
_GRADUAL = 0.35
#: Heights of the two sides are told apart to this share of the larger.
_RESOLUTION = 0.1
_CLASSES = 4


def side_evidence(
    surface: Surface,
    links: Indices,
    curvature: Curvature,
    face_class: Indices,
    limit: float,
    is_settled: Flags | None = None,
) -> tuple[Floats, Flags]:
    """Return what the sides of borders say about the polygons beside them.

    Parameters
    ----------
    surface : Surface
    links : (p, 2) int64
        Of the surface's sectors.
    curvature : Curvature
        On the sectors.
    face_class : (m,) int64
        Classes whose borders are about right.
    limit : float
        Curvature limit in 1/m: a jump well below it is none.
    is_settled : (m,) bool, optional
        Polygons that need not be asked.

    Returns
    -------
    cost : (m, 4) float64
        Half the squared distance of a polygon's corners from the surface of each class beside it,
        in standard deviations; meaningless where nothing is told.
    is_told : (m,) bool
    """
    sector, start = surface.corner_sector, surface.mesh.polygon_start[:-1]
    place_class = class_of_sectors(surface, face_class)
    band = place_class < 0
    for _ in range(RINGS):
        band = _grown(links, band)
    band &= curvature.is_defined
    asks = band.copy()
    if is_settled is not None:
        asks[:] = False
        asks[sector[~is_settled[surface.mesh.corner_polygon]]] = True
        asks &= band
    asked = np.flatnonzero(asks)
    cost = np.zeros((len(face_class), _CLASSES))
    if not len(asked):
        return cost, np.zeros(len(face_class), dtype=np.bool_)
    around = _classes_around(surface, links, face_class)
    off, deviation, jumps = _ask(
        surface, curvature, links, asked, place_class, (band, around), limit
    )
    # Where a class beside a place cannot be continued, the others prove nothing against it.
    is_blind: Flags = np.logical_or.reduce(around[asked] & ~np.isfinite(deviation), axis=1)
    number = np.full(surface.sector_count, -1, dtype=np.int64)
    number[asked] = np.arange(len(asked))
    corner = number[sector]
    counts = (corner >= 0) & jumps[corner]
    is_told = np.logical_or.reduceat(counts, start) & (face_class >= 0)
    is_told &= ~np.logical_or.reduceat((corner >= 0) & is_blind[corner], start)
    told = np.flatnonzero(is_told)
    if len(told):
        chosen = ranges(surface.mesh.polygon_start, told)
        first = np.append(0, np.cumsum(np.diff(surface.mesh.polygon_start)[told]))[:-1]
        cost[told] = _costs(off, deviation, corner[chosen], counts[chosen], first)
        own = np.isfinite(cost[told, face_class[told]])
        is_told[told] = own & (np.isfinite(cost[told]).sum(axis=1) > 1)
    return cost, is_told


def _costs(
    off: Floats, deviation: Floats, corner: Indices, counts: Flags, first: Indices
) -> Floats:
    """Return what classes cost polygons, given the places at their corners and which count."""
    # Beyond a seam the height grows with the square of the distance: the mean of roots tells on
    # which side the polygon's center lies.
    known = np.isfinite(deviation)
    root = np.full(off.shape, np.inf)
    root[known] = np.sqrt(np.maximum(off[known] - deviation[known], 0.0))
    many = np.maximum(np.add.reduceat(counts.astype(np.float64), first), 1.0)[:, None]
    far = (np.add.reduceat(np.where(counts[:, None], root[corner], 0.0), first) / many) ** 2
    noise = np.maximum.reduceat(np.where(counts[:, None], deviation[corner], 0.0), first)
    is_known = np.isfinite(noise) & np.isfinite(far)
    worst = np.where(is_known, far, 0.0).max(axis=1, keepdims=True)
    scale = np.hypot(np.where(is_known, noise, 1.0), _RESOLUTION * worst)
    cost = 0.5 * (np.where(is_known, far, 0.0) / np.maximum(scale, 1e-300)) ** 2
    return np.where(is_known, cost, np.inf)


def _classes_around(surface: Surface, links: Indices, face_class: Indices) -> Flags:
    """Return which classes polygons near a sector have, (s, 4) bool."""
    around = np.zeros((surface.sector_count, _CLASSES), dtype=np.bool_)
    label = face_class[surface.mesh.corner_polygon]
    is_known = label >= 0
    around[surface.corner_sector[is_known], label[is_known]] = True
    for _ in range(RINGS):
        spread = around.copy()
        for one, other in ((0, 1), (1, 0)):
            for surface_class in range(_CLASSES):
                has = around[links[:, one], surface_class]
                spread[links[has, other], surface_class] = True
        around = spread
    return around


def class_of_sectors(surface: Surface, face_class: Indices) -> Indices:
    """Return the class of all polygons at a sector, -1 where they differ or have none."""
    label = face_class[surface.mesh.corner_polygon]
    order = np.argsort(surface.corner_sector, kind="stable")
    sorted_label = label[order]
    first = np.searchsorted(surface.corner_sector[order], np.arange(surface.sector_count))
    low = np.minimum.reduceat(sorted_label, first)
    high = np.maximum.reduceat(sorted_label, first)
    return np.where(low == high, low, -1)


def _grown(links: Indices, chosen: Flags) -> Flags:
    result = chosen.copy()
    result[links[chosen[links[:, 0]] | chosen[links[:, 1]]].reshape(-1)] = True
    return result


def _ask(
    surface: Surface,
    curvature: Curvature,
    links: Indices,
    asked: Indices,
    place_class: Indices,
    where: tuple[Flags, Flags],
    limit: float,
) -> tuple[Floats, Floats, Flags]:
    """Return how far places lie off the surface of each class, its deviation, and who sees a jump.

    Both are infinite for classes that are not near.
    """
    band, around = where
    length = link_lengths(surface.sector_position, links)
    many = np.bincount(links.reshape(-1), minlength=surface.sector_count)
    reach = np.bincount(links.reshape(-1), np.repeat(length, 2), surface.sector_count)
    reach = _REACH * reach / np.maximum(many, 1)
    is_source = ~band & (place_class >= 0) & curvature.is_defined
    alike = (
        is_source[links[:, 0]]
        & is_source[links[:, 1]]
        & (place_class[links[:, 0]] == place_class[links[:, 1]])
    )
    piece = connected_groups(links[alike], surface.sector_count)
    where_at = Field.of(surface.sector_position, curvature.normal, curvature.noise)
    sides = {
        surface_class: Side.of(
            surface.sector_position,
            np.flatnonzero(is_source & (place_class == surface_class)),
            piece,
        )
        for surface_class in np.unique(place_class[is_source]).tolist()
    }
    off = np.full((len(asked), _CLASSES), np.inf)
    deviation = np.full((len(asked), _CLASSES), np.inf)
    bends = {surface_class: np.zeros((5, len(asked))) for surface_class in sides}
    # What one class beside it tells nothing about proves nothing, nor do its polygons: a place is
    # asked as long as every class may answer, and whether it is near enough comes first.
    near = around[asked]
    missing = [number for number in range(_CLASSES) if number not in sides]
    is_open: Flags = ~np.logical_or.reduce(near[:, missing], axis=1)
    for surface_class, side in sides.items():
        chosen = np.flatnonzero(is_open & near[:, surface_class])
        is_open[chosen] = side.is_near(surface.sector_position[asked[chosen]], reach[asked[chosen]])
    is_open = _with_open_polygons(surface, asked, is_open)
    for surface_class, side in sides.items():
        chosen = np.flatnonzero(is_open & near[:, surface_class])
        is_open[chosen] = False
        found, fit = side.continued(where_at, asked[chosen], reach[asked[chosen]])
        chosen = chosen[found]
        off[chosen, surface_class] = np.where(fit.is_sound, np.abs(fit.height), np.inf)
        deviation[chosen, surface_class] = np.where(fit.is_sound, fit.deviation, np.inf)
        bends[surface_class][:, chosen] = [*fit.bend, fit.bend_deviation, fit.change]
        is_open[chosen] = fit.is_sound
    return off, deviation, _jumps(bends, np.isfinite(deviation), limit)


def _with_open_polygons(surface: Surface, asked: Indices, is_open: Flags) -> Flags:
    """Return which places have a polygon of which no corner is a place that is not open."""
    start, sector = surface.mesh.polygon_start[:-1], surface.corner_sector
    is_closed = np.zeros(surface.sector_count, dtype=np.bool_)
    is_closed[asked[~is_open]] = True
    is_shut = np.logical_or.reduceat(is_closed[sector], start)
    result = np.zeros(surface.sector_count, dtype=np.bool_)
    result[sector[~is_shut[surface.mesh.corner_polygon]]] = True
    return result[asked] & is_open


def _jumps(bends: dict[int, Floats], is_sound: Flags, limit: float) -> Flags:
    """Return the places where second derivatives of two sides differ."""
    jumps = np.zeros(len(is_sound), dtype=np.bool_)
    for one, other in itertools.combinations(bends, 2):
        both = np.flatnonzero(is_sound[:, one] & is_sound[:, other])
        a, b = bends[one][:, both], bends[other][:, both]
        size = size_of_bend(a[:3] - b[:3])
        doubt = _SIGNIFICANT * np.hypot(a[3], b[3])
        gradual = a[4] + b[4]
        gradual += _GRADUAL * np.maximum(size_of_bend(a[:3]), size_of_bend(b[:3]))
        jumps[both] |= size > np.maximum(_JUMP * limit, np.maximum(doubt, gradual))
    return jumps
