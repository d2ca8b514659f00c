# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Planes, spheres, cylinders, cones and tori: distances, fits and what fits leave."""

from __future__ import annotations

import numpy as np
import pytest
from architectural_curvature.addon.geometry.primitives.extents import narrowest_extent
from architectural_curvature.addon.geometry.primitives.fits import first_guesses, refine
from architectural_curvature.addon.geometry.primitives.residuals import correlates, has_shape
from architectural_curvature.addon.geometry.primitives.shapes import Kind, Primitive, frame_of
from numpy.typing import NDArray

Array = NDArray[np.float64]

ORIGIN = np.array([3.0, -2.0, 0.5])
FRAME = frame_of(np.array([0.3, -0.5, 0.8]))
SIZES: dict[Kind, tuple[float, ...]] = {
    Kind.PLANE: (),
    Kind.SPHERE: (1.5,),
    Kind.CYLINDER: (1.5,),
    Kind.CONE: (1.5, 0.4),
    Kind.TORUS: (2.0, 0.5),
}


def _sample(kind: Kind, count: int, reach: float = 1.2) -> tuple[Array, Array]:
    """Return points and normals of a patch of the surface with `SIZES`."""
    u, v = np.random.default_rng(0).uniform(-reach, reach, (2, count))
    round_u = np.stack([np.cos(u), np.sin(u), 0.0 * u], axis=1)
    up = np.array([0.0, 0.0, 1.0])
    sizes = SIZES[kind]
    if kind is Kind.PLANE:
        points, normals = np.stack([u, v, 0.0 * u], axis=1), np.broadcast_to(up, (count, 3))
    elif kind is Kind.SPHERE:
        normals = np.cos(v)[:, None] * round_u + np.sin(v)[:, None] * up
        points = sizes[0] * normals
    elif kind is Kind.CYLINDER:
        normals, points = round_u, sizes[0] * round_u + v[:, None] * up
    elif kind is Kind.CONE:
        radius, angle = sizes
        normals = np.cos(angle) * round_u - np.sin(angle) * up
        points = (radius + np.tan(angle) * v)[:, None] * round_u + v[:, None] * up
    else:
        normals = np.cos(v)[:, None] * round_u + np.sin(v)[:, None] * up
        points = sizes[0] * round_u + sizes[1] * normals
    return ORIGIN + points @ FRAME, normals @ FRAME


def _exact(kind: Kind) -> Primitive:
    return Primitive(kind, ORIGIN, FRAME, SIZES[kind])


@pytest.mark.parametrize("kind", Kind)
def test_heights_are_distances_along_the_normals(kind: Kind) -> None:
    points, normals = _sample(kind, 50)
    away = np.linspace(-0.2, 0.2, 50)
    moved = points + away[:, None] * normals
    np.testing.assert_allclose(_exact(kind).heights(moved), away, atol=1e-14)
    np.testing.assert_allclose(_exact(kind).normals(moved), normals, atol=1e-14)


@pytest.mark.parametrize("kind", Kind)
def test_derivatives_are_those_of_the_heights(kind: Kind) -> None:
    points = _sample(kind, 50)[0] + np.random.default_rng(1).normal(0.0, 0.05, (50, 3))
    exact = _exact(kind)
    _, by = exact.derivatives(points)
    assert by.shape == (50, kind.value)
    for number, step in enumerate(1e-6 * np.eye(kind.value)):
        change = exact.changed(step).heights(points) - exact.changed(-step).heights(points)
        # Central differences of 1e-6 lose ten of sixteen digits.
        np.testing.assert_allclose(change / 2e-6, by[:, number], atol=1e-8)


@pytest.mark.parametrize("kind", Kind)
def test_fits_find_the_surface_they_were_given(kind: Kind) -> None:
    points, normals = _sample(kind, 200)
    fits = [refine(guess, points, 1e-12) for guess in first_guesses(kind, points, normals)]
    best = min(fits, key=lambda fit: float(np.abs(fit.heights(points)).max()))
    assert np.abs(best.heights(points)).max() < 1e-12
    np.testing.assert_allclose(
        best.sizes[-1:],
        SIZES[kind][-1:]
        if kind is not Kind.CONE
        else (np.copysign(SIZES[kind][-1], best.sizes[-1]),),
        rtol=1e-9,
    )


@pytest.mark.parametrize("kind", Kind)
def test_fits_of_noise_err_by_less_than_the_noise_and_forget_outliers(kind: Kind) -> None:
    points, normals = _sample(kind, 400)
    rng = np.random.default_rng(2)
    scatter = 0.01
    noisy = points + (rng.normal(0.0, scatter, 400) + 0.5 * (rng.random(400) < 0.05))[:, None] * (
        normals
    )
    fits = [refine(guess, noisy, 1e-12) for guess in first_guesses(kind, noisy, normals)]
    best = min(fits, key=lambda fit: float(np.median(np.abs(fit.heights(noisy)))))
    # The variance of a fit, averaged over its points, is that of the noise times d / n.
    expected = scatter * np.sqrt(kind.value / 400)
    off = best.heights(points)
    assert np.sqrt((off * off).mean()) < 2.0 * expected


