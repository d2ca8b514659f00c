# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh is read as the user sees it: its polygons, in meters, around their middle."""

from __future__ import annotations

from itertools import pairwise

import bpy
import numpy as np
import pytest
from architectural_curvature.addon.bridge.mesh import read_polygon_mesh
from architectural_curvature.addon.geometry.errors import InvalidMeshError
from architectural_curvature.addon.geometry.mesh import PolygonMesh
from bpy.types import Object
from models import add_mesh, add_surface, dome

UNIT = np.eye(3)

# An L of three unit squares in one face: its area is 3, that of its hull 3.5.
L_SHAPE = [(0, 0, 0), (2, 0, 0), (2, 1, 0), (1, 1, 0), (1, 2, 0), (0, 2, 0)]


def _read(obj: Object) -> PolygonMesh:
    return read_polygon_mesh(obj.data, UNIT)


def _triangle_area(mesh: PolygonMesh) -> float:
    a, b, c = np.moveaxis(mesh.vertices[mesh.corner_vertex[mesh.triangle_corner]], 1, 0)
    return float(0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1).sum())


def test_polygons_of_every_size_keep_their_corners_in_order() -> None:
    faces = [(0, 1, 2), (0, 2, 3, 4), (0, 4, 5, 6, 7)]
    angle = np.arange(7) * 2.0 * np.pi / 7
    vertices = np.column_stack([np.cos(angle), np.sin(angle), np.zeros(7)])
    mesh = _read(add_mesh("Fan", np.vstack([[0, 0, 0], vertices]), faces))
    starts = mesh.polygon_start
    read = [tuple(mesh.corner_vertex[a:b]) for a, b in pairwise(starts)]
    assert read == faces


@pytest.mark.parametrize("size", [3, 4, 5, 8, 17])
def test_polygon_of_n_corners_has_n_minus_2_triangles(size: int) -> None:
    angle = np.arange(size) * 2.0 * np.pi / size
    corners = np.column_stack([np.cos(angle), np.sin(angle), np.zeros(size)])
    mesh = _read(add_mesh("Polygon", corners, [range(size)]))
    assert len(mesh.triangle_corner) == size - 2
    assert _triangle_area(mesh) == pytest.approx(0.5 * size * np.sin(2.0 * np.pi / size))


def test_concave_polygon_is_not_filled() -> None:
    mesh = _read(add_mesh("L", L_SHAPE, [range(6)]))
    assert mesh.polygon_count == 1
    assert _triangle_area(mesh) == pytest.approx(3.0)


def test_lengths_are_multiplied_by_the_given_matrix() -> None:
    obj = add_mesh("L", L_SHAPE, [range(6)])
    mesh = read_polygon_mesh(obj.data, np.diag([2.0, 3.0, 1.0]))
    assert _triangle_area(mesh) == pytest.approx(3.0 * 2.0 * 3.0)


def test_positions_are_centered() -> None:
    vertices = np.array(L_SHAPE, dtype=float) + [1000.0, -500.0, 250.0]
    mesh = _read(add_mesh("Far", vertices, [range(6)]))
    assert mesh.vertices.min(axis=0) == pytest.approx([-1.0, -1.0, 0.0])
    assert mesh.vertices.max(axis=0) == pytest.approx([1.0, 1.0, 0.0])


def test_marked_edges_are_read() -> None:
    obj = add_surface(dome, steps=2)
    obj.data.edges[3].use_edge_sharp = True
    assert np.flatnonzero(_read(obj).edge_is_sharp).tolist() == [3]


def test_mesh_is_not_changed_by_reading() -> None:
    obj = add_surface(dome)
    before = [tuple(vertex.co) for vertex in obj.data.vertices]
    names = obj.data.attributes.keys()
    _read(obj)
    assert [tuple(vertex.co) for vertex in obj.data.vertices] == before
    assert obj.data.attributes.keys() == names


def test_empty_mesh_is_refused_in_words() -> None:
    with pytest.raises(InvalidMeshError, match="the mesh is empty"):
        read_polygon_mesh(bpy.data.meshes.new("Empty"), UNIT)


def test_mesh_of_lone_vertices_is_refused_in_words() -> None:
    with pytest.raises(InvalidMeshError, match="the mesh has no faces"):
        _read(add_mesh("Points", [(0, 0, 0), (1, 0, 0)], []))
