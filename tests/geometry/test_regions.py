# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Regions are connected areas of one class that no crease runs through."""

from __future__ import annotations

import numpy as np
import pytest
from architectural_curvature.addon.geometry.absorption import absorb_small_regions
from architectural_curvature.addon.geometry.mesh import mesh_from_polygons
from architectural_curvature.addon.geometry.regions import (
    connect_regions,
)
from architectural_curvature.addon.geometry.surface import Surface, build_surface
from numpy.typing import NDArray
from solids import cube, grid

FLAT, SINGLE, DOME, SADDLE = range(4)
UNDEFINED = -1


def _plate(rows: list[str], **marks: object) -> tuple[Surface, NDArray[np.int64]]:
    """A plate of unit squares with classes as drawn, the first row at the far side."""
    width, depth = len(rows[0]), len(rows)
    vertices, faces = grid(lambda u, v: (width * u, depth * v, 0.0), (width, depth))
    letters = {".": FLAT, "s": SINGLE, "d": DOME, "h": SADDLE, "?": UNDEFINED}
    classes = [letters[rows[depth - 1 - j][i]] for i in range(width) for j in range(depth)]
    surface = build_surface(mesh_from_polygons(vertices, faces, **marks))  # pyright: ignore[reportArgumentType]
    return surface, np.array(classes)


def _drawn(classes: NDArray[np.int64], width: int) -> list[str]:
    columns = classes.reshape(width, -1)
    return [
        "".join("?.sdh"[c + 1] for c in columns[:, j]) for j in reversed(range(columns.shape[1]))
    ]


def test_regions_are_numbered_by_falling_area() -> None:
    surface, classes = _plate(["..sss", "d.sss", "d.sss"])
    regions = connect_regions(surface, classes)
    assert regions.count == 3
    assert regions.region_class.tolist() == [SINGLE, FLAT, DOME]
    np.testing.assert_allclose(regions.area, [9.0, 4.0, 2.0], rtol=1e-14)
    assert regions.face_count.tolist() == [9, 4, 2]
    for number, surface_class in enumerate(regions.region_class):
        assert (classes[regions.face_region == number] == surface_class).all()


def test_the_length_of_a_boundary_is_that_of_its_outline() -> None:
    surface, classes = _plate(["ssss", "s..s", "s..s", "ssss"])
    regions = connect_regions(surface, classes)
    # The ring has the outer outline of 16 and the inner one of 8.
    assert regions.region_class.tolist() == [SINGLE, FLAT]
    np.testing.assert_allclose(regions.boundary_length, [24.0, 8.0], rtol=1e-14)


def test_faces_that_touch_in_a_point_are_not_connected() -> None:
    surface, classes = _plate([".s", "s."])
    assert connect_regions(surface, classes).count == 4


def test_equal_areas_keep_the_order_of_their_first_face() -> None:
    surface, classes = _plate([".s.s.s"])
    assert connect_regions(surface, classes).face_region.tolist() == [0, 1, 2, 3, 4, 5]


def test_undefined_faces_have_no_region() -> None:
    surface, classes = _plate([".?s", ".?s"])
    regions = connect_regions(surface, classes)
    assert regions.count == 2
    assert (regions.face_region[classes == UNDEFINED] == -1).all()


def test_where_all_is_undefined_there_are_no_regions() -> None:
    surface, classes = _plate(["??"])
    regions = connect_regions(surface, classes)
    assert regions.count == 0
    assert len(regions.boundary_length) == 0


def test_every_side_of_a_cube_is_a_region() -> None:
    surface = build_surface(mesh_from_polygons(*cube(3)))
    regions = connect_regions(surface, np.zeros(54, dtype=np.int64))
    assert regions.count == 6
    np.testing.assert_allclose(regions.area, 1.0, rtol=1e-14)
    np.testing.assert_allclose(regions.boundary_length, 4.0, rtol=1e-14)


