# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Areas, normals and angles of polygons."""

from __future__ import annotations

import numpy as np
import pytest
from architectural_curvature.addon.geometry.mesh import PolygonMesh, mesh_from_polygons
from architectural_curvature.addon.geometry.polygons import (
    corner_angles,
    degenerate_polygons,
    measure_polygons,
)
from solids import cube


def _triangle(height: float, resolution: float = 0.0, size: float = 1.0) -> PolygonMesh:
    corners = np.array([[0.0, 0, 0], [1, 0, 0], [0.3, height, 0]]) * size
    return mesh_from_polygons(corners, [[0, 1, 2]], resolution=resolution)


def _is_degenerate(mesh: PolygonMesh) -> bool:
    return bool(degenerate_polygons(mesh, measure_polygons(mesh)[1])[0])


def _regular(sides: int) -> PolygonMesh:
    angle = 2 * np.pi * np.arange(sides) / sides
    corners = np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
    return mesh_from_polygons(corners, [list(range(sides))])


@pytest.mark.parametrize("sides", [3, 4, 5, 12])
def test_area_and_angles_of_regular_polygons(sides: int) -> None:
    mesh = _regular(sides)
    area = 0.5 * sides * np.sin(2 * np.pi / sides)
    np.testing.assert_allclose(measure_polygons(mesh)[1], [area], rtol=1e-14)
    np.testing.assert_allclose(measure_polygons(mesh)[0], [[0, 0, area]], atol=1e-15)
    np.testing.assert_allclose(
        corner_angles(mesh, np.arange(sides)), np.pi * (1 - 2 / sides), rtol=1e-14
    )


def test_area_vectors_of_a_closed_mesh_cancel() -> None:
    mesh = mesh_from_polygons(*cube(3))
    np.testing.assert_allclose(measure_polygons(mesh)[0].sum(axis=0), 0.0, atol=1e-15)
    assert measure_polygons(mesh)[1].sum() == pytest.approx(6.0, rel=1e-14)


def test_the_area_vector_keeps_its_digits_far_from_the_origin() -> None:
    corners = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0]]) + 2.0**20
    mesh = mesh_from_polygons(corners, [[0, 1, 2]])
    np.testing.assert_array_equal(measure_polygons(mesh)[0], [[0, 0, 0.5]])


def test_a_polygon_that_is_not_planar_has_newells_normal() -> None:
    # A square of the hyperbolic paraboloid z = x y seen from above covers its projection.
    corners = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 1], [0, 1, 0]])
    mesh = mesh_from_polygons(corners, [[0, 1, 2, 3]])
    assert measure_polygons(mesh)[0][0, 2] == pytest.approx(1.0, rel=1e-15)


def test_a_reflex_corner_counts_with_its_smaller_angle() -> None:
    arrow = np.array([[0.0, 0, 0], [1, -1, 0], [0.25, 0, 0], [1, 1, 0]])
    angles = corner_angles(mesh_from_polygons(arrow, [[0, 1, 2, 3]]), np.arange(4))
    assert angles[2] == pytest.approx(2 * np.arctan2(1.0, 0.75), rel=1e-14)


@pytest.mark.parametrize("size", [1e-3, 1.0, 1e4])
def test_thin_is_relative_to_size(size: float) -> None:
    # Half the height must exceed 1e-9 of the longest side: rounding leaves 1e-16 of it.
    assert _is_degenerate(_triangle(1e-9, size=size))
    assert not _is_degenerate(_triangle(1e-8, size=size))


def test_thin_is_what_the_rounding_of_coordinates_can_make() -> None:
    assert _is_degenerate(_triangle(1e-6, resolution=1e-6))
    assert not _is_degenerate(_triangle(4e-6, resolution=1e-6))


def test_a_face_whose_corners_coincide_is_degenerate() -> None:
    assert _is_degenerate(mesh_from_polygons(np.ones((3, 3)), [[0, 1, 2]]))
