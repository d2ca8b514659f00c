# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Closed meshes on ellipsoids, spheres among them."""

from __future__ import annotations

import numpy as np
from scipy.spatial import ConvexHull

from .forms import Shape, shape_from_bending
from .sampling import Indices, Sample, split_quads
from .taylor import Array

SPHERE_KINDS = ("geodesic", "uv", "irregular", "quads")

_GOLDEN = (1.0 + 5.0**0.5) / 2.0


def sample_ellipsoid(
    axes: tuple[float, float, float], kind: str, count: int, seed: int = 0
) -> Sample:
    """Return a closed mesh on an ellipsoid around the origin.

    Parameters
    ----------
    axes : (float, float, float)
        Half axes in x, y and z; equal for a sphere.
    kind : str
        One of `SPHERE_KINDS`: a subdivided icosahedron, meridians and parallels, scattered points,
        or a blown-up cube of quads.
    count : int
        Cells along an edge of the icosahedron, from pole to pole, or along an edge of the cube;
        scattered points are as many as on the icosahedron.
    seed : int
        Of the scattered points.
    """
    unit, polygons = {
        "geodesic": lambda: _hull(_geodesic_points(count)),
        "uv": lambda: _uv(count),
        "irregular": lambda: _hull(_scattered_points(10 * count**2 + 2, seed)),
        "quads": lambda: _cube(count),
    }[kind]()
    return Sample(ellipsoid_shape(axes, unit), polygons)


def ellipsoid_shape(axes: tuple[float, float, float], unit: Array) -> Shape:
    """Return the exact shape where points of the unit sphere come to lie by stretching it.

    The ellipsoid is the level set of q = (x/a)² + (y/b)² + (z/c)²: the second fundamental form on
    tangents s, t is s·Hess(q) t / |grad q|.

    Parameters
    ----------
    axes : (float, float, float)
        Half axes.
    unit : (n, 3) float64
    """
    square = np.array(axes) ** 2
    position = unit * np.array(axes)
    gradient = position / square
    length = np.linalg.norm(gradient, axis=1)
    normal = gradient / length[:, None]
    # Any tangent does: across the coordinate axis that the normal is farthest from.
    tangent = np.cross(normal, np.eye(3)[np.argmin(np.abs(normal), axis=1)])
    tangent /= np.linalg.norm(tangent, axis=1)[:, None]
    across = np.cross(normal, tangent)
    aa, ab, bb = (
        (s * t / square).sum(axis=1) / length
        for s, t in ((tangent, tangent), (tangent, across), (across, across))
    )
    return shape_from_bending(position, normal, tangent, aa, ab, bb)


def _hull(unit: Array) -> tuple[Array, Indices]:
    """Return points of the sphere with the triangles of their hull, which are Delaunay's."""
    triangles = ConvexHull(unit).simplices.astype(np.int64)
    corner = unit[triangles]
    is_inward = np.linalg.det(corner) < 0.0
    triangles[is_inward] = triangles[is_inward][:, ::-1]
    return unit, triangles


def _geodesic_points(count: int) -> Array:
    corners = np.array(
        [
            np.roll((0.0, s, t * _GOLDEN), shift)
            for shift in range(3)
            for s in (-1, 1)
            for t in (-1, 1)
        ]
    )
    weights = [(i, j, count - i - j) for i in range(count + 1) for j in range(count + 1 - i)]
    points = np.array(weights) @ corners[ConvexHull(corners).simplices]
    points = points.reshape(-1, 3) / np.linalg.norm(points.reshape(-1, 3), axis=1)[:, None]
    return points[np.sort(np.unique(np.round(points, 9), axis=0, return_index=True)[1])]


def _scattered_points(count: int, seed: int) -> Array:
    """Return points on a spiral with even spacing, moved about by a third of it."""
    number = np.arange(count) + 0.5
    height = 1.0 - 2.0 * number / count
    turn = 2.0 * np.pi * number * _GOLDEN
    ring = np.sqrt(1.0 - height**2)
    points = np.stack([ring * np.cos(turn), ring * np.sin(turn), height], axis=1)
    spacing = np.sqrt(4.0 * np.pi / count)
    points += np.random.default_rng(seed).uniform(-0.3, 0.3, points.shape) * spacing
    return points / np.linalg.norm(points, axis=1)[:, None]


def _uv(count: int) -> tuple[Array, Indices]:
    """Return rings of 2 count points between two poles, all in triangles."""
    around = 2 * count
    polar = np.linspace(0.0, np.pi, count + 1)[1:-1, None]
    turn = np.linspace(0.0, 2.0 * np.pi, around, endpoint=False)[None, :]
    rings = np.stack(
        [np.sin(polar) * np.cos(turn), np.sin(polar) * np.sin(turn), np.cos(polar) + 0.0 * turn],
        axis=2,
    )
    points = np.concatenate([rings.reshape(-1, 3), [[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]]])
    top, bottom = len(points) - 2, len(points) - 1
    i, j = (index.ravel() for index in np.indices((count - 2, around)))
    after = (j + 1) % around
    quads = np.stack(
        [i * around + j, (i + 1) * around + j, (i + 1) * around + after, i * around + after], axis=1
    )
    first = np.arange(around)
    following = np.roll(first, -1)
    last = (count - 2) * around
    caps = [
        np.stack([np.full(around, top), first, following], axis=1),
        np.stack([np.full(around, bottom), last + following, last + first], axis=1),
    ]
    triangles = split_quads(quads, np.zeros(len(quads), dtype=np.bool_))
    return points, np.concatenate([triangles, *caps]).astype(np.int64)


def _cube(count: int) -> tuple[Array, Indices]:
    """Return a cube whose sides are divided evenly in angle and blown up to the sphere."""
    step = np.tan(np.linspace(-0.25 * np.pi, 0.25 * np.pi, count + 1))
    a, b = np.meshgrid(step, step, indexing="ij")
    sides = [
        np.roll(np.stack([sign * np.ones_like(a), sign * a, b], axis=2), axis, axis=2)
        for axis in range(3)
        for sign in (-1.0, 1.0)
    ]
    points = np.stack(sides).reshape(-1, 3)
    points /= np.linalg.norm(points, axis=1)[:, None]
    _, first, number = np.unique(
        np.round(points, 9) + 0.0, axis=0, return_index=True, return_inverse=True
    )
    side, i, j = (index.ravel() for index in np.indices((6, count, count)))
    width = count + 1
    corner = side * width**2 + i * width + j
    quads = np.stack([corner, corner + width, corner + width + 1, corner + 1], axis=1)
    return points[first], number.reshape(-1)[quads].astype(np.int64)