def test_no_region_crosses_a_crease_however_flat() -> None:
    # The crease runs along x = 2 of a plate of 4 × 2.
    surface, classes = _plate(["....", "...."], sharp_edges=[(6, 7), (7, 8)])
    regions = connect_regions(surface, classes)
    assert regions.face_region.tolist() == [0, 0, 0, 0, 1, 1, 1, 1]
    np.testing.assert_allclose(regions.boundary_length, 8.0, rtol=1e-14)


def test_a_crease_within_a_region_does_not_lengthen_its_outline() -> None:
    # One marked edge in the middle: faces on both sides stay connected around its ends.
    surface, classes = _plate(["...", "...", "..."], sharp_edges=[(5, 6)])
    regions = connect_regions(surface, classes)
    assert regions.count == 1
    assert regions.boundary_length[0] == pytest.approx(12.0, rel=1e-14)


def test_numbering_does_not_depend_on_the_order_of_faces() -> None:
    vertices, faces = grid(lambda u, v: (6.0 * u, 5.0 * v, 0.0), (6, 5))
    classes = np.random.default_rng(5).integers(0, 2, len(faces))
    order = np.random.default_rng(6).permutation(len(faces))
    plain = connect_regions(build_surface(mesh_from_polygons(vertices, faces)), classes)
    mixed = connect_regions(
        build_surface(mesh_from_polygons(vertices, [faces[k] for k in order])), classes[order]
    )
    np.testing.assert_allclose(mixed.area, plain.area, rtol=1e-12)
    # Areas that occur once must have the same number; others may swap with their equals.
    single = [i for i, area in enumerate(plain.area) if np.isclose(plain.area, area).sum() == 1]
    assert single
    for number in single:
        assert np.array_equal(mixed.face_region == number, (plain.face_region == number)[order])


def test_without_a_least_area_nothing_is_absorbed() -> None:
    surface, classes = _plate(["..s", "d.."])
    assert np.array_equal(absorb_small_regions(surface, classes, 0.0), classes)


def test_specks_take_the_class_around_them() -> None:
    surface, classes = _plate([".....", ".s.d.", "....."])
    assert _drawn(absorb_small_regions(surface, classes, 1.5), 5) == ["....."] * 3


def test_regions_of_the_least_area_stay() -> None:
    surface, classes = _plate([".....", ".ss..", "....."])
    assert np.array_equal(absorb_small_regions(surface, classes, 2.0), classes)
    assert not absorb_small_regions(surface, classes, 2.1).any()


def test_the_longest_shared_border_decides() -> None:
    surface, classes = _plate(["....", ".d.s", "ssss"])
    assert _drawn(absorb_small_regions(surface, classes, 1.5), 4) == ["....", "...s", "ssss"]


def test_of_equally_long_borders_the_larger_region_wins() -> None:
    surface, classes = _plate(["....", ".dss", "ssss"])
    assert _drawn(absorb_small_regions(surface, classes, 1.5), 4) == ["....", ".sss", "ssss"]


def test_the_smallest_is_absorbed_first() -> None:
    # The dome joins the saddles, which are then large enough to stay.
    surface, classes = _plate(["dhh....."])
    assert _drawn(absorb_small_regions(surface, classes, 2.5), 8) == ["hhh....."]


def test_nothing_is_absorbed_across_a_crease() -> None:
    surface, classes = _plate([".s", ".s"], sharp_edges=[(3, 4), (4, 5)])
    assert np.array_equal(absorb_small_regions(surface, classes, 100.0), classes)


def test_undefined_faces_neither_absorb_nor_are_absorbed() -> None:
    surface, classes = _plate(["?s?", "???", "..?"])
    assert np.array_equal(absorb_small_regions(surface, classes, 10.0), classes)


def test_absorbing_does_not_change_its_input() -> None:
    surface, classes = _plate(["...", ".s."])
    before = classes.copy()
    absorb_small_regions(surface, classes, 5.0)
    assert np.array_equal(classes, before)
