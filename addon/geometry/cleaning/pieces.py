# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pieces: parts of the surface that one plane, sphere, cylinder, cone or torus describes.

A local fit knows a few edges of the surface; under noise that is not enough to tell where a wall
ends and a fillet begins. A wall is one plane from end to end, and hundreds of points tell which.
Each region's core is a seed; the simplest primitive that leaves nothing but noise grows over all
that lies on it, and is fitted again until it grows no more. What no primitive describes, gets none.

References
----------
.. [1] Besl, Jain (1988). Segmentation through variable-order surface fitting. IEEE PAMI 10(2).
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ..classification import SurfaceClass
from ..groups import connected_groups
from ..links import link_lengths
from ..nearest import nearest_along
from ..progress import part_of
from ..types import Flags, Floats, Indices, Progress
from .certainty import certain_piece
from .discs import pieces_from_discs
from .growth import FEWEST, Piece, Places

#: A core has at least so many points, if the region has.
_LEAST_CORE = 48
#: A seed is that part of a region that is farther from its border than this share of its depth.
_CORE = 0.5
#: Points of a seed after which it takes no further ring; seeds per region.
_ENOUGH, _SEEDS = 400, 4
#: The largest regions are asked, so many at most: each costs some milliseconds.
_MOST = 300
#: Regions in a row without a piece after which no smaller one is asked: a free form has none.
_HOPELESS = 12
#: A seed whose region is explained up to this share of its core is the last.
_REST = 0.2
#: Doubt about a piece's curvature, as a share of how far it is from the limit, above which it says
#: nothing about classes: what could hide in its noise is eight times as much.
_HIDDEN = 1.0 / 16.0
#: Normals of neighbors on a wall turn by less than this many times what the limit allows.
_CALM = 4.0
#: Noise of a piece may exceed that of the whole by this factor.
_LOUD = 3.0
#: Heights below this share of an edge move no border by more than a fraction of an edge …
_LEAST = 3e-4
#: … and below this, or the step that coordinates were rounded to, they are rounding.
_EXACT = 1e-6


def find_pieces(
    position: Floats,
    normal: Floats,
    links: Indices,
    place_class: Indices,
    mean: Floats,
    is_rim: Flags,
    noise: float,
    resolution: float,
    limit: float,
    on_progress: Progress | None = None,
) -> list[Piece]:
    """Return the pieces that regions of a class are made of, each found once.

    Parameters
    ----------
    position, normal : (s, 3) float64
        Of the places; in meters.
    links : (p, 2) int64
        Neighbors, each pair once.
    place_class : (s,) int64
        Class that a place lies in; negative on borders.
    mean : (s,) float64
        Mean curvature in 1/m: a region that bends to both sides is several pieces.
    is_rim : (s,) bool
        Places on creases and rims.
    noise : float
        Standard deviation in meters by which most places leave a smooth surface.
    resolution : float
        Rounding step of the coordinates in meters, or 0.
    limit : float
        Curvature in 1/m that matters.
    on_progress : callable, optional
        Receives the share of the work that is done; may raise to stop it.

    Returns
    -------
    list of Piece
    """
    if not len(links):
        return []
    # In an order of their own, so that nothing rests on how the mesh was numbered.
    order = np.lexsort((*normal.T, *position.T))
    position, normal, mean, is_rim = position[order], normal[order], mean[order], is_rim[order]
    links, place_class = _renumbered(links, order), place_class[order]
    length = link_lengths(position, links)
    edge = float(np.median(length))
    least = _LEAST * edge
    start, neighbor = _neighbors(links, len(position))
    places = Places(
        position=position,
        normal=normal,
        start=start,
        neighbor=neighbor,
        is_rim=is_rim,
        # Coarser rounding is noise like any other.
        exact=min(max(_EXACT * edge, resolution), least),
        least=least,
        most=max(_LOUD * noise, least),
    )
    taken = np.zeros(len(position), dtype=np.bool_)
    place_class = _cut_where_bends_turn(links, place_class, mean)
    net = links, length
    pieces = _pieces_inside(places, net, place_class, taken, limit, part_of(on_progress, 0.0, 0.7))
    if pieces:
        # What no piece has taken may be one that the classes do not show, however narrow …
        rest = np.where(taken, -1, 0)
        pieces += _pieces_inside(places, net, rest, taken, limit, part_of(on_progress, 0.7, 0.8))
        pieces += pieces_from_discs(places, net, taken, limit, part_of(on_progress, 0.8, 0.9))
        # … or a strip of wall between fillets, which noise has made to seem bent, but not by much.
        turn = np.linalg.norm(normal[links[:, 0]] - normal[links[:, 1]], axis=1)
        calm = turn < _CALM * limit * length
        net, rest = (links[calm], length[calm]), np.where(taken, -1, int(SurfaceClass.SINGLE))
        pieces += _pieces_inside(places, net, rest, taken, limit, part_of(on_progress, 0.9, 1.0))
    return [replace(piece, members=order[piece.members]) for piece in pieces]


