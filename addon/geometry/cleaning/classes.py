# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""From curvature and a criterion to classes that can be drawn and counted."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..absorption import absorb_small_regions
from ..classification import SurfaceClass
from ..criterion import Criterion
from ..curvature import Curvature, with_sector_values
from ..groups import connected_groups, sum_by_group
from ..links import rim_sectors, sector_links, smooth_links
from ..progress import part_of
from ..regions import connect_regions
from ..surface import Surface
from ..types import Flags, Floats, Indices, Progress
from .developability import reject_bent_rulings
from .labels import FaceCurvature, Labeling, class_of_sectors, seam_evidence
from .necks import split_at_necks
from .piece_evidence import PieceCosts, piece_costs
from .pieces import find_pieces
from .settling import settle_at_seams
from .sizes import default_min_area, worth_telling

#: Share of the curvature's difference between the corners that a polygon's own is uncertain by.
_SPREAD = 0.05


@dataclass(frozen=True)
class CleanClasses:
    """The class of every polygon, and what it rests on.

    Parameters
    ----------
    face_class : (m,) int64
        Values of `SurfaceClass`.
    part : (m,) int64
        Regions do not reach across parts: they differ at the two sides of a narrow neck.
    on_pieces : PieceCosts
        The surfaces that polygons lie on.
    """

    face_class: Indices
    part: Indices
    on_pieces: PieceCosts


def clean_classes(
    surface: Surface,
    curvature: Curvature,
    criterion: Criterion,
    min_area: float,
    locked: Indices | None = None,
    on_progress: Progress | None = None,
) -> CleanClasses:
    """Return the class of every polygon, and the part of the surface that it belongs to.

    Parameters
    ----------
    surface : Surface
    curvature : Curvature
        On the sectors of the surface.
    criterion : Criterion
    min_area : float
        Regions below this area in m² join a neighbor; 0 takes `default_min_area`, but keeps what
        is `worth_telling`.
    locked : (m,) int64, optional
        Values of `SurfaceClass` given by hand, -1 where free.
    on_progress : callable, optional
        Receives the share of the work that is done; may raise to stop it.

    Returns
    -------
    CleanClasses
    """
    is_locked = None if locked is None else locked >= 0
    links = sector_links(surface)
    k1, k2, evidence = seam_evidence(surface, links, curvature, criterion)
    sharp = with_sector_values(surface, curvature, k1, k2)
    faces = face_estimate(surface, sharp)
    part_of(on_progress, 0.0, 0.2)(1.0)
    labeling = Labeling.of(surface, faces, criterion, evidence, locked)
    labels = labeling.labels(part_of(on_progress, 0.2, 0.4))
    on_pieces = _find_pieces(
        surface, links, curvature, labels, criterion, part_of(on_progress, 0.4, 0.55)
    )
    if on_pieces.is_near.any():
        labels = labeling.labels(part_of(on_progress, 0.55, 0.8), on_pieces)
        labels = settle_at_seams(surface, criterion, labels, on_pieces, is_locked)
    is_kept = np.zeros(len(labels), dtype=np.bool_) if is_locked is None else is_locked
    if not min_area:
        min_area = default_min_area(surface, criterion)
        regions = connect_regions(surface, labels)
        is_kept = is_kept | worth_telling(surface, faces, regions, criterion)
    labels = absorb_small_regions(surface, labels, min_area, is_kept)
    part_of(on_progress, 0.8, 0.9)(0.5)
    bent = reject_bent_rulings(
        surface, sharp, labels, criterion.tolerance.panel_size, criterion.curvature_limit
    )
    # Where a cylinder or cone is known there is nothing to measure, least of all on narrow strips.
    bent &= ~on_pieces.has_rulings(labels)
    bent &= True if is_locked is None else ~is_locked
    labels = _without_bent(surface, faces, labels, bent, criterion.tolerance.panel_size)
    part_of(on_progress, 0.9, 1.0)(0.5)
    primitives = [piece.primitive for piece in on_pieces.pieces]
    part = split_at_necks(
        surface, labels, min_area, is_locked, on_pieces.piece_of(labels), primitives
    )
    return CleanClasses(labels, part, on_pieces)


def _without_bent(
    surface: Surface, faces: FaceCurvature, labels: Indices, bent: Flags, panel_size: float
) -> Indices:
    """Return the labels with dome or saddle where rulings are bent, one for each connected part.

    One polygon's K is zero but for noise. Parts smaller than a panel stay single-curved: rulings
    are straight or not over the length of a panel.
    """
    links, _ = smooth_links(surface)
    group = connected_groups(links[bent[links[:, 0]] & bent[links[:, 1]]], len(bent))
    area = surface.polygon_area
    bend = sum_by_group(group, area * faces.k1 * faces.k2, len(bent))[group]
    is_told = bent & (sum_by_group(group, area, len(bent))[group] >= panel_size**2)
    double = np.where(bend > 0.0, SurfaceClass.ELLIPTIC, SurfaceClass.HYPERBOLIC)
    return np.where(is_told, double, labels).astype(np.int64)


def _find_pieces(
    surface: Surface,
    links: Indices,
    curvature: Curvature,
    labels: Indices,
    criterion: Criterion,
    on_progress: Progress,
) -> PieceCosts:
    pieces = find_pieces(
        surface.sector_position,
        curvature.normal,
        links,
        np.where(curvature.is_defined, class_of_sectors(surface, labels), -1),
        curvature.mean,
        rim_sectors(surface),
        curvature.noise,
        surface.mesh.resolution,
        criterion.curvature_limit,
        on_progress,
    )
    return piece_costs(surface, pieces, criterion)


def face_estimate(surface: Surface, curvature: Curvature) -> FaceCurvature:
    """Return the polygons' curvature with its uncertainty."""
    sector, start = surface.corner_sector, surface.mesh.polygon_start[:-1]
    error = np.add.reduceat(curvature.uncertainty[sector], start)
    error /= np.diff(surface.mesh.polygon_start)
    spread = np.maximum(_spread(curvature.k1[sector], start), _spread(curvature.k2[sector], start))
    return FaceCurvature(
        curvature.face_k1,
        curvature.face_k2,
        np.hypot(error, _SPREAD * spread),
        curvature.is_face_defined,
    )


def _spread(values: Floats, start: Indices) -> Floats:
    return np.maximum.reduceat(values, start) - np.minimum.reduceat(values, start)
