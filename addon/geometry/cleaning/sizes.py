# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which regions are worth telling where nobody asks for a least area.

A region with less area than a panel is noise to a designer, with two exceptions. A low wall may
hold a row of panels though none of them is as high as it is long: what counts is the room between
a region's borders. And a fillet narrower than a panel turns a wall by a right angle: to call it
flat would be wrong, however small it is.
"""

from __future__ import annotations

import numpy as np

from ..classification import SurfaceClass
from ..criterion import Criterion
from ..groups import sum_by_group
from ..links import joined_links, smooth_links
from ..regions import Regions
from ..surface import Surface
from ..types import Flags, Floats, Indices
from .labels import FaceCurvature

#: A region with this share of the whole area is a part of the model, however large a panel is.
_LARGEST_SHARE = 0.005


def default_min_area(surface: Surface, criterion: Criterion) -> float:
    """Return the least area of a region in m² where nobody asks for one.

    One panel; but of a model that is small for its panels no more than a share, so that its parts
    are still told.
    """
    panel = criterion.tolerance.panel_size**2
    return min(panel, _LARGEST_SHARE * float(surface.polygon_area.sum()))


def worth_telling(
    surface: Surface, faces: FaceCurvature, regions: Regions, criterion: Criterion
) -> Flags:
    """Return the polygons of regions that stay although they have less area than a panel.

    Parameters
    ----------
    surface : Surface
    faces : FaceCurvature
    regions : Regions
    criterion : Criterion

    Returns
    -------
    (m,) bool
        Where a panel fits between the region's borders; and where the neighbor with the longest
        common border is of a simpler class, and the region turns by more than a panel may, for at
        least a panel's length.
    """
    width, neighbor = _width_and_neighbor(surface, regions)
    panel, limit = criterion.tolerance.panel_size, criterion.curvature_limit
    told_by = np.where(neighbor >= 0, regions.region_class[neighbor], SurfaceClass.UNDEFINED)
    big = np.maximum(np.abs(faces.k1), np.abs(faces.k2))
    small = np.minimum(np.abs(faces.k1), np.abs(faces.k2))
    too_much = np.zeros(regions.count)
    for simpler, size in ((SurfaceClass.FLAT, big), (SurfaceClass.SINGLE, small)):
        chosen = (told_by == simpler) & (regions.region_class > simpler)
        too_much[chosen] = (_mean(surface, regions, size) - limit)[chosen]
    turns = too_much * np.minimum(width, panel) > limit * panel
    turns &= regions.boundary_length >= 2.0 * panel
    is_told = turns | (width >= panel)
    return np.append(is_told, False)[regions.face_region]


def _width_and_neighbor(surface: Surface, regions: Regions) -> tuple[Floats, Indices]:
    """Return the room between a region's borders in meters, and the neighbor it shares most with.

    The width of a strip between two long borders, the radius of a disc; rims and creases are no
    borders. Infinite, and -1, without neighbors.
    """
    links, length = smooth_links(surface)
    sides = regions.face_region[links]
    known = (sides >= 0).all(axis=1)
    pairs, shared = joined_links(sides[known], length[known], regions.count)
    own = np.concatenate([pairs[:, 0], pairs[:, 1]])
    other = np.concatenate([pairs[:, 1], pairs[:, 0]])
    shared = np.tile(shared, 2)
    neighbor = np.full(regions.count, -1, dtype=np.int64)
    order = np.lexsort((-other, shared))
    neighbor[own[order]] = other[order]
    border = sum_by_group(own, shared, regions.count)
    width = np.full(regions.count, np.inf)
    np.divide(2.0 * regions.area, border, out=width, where=border > 0.0)
    return width, neighbor


def _mean(surface: Surface, regions: Regions, values: Floats) -> Floats:
    is_known = regions.face_region >= 0
    weight = surface.polygon_area[is_known]
    total = sum_by_group(regions.face_region[is_known], weight * values[is_known], regions.count)
    return np.divide(total, regions.area, out=np.zeros(regions.count), where=regions.area > 0.0)
