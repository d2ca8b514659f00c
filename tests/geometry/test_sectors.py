# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A vertex has one sector per smooth side, and the widest one leads."""

from __future__ import annotations

import numpy as np
from architectural_curvature.addon.geometry.mesh import mesh_from_polygons
from architectural_curvature.addon.geometry.sectors import leading_sectors
from architectural_curvature.addon.geometry.surface import Surface, build_surface
from solids import cube, grid


def _plate(count: int = 4, **marks: object) -> Surface:
    vertices, faces = grid(lambda u, v: (count * u, count * v, 0.0), (count, count))
    return build_surface(mesh_from_polygons(vertices, faces, **marks))  # pyright: ignore[reportArgumentType]


def _sectors_per_vertex(surface: Surface) -> np.ndarray:
    return np.bincount(surface.sector_vertex, minlength=surface.mesh.vertex_count)


def test_without_creases_sectors_are_vertices() -> None:
    surface = _plate()
    assert np.array_equal(surface.sector_vertex, np.arange(25))
    assert np.array_equal(surface.corner_sector, surface.mesh.corner_vertex)
    assert not surface.has_creases


def test_a_crease_across_a_plate_splits_its_vertices_in_two() -> None:
    line = [(10 + j, 11 + j) for j in range(4)]
    surface = _plate(sharp_edges=line)
    assert surface.has_creases
    assert np.array_equal(_sectors_per_vertex(surface)[10:15], np.full(5, 2))
    assert surface.sector_count == 25 + 5


def test_where_a_crease_ends_inside_the_vertex_stays_whole() -> None:
    # The crease runs from the rim at vertex 10 to vertex 12 in the middle of the plate.
    surface = _plate(sharp_edges=[(10, 11), (11, 12)])
    assert _sectors_per_vertex(surface)[10:13].tolist() == [2, 2, 1]
    assert surface.sector_count == 25 + 2


def test_a_single_marked_edge_inside_splits_nothing() -> None:
    surface = _plate(sharp_edges=[(11, 12)])
    assert not surface.has_creases
    assert surface.edges.is_crease.sum() == 1


def test_a_vertex_where_two_fans_touch_has_two_sectors() -> None:
    bow_tie = np.array([[0.0, 0, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0], [-1, -1, 0]])
    surface = build_surface(mesh_from_polygons(bow_tie, [[0, 1, 2], [0, 3, 4]]))
    assert _sectors_per_vertex(surface).tolist() == [2, 1, 1, 1, 1]


def test_the_corners_of_a_cube_have_three_sectors_and_its_edges_two() -> None:
    surface = build_surface(mesh_from_polygons(*cube(3)))
    on_sides = np.isin(surface.mesh.vertices, (0.0, 1.0)).sum(axis=1)
    assert np.array_equal(_sectors_per_vertex(surface), on_sides)


def test_sectors_are_numbered_in_the_order_of_their_vertices() -> None:
    surface = build_surface(mesh_from_polygons(*cube(3)))
    assert (np.diff(surface.sector_vertex) >= 0).all()
    assert np.array_equal(surface.sector_vertex[surface.corner_sector], surface.mesh.corner_vertex)


def test_unused_vertices_have_no_sector() -> None:
    vertices = np.array([[9.0, 9, 9], [0, 0, 0], [1, 0, 0], [0, 1, 0], [8, 8, 8]])
    surface = build_surface(mesh_from_polygons(vertices, [[1, 2, 3]]))
    assert surface.sector_vertex.tolist() == [1, 2, 3]
    assert surface.vertex_sector.tolist() == [-1, 0, 1, 2, -1]


def test_faces_of_opposite_winding_do_not_share_a_sector() -> None:
    square = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
    surface = build_surface(mesh_from_polygons(square, [[0, 1, 2], [0, 3, 2]]))
    assert _sectors_per_vertex(surface).tolist() == [2, 1, 2, 1]


def test_the_sector_with_the_largest_angle_leads() -> None:
    # At vertex 0 a face of 135° and one of 45° meet in a crease.
    vertices = np.array([[0.0, 0, 0], [1, 0, 0], [-1, 1, 0], [-1, 0, 0]])
    mesh = mesh_from_polygons(vertices, [[0, 2, 3], [0, 1, 2]], sharp_edges=[(0, 2)])
    surface = build_surface(mesh)
    leading = surface.vertex_sector[0]
    assert surface.corner_sector[3] == leading
    assert surface.corner_sector[0] != leading


def test_of_equal_angles_the_first_sector_leads_whatever_the_rounding() -> None:
    angles = np.array([1.0, 1.0 + 1e-12, 0.5, 2.0])
    leading = leading_sectors(np.array([0, 0, 1, 1]), np.arange(4), angles, 3)
    assert leading.tolist() == [0, 3, -1]
