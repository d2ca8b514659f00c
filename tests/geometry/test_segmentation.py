# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures per class and region agree with the formulas of solids."""

from __future__ import annotations

import numpy as np
import pytest
from architectural_curvature.addon.geometry.classification import SurfaceClass
from architectural_curvature.addon.geometry.curvature import Curvature, estimate_curvature
from architectural_curvature.addon.geometry.mesh import mesh_from_polygons
from architectural_curvature.addon.geometry.segmentation import Segmentation, segment
from architectural_curvature.addon.geometry.surface import Surface, build_surface
from architectural_curvature.addon.geometry.tolerance import Tolerance
from curvatures import given_curvature
from solids import capped_cylinder, cube, grid, pointed_vault

#: The limit is 0.08/m, a radius of 12.5 m.
STRICT = Tolerance(1.0, 0.01)


def _segmented(vertices: object, faces: object, tolerance: Tolerance = STRICT) -> Segmentation:
    surface = build_surface(mesh_from_polygons(vertices, faces))  # pyright: ignore[reportArgumentType]
    return segment(surface, estimate_curvature(surface), tolerance)


def _given(k1: list[float], *, defined: bool = True) -> tuple[Surface, Curvature]:
    """A strip of unit squares, one per value, each cut off from the next by creases."""
    vertices, faces = grid(lambda u, v: (len(k1) * u, v, 0.0), (len(k1), 1))
    cuts = [(2 * i, 2 * i + 1) for i in range(1, len(k1))]
    surface = build_surface(mesh_from_polygons(vertices, faces, sharp_edges=cuts))
    return surface, given_curvature(surface, k1, k1, is_defined=defined)


def test_a_cube_is_flat_in_six_regions() -> None:
    result = _segmented(*cube(3))
    flat = result.classes[SurfaceClass.FLAT]
    assert (flat.faces, flat.regions, flat.min_radius) == (54, 6, None)
    assert flat.share == pytest.approx(1.0, rel=1e-14)
    assert flat.area == pytest.approx(6.0, rel=1e-14)
    assert result.region_min_radius == (None,) * 6


def test_a_closed_cylinder_has_a_single_curved_wall_and_flat_caps() -> None:
    radius, height, around = 2.0, 3.0, 48
    result = _segmented(*capped_cylinder(radius, height, around, 12))
    chord = 2.0 * radius * np.sin(np.pi / around)
    wall = result.classes[SurfaceClass.SINGLE]
    assert (wall.faces, wall.regions) == (12 * around, 1)
    assert wall.area == pytest.approx(around * chord * height, rel=1e-12)
    caps = result.classes[SurfaceClass.FLAT]
    assert caps.regions == 2
    polygon = 0.5 * around * radius**2 * np.sin(2.0 * np.pi / around)
    assert caps.area == pytest.approx(2.0 * polygon, rel=1e-12)
    outline = around * chord
    np.testing.assert_allclose(
        result.regions.boundary_length, [2.0 * outline, outline, outline], rtol=1e-12
    )
    # The fit's circle passes inside by a share k² r² / 4 of the radius, with r two cells.
    reach = 2.0 * np.hypot(chord, 0.25)
    assert wall.min_radius == pytest.approx(radius, rel=reach**2 / radius**2 / 4.0)


def test_a_pointed_vault_is_single_curved_in_two_regions() -> None:
    vertices, faces = pointed_vault(12)
    result = _segmented(vertices, faces)
    single = result.classes[SurfaceClass.SINGLE]
    assert (single.faces, single.regions) == (len(faces), 2)
    side = [vertices[face, 0].mean() > 0.0 for face in faces]
    assert len(set(result.regions.face_region[side])) == 1


def test_a_loose_tolerance_makes_everything_flat() -> None:
    result = _segmented(*pointed_vault(12), Tolerance(1.0, 1.0))
    assert result.classes[SurfaceClass.FLAT].share == pytest.approx(1.0, rel=1e-14)


def test_shares_add_up_and_every_face_is_counted_once() -> None:
    result = _segmented(*capped_cylinder(1.0, 1.0, 24, 6))
    measures = result.classes.values()
    assert set(result.classes) == set(SurfaceClass)
    assert sum(m.share for m in measures) == pytest.approx(1.0, rel=1e-14)
    assert sum(m.faces for m in measures) == len(result.face_class)
    assert sum(m.regions for m in measures) == result.regions.count
    assert sum(m.area for m in measures) == pytest.approx(result.regions.area.sum(), rel=1e-14)


def test_every_region_has_its_own_smallest_radius() -> None:
    surface, curvature = _given([0.5, 0.25, 0.0])
    result = segment(surface, curvature, STRICT)
    assert result.face_class.tolist() == [2, 2, 0]
    assert result.region_min_radius == (2.0, 4.0, None)
    assert result.classes[SurfaceClass.ELLIPTIC].min_radius == pytest.approx(2.0, rel=1e-12)
    assert result.classes[SurfaceClass.FLAT].min_radius is None


def test_where_nothing_is_defined_nothing_is_invented() -> None:
    surface, curvature = _given([0.5, 0.25], defined=False)
    result = segment(surface, curvature, STRICT)
    undefined = result.classes[SurfaceClass.UNDEFINED]
    assert (undefined.faces, undefined.regions, undefined.min_radius) == (2, 0, None)
    assert undefined.share == 1.0
    assert result.regions.count == 0
    assert result.region_min_radius == ()


def test_small_regions_join_their_neighbors_on_request() -> None:
    vertices, faces = grid(lambda u, v: (6.0 * u, v, 0.0), (6, 1))
    surface = build_surface(mesh_from_polygons(vertices, faces))
    curvature = given_curvature(surface, [0.0, 0.0, 0.0, 0.0, 1.0, 1.0], 0.0)
    kept = segment(surface, curvature, STRICT)
    assert kept.face_class.tolist() == [0, 0, 0, 0, 1, 1]
    absorbed = segment(surface, curvature, STRICT, min_area=3.0)
    assert absorbed.face_class.tolist() == [0] * 6
    assert absorbed.regions.count == 1


def test_the_tolerance_is_kept_with_its_result() -> None:
    assert _segmented(*cube(1)).tolerance is STRICT
