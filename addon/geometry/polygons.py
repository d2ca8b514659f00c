# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Area vectors and corner angles of polygons, planar or not."""

from __future__ import annotations

import numpy as np

from .groups import sum_by_group
from .mesh import PolygonMesh
from .types import Flags, Floats, Indices

#: A triangle whose height is below this share of its longest side has no usable normal.
_THINNEST = 1e-9


def measure_polygons(mesh: PolygonMesh) -> tuple[Floats, Floats]:
    """Return the vector area and the area of every polygon.

    The length of the vector is the area of the projection that is largest, its direction the
    normal (Newell's). The area is that of the triangles that fill the polygon. Both agree for
    planar polygons.

    Parameters
    ----------
    mesh : PolygonMesh
        Positions in meters.

    Returns
    -------
    vectors : (m, 3) float64
        In m²; zero for polygons without area. Points outward for counter-clockwise corners.
    areas : (m,) float64
        In m².
    """
    x, y, z = _triangle_vectors(mesh)
    areas = np.sqrt(x * x + y * y + z * z)
    if len(areas) == mesh.polygon_count:
        return np.stack([x, y, z], axis=1), areas
    vectors = [sum_by_group(mesh.triangle_polygon, part, mesh.polygon_count) for part in (x, y, z)]
    return np.stack(vectors, axis=1), sum_by_group(mesh.triangle_polygon, areas, mesh.polygon_count)


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
    end = mesh.corner_vertex[mesh.next_corner]
    square = np.zeros(len(end))
    for axis in range(3):
        values = np.ascontiguousarray(mesh.vertices[:, axis])
        side = values[end]
        side -= values[mesh.corner_vertex]
        square += side * side
    longest = np.sqrt(np.maximum.reduceat(square, mesh.polygon_start[:-1]))
    return areas <= longest * (mesh.resolution + _THINNEST * longest)


def _triangle_vectors(mesh: PolygonMesh) -> tuple[Floats, Floats, Floats]:
    """Return x, y and z of the triangles' vector areas, each (t,) and contiguous: that is fast."""
    a, b, c = (mesh.corner_vertex[mesh.triangle_corner[:, i]] for i in range(3))
    one: list[Floats] = []
    other: list[Floats] = []
    for axis in range(3):
        values = np.ascontiguousarray(mesh.vertices[:, axis])
        origin = values[a]
        one.append(values[b] - origin)
        other.append(values[c] - origin)
    (ux, uy, uz), (vx, vy, vz) = one, other
    return 0.5 * (uy * vz - uz * vy), 0.5 * (uz * vx - ux * vz), 0.5 * (ux * vy - uy * vx)


def corner_angles(mesh: PolygonMesh, corners: Indices) -> Floats:
    """Return the interior angle at some corners, (k,) float64 in radians, 0 to pi.

    A reflex corner counts with its smaller angle: the angles weigh sectors against each other,
    for which the difference does not matter.
    """
    here, after, before = (
        mesh.vertices[mesh.corner_vertex[at]]
        for at in (corners, mesh.next_corner[corners], mesh.previous_corner[corners])
    )
    ahead, behind = after - here, before - here
    return np.arctan2(
        np.linalg.norm(np.cross(ahead, behind), axis=1), np.einsum("ij,ij->i", ahead, behind)
    )
