# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Curvature on whatever a designer models: pieces, folds and defects."""

from __future__ import annotations

import numpy as np
import pytest
from architectural_curvature.addon.geometry.curvature import Curvature, estimate_curvature
from architectural_curvature.addon.geometry.mesh import mesh_from_polygons
from architectural_curvature.addon.geometry.planar import planar_polygons
from architectural_curvature.addon.geometry.surface import Surface, build_surface
from solids import capped_cylinder, cube, grid, joined, pointed_vault
from surfaces.catalogue import PATCHES
from surfaces.sampling import KINDS, sample_patch
from surfaces.spheres import sample_ellipsoid

SQUARE = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])


def _measure(vertices: object, faces: object, **marks: object) -> tuple[Surface, Curvature]:
    surface = build_surface(mesh_from_polygons(vertices, faces, **marks))  # pyright: ignore[reportArgumentType]
    return surface, estimate_curvature(surface)


def _assert_flat(curvature: Curvature) -> None:
    assert curvature.is_defined.all()
    for values in (curvature.k1, curvature.k2, curvature.direction_1, curvature.direction_2):
        assert not values.any()


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("name", ["waves", "torus", "cone", "monkey saddle"])
def test_directions_are_unit_orthogonal_and_tangent_or_zero(name: str, kind: str) -> None:
    sample = sample_patch(PATCHES[name], kind, (20, 12))
    surface, curvature = _measure(sample.shape.position, sample.polygons)
    one, other = curvature.direction_1, curvature.direction_2
    lengths = np.linalg.norm(one, axis=1)
    is_zero = lengths == 0.0
    assert np.array_equal(is_zero, np.linalg.norm(other, axis=1) == 0.0)
    np.testing.assert_allclose(lengths[~is_zero], 1.0, rtol=1e-12)
    np.testing.assert_allclose(np.linalg.norm(other[~is_zero], axis=1), 1.0, rtol=1e-12)
    np.testing.assert_allclose(np.einsum("ij,ij->i", one, other), 0.0, atol=1e-12)
    # Normals of faces around a vertex lie within the turn of the normal over two cells.
    size = np.maximum(np.abs(sample.shape.k1), np.abs(sample.shape.k2)).max()
    normal = sample.shape.normal[surface.sector_vertex]
    tilt = np.abs(np.einsum("ij,ij->i", np.cross(one, other), normal))[~is_zero]
    assert (tilt >= np.cos(min(2.0 * size * sample.longest_edge, 0.5 * np.pi))).all()


def test_nothing_stored_is_nan_whatever_the_mesh() -> None:
    for vertices, faces in (cube(1), capped_cylinder(1.0, 2.0, 12, 3), pointed_vault(2)):
        _, curvature = _measure(vertices, faces)
        for values in (curvature.k1, curvature.k2, curvature.direction_1, curvature.direction_2):
            assert np.isfinite(values).all()


@pytest.mark.parametrize("count", [1, 2, 5])
def test_all_six_sides_of_a_cube_are_flat(count: int) -> None:
    surface, curvature = _measure(*cube(count))
    _assert_flat(curvature)
    assert planar_polygons(surface).all()


def test_a_flat_piece_is_flat_up_to_the_rounding_of_its_coordinates() -> None:
    # Single precision at a distance of 1000 m rounds to 6e-5 m.
    vertices, faces = grid(lambda u, v: (u, v, 0.3 * u - 0.7 * v), (6, 6))
    rounded = (vertices + 1000.0).astype(np.float32).astype(np.float64)
    _assert_flat(_measure(rounded, faces, resolution=6e-5)[1])


def test_a_folded_plate_is_flat_on_both_sides() -> None:
    right = grid(lambda u, v: (u, v, -u), (5, 5))
    left = grid(lambda u, v: (u - 1.0, v, u - 1.0), (5, 5))
    surface, curvature = _measure(*joined(right, left))
    assert surface.has_creases
    _assert_flat(curvature)


def test_a_single_triangle_is_flat() -> None:
    _assert_flat(_measure(SQUARE, [[0, 1, 2]])[1])


def test_a_single_quad_that_is_not_planar_is_not_invented() -> None:
    _, curvature = _measure(SQUARE + [[0, 0, 0], [0, 0, 0], [0, 0, 0.5], [0, 0, 0]], [[0, 1, 2, 3]])
    assert not curvature.k1[~curvature.is_defined].any()
    assert np.isfinite(curvature.k1).all()


def test_a_face_without_area_is_undefined_on_its_own() -> None:
    vertices = np.array([[0.0, 0, 0], [1, 0, 0], [2, 0, 0]])
    surface, curvature = _measure(vertices, [[0, 1, 2]])
    assert surface.is_degenerate.all()
    assert not curvature.is_defined.any()
    assert not curvature.k1.any()