def _renumbered(links: Indices, order: Indices) -> Indices:
    """Return links between places by their numbers in an order, sorted."""
    number = np.empty(len(order), dtype=np.int64)
    number[order] = np.arange(len(order))
    links = np.sort(number[links], axis=1)
    return links[np.lexsort((links[:, 1], links[:, 0]))]


def _neighbors(links: Indices, count: int) -> tuple[Indices, Indices]:
    """Return where the neighbors of every place start, (count + 1,), and all neighbors."""
    own = np.concatenate([links[:, 0], links[:, 1]])
    other = np.concatenate([links[:, 1], links[:, 0]])
    start = np.concatenate([[0], np.cumsum(np.bincount(own, minlength=count))])
    return start, other[np.argsort(own, kind="stable")]


def _cut_where_bends_turn(links: Indices, place_class: Indices, mean: Floats) -> Indices:
    """Return the classes, negative where neighbors of one curved class bend to opposite sides."""
    one, other = links.T
    turns = (place_class[one] == place_class[other]) & ((mean[one] > 0.0) != (mean[other] > 0.0))
    turns &= (place_class[one] == SurfaceClass.SINGLE) | (place_class[one] == SurfaceClass.ELLIPTIC)
    result = place_class.copy()
    result[links[turns].reshape(-1)] = -1
    return result


def _pieces_inside(
    places: Places,
    net: tuple[Indices, Floats],
    place_class: Indices,
    taken: Flags,
    limit: float,
    on_progress: Progress,
) -> list[Piece]:
    """Return the pieces that grow from regions of one class, and mark what they take."""
    links, length = net
    border = np.flatnonzero(place_class < 0)
    depth = np.full(len(taken), np.inf)
    if len(border):
        depth, _ = nearest_along(links, length, border, len(taken), np.inf)
    # Where creases and rims are the only borders there is nothing to place; but whether rulings are
    # straight, a cylinder tells best.
    is_asked = (place_class >= 0) & (np.isfinite(depth) | (place_class == SurfaceClass.SINGLE))
    depth[~np.isfinite(depth)] = 0.0
    inside = place_class[links[:, 0]] == place_class[links[:, 1]]
    inside &= place_class[links[:, 0]] >= 0
    region = connected_groups(links[inside], len(taken))
    region[~is_asked] = -1
    names, sizes = np.unique(region, return_counts=True)
    order = np.argsort(region, kind="stable")
    start = np.concatenate([[0], np.cumsum(sizes)])
    pieces: list[Piece] = []
    largest = np.argsort(-sizes, kind="stable")[:_MOST].tolist()
    in_vain = 0
    for done, at in enumerate(largest):
        on_progress(done / len(largest))
        if names[at] >= 0 and sizes[at] >= FEWEST:
            core = _core(order[start[at] : start[at + 1]], depth)
            found = _pieces_of(places, core, depth, taken, limit)
            pieces += found
            in_vain = 0 if found else in_vain + 1
        if in_vain >= _HOPELESS:
            break
    return pieces


def _core(group: Indices, depth: Floats) -> Indices:
    """Return the deep part of a region, at least as much as two seeds take."""
    own = depth[group]
    least = min(_LEAST_CORE, len(own))
    enough = np.partition(own, -least)[-least]
    return group[own >= min(_CORE * own.max(), enough)]


def _pieces_of(
    places: Places, core: Indices, depth: Floats, taken: Flags, limit: float
) -> list[Piece]:
    """Return the pieces that grow from a region's core, and mark what they take."""
    pieces: list[Piece] = []
    is_open = places.flags(core)

    def is_free(chosen: Indices) -> Flags:
        return is_open[chosen] & ~taken[chosen]

    for _ in range(_SEEDS):
        rest = core[is_free(core)]
        if len(rest) < max(FEWEST, _REST * len(core)):
            break
        deepest = rest[np.argmax(depth[rest])]
        seed = places.spread(np.array([deepest]), is_free, _ENOUGH)
        is_open[seed] = False
        piece = certain_piece(places, seed, limit, _HIDDEN)
        if piece is not None:
            taken[piece.members] = True
            pieces.append(piece)
    return pieces
