# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Edges are smooth, creases or rims by the rules that users are told."""

from __future__ import annotations

import numpy as np
import pytest
from architectural_curvature.addon.geometry.creases import Edges, dihedral_angles
from architectural_curvature.addon.geometry.mesh import mesh_from_polygons
from architectural_curvature.addon.geometry.surface import build_surface
from solids import cube


def _fold(degrees: float) -> np.ndarray:
    """Two unit squares that share the edge from vertex 0 to 1, folded by an angle."""
    a = np.radians(degrees)
    return np.array(
        [
            [0.0, 0, 0],
            [0, 1, 0],
            [-1, 1, 0],
            [-1, 0, 0],
            [np.cos(a), 0, -np.sin(a)],
            [np.cos(a), 1, -np.sin(a)],
        ]
    )


FACES = [[0, 1, 2, 3], [1, 0, 4, 5]]


def _edges(degrees: float, limit: float, **marks: object) -> Edges:
    mesh = mesh_from_polygons(_fold(degrees), FACES, **marks)  # pyright: ignore[reportArgumentType]
    return build_surface(mesh, np.radians(limit)).edges


@pytest.mark.parametrize("degrees", [0.0, 1e-6, 1.0, 29.9, 90.0, 150.0, 180.0])
def test_dihedral_angles_are_exact_even_when_small(degrees: float) -> None:
    a = np.radians(degrees)
    one, other = np.array([[0.0, 0, 2]]), np.array([[0, 3 * np.sin(a), 3 * np.cos(a)]])
    assert dihedral_angles(one, other)[0] == pytest.approx(a, rel=1e-12, abs=1e-15)


@pytest.mark.parametrize(("degrees", "is_crease"), [(29.0, False), (31.0, True), (-31.0, True)])
def test_folds_beyond_the_crease_angle_are_creases(degrees: float, *, is_crease: bool) -> None:
    edges = _edges(degrees, 30.0)
    assert edges.is_crease.tolist() == [is_crease]
    assert len(edges.smooth) == (not is_crease)
    assert len(edges.rim) == 6


def test_a_marked_edge_is_a_crease_even_where_flat() -> None:
    assert _edges(0.0, 30.0, sharp_edges=[(0, 1)]).is_crease.all()


def test_a_marked_rim_stays_a_rim() -> None:
    edges = _edges(0.0, 30.0, sharp_edges=[(1, 2)])
    assert not edges.is_crease.any()
    assert len(edges.rim) == 6


def test_at_180_degrees_only_marks_make_creases() -> None:
    assert not _edges(179.0, 180.0).is_crease.any()


def test_an_edge_whose_faces_disagree_in_winding_is_no_smooth_edge() -> None:
    mesh = mesh_from_polygons(_fold(0.0), [FACES[0], FACES[1][::-1]])
    edges = build_surface(mesh).edges
    assert edges.flipped_count == 1
    assert len(edges.inner) == 0
    assert len(edges.rim) == 6


def test_an_edge_with_three_faces_is_no_smooth_edge() -> None:
    vertices = np.concatenate([_fold(0.0), [[0, 0, 1.0], [0, 1, 1]]])
    edges = build_surface(mesh_from_polygons(vertices, [*FACES, [0, 1, 7, 6]])).edges
    assert edges.nonmanifold_count == 1
    assert edges.flipped_count == 0
    assert len(edges.inner) == 0


def test_no_angle_is_measured_at_a_sliver() -> None:
    # A face without area between two coplanar ones has any normal; the plate stays whole.
    vertices = np.array([[0.0, 0, 0], [0, 2, 0], [-1, 1, 0], [1, 1, 0], [0, 1, 0]])
    mesh = mesh_from_polygons(vertices, [[0, 4, 1, 2], [1, 0, 3], [0, 1, 4]])
    surface = build_surface(mesh)
    assert surface.is_degenerate.tolist() == [False, False, True]
    assert not surface.edges.is_crease.any()
    assert surface.sector_count == 5


def test_every_edge_of_a_cube_is_a_crease_but_those_within_its_sides() -> None:
    edges = build_surface(mesh_from_polygons(*cube(3))).edges
    # 12 edges of 3 pieces are folded; each of 6 sides has 2 · 3 · 2 inner edges.
    assert edges.is_crease.sum() == 36
    assert len(edges.smooth) == 72
    assert len(edges.rim) == 0


def test_inner_edges_name_half_edges_in_opposite_directions() -> None:
    mesh = mesh_from_polygons(*cube(2))
    pairs = build_surface(mesh).edges.inner
    start, end = mesh.corner_vertex[pairs], mesh.corner_vertex[mesh.next_corner[pairs]]
    assert np.array_equal(start, end[:, ::-1])
