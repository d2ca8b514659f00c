# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The sample models are the surfaces that assets/README.md says they are."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np
import pytest
from architectural_curvature.addon.geometry.classification import SurfaceClass
from architectural_curvature.addon.geometry.curvature import estimate_curvature
from architectural_curvature.addon.geometry.diagnosis import diagnose
from architectural_curvature.addon.geometry.mesh import mesh_from_polygons
from architectural_curvature.addon.geometry.segmentation import segment
from architectural_curvature.addon.geometry.surface import Surface, build_surface
from architectural_curvature.addon.geometry.tolerance import resolve_tolerance
from numpy.typing import NDArray
from sample_models import MODELS, Points, read_obj
from scipy.spatial import cKDTree

ASSETS = Path(__file__).resolve().parents[2] / "assets"

CLOSED = ("torus", "ellipsoid")

models = pytest.mark.parametrize("name", MODELS)


@cache
def _surface(name: str) -> Surface:
    return build_surface(mesh_from_polygons(*read_obj(ASSETS / "models" / f"{name}.obj")))


@cache
def _points(name: str) -> Points:
    return MODELS[name]()


def _table() -> dict[str, list[str]]:
    lines = (ASSETS / "README.md").read_text(encoding="utf-8").splitlines()
    rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in lines if "|" in line]
    return {row[0].strip("`").removesuffix(".obj"): row[1:] for row in rows if ".obj" in row[0]}


@models
def test_the_table_of_exact_values_follows_from_the_formulas(name: str) -> None:
    mesh, points = _surface(name).mesh, _points(name)
    tolerance = resolve_tolerance(0.0, 0.0, mesh.diagonal)
    assert _table()[name] == [
        f"{mesh.polygon_count}",
        f"{points.area.sum():.1f}",
        *(f"{100.0 * share:.1f}" for share in points.shares(tolerance.curvature_limit)),
        f"{points.smallest_radius:.2f}",
        f"{tolerance.radius_limit:.1f}",
    ]


@models
def test_models_are_sound_quads_with_rims_where_they_are_open(name: str) -> None:
    surface = _surface(name)
    assert diagnose(surface) == ()
    assert (np.diff(surface.mesh.polygon_start) == 4).all()
    assert (len(surface.edges.rim) == 0) == (name in CLOSED)
    assert surface.has_creases == (name == "pavilion")


@models
def test_models_stand_upright_on_the_ground_or_around_the_origin(name: str) -> None:
    vertices = _surface(name).mesh.vertices
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    if name in CLOSED:
        np.testing.assert_allclose(low, -high, atol=2e-6)
    else:
        assert low[2] == 0.0
    assert (high - low).argmin() == 2


@models
def test_vertices_lie_on_their_surface(name: str) -> None:
    x, y, z = _surface(name).mesh.vertices.T
    far = {
        "torus": lambda: np.hypot(np.hypot(x, y) - 6.0, z) - 2.5,
        "ellipsoid": lambda: 4.0 * (np.sqrt((x / 9) ** 2 + (y / 6) ** 2 + (z / 4) ** 2) - 1.0),
        "barrel_vault": lambda: np.hypot(np.hypot(np.maximum(np.abs(x) - 6.0, 0.0), y), z) - 5.0,
        # The points stand 4 cm apart in both directions, and up to a fifth wider where the plan
        # and the overhang stretch them.
        "pavilion": lambda: (
            cKDTree(_points(name).position).query(_surface(name).mesh.vertices)[0] - 0.05
        ).clip(0.0),
    }[name]()
    # Coordinates are rounded to a micrometer.
    np.testing.assert_allclose(far, 0.0, atol=1e-6)


def test_the_quads_of_the_pavilion_are_planar_panels() -> None:
    mesh = _surface("pavilion").mesh
    a, b, c, d = mesh.vertices[mesh.corner_vertex].reshape(-1, 4, 3).transpose(1, 0, 2)
    normal = np.cross(c - a, d - b)
    height = np.einsum("ij,ij->i", b - a, normal) / np.linalg.norm(normal, axis=1)
    # Coordinates are rounded to a micrometer. Only the two rows of the fascia are warped where the
    # roof narrows along the free line, in 18 steps.
    is_warped = np.abs(height) > 2e-6
    assert is_warped.sum() <= 2 * 18
    assert np.abs(height).max() < 1e-3


@models
def test_faces_away_from_borders_have_the_exact_class(name: str) -> None:
    surface, points = _surface(name), _points(name)
    tolerance = resolve_tolerance(0.0, 0.0, surface.mesh.diagonal)
    # Without a least area: parts of a wall that hold no panel would join their neighbors.
    found = segment(surface, estimate_curvature(surface), tolerance, min_area=1e-6).face_class
    middle = surface.mesh.vertices[surface.mesh.corner_vertex].reshape(-1, 4, 3).mean(axis=1)
    _, nearest = cKDTree(points.position).query(middle)
    exact = points.classes(tolerance.curvature_limit)[nearest]
    is_clear = _is_alike_around(surface, exact, rings=3)
    assert (found[is_clear] == exact[is_clear]).all()
    assert is_clear.mean() > 1.0 / 3.0
    # The whole is right but for the rings of faces along borders.
    right = surface.polygon_area[found == exact].sum() / surface.polygon_area.sum()
    assert right >= surface.polygon_area[is_clear].sum() / surface.polygon_area.sum()
    assert SurfaceClass.UNDEFINED not in found


def _is_alike_around(surface: Surface, values: NDArray[np.int64], rings: int) -> NDArray[np.bool_]:
    """Return which faces have equal values within some rings that cross no crease."""
    corner_sector = surface.corner_sector.reshape(-1, 4)
    low, high = values.copy(), values.copy()
    for _ in range(rings):
        lowest = np.full(surface.sector_count, low.max())
        highest = np.full(surface.sector_count, high.min())
        np.minimum.at(lowest, corner_sector, low[:, None])
        np.maximum.at(highest, corner_sector, high[:, None])
        low, high = lowest[corner_sector].min(axis=1), highest[corner_sector].max(axis=1)
    return low == high


@models
def test_nearly_all_of_the_area_has_the_exact_class(name: str) -> None:
    surface, points = _surface(name), _points(name)
    tolerance = resolve_tolerance(0.0, 0.0, surface.mesh.diagonal)
    found = segment(surface, estimate_curvature(surface), tolerance).face_class
    middle = surface.mesh.vertices[surface.mesh.corner_vertex].reshape(-1, 4, 3).mean(axis=1)
    _, nearest = cKDTree(points.position).query(middle)
    is_right = found == points.classes(tolerance.curvature_limit)[nearest]
    # What is asked of all clean composites.
    assert surface.polygon_area[is_right].sum() >= 0.99 * surface.polygon_area.sum()
