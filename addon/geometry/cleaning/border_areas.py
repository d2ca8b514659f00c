# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Areas up to the lines that borders stand for.

A polygon has one class, and a border between classes follows edges. The line that it stands for
does not: on quads along the border whole rows change sides together, and areas jump by a row when
the mesh is refined. What a polygon has beyond the line is counted on the other side.
"""

from __future__ import annotations

import numpy as np

from ..criterion import Criterion
from ..curvature import Curvature
from ..groups import sum_by_group
from ..regions import Regions, with_areas
from ..surface import Surface
from ..types import Flags, Floats
from .crossings import Crossings, find_crossings
from .levels import corner_levels
from .piece_evidence import PieceCosts


def measured_along_borders(
    surface: Surface,
    curvature: Curvature,
    criterion: Criterion,
    regions: Regions,
    on_pieces: PieceCosts,
    is_locked: Flags | None = None,
) -> Regions:
    """Return regions with their areas up to the lines of their borders, numbered anew by area.

    Parameters
    ----------
    surface : Surface
    curvature : Curvature
        On the sectors of the surface.
    criterion : Criterion
    regions : Regions
    on_pieces : PieceCosts
        The surfaces that polygons lie on.
    is_locked : (m,) bool, optional
        Polygons whose class was given by hand: they belong to it whole.

    Returns
    -------
    Regions
        Of the same polygons; the sum of all areas is the same.
    """
    crossings = find_crossings(surface, regions.face_region, regions.region_class, is_locked)
    level = corner_levels(surface, curvature, criterion, crossings, on_pieces)
    moved = _share_above(surface, crossings, level) * surface.polygon_area[crossings.face]
    own = regions.face_region[crossings.face]
    area = regions.area + sum_by_group(crossings.beyond, moved, regions.count)
    return with_areas(regions, area - sum_by_group(own, moved, regions.count))


def _share_above(surface: Surface, crossings: Crossings, level: Floats) -> Floats:
    """Return how much of each polygon has a positive level, 0 where all corners have one sign.

    Where not even a corner is on the polygon's own side the border was drawn for other reasons.
    """
    mesh, count = surface.mesh, len(crossings.face)
    corner_level = np.full(len(mesh.corner_vertex), np.nan)
    corner_level[crossings.corner] = level
    number = np.full(len(surface.polygon_area), -1, dtype=np.int64)
    number[crossings.face] = np.arange(count)
    triangle = np.flatnonzero(number[mesh.triangle_polygon] >= 0)
    corners = mesh.triangle_corner[triangle]
    place = mesh.vertices[mesh.corner_vertex[corners]]
    area = np.linalg.norm(np.cross(place[:, 1] - place[:, 0], place[:, 2] - place[:, 0]), axis=1)
    row = number[mesh.triangle_polygon[triangle]]
    above = sum_by_group(row, area * _triangle_share(corner_level[corners]), count)
    total = sum_by_group(row, area, count)
    share = np.divide(above, total, out=np.zeros(count), where=total > 0.0)
    return np.where(share < 1.0, np.nan_to_num(share), 0.0)


def _triangle_share(level: Floats) -> Floats:
    """Return how much of each triangle has a positive level that is linear between corners."""
    level = np.sort(level, axis=1)
    low, middle, high = level.T
    corner = np.where(middle > 0.0, low, high)
    # The corner that is alone on its side cuts off a triangle similar in two ratios.
    first = np.where(middle > 0.0, middle, low)
    second = np.where(middle > 0.0, high, middle)
    is_cut = (low < 0.0) & (high > 0.0)
    ratio = np.divide(
        corner * corner,
        (corner - first) * (corner - second),
        out=np.zeros(len(corner)),
        where=is_cut & (corner != 0.0),
    )
    cut = np.where(middle > 0.0, 1.0 - ratio, ratio)
    result = np.where(is_cut, cut, (low >= 0.0).astype(np.float64))
    return np.where(np.isnan(level).any(axis=1), np.nan, result)
