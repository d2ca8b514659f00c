# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh is checked when it is made, and refused in words that say what to do."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from architectural_curvature.addon.geometry.errors import CurvatureError, InvalidMeshError
from architectural_curvature.addon.geometry.mesh import mesh_from_polygons, number_edges

SQUARE = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])


def _refusal(vertices: object, polygons: object) -> str:
    with pytest.raises(InvalidMeshError) as caught:
        mesh_from_polygons(np.array(vertices, dtype=float), polygons)  # pyright: ignore[reportArgumentType]
    return str(caught.value)


def test_a_mesh_without_faces_is_refused() -> None:
    assert _refusal(SQUARE, []) == "the mesh has no faces: add faces, or choose another object"


def test_an_empty_mesh_is_refused() -> None:
    assert _refusal(np.empty((0, 3)), []).startswith("the mesh has no faces")


def test_a_face_with_two_corners_is_refused_by_number() -> None:
    message = _refusal(SQUARE, [[0, 1, 2], [2, 3]])
    assert message == "face 1 has 2 corners: a face needs at least three"


@pytest.mark.parametrize("number", [np.nan, np.inf, -np.inf])
def test_coordinates_that_are_not_finite_are_counted_and_named(number: float) -> None:
    vertices = SQUARE.copy()
    vertices[2, 1] = vertices[3, 0] = number
    assert _refusal(vertices, [[0, 1, 2, 3]]) == (
        "2 of 4 vertices have coordinates that are not finite (the first is vertex 2): "
        "delete or move them"
    )


@pytest.mark.parametrize("number", [-1, 4])
def test_vertex_numbers_out_of_range_are_refused(number: int) -> None:
    message = _refusal(SQUARE, [[0, 1, 2], [0, 2, number]])
    assert message == f"a face uses vertex {number}, but the mesh has the vertices 0 to 3"


def test_vertices_of_another_shape_are_refused() -> None:
    mesh = mesh_from_polygons(SQUARE, [[0, 1, 2, 3]])
    with pytest.raises(InvalidMeshError, match=r"must have the shape \(n, 3\), not \(4, 2\)"):
        replace(mesh, vertices=SQUARE[:, :2])


def test_all_refusals_are_errors_of_one_kind() -> None:
    assert issubclass(InvalidMeshError, CurvatureError)
    assert issubclass(CurvatureError, ValueError)


def test_polygons_of_any_size_are_filled_by_fans() -> None:
    pentagon = [[np.cos(a), np.sin(a), 0] for a in 2 * np.pi * np.arange(5) / 5]
    mesh = mesh_from_polygons(np.array([*pentagon, [3, 0, 0]]), [[0, 1, 2, 3, 4], [0, 4, 5]])
    assert mesh.polygon_count == 2
    assert mesh.vertex_count == 6
    assert mesh.triangle_polygon.tolist() == [0, 0, 0, 1]
    assert mesh.corner_vertex[mesh.triangle_corner].tolist() == [
        [0, 1, 2],
        [0, 2, 3],
        [0, 3, 4],
        [0, 4, 5],
    ]


def test_corners_know_their_neighbors_around_each_polygon() -> None:
    mesh = mesh_from_polygons(SQUARE, [[0, 1, 2], [0, 2, 3]])
    assert mesh.next_corner.tolist() == [1, 2, 0, 4, 5, 3]
    assert mesh.previous_corner.tolist() == [2, 0, 1, 5, 3, 4]
    assert mesh.corner_polygon.tolist() == [0, 0, 0, 1, 1, 1]


def test_faces_that_share_two_vertices_share_an_edge() -> None:
    mesh = mesh_from_polygons(SQUARE, [[0, 1, 2], [0, 2, 3]])
    assert len(mesh.edge_is_sharp) == 5
    assert mesh.corner_edge[2] == mesh.corner_edge[3]
    assert len(set(mesh.corner_edge.tolist())) == 5


def test_edges_are_numbered_whatever_their_direction() -> None:
    half_edge_edge, edges = number_edges(np.array([3, 1, 0]), np.array([1, 3, 2]), 4)
    assert half_edge_edge.tolist() == [1, 1, 0]
    assert edges.tolist() == [[0, 2], [1, 3]]


def test_sharp_edges_are_marked_in_either_direction() -> None:
    for pair in ((0, 2), (2, 0)):
        mesh = mesh_from_polygons(SQUARE, [[0, 1, 2], [0, 2, 3]], sharp_edges=[pair])
        assert mesh.edge_is_sharp.sum() == 1
        assert mesh.edge_is_sharp[mesh.corner_edge[2]]


def test_the_diagonal_measures_used_vertices_only() -> None:
    far = np.concatenate([SQUARE, [[1e6, 0, 0]]])
    assert mesh_from_polygons(far, [[0, 1, 2]]).diagonal == pytest.approx(np.sqrt(2.0), rel=1e-15)


def test_a_mesh_does_not_change_its_input() -> None:
    vertices, polygons = SQUARE.copy(), [[0, 1, 2, 3]]
    mesh = mesh_from_polygons(vertices, polygons)
    vertices[0] = 7.0
    assert mesh.vertices[0].tolist() == [0.0, 0.0, 0.0]
    assert polygons == [[0, 1, 2, 3]]
