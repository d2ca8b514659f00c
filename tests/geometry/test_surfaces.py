# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The exact surfaces are exact, and their meshes are what they claim to be."""

from __future__ import annotations

import numpy as np
import pytest
from surfaces.catalogue import CONE_SLOPE, DEVELOPABLE, MINIMAL, PATCHES, TORUS_RING, TORUS_TUBE
from surfaces.sampling import KINDS, Sample, sample_patch
from surfaces.spheres import SPHERE_KINDS, ellipsoid_shape, sample_ellipsoid

#: Derivatives are exact to rounding: some tens of operations on numbers of about one.
ROUNDING = 1e-13


def _parameters(name: str) -> tuple[np.ndarray, np.ndarray]:
    patch = PATCHES[name]
    random = np.random.default_rng(7)
    return random.uniform(*patch.u, 200), random.uniform(*patch.v, 200)


@pytest.mark.parametrize("name", PATCHES)
def test_derivatives_agree_with_finite_differences(name: str) -> None:
    u, v = _parameters(name)
    step = 1e-4

    def position(du: float, dv: float) -> np.ndarray:
        return PATCHES[name].derivatives(u + du * step, v + dv * step)[0]

    _, by_u, by_v, by_uu, by_uv, by_vv = PATCHES[name].derivatives(u, v)
    differences = {
        "u": (by_u, (position(1, 0) - position(-1, 0)) / (2 * step)),
        "v": (by_v, (position(0, 1) - position(0, -1)) / (2 * step)),
        "uu": (by_uu, (position(1, 0) - 2 * position(0, 0) + position(-1, 0)) / step**2),
        "vv": (by_vv, (position(0, 1) - 2 * position(0, 0) + position(0, -1)) / step**2),
        "uv": (
            by_uv,
            (position(1, 1) - position(1, -1) - position(-1, 1) + position(-1, -1)) / (4 * step**2),
        ),
    }
    # Truncation step²/6 times third or fourth derivatives (below 20 here), and rounding
    # 4 · 1e-16 · |position| / step² in second differences: together below 2e-7.
    for exact, difference in differences.values():
        np.testing.assert_allclose(difference, exact, rtol=0.0, atol=2e-7)


def test_curvatures_follow_the_textbook() -> None:
    def expect(name: str, k1: np.ndarray | float, k2: np.ndarray | float) -> None:
        shape = PATCHES[name].shape(*_parameters(name))
        np.testing.assert_allclose(shape.k1, k1, rtol=0.0, atol=ROUNDING)
        np.testing.assert_allclose(shape.k2, k2, rtol=0.0, atol=ROUNDING)

    expect("plane", 0.0, 0.0)
    expect("sphere zone", 1.0, 1.0)
    expect("cylinder", 1.0, 0.0)
    expect("barrel vault", 1.0, 0.0)
    _, v = _parameters("cone")
    expect("cone", CONE_SLOPE / (v * np.hypot(1.0, CONE_SLOPE)), 0.0)
    _, v = _parameters("torus")
    expect("torus", 1.0 / TORUS_TUBE, np.cos(v) / (TORUS_RING + TORUS_TUBE * np.cos(v)))
    _, v = _parameters("catenoid")
    expect("catenoid", np.cosh(v) ** -2, -(np.cosh(v) ** -2))
    _, v = _parameters("helicoid")
    expect("helicoid", 0.6 / (0.36 + v**2), -0.6 / (0.36 + v**2))
    u, v = _parameters("enneper")
    size = 2.0 / (1.0 + u**2 + v**2) ** 2
    expect("enneper", size, -size)
    # At the distance w along the tangent of a curve, k is torsion / (curvature w). For the helix
    # (cos u, sin u, u/2) that ratio is 1/2, and the tangent's length is sqrt(5/4).
    _, v = _parameters("tangent developable")
    expect("tangent developable", 0.5 / (v * np.sqrt(1.25)), 0.0)


@pytest.mark.parametrize("name", ["hyperbolic paraboloid", "monkey saddle", "elliptic paraboloid"])
def test_graphs_follow_monges_formulas(name: str) -> None:
    u, v = _parameters(name)
    _, _, _, by_uu, by_uv, by_vv = PATCHES[name].derivatives(u, v)
    p, q = (PATCHES[name].derivatives(u, v)[i][:, 2] for i in (1, 2))
    r, s, t = by_uu[:, 2], by_uv[:, 2], by_vv[:, 2]
    root = 1.0 + p**2 + q**2
    shape = PATCHES[name].shape(u, v)
    np.testing.assert_allclose(shape.k1 * shape.k2, (r * t - s**2) / root**2, atol=ROUNDING)
    # The normals point up, and a graph that bends upward bends toward them.
    mean = -((1 + q**2) * r - 2 * p * q * s + (1 + p**2) * t) / (2 * root**1.5)
    np.testing.assert_allclose(0.5 * (shape.k1 + shape.k2), mean, atol=ROUNDING)


