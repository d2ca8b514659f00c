# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What stays, what joins a neighbor, and how surfaces continue beyond their border."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from architectural_curvature.addon.geometry.cleaning.continuation import continue_surface
from architectural_curvature.addon.geometry.cleaning.sizes import default_min_area
from architectural_curvature.addon.geometry.criterion import panel_criterion
from architectural_curvature.addon.geometry.curvature import Curvature, estimate_curvature
from architectural_curvature.addon.geometry.mesh import mesh_from_polygons
from architectural_curvature.addon.geometry.outlines.borders import trace_borders
from architectural_curvature.addon.geometry.segmentation import Segmentation, segment
from architectural_curvature.addon.geometry.surface import Surface, build_surface
from architectural_curvature.addon.geometry.tolerance import Tolerance
from composites.profiles import profile_points
from numpy.typing import NDArray
from solids import grid

#: Panels of 2 m; the limit is 0.02/m.
TOLERANCE = Tolerance(2.0, 0.01)
#: A plate of 24 × 4 squares of a meter.
PLATE = build_surface(mesh_from_polygons(*grid(lambda u, v: (24 * u, 4 * v, 0.0), (24, 4))))
COLUMN = np.arange(96) // 4


#: Two plates of 4 m and a fillet of a meter between them, 4 m deep, in cells of a quarter.
PROFILE = [(4.0, 0.0), (1.0, 1.5), (4.0, 0.0)]


@cache
def _folded() -> tuple[Surface, Curvature]:
    across, up = profile_points(PROFILE, np.linspace(0.0, 9.0, 37))[0].T
    vertices, polygons = grid(
        lambda u, v: (across[round(36 * u)], 4.0 * v, up[round(36 * u)]), (36, 16)
    )
    surface = build_surface(mesh_from_polygons(vertices, polygons))
    return surface, estimate_curvature(surface)


def _segmented(min_area: float = 0.0) -> Segmentation:
    return segment(*_folded(), TOLERANCE, min_area)


def test_a_panel_is_the_least_area_but_no_more_than_a_share_of_the_model() -> None:
    assert default_min_area(PLATE, panel_criterion(Tolerance(0.5, 0.01))) == 0.25
    assert default_min_area(PLATE, panel_criterion(TOLERANCE)) == pytest.approx(0.48)


def test_a_fillet_stays_though_it_is_narrower_than_a_panel() -> None:
    regions = _segmented().regions
    assert regions.region_class.tolist() == [0, 0, 1]
    assert regions.area[2] == pytest.approx(4.0, rel=0.01)


def test_a_least_area_that_is_asked_for_spares_nothing() -> None:
    plain = _segmented().regions
    (area,) = plain.area[plain.region_class == 1]
    assert 1 in _segmented(min_area=0.99 * area).regions.region_class
    assert _segmented(min_area=1.01 * area).regions.region_class.tolist() == [0]


@pytest.mark.parametrize(("bend_x", "bend_y"), [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0)])
def test_planes_cylinders_and_spheres_continue_exactly(bend_x: float, bend_y: float) -> None:
    rng = np.random.default_rng(0)
    x, y = rng.uniform([[0.1], [-0.25]], [[0.5], [0.25]], (20, 2, 48)).transpose(1, 2, 0)

    def height(x: NDArray[np.float64], y: NDArray[np.float64]) -> NDArray[np.float64]:
        square = bend_x * x**2 + bend_y * y**2
        return square / (1.0 + np.sqrt(1.0 - square))

    # In a frame that looks along the normal in the middle of the points.
    slope = bend_x * 0.3 / np.sqrt(1.0 - bend_x * 0.09)
    turn = np.array([[1.0, slope], [-slope, 1.0]]) / np.hypot(1.0, slope)
    local_x, local_z = np.einsum("ij,jpc->ipc", turn, np.stack([x, height(x, y)]))
    fit = continue_surface((local_x, y, local_z), x > 0.0, 1e-6)
    assert fit.is_sound.all()
    # Of a circle, what is left are terms of degree 6: k⁵ x⁶ / 16.
    assert np.abs(fit.height).max() < 0.5**6 / 16.0
    assert np.abs(fit.height).max() < 0.1 * 0.5 * 0.1**2 or bend_x == 0.0


def test_the_border_of_two_halves_is_one_straight_curve_with_its_length() -> None:
    curves = trace_borders(PLATE, (COLUMN >= 12).astype(np.int64))
    assert curves.regions.tolist() == [[0, 1]]
    assert curves.curves.is_closed.tolist() == [False]
    assert curves.curves.lengths == pytest.approx([4.0], rel=1e-12)


def test_a_zigzag_border_is_straightened_within_the_tolerance() -> None:
    row = np.arange(96) % 4
    zigzag = trace_borders(PLATE, (12 + row % 2 <= COLUMN).astype(np.int64)).curves
    smooth = trace_borders(PLATE, (12 + row % 2 <= COLUMN).astype(np.int64), tolerance=0.5).curves
    assert zigzag.lengths == pytest.approx([7.0], rel=1e-12)
    assert smooth.lengths[0] < 5.0
    assert np.linalg.norm(smooth.points - zigzag.points, axis=1).max() <= 0.5 + 1e-12
