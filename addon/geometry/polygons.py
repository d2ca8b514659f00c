# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Area vectors and corner angles of polygons, planar or not."""

from __future__ import annotations

import numpy as np

from .groups import sum_by_group
from .mesh import PolygonMesh
from .types import Flags, Floats

#: A triangle whose height is below this share of its longest side has no usable normal.
_THINNEST = 1e-9


def polygon_area_vectors(mesh: PolygonMesh) -> Floats:
    """Return the vector area of every polygon: its length the area, its direction the normal.

    For polygons that are not planar this is Newell's normal, the area of the projection that is
    largest.

    Parameters
    ----------
    mesh : PolygonMesh
        Positions in meters.

    Returns
    -------
    (m, 3) float64
        In m²; zero for polygons without area. Points outward for counter-clockwise corners.
    """
    position = mesh.vertices[mesh.corner_vertex]
    origin = np.repeat(position[mesh.polygon_start[:-1]], np.diff(mesh.polygon_start), axis=0)
    arm = position - origin
    return 0.5 * np.add.reduceat(
        np.cross(arm, arm[mesh.next_corner]), mesh.polygon_start[:-1], axis=0
    )


def triangle_areas(mesh: PolygonMesh) -> Floats:
    """Return the area of every filling triangle, (t,) float64 in m²."""
    position = mesh.vertices[mesh.corner_vertex[mesh.triangle_corner]]
    cross = np.cross(position[:, 1] - position[:, 0], position[:, 2] - position[:, 0])
    return 0.5 * np.linalg.norm(cross, axis=1)


def polygon_areas(mesh: PolygonMesh) -> Floats:
    """Return the area of every polygon as the sum of its triangles, (m,) float64 in m²."""
    return sum_by_group(mesh.triangle_polygon, triangle_areas(mesh), mesh.polygon_count)


def degenerate_polygons(mesh: PolygonMesh, areas: Floats) -> Flags:
    """Return which polygons are so thin that their normal is rounding noise.

    Parameters
    ----------
    mesh : PolygonMesh
        Positions in meters.
    areas : (m,) float64
        Areas of the polygons in m².

    Returns
    -------
    (m,) bool
        True where the height over the longest side is within the coordinates' rounding.
    """
    position = mesh.vertices[mesh.corner_vertex]
    side = np.linalg.norm(position[mesh.next_corner] - position, axis=1)
    longest = np.maximum.reduceat(side, mesh.polygon_start[:-1])
    return areas <= longest * (mesh.resolution + _THINNEST * longest)


def corner_angles(mesh: PolygonMesh) -> Floats:
    """Return the interior angle at every corner, (c,) float64 in radians, 0 to pi.

    A reflex corner counts with its smaller angle: the angles weigh sectors against each other,
    for which the difference does not matter.
    """
    position = mesh.vertices[mesh.corner_vertex]
    ahead = position[mesh.next_corner] - position
    behind = position[mesh.previous_corner] - position
    return np.arctan2(
        np.linalg.norm(np.cross(ahead, behind), axis=1), np.einsum("ij,ij->i", ahead, behind)
    )
