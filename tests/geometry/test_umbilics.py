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
from surfaces.catalogue import PATCHES, Patch
from surfaces.sampling import Sample, sample_patch
from surfaces.spheres import sample_ellipsoid
from surfaces.taylor import sin

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


@pytest.mark.parametrize(
    ("cubic", "kind"),
    [(1.5, UmbilicKind.MONSTAR), (1.7, UmbilicKind.MONSTAR), (3.0, UmbilicKind.LEMON)],
)
def test_a_cubic_form_decides_between_lemon_and_monstar(cubic: float, kind: UmbilicKind) -> None:
    """The surface is z = -(x² + y²) / 20 - (a x³ + 3 x y²) / 3.

    There zxx - zyy = -2 (a - 1) x and 2 zxy = -4 y. A line leaves straight at the angle t where
    their quotient is tan 2t: sin t = 0, or cos² t = 1 / (3 - a), which is a share for a < 2.
    """
    roof = Patch(
        lambda u, v: (u, v, -0.05 * (u * u + v * v) - (cubic * u * u * u + 3.0 * u * v * v) / 3.0),
        (-0.8, 0.8),
        (-0.8, 0.8),
    )
    sample = sample_patch(roof, "regular", (61, 61))
    umbilics = line_field(sample).umbilics
    here = np.flatnonzero(np.linalg.norm(umbilics.position, axis=1) < sample.longest_edge)
    assert umbilics.index[here].tolist() == [0.5]
    assert umbilics.kind[here].tolist() == [kind]
    ray = umbilics.rays[here[0]]
    ray = ray[(ray != 0.0).any(axis=1)]
    lean = np.degrees(np.arctan(np.abs(ray[:, 1] / ray[:, 0])))
    aside = np.degrees(np.arccos(np.sqrt(1.0 / (3.0 - cubic)))) if cubic < 2.0 else 0.0
    expected = [0.0, aside, aside] if kind == UmbilicKind.MONSTAR else [0.0]
    assert np.sort(lean) == pytest.approx(expected, abs=5.0)


def test_rays_of_a_monkey_saddle_are_sixty_degrees_apart() -> None:
    umbilics = line_field(sample_patch(PATCHES["monkey saddle"], "regular", (40, 40))).umbilics
    ray = umbilics.rays[0]
    angle = np.sort(np.arctan2(ray[:, 1], ray[:, 0]) % (2.0 * pi))
    assert np.diff(angle) == pytest.approx([2.0 * pi / 3.0] * 2, abs=0.05)


@pytest.mark.parametrize("noise", [0.0, 0.005])
@pytest.mark.parametrize("name", ["torus", "catenoid", "elliptic paraboloid", "enneper"])
def test_surfaces_without_umbilics_have_none(name: str, noise: float) -> None:
    umbilics = line_field(sample_patch(PATCHES[name], "irregular", (90, 60)), noise).umbilics
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


@pytest.mark.parametrize("noise", [0.0, 0.005])
def test_areas_and_points_add_up_together(noise: float) -> None:
    """A sphere with a bulge: what is left of the sphere is an area, the bulge has points."""
    sphere = sample_ellipsoid((1.0, 1.0, 1.0), "irregular", 24)
    unit = sphere.shape.position
    height = np.maximum(unit @ np.array([0.6, 0.48, 0.64]) - 0.1, 0.0)
    bulge = 0.5 * height**3 * (1.0 + 0.6 * unit[:, 0])
    moves = np.random.default_rng(1).normal(0.0, noise * sphere.longest_edge, len(unit))
    mesh = mesh_from_polygons(unit * (1.0 + bulge + moves)[:, None], sphere.polygons)
    surface = build_surface(mesh, crease_angle=pi)
    umbilics = build_line_field(surface, estimate_curvature(surface)).umbilics
    assert umbilics.area_size.max() > 1.5 * pi
    assert umbilics.count > 0
    assert umbilics.total_index == 2.0


