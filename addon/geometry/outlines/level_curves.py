# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Level curves of a quantity on the sectors, traced through the insides of the triangles."""

from __future__ import annotations

import numpy as np

from ..curvature import Curvature
from ..groups import connected_groups
from ..links import sector_links, typical_length
from ..nearest import nearest
from ..surface import Surface
from ..types import Flags, Floats
from .polylines import Polylines, chain_segments


def trace_level(
    surface: Surface, values: Floats, level: float = 0.0, usable: Flags | None = None
) -> Polylines:
    """Return the curves on which a quantity has a value.

    Linear along edges and inside triangles; never across a crease, where values jump.

    Parameters
    ----------
    surface : Surface
    values : (s,) float64
        On the sectors.
    level : float
        The value wanted. Values equal to it count as above.
    usable : (s,) bool, optional
        Sectors where the quantity means something.

    Returns
    -------
    Polylines
        Points in meters in the mesh's own coordinates; `source` is meaningless. Curves end at
        rims, creases and unusable places, closed ones are flagged. Longest first.
    """
    triangles = surface.sector_triangles
    above = values >= level
    is_crossed = above[triangles].any(axis=1) & ~above[triangles].all(axis=1)
    if usable is not None:
        is_crossed &= usable[triangles].all(axis=1)
    crossed = triangles[is_crossed]
    if not len(crossed):
        return Polylines(
            np.zeros((0, 3)), np.zeros(1, np.int64), np.zeros(0, np.bool_), np.zeros(0, np.int64)
        )
    # The corner that is alone on its side: the curve runs between its two edges.
    up = above[crossed]
    alone = np.where(up.sum(axis=1) == 1, np.argmax(up, axis=1), np.argmin(up, axis=1))
    rows = np.arange(len(crossed))
    peak = crossed[rows, alone]
    others = [crossed[rows, (alone + 1) % 3], crossed[rows, (alone + 2) % 3]]
    low = np.concatenate([np.minimum(peak, other) for other in others])
    high = np.concatenate([np.maximum(peak, other) for other in others])
    keys, node = np.unique(low * surface.sector_count + high, return_inverse=True)
    one, two = np.divmod(keys, surface.sector_count)
    share = (level - values[one]) / (values[two] - values[one])
    position = surface.mesh.vertices[surface.sector_vertex]
    points = position[one] + share[:, None] * (position[two] - position[one])
    segments = node.reshape(2, -1).T
    return chain_segments(segments[segments[:, 0] != segments[:, 1]], points)


def parabolic_curves(surface: Surface, curvature: Curvature, flatness: float = 0.0) -> Polylines:
    """Return the curves between dome-like and saddle-like parts, where K = 0.

    Traced on the curvature of smaller size, signed so that domes are positive: it changes sign
    where K does, but about linearly, which places the curve more accurately.

    Parameters
    ----------
    surface : Surface
    curvature : Curvature
    flatness : float
        Curvature in 1/m that counts as none: on single-curved and flat parts K is zero everywhere
        and noise has many zeros. A curve is kept where the smaller curvature exceeds this on both
        sides of it.

    Returns
    -------
    Polylines
    """
    size_1, size_2 = np.abs(curvature.k1), np.abs(curvature.k2)
    # sign(k_big) k_small: where the two swap sizes they agree up to the sign of K.
    signed = np.where(
        size_1 >= size_2, np.sign(curvature.k1) * curvature.k2, np.sign(curvature.k2) * curvature.k1
    )
    curves = trace_level(surface, signed, 0.0, curvature.is_defined)
    return _between_extremes(surface, signed, curves, flatness)


def _between_extremes(
    surface: Surface, signed: Floats, curves: Polylines, flatness: float
) -> Polylines:
    """Keep the curves with clear domes on one side and clear saddles on the other."""
    if flatness <= 0.0 or not curves.count:
        return curves
    # The parts that a curve separates: sectors joined by edges on one side of zero.
    links = sector_links(surface)
    same = (signed[links[:, 0]] >= 0.0) == (signed[links[:, 1]] >= 0.0)
    part = connected_groups(links[same], surface.sector_count)
    reach = np.zeros(int(part.max()) + 1)
    np.maximum.at(reach, part, np.abs(signed))
    is_clear = reach[part] > flatness
    position = surface.mesh.vertices[surface.sector_vertex]
    clear = [np.flatnonzero(is_clear & side) for side in (signed >= 0.0, signed < 0.0)]
    if not all(len(side) for side in clear):
        return trace_level(surface, np.ones(surface.sector_count))
    edge = typical_length(position, links)
    near = [
        np.isfinite(nearest(position[side], curves.points, 1, 2.0 * edge)[0][:, 0])
        for side in clear
    ]
    share = np.add.reduceat((near[0] & near[1]).astype(np.float64), curves.start[:-1])
    keep = share > 0.5 * np.diff(curves.start)
    return select_curves(curves, keep)


def select_curves(curves: Polylines, keep: Flags) -> Polylines:
    """Return some of the curves, in the same order."""
    size = np.diff(curves.start)
    chosen = np.repeat(keep, size)
    return Polylines(
        curves.points[chosen],
        np.concatenate([[0], np.cumsum(size[keep])]).astype(np.int64),
        curves.is_closed[keep],
        curves.source[chosen],
    )
