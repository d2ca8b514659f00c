# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Smooth pieces that are planes: flat exactly, where any fit would only be flat to rounding."""

from __future__ import annotations

import numpy as np

from .groups import connected_groups, sum_by_group
from .polygons import polygon_area_vectors
from .surface import Surface
from .types import Flags, Floats

#: A piece thinner than this share of its extent is a plane.
_PLANARITY = 1e-6


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
    return is_plane[polygon_piece]


def sectors_of(surface: Surface, polygons: Flags) -> Flags:
    """Return the sectors at the corners of chosen polygons, (s,) bool."""
    chosen = np.zeros(surface.sector_count, dtype=np.bool_)
    chosen[surface.corner_sector[polygons[surface.mesh.corner_polygon]]] = True
    return chosen