@pytest.mark.parametrize("name", DEVELOPABLE)
def test_developable_surfaces_have_no_gaussian_curvature(name: str) -> None:
    shape = PATCHES[name].shape(*_parameters(name))
    np.testing.assert_allclose(shape.k1 * shape.k2, 0.0, atol=ROUNDING)


@pytest.mark.parametrize("name", MINIMAL)
def test_minimal_surfaces_have_no_mean_curvature(name: str) -> None:
    shape = PATCHES[name].shape(*_parameters(name))
    np.testing.assert_allclose(shape.k1 + shape.k2, 0.0, atol=ROUNDING)


@pytest.mark.parametrize("name", PATCHES)
def test_normals_turn_along_principal_directions_as_rodrigues_says(name: str) -> None:
    # dn = k dx along a principal direction, with k positive where the surface bends away.
    u, v = _parameters(name)
    patch, step = PATCHES[name], 1e-5
    shape = patch.shape(u, v)
    _, by_u, by_v, *_ = patch.derivatives(u, v)
    turn_u = (patch.shape(u + step, v).normal - patch.shape(u - step, v).normal) / (2 * step)
    turn_v = (patch.shape(u, v + step).normal - patch.shape(u, v - step).normal) / (2 * step)
    frame = np.stack([by_u, by_v], axis=2)
    for direction, k in ((shape.direction_1, shape.k1), (shape.direction_2, shape.k2)):
        way = np.einsum("nij,nj->ni", np.linalg.pinv(frame), direction)
        turn = way[:, :1] * turn_u + way[:, 1:] * turn_v
        # Truncation step²/6 · third derivatives (below 100), rounding 1e-16/step.
        np.testing.assert_allclose(turn, k[:, None] * direction, atol=1e-8)


def test_ellipsoid_agrees_with_its_parametrization() -> None:
    # Gaussian curvature 1/(a b c h²)² and the vertices' curvatures a/b², a/c² by symmetry.
    a, b, c = axes = (3.0, 2.0, 1.0)
    unit = np.random.default_rng(1).normal(size=(200, 3))
    unit /= np.linalg.norm(unit, axis=1)[:, None]
    shape = ellipsoid_shape(axes, unit)
    h = (shape.position**2 / np.array(axes) ** 4).sum(axis=1)
    np.testing.assert_allclose(shape.k1 * shape.k2, 1.0 / (a * b * c * h) ** 2, rtol=1e-12)
    tips = ellipsoid_shape(axes, np.eye(3))
    np.testing.assert_allclose(tips.k1, [a / c**2, b / c**2, c / b**2], rtol=1e-14)
    np.testing.assert_allclose(tips.k2, [a / b**2, b / a**2, c / a**2], rtol=1e-14)
    np.testing.assert_allclose(np.abs(tips.direction_1), np.eye(3)[[2, 2, 1]], atol=ROUNDING)


def _check_mesh(sample: Sample, euler: int) -> None:
    shape, polygons = sample.shape, sample.polygons
    assert np.array_equal(np.unique(polygons), np.arange(len(shape.position)))
    ends = np.stack([polygons, np.roll(polygons, -1, axis=1)], axis=-1).reshape(-1, 2)
    # A half-edge occurs once: the mesh is manifold and wound alike.
    assert len(np.unique(ends, axis=0)) == len(ends)
    edges = len(np.unique(np.sort(ends, axis=1), axis=0))
    assert len(shape.position) - edges + len(polygons) == euler
    corner = shape.position[polygons]
    facet = np.cross(corner[:, 1] - corner[:, 0], corner[:, -1] - corner[:, 0])
    for k in range(polygons.shape[1]):
        assert (np.einsum("ij,ij->i", facet, shape.normal[polygons[:, k]]) > 0.0).all()


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("name", PATCHES)
def test_meshes_are_welded_and_wound_along_the_normals(name: str, kind: str) -> None:
    patch = PATCHES[name]
    # Annuli and the torus have the Euler characteristic 0, disks 1.
    _check_mesh(sample_patch(patch, kind, (24, 16)), 0 if any(patch.is_closed) else 1)


@pytest.mark.parametrize("kind", SPHERE_KINDS)
def test_spheres_are_closed_and_wound_outward(kind: str) -> None:
    sample = sample_ellipsoid((3.0, 2.0, 2.0), kind, 8)
    _check_mesh(sample, 2)
    assert not sample.is_rim.any()


def test_depth_counts_faces_from_the_rim() -> None:
    sample = sample_patch(PATCHES["plane"], "quads", (8, 8))
    i, j = np.divmod(np.arange(81), 9)
    expected = np.minimum.reduce([i, j, 8 - i, 8 - j])
    assert np.array_equal(sample.depth(3), np.minimum(expected, 3))
    assert np.array_equal(sample.is_rim, expected == 0)
