# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Smooth pieces that are planes: flat exactly, where any fit would only be flat to rounding."""

from __future__ import annotations

import numpy as np

from .groups import connected_groups, sum_by_group
from .surface import Surface
from .types import Flags, Floats, Indices

#: A piece thinner than this share of its extent is a plane.
_PLANARITY = 1e-6
#: Of a plane, the sum of the polygons' area vectors is nearly as long as the sum of their lengths.
_ALIGNED = 0.99
#: An edge that folds by this (radians) between polygons wide enough is no part of a plane.
_BENT = 1e-3
#: Steps from polygon to polygon by which a bent edge is spread.
_STEPS = 4


def planar_polygons(surface: Surface) -> Flags:
    """Return which polygons lie on a smooth piece that is a plane up to rounding.

    A piece is what smooth edges connect. Pieces without area are no planes.

    Parameters
    ----------
    surface : Surface

    Returns
    -------
    (m,) bool
    """
    mesh = surface.mesh
    pairs = mesh.corner_polygon[surface.edges.smooth]
    if not _may_be_planes(surface, pairs).any():
        return np.zeros(mesh.polygon_count, dtype=np.bool_)
    polygon_piece = connected_groups(pairs, mesh.polygon_count)
    piece_count = int(polygon_piece.max()) + 1
    vector = surface.polygon_vector
    normal = np.stack(
        [sum_by_group(polygon_piece, vector[:, axis], piece_count) for axis in range(3)], axis=1
    )
    length = np.linalg.norm(normal, axis=1)
    whole = sum_by_group(polygon_piece, np.linalg.norm(vector, axis=1), piece_count)
    is_plane = (length > 0.0) & (length >= _ALIGNED * whole)
    if is_plane.any():
        normal /= np.where(length > 0.0, length, 1.0)[:, None]
        is_plane &= _is_thin(surface, is_plane[polygon_piece], polygon_piece, normal)
    return is_plane[polygon_piece]


def _may_be_planes(surface: Surface, pairs: Indices) -> Flags:
    """Return the polygons with no bent edge within some steps, (m,) bool.

    On most curved surfaces there are none, and to see that is faster than to find the pieces.
    """
    edges, mesh = surface.edges, surface.mesh
    may = np.ones(mesh.polygon_count, dtype=np.bool_)
    # The fold over a polygon no wider than the tolerance says nothing of its piece.
    tolerance = _PLANARITY * mesh.diagonal + 2.0 * mesh.resolution
    is_wide = surface.polygon_area * _BENT > tolerance * np.sqrt(surface.polygon_area)
    bent = edges.is_bent[~edges.is_crease]
    telling = pairs[bent & is_wide[pairs[:, 0]] & is_wide[pairs[:, 1]]]
    may[telling.ravel()] = False
    for _ in range(_STEPS):
        if not may.any():
            break
        spoiled = may[pairs[:, 0]] != may[pairs[:, 1]]
        may[pairs[spoiled].ravel()] = False
    return may


def _is_thin(surface: Surface, polygons: Flags, polygon_piece: Indices, normal: Floats) -> Flags:
    """Return which pieces of chosen polygons are thin across their normals, (p,) bool."""
    mesh = surface.mesh
    corner = np.flatnonzero(polygons[mesh.corner_polygon])
    piece = polygon_piece[mesh.corner_polygon[corner]]
    order = np.argsort(piece, kind="stable")
    piece = piece[order]
    start = np.flatnonzero(np.diff(piece, prepend=-1))
    position = surface.sector_position[surface.corner_sector[corner[order]]]
    height = np.einsum("ij,ij->i", position, normal[piece])

    def spread(values: Floats) -> Floats:
        return np.maximum.reduceat(values, start) - np.minimum.reduceat(values, start)

    extent = np.linalg.norm([spread(position[:, axis]) for axis in range(3)], axis=0)
    thin = np.zeros(len(normal), dtype=np.bool_)
    thin[piece[start]] = spread(height) <= _PLANARITY * extent + 2.0 * mesh.resolution
    return thin


def sectors_of(surface: Surface, polygons: Flags) -> Flags:
    """Return the sectors at the corners of chosen polygons, (s,) bool."""
    chosen = np.zeros(surface.sector_count, dtype=np.bool_)
    if polygons.any():
        chosen[surface.corner_sector[polygons[surface.mesh.corner_polygon]]] = True
    return chosen
