# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Level curves of a quantity on the sectors, traced through the insides of the triangles."""

from __future__ import annotations

import numpy as np

from ..curvature import Curvature
from ..groups import connected_groups
from ..links import sector_links, typical_length
from ..nearest import nearest_along
from ..surface import Surface
from ..types import Flags, Floats, Indices
from .polylines import Polylines, chain_segments

#: Share of the flatness below which a curvature is taken for none, however certain it is.
_NOTHING = 0.05


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


def parabolic_curves(
    surface: Surface, curvature: Curvature, flatness: float = 0.0, reach: float = 0.0
) -> Polylines:
    """Return the curves between dome-like and saddle-like parts, where K = 0.

    Traced on the curvature of smaller size, signed so that domes are positive: it changes sign
    where K does, but about linearly, which places the curve more accurately. Where it is zero but
    for its uncertainty, as on cylinders, it says nothing: there the curve runs in the middle
    between dome and saddle, if both are near.

    Parameters
    ----------
    surface : Surface
    curvature : Curvature
    flatness : float
        Curvature in 1/m that domes and saddles exceed somewhere; 0 takes every change of sign.
    reach : float
        How far in meters dome and saddle may be from a curve, at least three edges.

    Returns
    -------
    Polylines
    """
    size_1, size_2 = np.abs(curvature.k1), np.abs(curvature.k2)
    # sign(k_big) k_small: where the two swap sizes they agree up to the sign of K.
    signed = np.where(
        size_1 >= size_2, np.sign(curvature.k1) * curvature.k2, np.sign(curvature.k2) * curvature.k1
    )
    if flatness <= 0.0:
        return trace_level(surface, signed, 0.0, curvature.is_defined)
    sure = np.abs(signed) > np.maximum(curvature.uncertainty, _NOTHING * flatness)
    sure &= curvature.is_defined
    links = sector_links(surface)
    sides = [
        _exceeding(signed, links, sure & side, flatness) for side in (signed >= 0.0, signed < 0.0)
    ]
    if not all(side.any() for side in sides):
        return trace_level(surface, np.ones(surface.sector_count))
    filled, is_near = _between(surface, signed, links, (sides[0], sides[1]), reach)
    return trace_level(surface, filled, 0.0, is_near)


def _exceeding(signed: Floats, links: Indices, members: Flags, flatness: float) -> Flags:
    """Return the members that are connected to one whose value exceeds the flatness."""
    inner = links[members[links].all(axis=1)]
    part = connected_groups(inner, len(signed))
    extent = np.zeros(int(part.max(initial=-1)) + 1)
    np.maximum.at(extent, part[members], np.abs(signed[members]))
    return members & (extent[part] > flatness)


def _between(
    surface: Surface, signed: Floats, links: Indices, sides: tuple[Flags, Flags], reach: float
) -> tuple[Floats, Flags]:
    """Return values that run linearly between two sides, and where both sides are near."""
    position = surface.mesh.vertices[surface.sector_vertex]
    steps = np.linalg.norm(position[links[:, 0]] - position[links[:, 1]], axis=1)
    edge = typical_length(position, links)
    reach = max(reach, 3.0 * edge)
    (far_1, source_1), (far_2, source_2) = (
        nearest_along(links, steps, np.flatnonzero(side), surface.sector_count, reach)
        for side in sides
    )
    settled = sides[0] | sides[1]
    is_near = np.isfinite(far_1) & np.isfinite(far_2)
    filled = np.where(settled, signed, 0.0)
    # Dome and saddle in one ring of neighbors: the value in between is as good as theirs.
    is_narrow = is_near & (far_1 + far_2 <= 2.5 * edge)
    filled = np.where(is_narrow, signed, filled)
    gap = is_near & ~settled & ~is_narrow
    share = far_1[gap] / (far_1[gap] + far_2[gap])
    filled[gap] = (1.0 - share) * signed[source_1[gap]] + share * signed[source_2[gap]]
    return filled, is_near
