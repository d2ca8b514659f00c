# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Necks: regions that hang together by a few edges only are different regions.

Where four regions meet in a point, a triangulation happens to join one opposite pair or the other
by a single edge, and noise by a few. A region count must not depend on that.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..groups import connected_groups, sum_by_group
from ..links import joined_links, smooth_links
from ..primitives.extents import narrowest_extent
from ..primitives.shapes import Primitive
from ..surface import Surface
from ..types import Flags, Floats, Indices

#: A neck this narrow, as a share of the mean width of the narrower part, and of no more than so
#: many edges, joins nothing.
_NECK, _NECK_EDGES = 0.5, 2.5

#: Widths by area and outline are too small by no more than this factor: outlines zigzag, and a
#: square has as much of them at its ends as on its sides.
_WIDEST = 3.0

#: Rings of polygons around the inner ones of a part that still belong to it.
_RINGS = 3


def split_at_necks(
    surface: Surface,
    face_class: Indices,
    min_area: float,
    is_locked: Flags | None = None,
    face_piece: Indices | None = None,
    primitives: Sequence[Primitive] = (),
) -> Indices:
    """Return connected parts of one class, cut where they are tied by a narrow neck.

    Parameters
    ----------
    surface : Surface
    face_class : (m,) int64
    min_area : float
        Parts below this area in m² are not cut off.
    is_locked : (m,) bool, optional
        Polygons that stay together where they touch, however narrow the neck.
    face_piece : (m,) int64, optional
        The surface that each polygon lies on, -1 where unknown.
    primitives : sequence of Primitive
        These surfaces.

    Returns
    -------
    (m,) int64
        Part of every polygon.
    """
    links, length = smooth_links(surface)
    same = face_class[links[:, 0]] == face_class[links[:, 1]]
    inner, inner_length = links[same], length[same]
    count = len(face_class)
    if face_piece is None:
        face_piece = np.full(count, -1, dtype=np.int64)
    core = _inner_faces(surface, links[~same], face_class)
    both = core[inner].all(axis=1) & (face_piece[inner[:, 0]] == face_piece[inner[:, 1]])
    part = connected_groups(inner[both], count)
    part_area = sum_by_group(part, np.where(core, surface.polygon_area, 0.0), count)
    is_large = part_area >= 0.25 * min_area
    piece = np.where(core & is_large[part], part, -1)
    piece = _grow(piece, part_area, inner, _RINGS)
    # What is far from any core, and not small, is a piece of its own: a narrow band is no neck.
    rest = connected_groups(inner[(piece[inner] < 0).all(axis=1)], count)
    rest_area = sum_by_group(rest, np.where(piece < 0, surface.polygon_area, 0.0), count)
    is_band = (piece < 0) & (rest_area >= min_area)[rest]
    piece = np.where(is_band, count + rest, piece)
    part_area = np.concatenate([part_area, rest_area])
    piece = _grow(piece, part_area, inner, count)
    # What no core and no band has reached is one piece per connected area.
    piece = np.where(piece >= 0, piece, count + rest)
    names, piece = np.unique(piece, return_inverse=True)
    piece = piece.reshape(-1)
    area = sum_by_group(piece, surface.polygon_area, len(names))
    pairs, neck = joined_links(piece[inner], inner_length, len(names))
    outline = _outlines(piece, links, length, len(names))
    width = np.full(len(names), np.inf)
    np.divide(2.0 * area, outline, out=width, where=outline > 0.0)
    narrow = width[pairs].min(axis=1)
    smaller = np.minimum(area[pairs[:, 0]], area[pairs[:, 1]])
    edge = float(np.median(length)) if len(length) else 0.0
    lies_on = np.full(2 * count, -1, dtype=np.int64)
    lies_on[part[core]] = face_piece[core]
    one, other = lies_on[names[pairs]].T
    is_neck = (neck < _NECK * narrow) & (neck < _NECK_EDGES * edge)
    # How wide known surfaces are does not depend on how their outlines zigzag.
    is_known = (one != other) & (one >= 0) & (other >= 0)
    wide = _extents(surface, piece, np.unique(pairs[is_known]), lies_on[names], primitives)
    # A strip that bends is narrower than it seems.
    wide = np.minimum(wide, _WIDEST * width)
    is_neck |= is_known & (neck < _NECK * wide[pairs].min(axis=1))
    is_neck &= smaller >= min_area
    tied = pairs[~is_neck]
    if is_locked is not None:
        tied = np.concatenate([tied, piece[inner[is_locked[inner].all(axis=1)]]])
    return connected_groups(tied, len(names))[piece]


def _extents(
    surface: Surface,
    piece: Indices,
    asked: Indices,
    lies_on: Indices,
    primitives: Sequence[Primitive],
) -> Floats:
    """Return how wide some parts are along the primitives that they lie on, (p,) in meters."""
    mesh = surface.mesh
    position = surface.sector_position[surface.corner_sector]
    # The middles of its sides stand for a polygon: of a triangle they have the same spread.
    middle = 0.5 * (position + position[mesh.next_corner])
    share = (surface.polygon_area / np.diff(mesh.polygon_start))[mesh.corner_polygon]
    owner = piece[mesh.corner_polygon]
    order = np.argsort(owner, kind="stable")
    first = np.searchsorted(owner[order], np.arange(len(lies_on) + 1))
    extents = np.zeros(len(lies_on))
    numbers: list[int] = asked.tolist()
    for part in numbers:
        own = order[first[part] : first[part + 1]]
        extents[part] = narrowest_extent(primitives[int(lies_on[part])], middle[own], share[own])
    return extents


def _inner_faces(surface: Surface, border: Indices, face_class: Indices) -> Flags:
    """Return the polygons without a corner on a border between classes."""
    sector = surface.corner_sector
    low = np.full(surface.sector_count, 9, dtype=np.int64)
    high = np.full(surface.sector_count, -9, dtype=np.int64)
    label = face_class[surface.mesh.corner_polygon]
    np.minimum.at(low, sector, label)
    np.maximum.at(high, sector, label)
    mixed = (low != high)[sector].astype(np.int64)
    return np.add.reduceat(mixed, surface.mesh.polygon_start[:-1]) == 0


def _grow(piece: Indices, part_area: Floats, links: Indices, rings: int) -> Indices:
    """Let pieces spread over neighbors without one; the largest comes first where they meet."""
    size = np.append(part_area, -1.0)
    own = np.concatenate([links[:, 0], links[:, 1]])
    other = np.concatenate([links[:, 1], links[:, 0]])
    for _ in range(rings):
        is_free = piece[own] < 0
        own, other = own[is_free], other[is_free]
        source = piece[other]
        reached = np.flatnonzero(source >= 0)
        if not len(reached):
            break
        face, source = own[reached], source[reached]
        order = np.argsort(size[source], kind="stable")
        piece = piece.copy()
        piece[face[order]] = source[order]
    return piece


def _outlines(piece: Indices, links: Indices, length: Floats, count: int) -> Floats:
    outer = piece[links[:, 0]] != piece[links[:, 1]]
    ends = piece[links[outer]]
    return sum_by_group(ends[:, 0], length[outer], count) + sum_by_group(
        ends[:, 1], length[outer], count
    )
