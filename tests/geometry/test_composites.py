# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Composite surfaces come apart into the pieces that they were made of."""

from __future__ import annotations

import itertools
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from architectural_curvature.addon.geometry.classification import SurfaceClass
from architectural_curvature.addon.geometry.curvature import estimate_curvature
from architectural_curvature.addon.geometry.mesh import mesh_from_polygons
from architectural_curvature.addon.geometry.outlines.borders import trace_borders
from architectural_curvature.addon.geometry.outlines.level_curves import parabolic_curves
from architectural_curvature.addon.geometry.segmentation import Segmentation, segment
from architectural_curvature.addon.geometry.surface import Surface, build_surface
from architectural_curvature.addon.geometry.tolerance import Tolerance, resolve_tolerance
from composites.boxes import rounded_box
from composites.catalogue import COMPOSITES, LATER
from composites.composite import Composite, Recipe, quads
from composites.sheets import zigzag_sheet
from composites.tubes import torus

NOISE = 0.01
ROWS = list(itertools.product(COMPOSITES, ("quads", "triangles"), (0.0, NOISE)))


@cache
def _segmented(name: str, recipe: Recipe) -> tuple[Composite, Surface, Segmentation]:
    shape = {**COMPOSITES, **LATER}[name](recipe)
    surface = build_surface(mesh_from_polygons(shape.vertices, shape.polygons.tolist()))
    tolerance = resolve_tolerance(0.0, 0.0, surface.mesh.diagonal)
    return shape, surface, segment(surface, estimate_curvature(surface), tolerance)


def _share_right(shape: Composite, surface: Surface, result: Segmentation) -> float:
    right = result.face_class == shape.exact(result.tolerance.curvature_limit)
    return float(surface.polygon_area[right].sum() / surface.polygon_area.sum())


@pytest.mark.parametrize(("name", "kind", "noise"), ROWS)
def test_the_class_is_right(name: str, kind: str, noise: float) -> None:
    share = _share_right(*_segmented(name, Recipe(kind=kind, noise=noise)))
    assert share >= (0.97 if noise else 0.99)


@pytest.mark.parametrize("noise", [0.0, NOISE])
@pytest.mark.parametrize("kind", ["quads", "triangles"])
@pytest.mark.parametrize("name", LATER)
def test_class_and_regions_of_other_shapes_are_right(name: str, kind: str, noise: float) -> None:
    shape, surface, result = _segmented(name, Recipe(kind=kind, noise=noise, seed=3))
    assert _share_right(shape, surface, result) >= (0.97 if noise else 0.99)
    assert result.regions.count == shape.regions


@pytest.mark.parametrize(("name", "kind", "noise"), ROWS)
def test_the_number_of_regions_is_exact(name: str, kind: str, noise: float) -> None:
    shape, _, result = _segmented(name, Recipe(kind=kind, noise=noise))
    assert result.regions.count == shape.regions


@pytest.mark.parametrize(("name", "kind", "noise"), ROWS)
def test_borders_lie_within_an_edge_of_the_seams(name: str, kind: str, noise: float) -> None:
    shape, surface, result = _segmented(name, Recipe(kind=kind, noise=noise))
    corner = shape.vertices[shape.polygons]
    sides = np.linalg.norm(corner - np.roll(corner, -1, axis=1), axis=2)
    # A triangle whose center is on its own side of a seam reaches beyond it by less than two thirds
    # of its longest side.
    reach = max(1.0, 2.0 / 3.0 * float(sides.max()) / shape.edge)
    # As much as of the area, which noise may take from the right class.
    assert _share_near_seams(shape, surface, result, reach) >= (0.97 if noise else 0.99)


@pytest.mark.parametrize(("name", "kind", "noise"), [row for row in ROWS if row[2]])
def test_borders_under_noise_lie_within_two_edges(name: str, kind: str, noise: float) -> None:
    assert _share_near_seams(*_segmented(name, Recipe(kind=kind, noise=noise)), 2.0) >= 0.99


