# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Umbilics are where theory puts them, with indices that add up to the Euler characteristic."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest
from architectural_curvature.addon.geometry.curvature import estimate_curvature
from architectural_curvature.addon.geometry.lines.tracer import LineField, build_line_field
from architectural_curvature.addon.geometry.lines.umbilics import UmbilicKind
from architectural_curvature.addon.geometry.mesh import mesh_from_polygons
from architectural_curvature.addon.geometry.surface import build_surface
from surfaces.catalogue import PATCHES
from surfaces.sampling import Sample, sample_patch
from surfaces.spheres import sample_ellipsoid

AXES = (1.5, 1.2, 1.0)


def line_field(sample: Sample, noise: float = 0.0, flip: bool = False) -> LineField:
    """Return the field of a sample whose points are moved by a share of the longest edge."""
    moves = np.random.default_rng(1).normal(0.0, noise, (len(sample.shape.position), 1))
    position = sample.shape.position + moves * sample.longest_edge * sample.shape.normal
    surface = build_surface(mesh_from_polygons(position, sample.polygons), crease_angle=pi)
    curvature = estimate_curvature(surface)
    return build_line_field(surface, curvature.flipped() if flip else curvature)


@pytest.mark.parametrize("kind", ["geodesic", "irregular"])
@pytest.mark.parametrize("noise", [0.0, 0.005])
def test_ellipsoid_has_four_lemons_at_known_places(kind: str, noise: float) -> None:
    sample = sample_ellipsoid(AXES, kind, 20)
    umbilics = line_field(sample, noise).umbilics
    a, b, c = np.array(AXES) ** 2
    x = AXES[0] * np.sqrt((a - b) / (a - c))
    z = AXES[2] * np.sqrt((b - c) / (a - c))
    assert umbilics.index.tolist() == [0.5] * 4
    assert (umbilics.kind == UmbilicKind.LEMON).all()
    assert len(umbilics.area_index) == 0
    exact = np.array([x, 0.0, z])
    assert np.abs(np.abs(umbilics.position) - exact).max() < sample.longest_edge
    assert len(np.unique(np.sign(umbilics.position[:, [0, 2]]), axis=0)) == 4


def test_monkey_saddle_has_one_star() -> None:
    sample = sample_patch(PATCHES["monkey saddle"], "irregular", (40, 40))
    umbilics = line_field(sample).umbilics
    assert umbilics.index.tolist() == [-0.5]
    assert umbilics.kind.tolist() == [UmbilicKind.STAR]
    assert np.linalg.norm(umbilics.position) < sample.longest_edge


def test_rays_of_a_monkey_saddle_are_sixty_degrees_apart() -> None:
    umbilics = line_field(sample_patch(PATCHES["monkey saddle"], "regular", (40, 40))).umbilics
    ray = umbilics.rays[0]
    angle = np.sort(np.arctan2(ray[:, 1], ray[:, 0]) % (2.0 * pi))
    assert np.diff(angle) == pytest.approx([2.0 * pi / 3.0] * 2, abs=0.05)


@pytest.mark.parametrize("name", ["torus", "catenoid", "elliptic paraboloid", "enneper"])
def test_surfaces_without_umbilics_have_none(name: str) -> None:
    umbilics = line_field(sample_patch(PATCHES[name], "irregular", (60, 40))).umbilics
    assert umbilics.count == 0
    assert len(umbilics.area_index) == 0


@pytest.mark.parametrize("noise", [0.0, 0.005])
def test_sphere_is_one_umbilic_area_of_index_two(noise: float) -> None:
    umbilics = line_field(sample_ellipsoid((1.0, 1.0, 1.0), "irregular", 16), noise).umbilics
    assert umbilics.count == 0
    assert umbilics.area_index.tolist() == [2.0]
    assert umbilics.area_size[0] == pytest.approx(4.0 * pi, rel=0.02)


@pytest.mark.parametrize("noise", [0.0, 0.01, 0.1])
@pytest.mark.parametrize("flip", [False, True])
def test_indices_add_up_to_the_euler_characteristic(noise: float, flip: bool) -> None:
    ellipsoid = line_field(sample_ellipsoid(AXES, "irregular", 12), noise, flip)
    assert ellipsoid.umbilics.total_index == 2.0
    torus = line_field(sample_patch(PATCHES["torus"], "irregular", (60, 30)), noise, flip)
    assert torus.umbilics.total_index == 0.0


def test_poles_of_a_spheroid_have_index_one() -> None:
    umbilics = line_field(sample_ellipsoid((1.0, 1.0, 1.6), "geodesic", 16)).umbilics
    assert umbilics.total_index == 2.0
    assert umbilics.index.sum() + umbilics.area_index.sum() == 2.0
    top = umbilics.position[:, 2] > 0.0
    assert umbilics.index[top].sum() == 1.0


def test_confidence_falls_towards_umbilics() -> None:
    lines = line_field(sample_ellipsoid(AXES, "geodesic", 20))
    umbilic = lines.umbilics.position - lines.field.mesh.offset
    away = np.linalg.norm(lines.field.mesh.position[:, None] - umbilic, axis=2).min(axis=1)
    confidence = lines.field.confidence
    assert confidence[np.argmin(away)] < 0.5
    assert confidence[away > 0.5].min() > 0.9