def test_poles_of_a_spheroid_have_index_one() -> None:
    umbilics = line_field(sample_ellipsoid((1.0, 1.0, 1.6), "geodesic", 16)).umbilics
    assert umbilics.total_index == 2.0
    assert umbilics.index.sum() + umbilics.area_index.sum() == 2.0
    top = umbilics.position[:, 2] > 0.0
    assert umbilics.index[top].sum() == 1.0


@pytest.mark.parametrize("cells", [(40, 12), (41, 12), (120, 30)])
@pytest.mark.parametrize("noise", [0.0, 0.002])
def test_where_a_profile_turns_over_there_is_a_seam_and_no_umbilic(
    cells: tuple[int, int], noise: float
) -> None:
    """On z = sin(2x) / 3 the larger curvature is across the waves on crests, along them in dips."""
    waves = Patch(lambda u, v: (u, v, sin(2.0 * u) / 3.0), (-2.0, 2.0), (-0.6, 0.6))
    sample = sample_patch(waves, "regular", cells)
    lines = line_field(sample, noise)
    assert lines.umbilics.count == 0
    middle = lines.field.mesh.points(
        np.arange(len(lines.umbilics.triangle_area)),
        np.full((len(lines.umbilics.triangle_area), 3), 1.0 / 3.0),
    )
    in_area = lines.umbilics.triangle_area >= 0
    turns = np.array([-0.5 * pi, 0.0, 0.5 * pi])
    away = np.abs(middle[:, :1] - turns).min(axis=1)
    assert in_area[away < 0.2 * sample.longest_edge].all()
    assert away[in_area].max() < 3.0 * sample.longest_edge


def test_a_plane_takes_in_the_ripples_beside_it() -> None:
    """A plate that is flat but for noise, next to a bend, is one area without umbilics."""
    profile = Patch(lambda u, v: (u, v, 0.0 * u), (-1.0, 1.0), (-1.0, 1.0))
    sample = sample_patch(profile, "irregular", (30, 30))
    umbilics = line_field(sample, 2e-4).umbilics
    assert umbilics.count == 0
    assert umbilics.area_size == pytest.approx([4.0], rel=1e-3)


def test_confidence_falls_towards_umbilics() -> None:
    lines = line_field(sample_ellipsoid(AXES, "geodesic", 20))
    umbilic = lines.umbilics.position - lines.field.mesh.offset
    away = np.linalg.norm(lines.field.mesh.position[:, None] - umbilic, axis=2).min(axis=1)
    confidence = lines.field.confidence
    assert confidence[np.argmin(away)] < 0.5
    assert confidence[away > 0.5].min() > 0.9


def areas_of(positions: np.ndarray, polygons: np.ndarray | list[list[int]]) -> LineField:
    """Return the field of polygons with the usual crease angle."""
    surface = build_surface(mesh_from_polygons(positions, polygons))
    return build_line_field(surface, estimate_curvature(surface))


def test_every_facet_of_an_icosahedron_is_an_area() -> None:
    """Its dihedral angles are creases of 42 degrees; each facet is one triangle."""
    sample = sample_ellipsoid((1.0, 1.0, 1.0), "geodesic", 1)
    umbilics = areas_of(sample.shape.position, sample.polygons).umbilics
    assert umbilics.area_size == pytest.approx([np.sqrt(3.0) / 4.0 * 1.0514622**2] * 20, rel=1e-6)
    assert umbilics.count == 0
    # Together with the creases between them they are the whole sphere.
    assert sorted(umbilics.area_index) == [0.0] * 19 + [2.0]


