# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Segmentation: every polygon gets a class, polygons of one class form regions."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .classification import SurfaceClass
from .cleaning.border_areas import measured_along_borders
from .cleaning.classes import clean_classes
from .cleaning.sizes import default_min_area
from .criterion import Criterion, panel_criterion
from .curvature import Curvature
from .progress import part_of
from .regions import Regions, connect_regions
from .statistics import smallest_radius
from .surface import Surface
from .tolerance import Tolerance
from .types import Floats, Indices, Progress


@dataclass(frozen=True)
class ClassMeasure:
    """How much of a surface belongs to one class.

    `area` in m², up to the lines that borders stand for, also where they run through polygons;
    `share` of the whole area, 0 to 1; `faces` whole polygons of the class; `min_radius` in meters,
    None if flat.
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
    criterion : Criterion
        Limits that the classes hold for.
    min_area : float
        Area in m² below which regions have joined a neighbor.
    face_class : (m,) int64
        Values of `SurfaceClass`.
    regions : Regions
    classes : dict
        One `ClassMeasure` per `SurfaceClass`.
    region_min_radius : tuple of float or None
        Smallest radius per region in meters, None for flat ones.
    """

    criterion: Criterion
    min_area: float
    face_class: Indices
    regions: Regions
    classes: dict[SurfaceClass, ClassMeasure]
    region_min_radius: tuple[float | None, ...]

    @property
    def tolerance(self) -> Tolerance:
        """Panel and deviation that the classes hold for."""
        return self.criterion.tolerance


def segment(
    surface: Surface,
    curvature: Curvature,
    criterion: Criterion | Tolerance,
    min_area: float = 0.0,
    locked: Indices | None = None,
    cuts: Indices | None = None,
    on_progress: Progress | None = None,
) -> Segmentation:
    """Segment a surface into regions of one class.

    Parameters
    ----------
    surface : Surface
    curvature : Curvature
        On the sectors of the surface.
    criterion : Criterion or Tolerance
        A tolerance stands for the criterion of panel and deviation.
    min_area : float
        Regions below this area in m² join the neighbor that they share the longest border with;
        0 takes `default_min_area`, but keeps what is `worth_telling`.
    locked : (m,) int64, optional
        Values of `SurfaceClass` given by hand, -1 where free; see `editing`.
    cuts : (m,) int64, optional
        Parts made by hand that no region reaches across; see `editing`.
    on_progress : callable, optional
        Receives the share of the work that is done; may raise to stop it.

    Returns
    -------
    Segmentation
    """
    if isinstance(criterion, Tolerance):
        criterion = panel_criterion(criterion)
    clean = clean_classes(
        surface, curvature, criterion, min_area, locked, part_of(on_progress, 0.0, 0.95)
    )
    face_class, part = clean.face_class, clean.part
    if cuts is not None:
        part = part * (int(cuts.max(initial=0)) + 1) + cuts
    regions = measured_along_borders(
        surface,
        curvature,
        criterion,
        connect_regions(surface, face_class, part),
        clean.on_pieces,
        None if locked is None else locked >= 0,
    )
    size = np.maximum(np.abs(curvature.face_k1), np.abs(curvature.face_k2))
    return Segmentation(
        criterion=criterion,
        min_area=min_area or default_min_area(surface, criterion),
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
        if surface_class == SurfaceClass.UNDEFINED:
            area = float(areas.sum())
        else:
            area = float(regions.area[regions.region_class == surface_class].sum())
        measures[surface_class] = ClassMeasure(
            area=area,
            share=area / total,
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
