# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Profiles of lines and arcs, extruded or revolved."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.spatial import cKDTree

from composites.charts import chart, on_seams
from composites.composite import (
    ELLIPTIC,
    FLAT,
    HYPERBOLIC,
    SINGLE,
    Array,
    Composite,
    Integers,
    Recipe,
    composite,
)

Pieces = Sequence[tuple[float, float]]
"""Length and curvature of each piece; curvature above 0 turns left."""


def profile_points(pieces: Pieces, arc: Array) -> tuple[Array, Array]:
    """Return points (n, 2) and headings of a profile that starts at the origin along +x."""
    start, heading, position = np.zeros(2), 0.0, 0.0
    points, headings = np.zeros((len(arc), 2)), np.zeros(len(arc))
    for number, (length, k) in enumerate(pieces):
        is_last = number == len(pieces) - 1
        inside = (arc >= position - 1e-12) & ((arc < position + length) | is_last)
        along = arc[inside] - position
        points[inside], headings[inside] = _on_piece(start, heading, k, along), heading + k * along
        start = _on_piece(start, heading, k, np.array([length]))[0]
        heading, position = heading + k * length, position + length
    return points, headings


def _on_piece(start: Array, heading: float, k: float, along: Array) -> Array:
    if k == 0:
        return start + along[:, None] * [np.cos(heading), np.sin(heading)]
    angle = heading + k * along
    turned = [np.sin(angle) - np.sin(heading), np.cos(heading) - np.cos(angle)]
    return start + np.stack(turned, axis=1) / k


def _arcs(recipe: Recipe, u: Array, pieces: Pieces) -> Array:
    lengths = np.array([length for length, _ in pieces])
    arc = u * lengths.sum()
    if not recipe.aligned:
        return arc
    rows = len(np.unique(u)) if recipe.kind == "quads" else _rows(u)
    return on_seams(arc, lengths.sum(), rows, np.cumsum(lengths)[:-1])


def _rows(u: Array) -> int:
    """Return how many rows random points were shaken out of: those on the first are not shaken."""
    return round(len(u) / int((u == 0).sum()))


class _Lookup:
    """Which piece of a profile points in its plane are nearest to."""

    def __init__(self, pieces: Pieces, classes: Sequence[int], offset: float = 0.0) -> None:
        lengths = np.array([length for length, _ in pieces])
        self.fine = np.linspace(0, lengths.sum(), 4001)
        self.ends = np.cumsum(lengths)[:-1]
        self.classes = np.array(classes)
        self.tree = cKDTree(profile_points(pieces, self.fine)[0] + [0.0, offset])

    def __call__(self, points: Array) -> Integers:
        arc = self.fine[self.tree.query(points)[1]]
        return self.classes[np.searchsorted(self.ends, arc, side="right")]


def extruded(
    pieces: Pieces, classes: Sequence[int], regions: int, depth: float, recipe: Recipe
) -> Composite:
    """Extrude a profile along y."""
    rng = np.random.default_rng(recipe.seed)
    total = sum(length for length, _ in pieces)
    u, v, polygons = chart(recipe, (total, depth), rng, wraps=False)
    p, heading = profile_points(pieces, _arcs(recipe, u, pieces))
    vertices = np.stack([p[:, 0], v * depth, p[:, 1]], axis=1)
    normals = np.stack([-np.sin(heading), 0 * heading, np.cos(heading)], axis=1)
    lookup = _Lookup(pieces, classes)

    def class_at(points: Array, limit: float) -> Integers:
        return lookup(points[:, [0, 2]])

    return composite(vertices, normals, polygons, recipe, rng, class_at, regions)


