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


def rounded_box(
    recipe: Recipe, half: tuple[float, float, float] = (0.7, 0.7, 0.7), radius: float = 0.35
) -> Composite:
    """Return 6 flat sides, twice as long as `half`, 12 edges of cylinders, 8 corners of spheres."""
    rng = np.random.default_rng(recipe.seed)
    # Equal arcs: a fillet takes up 45 degrees on each side of a box's edge.
    arc = radius * np.pi / 4
    reach = np.array(half) + arc
    seams = np.array(half) / reach
    edge = np.sqrt(8 * (reach * np.roll(reach, 1)).sum() / recipe.count)
    grids = [np.linspace(-1, 1, max(6, round(2 * each / edge) + 1)) for each in reach]
    if recipe.aligned:
        grids = [_on_seam(grid, seam) for grid, seam in zip(grids, seams, strict=True)]

    def along(axis: int, parameter: Array) -> Array:
        x = np.abs(parameter) * reach[axis]
        bent = half[axis] + radius * np.tan(np.clip((x - half[axis]) / radius, 0, np.pi / 4))
        return np.sign(parameter) * np.where(x <= half[axis], x, bent)

    points: list[Array] = []
    cells: list[Integers] = []
    for axis in range(3):
        for sign in (-1.0, 1.0):
            one, other = (axis + 1) % 3, (axis + 2) % 3
            kept = seams[[one, other]] if recipe.aligned else np.full(2, np.inf)
            p, q, side = _side(recipe, (grids[one], grids[other]), kept, rng)
            xyz = np.zeros((len(p), 3))
            xyz[:, axis] = sign * (half[axis] + radius)
            xyz[:, one], xyz[:, other] = along(one, p), along(other, q)
            cells.append((side if sign > 0 else side[:, ::-1]) + sum(map(len, points)))
            points.append(xyz)
    cube = np.concatenate(points)
    _, first, number = np.unique(
        np.round(cube, 9) + 0.0, axis=0, return_index=True, return_inverse=True
    )
    cube, polygons = cube[first], number.reshape(-1)[np.concatenate(cells)]
    inner = np.clip(cube, -np.array(half), half)
    normals = cube - inner
    normals /= np.linalg.norm(normals, axis=1)[:, None]

    def class_at(points: Array, limit: float) -> Integers:
        outside = (np.abs(points) > half).sum(axis=1)
        return np.array([FLAT, FLAT, SINGLE, ELLIPTIC])[outside]

    return composite(inner + radius * normals, normals, polygons, recipe, rng, class_at, 26)


def _on_seam(grid: Array, seam: float) -> Array:
    """Return the grid with its nearest lines moved onto the seam, on both sides of the middle."""
    line = abs(float(grid[np.argmin(np.abs(grid - seam))]))
    return np.interp(grid, [-1, -line, line, 1], [-1, -seam, seam, 1])


def _side(
    recipe: Recipe, grids: tuple[Array, Array], seams: Array, rng: np.random.Generator
) -> tuple[Array, Array, Integers]:
    """Return the points and cells of one side; points on rims and seams are not shaken."""
    many = [len(grid) for grid in grids]
    p, q = (a.ravel() for a in np.meshgrid(*grids, indexing="ij"))
    if recipe.kind == "quads":
        return p, q, quads(*many)
    steps = [2.0 / (n - 1) for n in many]
    is_rim = (np.abs(p) == 1) | (np.abs(q) == 1)
    shaken: list[Array] = []
    for values, seam, step in zip((p, q), seams, steps, strict=True):
        stays = is_rim | (np.abs(np.abs(values) - seam) < 1e-9)
        shaken.append(values + np.where(stays, 0, rng.uniform(-0.35, 0.35, len(values)) * step))
    p, q = shaken
    # In steps, so that triangles are those of the surface.
    return p, q, triangulated(np.c_[p / steps[0], q / steps[1]], 1e-9)
