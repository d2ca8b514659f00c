# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of a rectangle from 0 to 1, the second parameter periodic if asked."""

from __future__ import annotations

import numpy as np

from composites.composite import Array, Integers, Recipe, quads, triangulated

#: By how much random points leave their grid, in steps.
_SHAKE = 0.4


def chart(
    recipe: Recipe, lengths: tuple[float, float], rng: np.random.Generator, *, wraps: bool
) -> tuple[Array, Array, Integers]:
    """Return parameters u, v and polygons whose edges are about equal at these side lengths."""
    rows = max(6, round(np.sqrt(recipe.count * lengths[0] / lengths[1])))
    columns = max(6, round(recipe.count / rows))
    step_u, step_v = 1.0 / (rows - 1), 1.0 / (columns if wraps else columns - 1)
    u, v = (
        a.astype(np.float64).ravel()
        for a in np.meshgrid(np.arange(rows) * step_u, np.arange(columns) * step_v, indexing="ij")
    )
    if recipe.kind == "quads":
        return u, v, quads(rows, columns, wraps=(False, wraps))
    du = rng.uniform(-_SHAKE, _SHAKE, len(u)) * step_u
    dv = rng.uniform(-_SHAKE, _SHAKE, len(u)) * step_v
    du[(u == 0) | (u > 1 - 1e-9)] = 0
    if not wraps:
        dv[(v == 0) | (v > 1 - 1e-9)] = 0
    u, v = u + du, v + dv
    return u, v, _wrapped_triangles(u, v, lengths, (0.0, 4.0 * step_v if wraps else 0.0))


def doubly_periodic_chart(
    recipe: Recipe, shape: tuple[int, int], lengths: tuple[float, float], rng: np.random.Generator
) -> tuple[Array, Array, Integers]:
    """Return parameters u, v, both periodic, and polygons."""
    u, v = (a.ravel() for a in np.meshgrid(*(np.arange(n) / n for n in shape), indexing="ij"))
    if recipe.kind == "quads":
        return u, v, quads(*shape, wraps=(True, True))
    u = u + rng.uniform(-_SHAKE, _SHAKE, len(u)) / shape[0]
    v = v + rng.uniform(-_SHAKE, _SHAKE, len(u)) / shape[1]
    return u, v, _wrapped_triangles(u, v, lengths, (5.0 / shape[0], 5.0 / shape[1]))


def _wrapped_triangles(
    u: Array, v: Array, lengths: tuple[float, float], margin: tuple[float, float]
) -> Integers:
    """Return triangles of points that are repeated around the chart where it is periodic."""
    points, owner = [np.c_[u * lengths[0], v * lengths[1]]], [np.arange(len(u))]
    for a in (0, -1, 1) if margin[0] else (0,):
        for b in (0, -1, 1) if margin[1] else (0,):
            near = (np.abs(u + a - 0.5) <= 0.5 + margin[0]) & (
                np.abs(v + b - 0.5) < 0.5 + margin[1]
            )
            if a or b:
                points.append(np.c_[(u[near] + a) * lengths[0], (v[near] + b) * lengths[1]])
                owner.append(np.flatnonzero(near))
    cells = triangulated(np.concatenate(points), 1e-9 * lengths[0] * lengths[1] / len(u))
    corners = np.concatenate(owner)[cells]
    # Of the copies of a triangle the one counts whose smallest corner is no copy.
    lowest = cells[np.arange(len(cells)), np.argmin(corners, axis=1)]
    return corners[lowest < len(u)]


def on_seams(arc: Array, total: float, rows: int, seams: Array) -> Array:
    """Return arc lengths moved so that the grid's lines nearest to seams lie on them."""
    grid = np.linspace(0, total, rows)
    moved = grid.copy()
    for seam in seams:
        moved[np.argmin(np.abs(grid - seam))] = seam
    return np.interp(arc, grid, moved)
