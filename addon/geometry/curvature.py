# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Principal curvatures of a surface, one value per smooth sector."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .groups import connected_groups, sum_by_group
from .libigl import principal_curvature
from .polygons import polygon_area_vectors
from .surface import Surface
from .types import Flags, Floats, Progress

#: Rings of the quadric fit: the smallest that libigl accepts, and by far its most accurate.
_RINGS = 2

#: Curvatures that differ by less than this share of their size have no directions.
_UMBILIC = 1e-6

#: A piece thinner than this share of its extent is a plane.
_PLANARITY = 1e-6


@dataclass(frozen=True)
class Curvature:
    """Principal curvatures and directions on the sectors of a surface.

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
    is_defined : (s,) bool
        Where the surface allows an estimate.
    """

    k1: Floats
    k2: Floats
    direction_1: Floats
    direction_2: Floats
    is_defined: Flags

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
        return Curvature(-self.k2, -self.k1, self.direction_2, self.direction_1, self.is_defined)


def estimate_curvature(surface: Surface, on_progress: Progress | None = None) -> Curvature:
    """Estimate principal curvatures and directions at every sector.

    Parameters
    ----------
    surface : Surface
        Cut along its creases; nothing is averaged across them.
    on_progress : callable, optional
        Receives the share of the work that is done.

    Returns
    -------
    Curvature
        Sectors of pieces that are planar have zero curvature; sectors of pieces too small or too
        degenerate for a fit are undefined.
    """
    triangles = surface.sector_triangles[~surface.is_degenerate[surface.mesh.triangle_polygon]]
    used, compact = np.unique(triangles, return_inverse=True)
    k1, k2 = np.zeros(surface.sector_count), np.zeros(surface.sector_count)
    direction_1, direction_2 = (np.zeros((surface.sector_count, 3)) for _ in range(2))
    is_defined = np.zeros(surface.sector_count, dtype=np.bool_)
    if len(used):
        k1[used], k2[used], direction_1[used], direction_2[used], failed = principal_curvature(
            surface.sector_position[used], compact.reshape(-1, 3), _RINGS
        )
        is_defined[used] = True
        is_defined[used[failed]] = False
    if on_progress:
        on_progress(0.9)
    is_planar = planar_sectors(surface)
    is_defined |= is_planar
    is_straight = is_planar | ~is_defined
    k1[is_straight], k2[is_straight] = 0.0, 0.0
    is_umbilic = is_straight | (k1 - k2 <= _UMBILIC * np.maximum(np.abs(k1), np.abs(k2)))
    direction_1[is_umbilic], direction_2[is_umbilic] = 0.0, 0.0
    return Curvature(k1, k2, direction_1, direction_2, is_defined)


def planar_sectors(surface: Surface) -> Flags:
    """Return which sectors lie on a smooth piece that is a plane up to rounding.

    Parameters
    ----------
    surface : Surface

    Returns
    -------
    (s,) bool
    """
    mesh = surface.mesh
    polygon = mesh.corner_polygon[surface.edges.smooth]
    polygon_piece = connected_groups(polygon, mesh.polygon_count)
    piece_count = int(polygon_piece.max()) + 1
    piece = polygon_piece[mesh.corner_polygon]
    vector = polygon_area_vectors(mesh)
    normal = np.stack(
        [sum_by_group(polygon_piece, vector[:, axis], piece_count) for axis in range(3)], axis=1
    )
    length = np.linalg.norm(normal, axis=1)
    normal /= np.maximum(length, np.finfo(float).tiny)[:, None]
    position = surface.sector_position[surface.corner_sector]
    height = np.einsum("ij,ij->i", position, normal[piece])
    order = np.argsort(piece, kind="stable")
    start = np.concatenate([[0], np.cumsum(np.bincount(piece, minlength=piece_count))[:-1]])

    def spread(values: Floats) -> Floats:
        values = values[order]
        return np.maximum.reduceat(values, start) - np.minimum.reduceat(values, start)

    extent = np.linalg.norm([spread(position[:, axis]) for axis in range(3)], axis=0)
    is_plane = (spread(height) <= _PLANARITY * extent + 2.0 * mesh.resolution) & (length > 0.0)
    planar = np.zeros(surface.sector_count, dtype=np.bool_)
    planar[surface.corner_sector] = is_plane[piece]
    return planar
