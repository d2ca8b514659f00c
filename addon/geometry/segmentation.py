# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Segmentation: every polygon gets a class, polygons of one class form regions."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .absorption import absorb_small_regions
from .classification import SurfaceClass, classify
from .curvature import Curvature
from .regions import Regions, connect_regions
from .statistics import smallest_radius
from .surface import Surface
from .tolerance import Tolerance
from .types import Floats, Indices


@dataclass(frozen=True)
class ClassMeasure:
    """How much of a surface belongs to one class.

    `area` in m²; `share` of the whole area, 0 to 1; `min_radius` in meters, None if flat.
    """

    area: float
    share: float
    faces: int
    regions: int
    min_radius: float | None


@dataclass(frozen=True)
class Segmentation:
    """Classes and regions of a surface's polygons.

    Parameters
    ----------
    tolerance : Tolerance
        Panel and deviation that the classes hold for.
    face_class : (m,) int64
        Values of `SurfaceClass`.
    regions : Regions
    classes : dict
        One `ClassMeasure` per `SurfaceClass`.
    region_min_radius : tuple of float or None
        Smallest radius per region in meters, None for flat ones.
    """

    tolerance: Tolerance
    face_class: Indices
    regions: Regions
    classes: dict[SurfaceClass, ClassMeasure]
    region_min_radius: tuple[float | None, ...]


def segment(
    surface: Surface, curvature: Curvature, tolerance: Tolerance, min_area: float = 0.0
) -> Segmentation:
    """Segment a surface at the tolerance of a panel.

    Parameters
    ----------
    surface : Surface
    curvature : Curvature
        On the sectors of the surface.
    tolerance : Tolerance
    min_area : float
        Regions below this area in m² join the neighbor that they share the longest border with.

    Returns
    -------
    Segmentation
    """
    k1, k2 = curvature.face_k1, curvature.face_k2
    labels = classify(k1, k2, tolerance.curvature_limit, curvature.is_face_defined)
    face_class = absorb_small_regions(surface, labels, min_area)
    regions = connect_regions(surface, face_class)
    size = np.maximum(np.abs(k1), np.abs(k2))
    return Segmentation(
        tolerance=tolerance,
        face_class=face_class,
        regions=regions,
        classes=_measure_classes(surface, face_class, regions, size),
        region_min_radius=_region_radii(surface, regions, size),
    )


def _measure_classes(
    surface: Surface, face_class: Indices, regions: Regions, size: Floats
) -> dict[SurfaceClass, ClassMeasure]:
    total = float(surface.polygon_area.sum()) or 1.0
    measures: dict[SurfaceClass, ClassMeasure] = {}
    for surface_class in SurfaceClass:
        of_class = face_class == surface_class
        areas = surface.polygon_area[of_class]
        is_curved = surface_class not in (SurfaceClass.UNDEFINED, SurfaceClass.FLAT)
        measures[surface_class] = ClassMeasure(
            area=float(areas.sum()),
            share=float(areas.sum()) / total,
            faces=int(of_class.sum()),
            regions=int((regions.region_class == surface_class).sum()),
            min_radius=smallest_radius(size[of_class], areas) if is_curved else None,
        )
    return measures


def _region_radii(surface: Surface, regions: Regions, size: Floats) -> tuple[float | None, ...]:
    order = np.argsort(regions.face_region, kind="stable")
    order = order[np.searchsorted(regions.face_region[order], 0) :]
    members = np.split(order, np.cumsum(regions.face_count)[:-1]) if regions.count else []
    return tuple(
        None
        if surface_class == SurfaceClass.FLAT
        else smallest_radius(size[faces], surface.polygon_area[faces])
        for surface_class, faces in zip(regions.region_class, members, strict=True)
    )
