# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Principal curvatures of a surface, one value per smooth sector."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from .planar import planar_polygons, sectors_of
from .progress import part_of
from .settings import Smoothing
from .surface import Surface
from .types import Flags, Floats, Progress

if TYPE_CHECKING:
    from .engine.estimate import Estimate

#: Scales of smoothing as the engine takes them.
_SCALES = {Smoothing.AUTO: "AUTO", Smoothing.NONE: "NONE"}


@dataclass(frozen=True)
class Curvature:
    """Principal curvatures and directions on the sectors and polygons of a surface.

    K = k1 k2 and H = (k1 + k2) / 2 hold by construction, and so does H² >= K.

    Parameters
    ----------
    k1, k2 : (s,) float64
        Principal curvatures in 1/m, k1 >= k2 by signed value. Positive where the surface bends
        away from its normals: a sphere of radius R with outward normals has k1 = k2 = 1/R. Zero
        where undefined.
    direction_1, direction_2 : (s, 3) float64
        Unit principal directions of k1 and k2; zero at umbilics, on flat parts and where
        undefined.
    normal : (s, 3) float64
        Unit normals of the fitted surface; zero where no face has area.
    uncertainty : (s,) float64
        Standard uncertainty of k1 and k2 in 1/m, as far as noise and misfit show it.
    is_defined : (s,) bool
        Where the surface allows an estimate.
    is_smoothed : (s,) bool
        Where noise was smoothed away.
    is_doubtful : (s,) bool
        Where too few points allow only a low order.
    face_k1, face_k2 : (m,) float64
        Principal curvatures of the polygons in 1/m; zero where undefined.
    is_face_defined : (m,) bool
        False for polygons without area or without any defined corner.
    noise : float
        Standard deviation in meters by which most sectors leave a smooth surface.
    """

    k1: Floats
    k2: Floats
    direction_1: Floats
    direction_2: Floats
    normal: Floats
    uncertainty: Floats
    is_defined: Flags
    is_smoothed: Flags
    is_doubtful: Flags
    face_k1: Floats
    face_k2: Floats
    is_face_defined: Flags
    noise: float = 0.0

    @property
    def gaussian(self) -> Floats:
        """(s,) Gaussian curvature K = k1 k2 in 1/m²."""
        return self.k1 * self.k2

    @property
    def mean(self) -> Floats:
        """(s,) mean curvature H = (k1 + k2) / 2 in 1/m."""
        return 0.5 * (self.k1 + self.k2)

    def flipped(self) -> Curvature:
        """Return the curvature seen from the other side: signs change, k1 and k2 swap."""
        return replace(
            self,
            k1=-self.k2,
            k2=-self.k1,
            direction_1=self.direction_2,
            direction_2=self.direction_1,
            normal=-self.normal,
            face_k1=-self.face_k2,
            face_k2=-self.face_k1,
        )


def estimate_curvature(
    surface: Surface,
    smoothing: Smoothing = Smoothing.AUTO,
    smoothing_length: float = 0.0,
    on_progress: Progress | None = None,
) -> Curvature:
    """Estimate principal curvatures and directions on a surface.

    Parameters
    ----------
    surface : Surface
        Cut along its creases; nothing is averaged across them.
    smoothing : Smoothing
    smoothing_length : float
        Detail below this length in meters is noise, where smoothing is by LENGTH.
    on_progress : callable, optional
        Receives the share of the work that is done.

    Returns
    -------
    Curvature
        Points without a tangent plane (the apex of a cone) and without faces are undefined;
        smooth pieces that are planes up to rounding are exactly flat.
    """
    # The engine loads scipy, which Blender's start must not pay for.
    from .engine import estimator
    from .engine.estimate import FALLBACK, SMOOTHED

    mesh = surface.mesh
    estimate = estimator.estimate_curvature(
        surface.sector_position,
        surface.sector_triangles,
        rounding_step=mesh.resolution,
        smoothing=_SCALES.get(smoothing, smoothing_length),
        on_progress=part_of(on_progress, 0.0, 0.85),
    )
    if on_progress:
        on_progress(0.9)
    face_k1, face_k2 = _polygon_curvature(surface, estimate)
    is_flat_face = planar_polygons(surface)
    is_flat = sectors_of(surface, is_flat_face)
    for values in (
        estimate.k1,
        estimate.k2,
        estimate.direction_1,
        estimate.direction_2,
        estimate.error,
    ):
        values[is_flat] = 0.0
    face_k1[is_flat_face], face_k2[is_flat_face] = 0.0, 0.0
    is_defined = is_flat | (estimate.quality >= 0)
    has_corner = np.logical_or.reduceat(is_defined[surface.corner_sector], mesh.polygon_start[:-1])
    is_face_defined = has_corner & ~surface.is_degenerate
    face_k1[~is_face_defined], face_k2[~is_face_defined] = 0.0, 0.0
    return Curvature(
        k1=estimate.k1,
        k2=estimate.k2,
        direction_1=estimate.direction_1,
        direction_2=estimate.direction_2,
        normal=estimate.normals,
        uncertainty=estimate.error,
        is_defined=is_defined,
        is_smoothed=(estimate.quality == SMOOTHED) & ~is_flat,
        is_doubtful=(estimate.quality == FALLBACK) & ~is_flat,
        face_k1=face_k1,
        face_k2=face_k2,
        is_face_defined=is_face_defined,
        noise=estimate.roughness,
    )


def with_sector_values(surface: Surface, curvature: Curvature, k1: Floats, k2: Floats) -> Curvature:
    """Return curvature with other values at some sectors, and what polygons make of them.

    Parameters
    ----------
    surface : Surface
    curvature : Curvature
    k1, k2 : (s,) float64
        In 1/m; polygons without a sector where they differ from the curvature's own keep theirs.

    Returns
    -------
    Curvature
    """
    from .engine.estimate import TRUSTED, UNDEFINED, Estimate

    changed = (k1 != curvature.k1) | (k2 != curvature.k2)
    start = surface.mesh.polygon_start[:-1]
    touched = np.logical_or.reduceat(changed[surface.corner_sector], start)
    touched &= curvature.is_face_defined
    if not touched.any():
        return curvature
    values = _polygon_curvature(
        surface,
        Estimate(
            k1=k1,
            k2=k2,
            direction_1=curvature.direction_1,
            direction_2=curvature.direction_2,
            normals=curvature.normal,
            quality=np.where(curvature.is_defined, TRUSTED, UNDEFINED),
            error=curvature.uncertainty,
            noise=np.zeros(len(k1)),
        ),
        touched,
    )
    face_k1, face_k2 = (
        np.where(touched, new, old)
        for new, old in zip(values, (curvature.face_k1, curvature.face_k2), strict=True)
    )
    return replace(curvature, k1=k1, k2=k2, face_k1=face_k1, face_k2=face_k2)


def _polygon_curvature(
    surface: Surface, estimate: Estimate, wanted: Flags | None = None
) -> tuple[Floats, Floats]:
    from .engine.faces import polygon_curvature
    from .engine.turning import facets_of_polygons

    return polygon_curvature(
        surface.sector_position,
        (surface.corner_sector, surface.mesh.polygon_start),
        (surface.sector_triangles, surface.mesh.triangle_polygon),
        facets_of_polygons(surface.polygon_vector, surface.polygon_area),
        estimate,
        wanted,
    )