def revolved(
    pieces: Pieces, classes: Sequence[int], regions: int, radius: float, recipe: Recipe
) -> Composite:
    """Revolve a profile, z along +x and the radius along +y, about the z axis."""
    rng = np.random.default_rng(recipe.seed)
    total = sum(length for length, _ in pieces)
    u, v, polygons = chart(recipe, (total, 2 * np.pi * radius), rng, wraps=True)
    p, heading = profile_points(pieces, _arcs(recipe, u, pieces))
    rho, a = radius + p[:, 1], 2 * np.pi * v
    vertices = np.stack([rho * np.cos(a), rho * np.sin(a), p[:, 0]], axis=1)
    normals = np.stack(
        [np.cos(heading) * np.cos(a), np.cos(heading) * np.sin(a), -np.sin(heading)], axis=1
    )
    lookup = _Lookup(pieces, classes, radius)

    def class_at(points: Array, limit: float) -> Integers:
        return lookup(np.c_[points[:, 2], np.hypot(points[:, 0], points[:, 1])])

    return composite(vertices, normals, polygons, recipe, rng, class_at, regions)


def folded_plate(recipe: Recipe) -> Composite:
    """Return four flat plates that meet in three rounded folds."""
    a, r = np.radians(70), 0.3
    fold = [(r * a, -1 / r), (1.0, 0.0), (r * a, 1 / r), (1.0, 0.0), (r * a, -1 / r), (1.0, 0.0)]
    return extruded([(1.0, 0.0), *fold], [FLAT, SINGLE] * 3 + [FLAT], 7, 3.0, recipe)


def two_fillets(recipe: Recipe) -> Composite:
    """Return three flat plates that meet in two folds of unlike radius."""
    a = np.radians(40)
    pieces = [(1.2, 0.0), (0.6 * a, -1 / 0.6), (0.8, 0.0), (0.48, 1 / 0.4), (1.0, 0.0)]
    return extruded(pieces, [FLAT, SINGLE, FLAT, SINGLE, FLAT], 5, 2.5, recipe)


def silo(recipe: Recipe) -> Composite:
    """Return a cone that a part of a torus bends into a cylinder."""
    a, start = np.radians(50), 1e-9
    pieces = [(start, a / start), (1.2, 0.0), (0.8 * a, -1 / 0.8), (2.0, 0.0)]
    return revolved(pieces, [SINGLE, SINGLE, ELLIPTIC, SINGLE], 3, 0.5, recipe)


def tulip(recipe: Recipe) -> Composite:
    """Return a cylinder that a part of a torus opens into a cone."""
    a = np.radians(40)
    pieces = [(1.5, 0.0), (a, 1.0), (1.0, 0.0)]
    return revolved(pieces, [SINGLE, HYPERBOLIC, SINGLE], 3, 0.6, recipe)


def bottle(recipe: Recipe) -> Composite:
    """Return a cylinder that a dome narrows to a cone and a saddle to a thinner cylinder."""
    a = np.radians(35)
    pieces = [(1.0, 0.0), (0.5 * a, -1 / 0.5), (0.8, 0.0), (0.6 * a, 1 / 0.6), (0.9, 0.0)]
    return revolved(pieces, [SINGLE, ELLIPTIC, SINGLE, HYPERBOLIC, SINGLE], 5, 1.4, recipe)


def basket_arch(recipe: Recipe) -> Composite:
    """Return a vault of three radii between two plates."""
    pieces = [(0.8, 0.0), (0.3, -1 / 0.5), (1.0, -1 / 2.0), (0.3, -1 / 0.5), (0.8, 0.0)]
    return extruded(pieces, [FLAT, SINGLE, SINGLE, SINGLE, FLAT], 3, 2.5, recipe)


def ogee(recipe: Recipe) -> Composite:
    """Return two parallel plates that an S of two cylinders joins."""
    pieces = [(1.0, 0.0), (0.54, -1 / 0.6), (0.54, 1 / 0.6), (1.0, 0.0)]
    return extruded(pieces, [FLAT, SINGLE, SINGLE, FLAT], 3, 2.0, recipe)


def shoulder(recipe: Recipe) -> Composite:
    """Return a cylinder that a dome narrows to a short cone."""
    a = np.radians(60)
    pieces = [(1.0, 0.0), (0.7 * a, -1 / 0.7), (0.3, 0.0)]
    return revolved(pieces, [SINGLE, ELLIPTIC, SINGLE], 3, 1.2, recipe)