def _share_near_seams(
    shape: Composite, surface: Surface, result: Segmentation, edges: float
) -> float:
    """Return how many border points have another class around them within so many edges."""
    limit = result.tolerance.curvature_limit
    curves = trace_borders(surface, result.regions.face_region).curves
    around = np.random.default_rng(0).normal(size=(40, 3))
    around *= edges * shape.edge / np.linalg.norm(around, axis=1)[:, None]
    own = shape.class_at(curves.points, limit)
    others = [
        shape.class_at(curves.points + share * step, limit)
        for step in around
        for share in np.arange(0.25, edges + 0.1, 0.25) / edges
    ]
    is_near = (np.array(others) != own).any(axis=0)
    return float(is_near.mean())


@pytest.mark.parametrize("seed", [0, 1])
def test_low_walls_around_a_slab_are_flat(seed: int) -> None:
    """Walls of five edges between fillets, which noise makes to seem bent from top to bottom."""
    recipe = Recipe(count=6000, kind="triangles", noise=NOISE, seed=seed)
    shape = rounded_box(recipe, half=(1.7, 1.2, 0.2), radius=0.3)
    surface = build_surface(mesh_from_polygons(shape.vertices, shape.polygons.tolist()))
    tolerance = resolve_tolerance(0.0, 0.0, surface.mesh.diagonal)
    result = segment(surface, estimate_curvature(surface), tolerance)
    center = shape.vertices[shape.polygons].mean(axis=1)
    is_wall = shape.exact(tolerance.curvature_limit) == SurfaceClass.FLAT
    is_wall &= np.abs(center[:, 2]) < 0.2 - shape.edge
    assert is_wall.sum() > 300
    assert (result.face_class[is_wall] == SurfaceClass.FLAT).mean() >= 0.99


NARROW = [((0.7, 0.7, 0.7), 0.2), ((1.0, 0.7, 0.5), 0.15), ((2.0, 1.5, 0.5), 0.3)]


def _box(
    half: tuple[float, float, float], radius: float, across: float, recipe: Recipe
) -> Composite:
    """Return a rounded box whose fillets are so many edges wide."""
    edge = radius * np.pi / 2 / across
    reach = np.array(half) + radius * np.pi / 4
    count = int(8 * (reach * np.roll(reach, 1)).sum() / edge**2)
    return rounded_box(replace(recipe, count=count), half, radius)


def _as_stored(shape: Composite) -> tuple[Surface, Segmentation]:
    """Return the segmentation of a shape whose coordinates are 32-bit numbers, as in Blender."""
    vertices = shape.vertices.astype(np.float32)
    step = float(np.spacing(np.abs(vertices).max()))
    mesh = mesh_from_polygons(vertices, shape.polygons.tolist(), resolution=step)
    surface = build_surface(mesh)
    tolerance = resolve_tolerance(0.0, 0.0, surface.mesh.diagonal)
    return surface, segment(surface, estimate_curvature(surface), tolerance)


@pytest.mark.parametrize("kind", ["quads", "triangles"])
@pytest.mark.parametrize(("half", "radius"), NARROW)
def test_fillets_of_five_edges_are_right_under_noise(
    half: tuple[float, float, float], radius: float, kind: str
) -> None:
    shape = _box(half, radius, 5.0, Recipe(kind=kind, noise=NOISE))
    assert _share_right(shape, *_as_stored(shape)) >= 0.97


@pytest.mark.parametrize("kind", ["quads", "triangles"])
@pytest.mark.parametrize(("half", "radius"), NARROW)
def test_regions_of_boxes_with_narrow_fillets_are_counted(
    half: tuple[float, float, float], radius: float, kind: str
) -> None:
    for seed in range(3 if kind == "triangles" else 1):
        shape = _box(half, radius, 6.5, Recipe(kind=kind, seed=seed))
        surface, result = _as_stored(shape)
        assert _share_right(shape, surface, result) >= 0.99
        assert result.regions.count == 26


