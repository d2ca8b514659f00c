# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Crossings: polygons that the line of a border between classes may run through."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..groups import ranges
from ..surface import Surface
from ..types import Flags, Indices


@dataclass(frozen=True)
class Crossings:
    """Polygons beside a border, the region beyond it, and their corners one after the other.

    `is_border` are the corners on the border, `row` says which of the polygons each is of.
    """

    face: Indices
    beyond: Indices
    own_class: Indices
    beyond_class: Indices
    corner: Indices
    row: Indices
    is_border: Flags


def find_crossings(
    surface: Surface, face_region: Indices, region_class: Indices, is_locked: Flags | None
) -> Crossings:
    """Find polygons with a corner where another class begins, and the region most of it is of.

    Parameters
    ----------
    surface : Surface
    face_region : (m,) int64
        Region of every polygon, negative without.
    region_class : (r,) int64
    is_locked : (m,) bool, optional
        Polygons that are not asked.
    """
    corner_region = face_region[surface.mesh.corner_polygon]
    known = np.flatnonzero(corner_region >= 0)
    count = max(len(region_class), 1)
    keys = np.unique(surface.corner_sector[known] * count + corner_region[known])
    sector, region = np.divmod(keys, count)
    start = np.searchsorted(sector, np.arange(surface.sector_count + 1))
    is_border = np.diff(start) > 1
    corner = known[is_border[surface.corner_sector[known]]]
    if is_locked is not None:
        corner = corner[~is_locked[surface.mesh.corner_polygon[corner]]]
    many = np.diff(start)[surface.corner_sector[corner]]
    other = region[ranges(start, surface.corner_sector[corner])]
    face = np.repeat(surface.mesh.corner_polygon[corner], many)
    is_other = region_class[other] != region_class[face_region[face]]
    pairs, often = np.unique(face[is_other] * count + other[is_other], return_counts=True)
    face, other = np.divmod(pairs, count)
    # The last of a polygon's rows in this order is the region that most of its corners touch.
    order = np.lexsort((-other, often, face))
    face, other = face[order], other[order]
    is_last = np.append(face[1:] != face[:-1], True)[: len(face)]
    face, other = face[is_last], other[is_last]
    corner = ranges(surface.mesh.polygon_start, face)
    return Crossings(
        face=face,
        beyond=other,
        own_class=region_class[face_region[face]],
        beyond_class=region_class[other],
        corner=corner,
        row=np.repeat(np.arange(len(face)), np.diff(surface.mesh.polygon_start)[face]),
        is_border=is_border[surface.corner_sector[corner]],
    )
