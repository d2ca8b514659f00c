# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A box with rounded edges and corners."""

from __future__ import annotations

import numpy as np

from composites.composite import (
    ELLIPTIC,
    FLAT,
    SINGLE,
    Array,
    Composite,
    Integers,
    Recipe,
    composite,
    quads,
    triangulated,
)


def rounded_box(recipe: Recipe, half: float = 0.7, radius: float = 0.35) -> Composite:
    """Return 6 flat sides, 12 edges of cylinders and 8 corners of spheres."""
    rng = np.random.default_rng(recipe.seed)
    n = max(6, round(np.sqrt(recipe.count / 6)) + 1)
    # Equal arcs: a fillet takes up 45 degrees on each side of a cube's edge.
    arc = radius * np.pi / 4
    seam = half / (half + arc)
    grid = np.linspace(-1, 1, n)
    if recipe.aligned:
        line = abs(float(grid[np.argmin(np.abs(grid - seam))]))
        grid = np.interp(grid, [-1, -line, line, 1], [-1, -seam, seam, 1])

    def along(parameter: Array) -> Array:
        x = np.abs(parameter) * (half + arc)
        bent = half + radius * np.tan(np.clip((x - half) / radius, 0, np.pi / 4))
        return np.sign(parameter) * np.where(x <= half, x, bent)

    points: list[Array] = []
    cells: list[Integers] = []
    for axis in range(3):
        for sign in (-1.0, 1.0):
            p, q, side = _side(recipe, grid, seam if recipe.aligned else np.inf, rng)
            xyz = np.zeros((len(p), 3))
            xyz[:, axis] = sign * (half + radius)
            xyz[:, (axis + 1) % 3], xyz[:, (axis + 2) % 3] = along(p), along(q)
            cells.append((side if sign > 0 else side[:, ::-1]) + sum(map(len, points)))
            points.append(xyz)
    cube = np.concatenate(points)
    _, first, number = np.unique(
        np.round(cube, 9) + 0.0, axis=0, return_index=True, return_inverse=True
    )
    cube, polygons = cube[first], number.reshape(-1)[np.concatenate(cells)]
    inner = np.clip(cube, -half, half)
    normals = cube - inner
    normals /= np.linalg.norm(normals, axis=1)[:, None]

    def class_at(points: Array, limit: float) -> Integers:
        outside = (np.abs(points) > half).sum(axis=1)
        return np.array([FLAT, FLAT, SINGLE, ELLIPTIC])[outside]

    return composite(inner + radius * normals, normals, polygons, recipe, rng, class_at, 26)


def _side(
    recipe: Recipe, grid: Array, seam: float, rng: np.random.Generator
) -> tuple[Array, Array, Integers]:
    """Return the points and cells of one side; points on rims and seams are not shaken."""
    n = len(grid)
    p, q = (a.ravel() for a in np.meshgrid(grid, grid, indexing="ij"))
    if recipe.kind == "quads":
        return p, q, quads(n, n)
    step = 2.0 / (n - 1)
    is_rim = (np.abs(p) == 1) | (np.abs(q) == 1)
    shaken: list[Array] = []
    for values in (p, q):
        stays = is_rim | (np.abs(np.abs(values) - seam) < 1e-9)
        shaken.append(values + np.where(stays, 0, rng.uniform(-0.35, 0.35, len(values)) * step))
    p, q = shaken
    return p, q, triangulated(np.c_[p, q], 1e-9 * step**2)