def test_a_bump_far_from_the_origin_keeps_its_classes() -> None:
    """Coordinates that are rounded to a fiftieth of an edge are noisy, and say nothing exactly."""
    x, y = (each.ravel() for each in np.meshgrid(*2 * [np.linspace(-5, 5, 51)], indexing="ij"))
    vertices = np.stack([x, y, 1.5 * np.exp(-(x**2 + y**2) / 8)], axis=1)
    far = np.array([50_000.0, 50_000.0, 0.0])
    rounded = (vertices + far).astype(np.float32).astype(np.float64) - far
    shares: list[list[float]] = []
    for points, step in ((vertices, 0.0), (rounded, float(np.spacing(np.float32(50_000.0))))):
        mesh = mesh_from_polygons(points, quads(51, 51).tolist(), resolution=step)
        surface = build_surface(mesh)
        tolerance = resolve_tolerance(0.0, 0.0, mesh.diagonal)
        face_class = segment(surface, estimate_curvature(surface), tolerance).face_class
        of_class = np.bincount(face_class, surface.polygon_area, 4)
        shares.append((of_class / of_class.sum()).tolist())
    np.testing.assert_allclose(shares[1], shares[0], atol=0.05)


@pytest.mark.parametrize("noise", [0.0, NOISE])
@pytest.mark.parametrize("kind", ["quads", "triangles"])
@pytest.mark.parametrize("count", [1500, 4000])
def test_single_curved_bands_join_the_arms_of_a_coarse_elbow(
    count: int, kind: str, noise: float
) -> None:
    shape, _, result = _segmented("pipe elbow", Recipe(count=count, kind=kind, noise=noise))
    assert result.regions.count == shape.regions


@pytest.mark.parametrize("kind", ["quads", "triangles"])
def test_parabolic_curves_of_a_torus_are_two_circles(kind: str) -> None:
    shape = torus(Recipe(kind=kind))
    surface = build_surface(mesh_from_polygons(shape.vertices, shape.polygons.tolist()))
    curves = parabolic_curves(surface, estimate_curvature(surface), 0.2)
    assert curves.is_closed.tolist() == [True, True]
    np.testing.assert_allclose(curves.lengths, 2 * np.pi, rtol=2e-3)
    off = np.hypot(np.hypot(*curves.points[:, :2].T) - 1, np.abs(curves.points[:, 2]) - 0.4)
    assert off.max() < 0.1 * shape.edge


@pytest.mark.parametrize("name", ["apse vault", "folded plate"])
def test_the_order_of_faces_and_vertices_does_not_matter(name: str) -> None:
    shape = COMPOSITES[name](Recipe(count=3000, kind="triangles", noise=NOISE))
    rng = np.random.default_rng(0)
    order = rng.permutation(len(shape.polygons))
    place = rng.permutation(len(shape.vertices))
    mixed = replace(
        shape, vertices=shape.vertices[np.argsort(place)], polygons=place[shape.polygons[order]]
    )
    found = [
        segment(surface, estimate_curvature(surface), Tolerance(0.25, 0.00125)).face_class
        for surface in (
            build_surface(mesh_from_polygons(each.vertices, each.polygons.tolist()))
            for each in (shape, mixed)
        )
    ]
    # Ties of distances and of cuts are rare, and rounding decides them.
    assert (found[1] == found[0][order]).mean() > 0.999


def test_the_same_input_gives_the_same_result() -> None:
    _, surface, result = _segmented("silo", Recipe(kind="triangles"))
    again = segment(surface, estimate_curvature(surface), result.criterion)
    assert (again.face_class == result.face_class).all()
    assert (again.regions.face_region == result.regions.face_region).all()


@pytest.mark.parametrize("cells", [6, 20])
def test_a_sheet_folded_in_zigzag_is_no_single_curved_area(cells: int) -> None:
    vertices, triangles = zigzag_sheet(81, 0.1, cells)
    surface = build_surface(mesh_from_polygons(vertices, triangles.tolist()))
    tolerance = resolve_tolerance(0.0, 0.0, surface.mesh.diagonal)
    regions = segment(surface, estimate_curvature(surface), tolerance).regions
    single = regions.area[regions.region_class == SurfaceClass.SINGLE]
    assert single.max(initial=0.0) < 0.5 * regions.area.sum()


def test_progress_rises_and_may_stop_the_work() -> None:
    _, surface, result = _segmented("silo", Recipe(kind="triangles"))
    curvature = estimate_curvature(surface)
    shares: list[float] = []
    segment(surface, curvature, result.criterion, on_progress=shares.append)
    assert len(shares) > 8
    assert shares == sorted(shares)
    assert 0.0 < shares[0] <= shares[-1] <= 1.0

    def stop(share: float) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        segment(surface, curvature, result.criterion, on_progress=stop)