@pytest.mark.parametrize(("lids", "euler"), [(True, 2.0), (False, None)])
def test_indices_at_creases_add_up_where_the_surface_is_closed(
    lids: bool, euler: float | None
) -> None:
    """A tin: a cylinder with flat lids, two creases; without lids it has rims instead."""
    around, along = 48, 12
    angle = 2 * np.pi * np.arange(around) / around
    height = np.linspace(0.0, 1.0, along)
    ring = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    points = np.concatenate([np.c_[ring, np.full(around, z)] for z in height])
    corner = np.arange(around)
    beside = (corner + 1) % around
    sides = [
        np.stack([corner, beside, beside + around, corner + around], axis=1) + row * around
        for row in range(along - 1)
    ]
    polygons = np.concatenate(sides).tolist()
    if lids:
        polygons += [corner[::-1].tolist(), (corner + (along - 1) * around).tolist()]
    umbilics = areas_of(points, polygons).umbilics
    assert umbilics.count == 0
    if euler is None:
        assert umbilics.total_index == 0.0
    else:
        assert umbilics.area_size == pytest.approx([0.5 * around * np.sin(2 * np.pi / around)] * 2)
        assert umbilics.total_index == euler


def test_creases_without_an_area_have_the_index_that_is_missing() -> None:
    """Two shells z = ±0.4 (1 - x² - y²), stretched to an oval, that meet in its sharp edge.

    Neither has an umbilic: those of x²/a + y²/b = 2z are where x = 0 and y² = b (a - b), which for
    a = 3.2 and b = 1.25 is beyond the edge.
    """
    around, along = 64, 12
    angle = 2 * np.pi * np.arange(around) / around
    radius = np.repeat(np.arange(1, along + 1) / along, around)
    flat = radius[:, None] * np.tile(np.stack([np.cos(angle), np.sin(angle)], axis=1), (along, 1))
    height = 0.4 * (1.0 - radius**2)
    rim = radius == 1.0
    stretch = np.array([1.6, 1.0, 1.0])
    points = np.concatenate(
        [
            np.c_[flat, height] * stretch,
            [[0.0, 0.0, 0.4]],
            np.c_[flat, -height][~rim] * stretch,
            [[0.0, 0.0, -0.4]],
        ]
    )
    corner = np.arange(around)
    beside = (corner + 1) % around
    rings = np.concatenate(
        [
            np.stack([corner, corner + around, beside + around, beside], axis=1) + row * around
            for row in range(along - 1)
        ]
    )
    upper = rings.tolist() + np.stack([np.full(around, along * around), corner, beside], 1).tolist()
    # The lower shell has the same corners, but for those at the edge.
    other = np.arange(len(points))
    other[: (along - 1) * around] += along * around + 1
    other[along * around] = len(points) - 1
    lower = [other[polygon[::-1]].tolist() for polygon in upper]
    umbilics = areas_of(points, upper + lower).umbilics
    assert umbilics.area_size.tolist() == [0.0]
    assert umbilics.area_index.tolist() == [2.0 - umbilics.index.sum()]
    assert umbilics.index.sum() == 0.0


def test_scraps_between_creases_are_one_area() -> None:
    """Polygons that point to opposite sides make a crease of every edge between them.

    On an ellipsoid of edges a fiftieth of the diagonal long whose triangles are turned over by
    chance, most pieces are a few triangles.
    """
    sample = sample_ellipsoid(AXES, "geodesic", 28)
    polygons = sample.polygons.copy()
    turned = np.random.default_rng(3).random(len(polygons)) < 0.5
    polygons[turned] = polygons[turned][:, ::-1]
    lines = areas_of(sample.shape.position, polygons)
    area = lines.umbilics.triangle_area
    mesh = lines.field.mesh
    small = 0
    for number in range(len(lines.umbilics.area_size)):
        corner = mesh.position[mesh.triangles[area == number]].reshape(-1, 3)
        reach = np.linalg.norm(corner - corner.mean(axis=0), axis=1).max()
        small += reach < lines.field.surface.mesh.diagonal / 40.0
        in_area = area == number
        assert lines.umbilics.area_size[number] == pytest.approx(
            0.5 * mesh.double_area[in_area].sum()
        )
    # Those together reach all over the model.
    assert small == 0
    assert len(lines.umbilics.area_size) < 100