def test_the_bend_of_a_torus_is_that_of_its_pipe_and_its_ring() -> None:
    big, pipe = SIZES[Kind.TORUS]
    points, _ = _sample(Kind.TORUS, 50, reach=3.0)
    around = np.hypot(*((points - ORIGIN) @ FRAME.T)[:, :2].T)
    own, other = _exact(Kind.TORUS).bends(points)
    np.testing.assert_allclose(own, 1.0 / pipe, rtol=1e-12)
    np.testing.assert_allclose(other, (around - big) / pipe / around, rtol=1e-9, atol=1e-12)
    assert other.min() < 0.0 < other.max()


def test_the_bend_of_a_cone_falls_away_from_its_apex() -> None:
    points, _ = _sample(Kind.CONE, 50)
    around = np.hypot(*((points - ORIGIN) @ FRAME.T)[:, :2].T)
    own, other = _exact(Kind.CONE).bends(points)
    np.testing.assert_allclose(own, np.cos(SIZES[Kind.CONE][1]) / around, rtol=1e-12)
    assert not other.any()


def test_noise_has_no_shape_and_a_cubic_far_below_the_noise_has_one() -> None:
    rng = np.random.default_rng(3)
    points, _ = _sample(Kind.CYLINDER, 900)
    x = ((points - ORIGIN) @ FRAME.T)[:, 2] / 1.2
    cubic = x**3 - 0.6 * x
    alarms = 0
    for _ in range(200):
        noise = rng.normal(size=900)
        alarms += has_shape(noise, points)
        assert has_shape(noise + 0.6 * cubic / cubic.std(), points)
    # At 3.5 standard deviations chance allows three tests in two thousand to fail.
    assert alarms <= 3


def test_a_row_of_points_has_no_more_shape_than_its_points() -> None:
    rng = np.random.default_rng(4)
    x, y = (a.ravel() for a in np.meshgrid(np.arange(4.0), np.arange(30.0)))
    points = np.stack([np.cos(0.3 * x), np.sin(0.3 * x), 0.1 * y], axis=1)
    assert not has_shape(rng.normal(size=120), points)


def test_neighbors_in_noise_are_not_alike_and_on_a_slope_they_are() -> None:
    rng = np.random.default_rng(5)
    one, other = np.arange(999), np.arange(1, 1000)
    pairs = np.concatenate([one, other]), np.concatenate([other, one])
    noise = rng.normal(size=1000)
    assert not correlates(noise, pairs)
    assert correlates(noise + np.linspace(-1.0, 1.0, 1000), pairs)
    assert not correlates(np.zeros(1000), pairs)


@pytest.mark.parametrize("kind", Kind)
def test_the_narrowest_extent_is_the_width_of_the_strip(kind: Kind) -> None:
    """Strips 0.3 m wide across one side of each surface, one of which is across angle ±180°."""
    rng = np.random.default_rng(0)
    width, long = rng.uniform(-0.15, 0.15, 20_000), rng.uniform(-1.0, 1.0, 20_000)
    frame = frame_of(np.array([0.3, -0.5, 0.8]))
    sizes, local = {
        Kind.PLANE: ((), np.stack([width, long, 0 * long])),
        Kind.SPHERE: (
            (2.0,),
            2.0
            * np.stack(
                [
                    np.cos(long / 2) * np.cos(width / 2),
                    np.sin(long / 2) * np.cos(width / 2),
                    np.sin(width / 2),
                ]
            ),
        ),
        Kind.CYLINDER: ((2.0,), np.stack([-2 * np.cos(width / 2), 2 * np.sin(width / 2), long])),
        Kind.CONE: (
            (2.0, 0.5),
            np.stack(
                [
                    -(2 + width * np.sin(0.5)) * np.cos(long),
                    (2 + width * np.sin(0.5)) * np.sin(long),
                    width * np.cos(0.5),
                ]
            ),
        ),
        Kind.TORUS: (
            (2.0, 0.5),
            np.stack(
                [
                    (2 + 0.5 * np.cos(2 * width)) * np.cos(long),
                    (2 + 0.5 * np.cos(2 * width)) * np.sin(long),
                    0.5 * np.sin(2 * width),
                ]
            ),
        ),
    }[kind]
    origin = np.array([1.0, 2.0, 3.0])
    primitive = Primitive(kind, origin, frame, sizes)
    points = origin + local.T @ frame
    found = narrowest_extent(primitive, points, np.ones(len(points)))
    assert found == pytest.approx(0.3, rel=0.01)
    # Where points are dense each stands for less.
    is_left = width < 0.0
    dense = np.concatenate([points, points[is_left]])
    weight = np.where(np.concatenate([is_left, is_left[is_left]]), 0.5, 1.0)
    assert narrowest_extent(primitive, dense, weight) == pytest.approx(found, rel=1e-9)


def test_a_whole_ring_is_as_wide_as_it_is_long_around() -> None:
    angle = np.arange(16) * np.pi / 8 + np.pi / 16
    ring = np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
    points = np.concatenate([ring + [0.0, 0.0, height] for height in np.linspace(-9, 9, 500)])
    cylinder = Primitive(Kind.CYLINDER, np.zeros(3), np.eye(3), (1.0,))
    found = narrowest_extent(cylinder, points, np.ones(len(points)))
    assert found == pytest.approx(2.0 * np.pi)
