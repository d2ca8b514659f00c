# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Points find their places on a surface."""

from __future__ import annotations

import numpy as np
from architectural_curvature.addon.geometry.mesh import mesh_from_polygons
from architectural_curvature.addon.geometry.places import (
    PlaceFinder,
    vertex_places,
)
from architectural_curvature.addon.geometry.surface import Surface, build_surface
from solids import capped_cylinder


def _points(surface: Surface, triangle: np.ndarray, barycentric: np.ndarray) -> np.ndarray:
    corners = surface.mesh.vertices[surface.sector_vertex][surface.sector_triangles[triangle]]
    return np.einsum("pc,pcx->px", barycentric, corners)


def test_points_are_found_where_they_are() -> None:
    surface = build_surface(mesh_from_polygons(*capped_cylinder(1.0, 2.0, 32, 8)))
    random = np.random.default_rng(1)
    triangle = random.integers(0, len(surface.sector_triangles), 200)
    weights = random.dirichlet((1.0, 1.0, 1.0), 200)
    points = _points(surface, triangle, weights)
    found, barycentric, distance = PlaceFinder(surface).nearest(points)
    np.testing.assert_allclose(_points(surface, found, barycentric), points, atol=1e-9)
    assert distance.max() < 1e-9
    np.testing.assert_allclose(barycentric.sum(axis=1), 1.0)


def test_deviation_is_the_distance_from_the_surface() -> None:
    surface = build_surface(mesh_from_polygons(*capped_cylinder(1.0, 2.0, 32, 8)))
    above = np.array([[0.0, 0.0, surface.mesh.vertices[:, 2].max() + 0.25]])
    np.testing.assert_allclose(PlaceFinder(surface).deviation(above), 0.25)
    assert PlaceFinder(surface).deviation(np.zeros((0, 3))) == 0.0


def test_vertices_have_places_in_a_triangle_of_theirs() -> None:
    surface = build_surface(mesh_from_polygons(*capped_cylinder(1.0, 2.0, 32, 8)))
    vertices = np.arange(0, surface.mesh.vertex_count, 7)
    triangle, barycentric = vertex_places(surface, vertices)
    off = np.linalg.norm(
        _points(surface, triangle, barycentric) - surface.mesh.vertices[vertices], axis=1
    )
    assert off.max() < 0.005
    assert barycentric.min() > 0.0


def test_rays_meet_the_near_side_first() -> None:
    surface = build_surface(mesh_from_polygons(*capped_cylinder(1.0, 2.0, 32, 8)))
    finder = PlaceFinder(surface)
    random = np.random.default_rng(2)
    low, high = surface.mesh.vertices.min(axis=0), surface.mesh.vertices.max(axis=0)
    for height in random.uniform(low[2], high[2], 50):
        # From far away, as orthographic views look: single precision there is 0.06 m.
        origin = np.array([1e6, random.uniform(-0.9, 0.9), height])
        seen = finder.seen(origin, np.array([-7.0, 0.0, 0.0]))
        assert seen is not None
        point = _points(surface, np.array([seen[0]]), seen[1][None])[0]
        np.testing.assert_allclose(point[1:], origin[1:], atol=1e-9)
        # Chords of a circle of 32 sides stay outside of the circle inside them.
        assert np.hypot(*point[:2]) >= np.cos(np.pi / 32) - 1e-9
        assert point[0] > 0.0
    assert finder.seen(np.array([5.0, 0.0, 0.0]), np.array([1.0, 0.0, 0.0])) is None
    assert finder.seen(np.array([5.0, 1.1, 0.0]), np.array([-1.0, 0.0, 0.0])) is None