def test_faces_without_area_do_not_spoil_their_neighbors() -> None:
    sample = sample_patch(PATCHES["waves"], "regular", (20, 20))
    position, triangles = sample.shape.position, sample.polygons
    plain_surface, plain = _measure(position, triangles)
    # A needle that fills a slit: its third corner lies on the side of a triangle.
    a, b = position[triangles[300, :2]]
    vertices = np.concatenate([position, [0.5 * (a + b)]])
    needle = [int(triangles[300, 1]), int(triangles[300, 0]), len(position)]
    surface, spoiled = _measure(vertices, [*triangles.tolist(), needle])
    assert surface.is_degenerate.sum() == 1
    assert np.isfinite(spoiled.k1).all()
    # Beyond the fit's two rings around the needle nothing changes.
    is_far = np.linalg.norm(position - a, axis=1) > 3.0 * sample.longest_edge
    near, far = plain_surface.vertex_sector[is_far], surface.vertex_sector[:-1][is_far]
    assert spoiled.is_defined[far].all()
    np.testing.assert_allclose(spoiled.k1[far], plain.k1[near], rtol=0.0, atol=1e-9)


def test_duplicate_faces_give_finite_values() -> None:
    sample = sample_ellipsoid((1.0, 1.0, 1.0), "geodesic", 5)
    twice = np.concatenate([sample.polygons, sample.polygons[:7]])
    surface, curvature = _measure(sample.shape.position, twice)
    assert surface.edges.nonmanifold_count + surface.edges.flipped_count > 0
    assert np.isfinite(curvature.k1).all()
    assert curvature.is_defined.sum() >= len(sample.shape.position) - 3 * 7


def test_nothing_bleeds_across_the_ridge_of_a_pointed_vault() -> None:
    # Either side alone is the same cylinder, so cutting along the ridge must change nothing.
    vertices, faces = pointed_vault(12)
    surface, curvature = _measure(vertices, faces)
    right = [face for face in faces if vertices[face, 0].mean() > 0.0]
    alone_surface, alone = _measure(vertices, right)
    used = np.isin(surface.sector_vertex, alone_surface.sector_vertex)
    of_right = np.zeros(surface.sector_count, dtype=bool)
    right_corners = np.repeat([vertices[face, 0].mean() > 0.0 for face in faces], 4)
    of_right[surface.corner_sector[right_corners]] = True
    assert (used & of_right).sum() == alone_surface.sector_count
    np.testing.assert_allclose(curvature.k1[of_right], alone.k1, rtol=1e-9)
    np.testing.assert_allclose(curvature.k2[of_right], alone.k2, atol=1e-9)


def test_the_ridge_of_a_pointed_vault_has_a_value_on_either_side() -> None:
    vertices, faces = pointed_vault(12)
    surface, curvature = _measure(vertices, faces)
    ridge = np.abs(vertices[surface.sector_vertex, 0]) < 1e-9
    assert ridge.sum() == 2 * (2 * 12 + 1)
    # k1 = 1/2; a fit over two steps of 2 · 5° exceeds it by k³ r² / 4, see test_accuracy.
    reach = 2.0 * np.hypot(2.0 * np.pi / 36.0, 3.0 / 24.0)
    np.testing.assert_allclose(curvature.k1[ridge], 0.5, atol=0.5**3 * reach**2 / 4.0)


def test_the_caps_of_a_cylinder_are_flat_and_its_wall_is_round() -> None:
    vertices, faces = capped_cylinder(2.0, 3.0, 48, 12)
    surface, curvature = _measure(vertices, faces)
    heights = [np.ptp(vertices[face, 2]) for face in faces]
    cap_corner = np.repeat(np.array(heights) == 0.0, [len(face) for face in faces])
    cap = np.zeros(surface.sector_count, dtype=bool)
    cap[surface.corner_sector[cap_corner]] = True
    assert not curvature.k1[cap].any()
    assert not curvature.k2[cap].any()
    reach = 2.0 * np.hypot(4.0 * np.sin(np.pi / 48.0), 0.25)
    slack = 0.5**3 * reach**2 / 4.0
    np.testing.assert_allclose(curvature.k1[~cap], 0.5, atol=slack)
    np.testing.assert_allclose(curvature.k2[~cap], 0.0, atol=slack)


def test_flipping_swaps_the_principal_curvatures_and_their_directions() -> None:
    sample = sample_patch(PATCHES["waves"], "regular", (10, 10))
    _, curvature = _measure(sample.shape.position, sample.polygons)
    over = curvature.flipped()
    assert np.array_equal(over.k1, -curvature.k2)
    assert np.array_equal(over.k2, -curvature.k1)
    assert np.array_equal(over.direction_1, curvature.direction_2)
    assert np.array_equal(over.gaussian, curvature.gaussian)
    assert np.array_equal(over.mean, -curvature.mean)
    assert np.array_equal(over.flipped().k1, curvature.k1)


def test_a_sphere_has_no_directions_where_its_curvatures_agree() -> None:
    sample = sample_ellipsoid((1.0, 1.0, 1.0), "geodesic", 1)
    _, curvature = _measure(sample.shape.position, sample.polygons)
    # An icosahedron looks alike from all its vertices, in five directions.
    is_umbilic = curvature.k1 - curvature.k2 <= 1e-6 * np.abs(curvature.k1)
    assert np.array_equal(is_umbilic, ~curvature.direction_1.any(axis=1))


def test_progress_is_reported_in_order() -> None:
    surface, _ = _measure(*cube(3))
    shares: list[float] = []
    estimate_curvature(surface, on_progress=shares.append)
    assert shares == sorted(shares)
    assert all(0.0 <= share <= 1.0 for share in shares)
    assert shares


def test_stopping_through_progress_stops() -> None:
    surface, _ = _measure(*cube(3))

    def stop(_share: float) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        estimate_curvature(surface, on_progress=stop)
