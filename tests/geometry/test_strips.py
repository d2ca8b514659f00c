# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Flat strips, as CAD programs tessellate cylinders and cones, bend as their circle."""

from __future__ import annotations

import numpy as np
import pytest
from architectural_curvature.addon.geometry.curvature import Curvature, estimate_curvature
from architectural_curvature.addon.geometry.mesh import mesh_from_polygons
from architectural_curvature.addon.geometry.statistics import smallest_radius
from architectural_curvature.addon.geometry.surface import Surface, build_surface
from numpy.typing import NDArray
from solids import grid

Array = NDArray[np.float64]


def _measure(vertices: object, faces: object, resolution: float = 0.0) -> tuple[Surface, Curvature]:
    mesh = mesh_from_polygons(vertices, faces, resolution=resolution)  # pyright: ignore[reportArgumentType]
    surface = build_surface(mesh)
    return surface, estimate_curvature(surface)


def _tube(turn: Array, heights: Array, radius: float) -> tuple[Array, list[list[int]]]:
    """Quads of a closed cylinder with corners at chosen angles and heights."""
    count = len(turn)
    rings = [
        np.stack([radius * np.cos(turn), radius * np.sin(turn), np.full(count, z)], axis=1)
        for z in heights
    ]
    faces = [
        [
            r * count + i,
            r * count + (i + 1) % count,
            (r + 1) * count + (i + 1) % count,
            r * count + count + i,
        ]
        for r in range(len(heights) - 1)
        for i in range(count)
    ]
    return np.concatenate(rings), faces


@pytest.mark.parametrize("count", [13, 24, 64])
@pytest.mark.parametrize("radius", [0.03, 1.0, 40.0])
def test_a_cylinder_one_quad_high_has_the_curvature_of_its_circle(
    count: int, radius: float
) -> None:
    turn = np.arange(count) * 2.0 * np.pi / count
    _, curvature = _measure(*_tube(turn, radius * np.array([0.0, 3.0]), radius))
    np.testing.assert_allclose(curvature.k1, 1.0 / radius, rtol=1e-9)
    np.testing.assert_allclose(curvature.k2, 0.0, atol=1e-9 / radius)
    np.testing.assert_allclose(np.abs(curvature.direction_2[:, 2]), 1.0, rtol=1e-9)
    # A chord's faces turn around the axis as the circle does.
    np.testing.assert_allclose(curvature.face_k1, 1.0 / radius, rtol=1e-6)


def test_strips_of_uneven_width_lie_on_the_same_circle() -> None:
    turn = np.cumsum(np.resize([0.1, 0.3, 0.2, 0.25], 28))
    turn *= 2.0 * np.pi / turn[-1]
    _, curvature = _measure(*_tube(turn, np.array([0.0, 3.0]), 1.0))
    np.testing.assert_allclose(curvature.k1, 1.0, rtol=1e-9)


def test_seen_from_inside_strips_bend_the_other_way() -> None:
    vertices, faces = _tube(np.arange(24) * np.pi / 12.0, np.array([0.0, 3.0]), 1.0)
    _, curvature = _measure(vertices, [face[::-1] for face in faces])
    np.testing.assert_allclose(curvature.k2, -1.0, rtol=1e-9)
    np.testing.assert_allclose(curvature.k1, 0.0, atol=1e-9)


def test_strips_survive_the_rounding_of_their_coordinates() -> None:
    vertices, faces = _tube(np.arange(48) * np.pi / 24.0, np.array([0.0, 3.0]), 1.0)
    rounded = vertices.astype(np.float32).astype(np.float64)
    step = float(np.spacing(np.float32(3.0)))
    _, curvature = _measure(rounded, faces, step)
    # A fold of b between strips of width w has k = b / w; rounding tilts a strip by 2 steps / w.
    width = 2.0 * np.sin(np.pi / 48.0)
    np.testing.assert_allclose(curvature.k1, 1.0, atol=4.0 * step / width**2)


@pytest.mark.parametrize("count", [32, 64])
def test_a_cone_of_triangles_bends_as_its_base(count: int) -> None:
    turn = np.arange(count) * 2.0 * np.pi / count
    rim = np.stack([np.cos(turn), np.sin(turn), 0.0 * turn], axis=1)
    faces = [[count, i, (i + 1) % count] for i in range(count)]
    surface, curvature = _measure(np.concatenate([rim, [[0.0, 0.0, 1.5]]]), faces)
    exact = 1.5 / np.hypot(1.0, 1.5)
    base = surface.sector_vertex < count
    # The section across a ruling is an ellipse, not a circle: second order in the strip's width.
    np.testing.assert_allclose(curvature.k1[base], exact, rtol=(np.pi / count) ** 2)
    assert curvature.is_defined.tolist() == base.tolist()


def test_a_vault_that_stands_on_its_rulings_is_round_up_to_all_its_rims() -> None:
    # A fifth of a cylinder of radius 1, cut off along and across its rulings.
    def arc(u: float, v: float) -> tuple[float, ...]:
        angle = np.radians(160.0) * (u - 0.5)
        return np.sin(angle), 2.0 * v, np.cos(angle)

    vertices, faces = grid(arc, (15, 20))
    rounded = vertices.astype(np.float32).astype(np.float64)
    surface, curvature = _measure(rounded, faces, 6e-8)
    # In the corners, where two rims meet, a fit of the circle's chords extrapolates by half a strip
    # both ways: the square of a strip's arc is what it may lose.
    np.testing.assert_allclose(curvature.face_k1, 1.0, atol=np.radians(160.0 / 15.0) ** 2)
    # Elsewhere a rim is at most half a strip away from where the fit has all it needs.
    half = 0.5 * np.radians(160.0 / 15.0)
    assert (np.abs(curvature.face_k1 - 1.0) < half**2).mean() > 0.98
    assert np.abs(curvature.face_k2).max() < 2e-3
    radius = smallest_radius(np.abs(curvature.face_k1), surface.polygon_area)
    assert radius == pytest.approx(1.0, abs=half**2)
