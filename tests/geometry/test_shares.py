# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Areas of classes are those of the surface, not of the rows of polygons that stand for it."""

from __future__ import annotations

import itertools
from functools import cache

import numpy as np
import pytest
from architectural_curvature.addon.geometry.classification import SurfaceClass
from architectural_curvature.addon.geometry.curvature import estimate_curvature
from architectural_curvature.addon.geometry.mesh import mesh_from_polygons
from architectural_curvature.addon.geometry.segmentation import Segmentation, segment
from architectural_curvature.addon.geometry.surface import Surface, build_surface
from architectural_curvature.addon.geometry.tolerance import Tolerance, resolve_tolerance
from composites.catalogue import COMPOSITES
from composites.composite import Recipe
from composites.tubes import torus, torus_shares

CLASSES = (
    SurfaceClass.FLAT,
    SurfaceClass.SINGLE,
    SurfaceClass.ELLIPTIC,
    SurfaceClass.HYPERBOLIC,
)


@cache
def _segmented(
    name: str, recipe: Recipe, tolerance: Tolerance | None = None
) -> tuple[Surface, Segmentation]:
    shape = {**COMPOSITES, "torus": torus}[name](recipe)
    surface = build_surface(mesh_from_polygons(shape.vertices, shape.polygons.tolist()))
    limits = tolerance or resolve_tolerance(0.0, 0.0, surface.mesh.diagonal)
    return surface, segment(surface, estimate_curvature(surface), limits)


def _shares(result: Segmentation) -> list[float]:
    return [result.classes[surface_class].share for surface_class in CLASSES]


@pytest.mark.parametrize("deviation", [0.00071, 0.001335, 0.004])
@pytest.mark.parametrize("kind", ["quads", "triangles"])
def test_shares_of_a_torus_follow_the_formula(kind: str, deviation: float) -> None:
    tolerance = Tolerance(0.2, deviation)
    _, result = _segmented("torus", Recipe(kind=kind), tolerance)
    exact = [0.0, *torus_shares(tolerance.curvature_limit)]
    # Far below the 1 % that whole rows of quads are worth: what is left is the polygons' own error.
    np.testing.assert_allclose(_shares(result), exact, atol=0.002)


@pytest.mark.parametrize("noise", [0.0, 0.01])
@pytest.mark.parametrize("name", ["rounded box", "torus"])
def test_doubling_a_mesh_keeps_the_shares(name: str, noise: float) -> None:
    """On the two shapes whose whole rows of quads are worth most."""
    _, coarse = _segmented(name, Recipe(noise=noise))
    _, fine = _segmented(name, Recipe(count=20_000, noise=noise), coarse.tolerance)
    np.testing.assert_allclose(_shares(fine), _shares(coarse), atol=0.01)


@pytest.mark.parametrize(
    ("name", "kind"), list(itertools.product([*COMPOSITES, "torus"], ("quads", "triangles")))
)
def test_halving_a_mesh_keeps_the_shares(name: str, kind: str) -> None:
    _, fine = _segmented(name, Recipe(kind=kind))
    _, coarse = _segmented(name, Recipe(count=5000, kind=kind), fine.tolerance)
    np.testing.assert_allclose(_shares(fine), _shares(coarse), atol=0.01)


@pytest.mark.parametrize("name", ["rounded box", "torus"])
def test_all_areas_add_up_to_the_surface(name: str) -> None:
    surface, result = _segmented(name, Recipe(kind="triangles"))
    total = surface.polygon_area.sum()
    assert result.regions.area.sum() == pytest.approx(total)
    assert sum(measure.area for measure in result.classes.values()) == pytest.approx(total)
    for surface_class in CLASSES:
        of_class = result.regions.region_class == surface_class
        area = result.classes[surface_class].area
        assert result.regions.area[of_class].sum() == pytest.approx(area)
    assert (np.diff(result.regions.area) <= 1e-8 * total).all()


def test_regions_keep_their_polygons_when_their_areas_change() -> None:
    surface, result = _segmented("pipe elbow", Recipe())
    regions = result.regions
    assert (regions.region_class[regions.face_region] == result.face_class).all()
    assert np.bincount(regions.face_region).tolist() == regions.face_count.tolist()
    whole = np.bincount(regions.face_region, surface.polygon_area)
    row = surface.polygon_area.max() * regions.boundary_length / surface.polygon_area.min() ** 0.5
    assert (np.abs(regions.area - whole) <= row).all()


def test_polygons_assigned_by_hand_count_whole() -> None:
    surface, free = _segmented("torus", Recipe())
    result = segment(
        surface, estimate_curvature(surface), free.criterion, locked=free.face_class.copy()
    )
    for surface_class in CLASSES:
        whole = surface.polygon_area[free.face_class == surface_class].sum()
        assert result.classes[surface_class].area == pytest.approx(whole)


def test_a_border_through_the_middle_of_quads_halves_them() -> None:
    """A plane that bends into a cylinder, on quads a third of which lies on the plane."""
    width, radius, step = 0.02, 1.0, 0.02
    arc = (np.arange(-60, 61) + 2 / 3) * step
    turn = np.maximum(arc, 0.0) / radius
    profile = np.stack([np.minimum(arc, 0.0) + radius * np.sin(turn), radius * (np.cos(turn) - 1)])
    y = width * np.arange(41)
    vertices = np.stack(
        [
            np.repeat(profile[0], len(y)),
            np.tile(y, len(arc)),
            np.repeat(profile[1], len(y)),
        ],
        axis=1,
    )
    first = (np.arange(len(arc) - 1)[:, None] * len(y) + np.arange(len(y) - 1)).ravel()
    quads = np.stack([first, first + len(y), first + len(y) + 1, first + 1], axis=1)
    surface = build_surface(mesh_from_polygons(vertices, quads.tolist()))
    result = segment(surface, estimate_curvature(surface), Tolerance(0.4, 0.004))
    flat = -arc[0] * y[-1]
    # A chord is shorter than its arc by the square of the turn over 24.
    assert result.classes[SurfaceClass.FLAT].area == pytest.approx(flat, abs=1e-3 * step * y[-1])
