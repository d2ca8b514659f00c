# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Connected areas of one class, and their measures."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .classification import SurfaceClass
from .groups import connected_groups, sum_by_group
from .links import half_edge_lengths
from .surface import Surface
from .types import Flags, Floats, Indices


@dataclass(frozen=True)
class Regions:
    """Connected areas of one class that no crease runs through.

    Parameters
    ----------
    face_region : (m,) int64
        Region of every polygon, 0 for the largest area; -1 where the class is undefined.
    region_class : (r,) int64
        `SurfaceClass` of every region.
    area : (r,) float64
        In m²; see `measured_along_borders` for what polygons across a border count.
    face_count : (r,) int64
        Number of polygons.
    boundary_length : (r,) float64
        Length of the region's whole outline in meters, creases and rims included.
    """

    face_region: Indices
    region_class: Indices
    area: Floats
    face_count: Indices
    boundary_length: Floats

    @property
    def count(self) -> int:
        """Number of regions."""
        return len(self.area)


def connect_regions(
    surface: Surface, face_class: Indices, face_part: Indices | None = None
) -> Regions:
    """Join neighboring polygons of one class into regions.

    Parameters
    ----------
    surface : Surface
    face_class : (m,) int64
        Values of `SurfaceClass`.
    face_part : (m,) int64, optional
        Parts that no region reaches across; the whole surface is one if not given.

    Returns
    -------
    Regions
        Numbered by falling area; equal areas in the order of their first polygon.
    """
    polygon = surface.mesh.corner_polygon[surface.edges.smooth]
    is_same = face_class[polygon[:, 0]] == face_class[polygon[:, 1]]
    if face_part is not None:
        is_same &= face_part[polygon[:, 0]] == face_part[polygon[:, 1]]
    label = connected_groups(polygon[is_same], len(face_class))
    is_defined = face_class != SurfaceClass.UNDEFINED
    names, compact = np.unique(label[is_defined], return_inverse=True)
    count = len(names)
    region = compact.reshape(-1)
    area = sum_by_group(region, surface.polygon_area[is_defined], count)
    face_region = np.full(len(face_class), -1, dtype=np.int64)
    face_region[is_defined] = region
    region_class = np.empty(count, dtype=np.int64)
    region_class[region] = face_class[is_defined]
    by_first_polygon = Regions(
        face_region=face_region,
        region_class=region_class,
        area=area,
        face_count=np.bincount(region, minlength=count),
        boundary_length=_boundary_lengths(surface, face_region, count),
    )
    return with_areas(by_first_polygon, area)


def with_areas(regions: Regions, area: Floats) -> Regions:
    """Return regions with areas, (r,) float64 in m², numbered by falling area.

    Equal areas keep their order.
    """
    order = np.argsort(-_rounded(area), kind="stable")
    rank = np.empty(regions.count + 1, dtype=np.int64)
    rank[order] = np.arange(regions.count)
    # The last entry is the one that -1 looks up.
    rank[-1] = -1
    return Regions(
        face_region=rank[regions.face_region],
        region_class=regions.region_class[order],
        area=area[order],
        face_count=regions.face_count[order],
        boundary_length=regions.boundary_length[order],
    )


def _rounded(values: Floats) -> Floats:
    """Return values without their last digits, so that summation order does not sort them."""
    scale = float(values.max(initial=0.0)) or 1.0
    return np.round(values / scale, 9)


def _boundary_lengths(surface: Surface, face_region: Indices, count: int) -> Floats:
    """Return the outline of every region: all its half-edges but those between its own faces."""
    region = face_region[surface.mesh.corner_polygon]
    pairs = surface.edges.inner
    is_inside = region[pairs[:, 0]] == region[pairs[:, 1]]
    is_outline: Flags = region >= 0
    is_outline[pairs[is_inside].reshape(-1)] = False
    return sum_by_group(region[is_outline], half_edge_lengths(surface)[is_outline], count)
