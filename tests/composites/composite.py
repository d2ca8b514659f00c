# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh of a composite surface, and what is exact about it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import Delaunay

Array = NDArray[np.float64]
Integers = NDArray[np.int64]
ExactClass = Callable[[Array, float], Integers]

FLAT, SINGLE, ELLIPTIC, HYPERBOLIC = range(4)


@dataclass(frozen=True)
class Recipe:
    """How a composite is meshed.

    count: about how many vertices. kind: "quads" or "triangles". noise: standard deviation along
    the normals, as a share of the mean edge. aligned: whether seams lie on mesh lines.
    """

    count: int = 10_000
    kind: str = "quads"
    noise: float = 0.0
    seed: int = 0
    aligned: bool = False


@dataclass(frozen=True)
class Composite:
    """A mesh, the class of points near it at a limit, how many regions it has, its mean edge."""

    vertices: Array
    polygons: Integers
    class_at: ExactClass
    regions: int
    edge: float

    def exact(self, limit: float) -> Integers:
        """Return the class at the center of every polygon, (m,) int64."""
        return self.class_at(self.vertices[self.polygons].mean(axis=1), limit)


def composite(
    vertices: Array,
    normals: Array,
    polygons: Integers,
    recipe: Recipe,
    rng: np.random.Generator,
    class_at: ExactClass,
    regions: int,
) -> Composite:
    """Turn polygons to the side of the normals, and add noise."""
    a, b, c = (vertices[polygons[:, corner]] for corner in range(3))
    facing = np.einsum("ij,ij->i", np.cross(b - a, c - a), normals[polygons[:, 0]])
    if np.median(facing) < 0:
        polygons = polygons[:, ::-1]
    corner = vertices[polygons]
    edge = float(np.linalg.norm(corner - np.roll(corner, -1, axis=1), axis=2).mean())
    if recipe.noise:
        height = rng.standard_normal(len(vertices)) * recipe.noise * edge
        vertices = vertices + normals * height[:, None]
    return Composite(vertices, polygons, class_at, regions, edge)


def triangulated(points: Array, least_area: float) -> Integers:
    """Return the Delaunay triangles of points in the plane, counter-clockwise, without slivers."""
    cells = Delaunay(points).simplices.astype(np.int64)
    first, second = (points[cells[:, i]] - points[cells[:, 0]] for i in (1, 2))
    area = first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]
    cells[area < 0] = cells[area < 0][:, [0, 2, 1]]
    return cells[np.abs(area) > least_area]


def quads(rows: int, columns: int, *, wraps: tuple[bool, bool] = (False, False)) -> Integers:
    """Return the quads of a grid of points, row by row; rows or columns may close."""
    i, j = (
        a.ravel()
        for a in np.meshgrid(
            np.arange(rows - (not wraps[0])), np.arange(columns - (not wraps[1])), indexing="ij"
        )
    )
    up, right = (i + 1) % rows, (j + 1) % columns
    corners = [i * columns + j, up * columns + j, up * columns + right, i * columns + right]
    return np.stack(corners, axis=1)
