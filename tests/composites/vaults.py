# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A barrel vault with apses."""

from __future__ import annotations

import numpy as np

from composites.composite import (
    ELLIPTIC,
    SINGLE,
    Array,
    Composite,
    Integers,
    Recipe,
    composite,
    quads,
    triangulated,
)


def apse_vault(recipe: Recipe, radius: float = 1.0, half: float = 1.5) -> Composite:
    """Return a barrel vault with a quarter of a sphere at both ends."""
    rng = np.random.default_rng(recipe.seed)
    width = radius * np.pi / 2
    if recipe.kind == "quads":
        plan, polygons = _plan_of_quads(recipe.count, half, width)
    else:
        plan, polygons = _plan_of_triangles(recipe, half, width, rng)
    spine = np.clip(plan[:, 0], -half, half)
    arm = plan - np.c_[spine, 0 * spine]
    distance = np.linalg.norm(arm, axis=1)
    direction = arm / np.maximum(distance, 1e-12)[:, None]
    angle = distance / radius
    normals = np.c_[np.sin(angle)[:, None] * direction, np.cos(angle)]
    vertices = np.c_[spine, 0 * spine, 0 * spine] + radius * normals

    def class_at(points: Array, limit: float) -> Integers:
        return np.where(np.abs(points[:, 0]) > half, ELLIPTIC, SINGLE).astype(np.int64)

    return composite(vertices, normals, polygons, recipe, rng, class_at, 3)


def _plan_of_quads(count: int, half: float, width: float) -> tuple[Array, Integers]:
    """Return the vault unrolled: a rectangle between two half discs, squeezed from squares."""
    n = max(4, int(np.round(np.sqrt(count / (half / width + 1)))) // 2 * 2)
    m = max(4, int(np.round(n * half / width)))
    xs = np.concatenate(
        [
            np.linspace(-1, 0, n // 2 + 1)[:-1],
            np.linspace(0, 1, m + 1)[:-1],
            np.linspace(1, 2, n // 2 + 1),
        ]
    )
    x, y = (a.ravel() for a in np.meshgrid(xs, np.linspace(-1, 1, n + 1), indexing="ij"))
    end = np.where(x < 0, x, np.where(x > 1, x - 1, 0.0))
    # Every concentric square goes to a circle, radially.
    small, big = np.minimum(np.abs(end), np.abs(y)), np.maximum(np.abs(end), np.abs(y))
    turn = np.pi / 4 * small / np.maximum(big, 1e-12)
    angle = np.where(np.abs(end) <= np.abs(y), turn, np.pi / 2 - turn)
    px, py = big * np.sin(angle) * np.sign(end), big * np.cos(angle) * np.sign(y)
    is_barrel = end == 0
    plan = np.stack(
        [
            np.where(is_barrel, (2 * x - 1) * half, np.sign(end) * half + px * width),
            np.where(is_barrel, y, py) * width,
        ],
        axis=1,
    )
    return plan, quads(len(xs), n + 1)


def _plan_of_triangles(
    recipe: Recipe, half: float, width: float, rng: np.random.Generator
) -> tuple[Array, Integers]:
    """Return the vault unrolled: a stadium of random triangles."""
    step = np.sqrt((4 * half * width + np.pi * width**2) / recipe.count)
    rows = max(4, round(2 * half / step))
    a = np.linspace(-np.pi / 2, np.pi / 2, max(8, round(np.pi * width / step)) + 1)
    line = np.linspace(-half, half, rows + 1)[1:-1]
    cap = np.c_[half + width * np.cos(a), width * np.sin(a)]
    side = np.c_[line, np.full(rows - 1, width)]
    nx, ny = int(2 * (half + width) / step) + 2, int(2 * width / step) + 2
    q = np.stack(
        [
            b.ravel()
            for b in np.meshgrid(
                (np.arange(nx) - nx / 2 + 0.5) * step, (np.arange(ny) - ny / 2 + 0.5) * step
            )
        ],
        axis=1,
    )
    q = q + rng.uniform(-0.38, 0.38, q.shape) * step
    q = q[np.hypot(np.maximum(np.abs(q[:, 0]) - half, 0), q[:, 1]) < width - 0.5 * step]
    seams = np.zeros((0, 2))
    if recipe.aligned:
        q = q[np.abs(np.abs(q[:, 0]) - half) > 0.35 * step]
        k = int(2 * width / step)
        ys = (np.arange(1, k) / k * 2 - 1) * width
        seams = np.concatenate([np.c_[np.full(k - 1, sign * half), ys] for sign in (-1, 1)])
    plan = np.concatenate([cap, -cap, side, -side, seams, q])
    return plan, triangulated(plan, 1e-4 * step**2)
