# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pipes: an elbow, and a whole torus."""

from __future__ import annotations

import numpy as np

from composites.charts import chart, doubly_periodic_chart, on_seams
from composites.composite import (
    ELLIPTIC,
    HYPERBOLIC,
    SINGLE,
    Array,
    Composite,
    Integers,
    Recipe,
    composite,
)
from composites.profiles import profile_points


def _torus_class(rho: Array, z: Array, bend: float, pipe: float, limit: float) -> Integers:
    """Return the class on a torus by the distance from its axis and the height, limit < 1/pipe."""
    cosine = (rho - bend) / np.hypot(rho - bend, z)
    small = cosine / (bend + pipe * cosine)
    return np.where(
        np.abs(small) <= limit, SINGLE, np.where(small > 0, ELLIPTIC, HYPERBOLIC)
    ).astype(np.int64)


def pipe_elbow(
    recipe: Recipe, bend: float = 1.0, pipe: float = 0.35, arm: float = 1.2
) -> Composite:
    """Return a pipe: cylinder, quarter of a torus, cylinder.

    Single-curved bands on the torus join the cylinders; a dome lies outside, a saddle inside.
    """
    rng = np.random.default_rng(recipe.seed)
    turn = 0.5 * np.pi * bend
    u, v, polygons = chart(recipe, (2 * arm + turn, 2 * np.pi * pipe), rng, wraps=True)
    arc = u * (2 * arm + turn)
    if recipe.aligned:
        rows = round(len(u) / int((u == 0).sum()))
        arc = on_seams(arc, 2 * arm + turn, rows, np.array([arm, arm + turn]))
    spine, heading = profile_points([(arm, 0.0), (turn, 1 / bend), (arm, 0.0)], arc)
    a = 2 * np.pi * v
    outward = np.stack([np.sin(heading), -np.cos(heading), 0 * heading], axis=1)
    normals = np.cos(a)[:, None] * outward + np.sin(a)[:, None] * [0.0, 0.0, 1.0]
    vertices = np.c_[spine, 0 * arc] + pipe * normals

    def class_at(points: Array, limit: float) -> Integers:
        x, y = points[:, 0] - arm, points[:, 1] - bend
        found = _torus_class(np.hypot(x, y), points[:, 2], bend, pipe, limit)
        return np.where((x > 0) & (y < 0), found, SINGLE)

    return composite(vertices, normals, polygons, recipe, rng, class_at, 3)


def torus(recipe: Recipe, bend: float = 1.0, pipe: float = 0.4) -> Composite:
    """Return a ring torus about the z axis."""
    rng = np.random.default_rng(recipe.seed)
    around = max(8, round(np.sqrt(recipe.count * pipe / bend)))
    along = max(8, round(recipe.count / around))
    u, v, polygons = doubly_periodic_chart(
        recipe, (along, around), (2 * np.pi * bend, 2 * np.pi * pipe), rng
    )
    a, b = 2 * np.pi * u, 2 * np.pi * v
    normals = np.stack([np.cos(b) * np.cos(a), np.cos(b) * np.sin(a), np.sin(b)], axis=1)
    spine = bend * np.stack([np.cos(a), np.sin(a), 0 * a], axis=1)

    def class_at(points: Array, limit: float) -> Integers:
        rho = np.hypot(points[:, 0], points[:, 1])
        return _torus_class(rho, points[:, 2], bend, pipe, limit)

    return composite(spine + pipe * normals, normals, polygons, recipe, rng, class_at, 4)


def torus_shares(limit: float, bend: float = 1.0, pipe: float = 0.4) -> Array:
    """Return the exact shares of single-curved, dome and saddle, for a limit below 1/pipe.

    With b the angle around the pipe, the smaller curvature is cos b / (R + r cos b), and the area
    between -b and b is proportional to R b + r sin b.
    """

    def area_up_to(cosine: float) -> float:
        b = np.arccos(np.clip(cosine, -1, 1))
        return (bend * b + pipe * np.sin(b)) / (np.pi * bend)

    dome = area_up_to(limit * bend / (1 - limit * pipe))
    saddle = 1 - area_up_to(-limit * bend / (1 + limit * pipe))
    return np.array([1 - dome - saddle, dome, saddle])
