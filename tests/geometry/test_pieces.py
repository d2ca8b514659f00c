# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pieces of composite surfaces, and none where curvature changes gradually."""

from __future__ import annotations

from collections import Counter

import numpy as np
import pytest
from architectural_curvature.addon.geometry.cleaning.growth import Piece
from architectural_curvature.addon.geometry.cleaning.labels import class_of_sectors
from architectural_curvature.addon.geometry.cleaning.pieces import find_pieces
from architectural_curvature.addon.geometry.curvature import estimate_curvature
from architectural_curvature.addon.geometry.links import rim_sectors, sector_links
from architectural_curvature.addon.geometry.mesh import mesh_from_polygons
from architectural_curvature.addon.geometry.primitives.shapes import Kind
from architectural_curvature.addon.geometry.segmentation import segment
from architectural_curvature.addon.geometry.surface import build_surface
from architectural_curvature.addon.geometry.tolerance import resolve_tolerance
from composites.catalogue import COMPOSITES
from composites.composite import Composite, Integers, Recipe
from numpy.typing import NDArray
from surfaces.catalogue import PATCHES
from surfaces.held_out import PATCHES as HELD_OUT
from surfaces.sampling import sample_patch

NOISE = 0.01


def _pieces(shape: Composite) -> list[Piece]:
    """Return the pieces that grow from the exact classes."""
    limit = resolve_tolerance(0.0, 0.0, float(np.linalg.norm(np.ptp(shape.vertices, axis=0))))
    return _found(
        shape.vertices, shape.polygons, shape.exact(limit.curvature_limit), limit.curvature_limit
    )


def _found(
    vertices: NDArray[np.float64], polygons: Integers, face_class: Integers, limit: float
) -> list[Piece]:
    surface = build_surface(mesh_from_polygons(vertices, polygons.tolist()))
    curvature = estimate_curvature(surface)
    return find_pieces(
        surface.sector_position,
        curvature.normal,
        sector_links(surface),
        class_of_sectors(surface, face_class),
        curvature.mean,
        rim_sectors(surface),
        curvature.noise,
        surface.mesh.resolution,
        limit,
    )


@pytest.mark.parametrize("noise", [0.0, NOISE])
@pytest.mark.parametrize("kind", ["quads", "triangles"])
def test_a_rounded_box_has_six_planes_twelve_cylinders_and_eight_spheres(
    kind: str, noise: float
) -> None:
    shape = COMPOSITES["rounded box"](Recipe(kind=kind, noise=noise))
    pieces = _pieces(shape)
    count = Counter(piece.primitive.kind for piece in pieces)
    assert count == {Kind.PLANE: 6, Kind.CYLINDER: 12, Kind.SPHERE: 8}
    radii = [piece.primitive.sizes[0] for piece in pieces if piece.primitive.sizes]
    np.testing.assert_allclose(radii, 0.35, rtol=0.02 if noise else 1e-9)


@pytest.mark.parametrize("count", [10_000, 80_000])
def test_a_bent_pipe_is_two_cylinders_and_a_torus_however_fine(count: int) -> None:
    """Rows beside a seam leave the other side by less than what moves borders, if they are fine."""
    pieces = _pieces(COMPOSITES["pipe elbow"](Recipe(count=count)))
    found = Counter(piece.primitive.kind for piece in pieces)
    assert found == {Kind.CYLINDER: 2, Kind.TORUS: 1}


@pytest.mark.parametrize("noise", [0.0, NOISE])
def test_a_silo_is_a_cone_a_torus_and_a_cylinder(noise: float) -> None:
    shape = COMPOSITES["silo"](Recipe(kind="triangles", noise=noise))
    pieces = {piece.primitive.kind: piece for piece in _pieces(shape)}
    assert set(pieces) == {Kind.CONE, Kind.TORUS, Kind.CYLINDER}
    tolerance = 0.02 if noise else 1e-9
    assert pieces[Kind.TORUS].primitive.sizes[1] == pytest.approx(0.8, rel=tolerance)
    assert abs(pieces[Kind.CONE].primitive.sizes[1]) == pytest.approx(
        np.radians(50.0), rel=tolerance
    )
    scatter = [piece.scatter / shape.edge for piece in pieces.values()]
    if noise:
        np.testing.assert_allclose(scatter, NOISE, rtol=0.1)


@pytest.mark.parametrize("noise", [0.0, NOISE])
@pytest.mark.parametrize("name", ["hyperboloid", "sine cylinder", "enneper", "catenoid"])
def test_what_bends_gradually_is_no_piece(name: str, noise: float) -> None:
    sample = sample_patch({**PATCHES, **HELD_OUT}[name], "irregular", (100, 100))
    position, polygons = sample.shape.position, sample.polygons
    side = position[polygons] - position[np.roll(polygons, -1, axis=1)]
    edge = np.linalg.norm(side, axis=2).mean()
    height = np.random.default_rng(1).normal(0.0, noise * edge, len(position))
    size = np.abs(np.stack([sample.shape.k1, sample.shape.k2])[:, polygons].mean(axis=2))
    # Borders of classes where a limit cuts through the surface.
    limit = float(np.median(size))
    face_class = (size > limit).sum(axis=0)
    pieces = _found(position + height[:, None] * sample.shape.normal, polygons, face_class, limit)
    assert sum(len(piece.members) for piece in pieces) < 0.02 * len(position)


def test_a_strip_of_two_rows_between_creases_is_one_single_curved_region() -> None:
    # A quarter of a ring of radius 2 with a square section of which the outer side has two rows.
    rng = np.random.default_rng(0)
    angle = np.linspace(0.0, 0.5 * np.pi, 41)
    height = np.array([0.0, 0.15, 0.3])
    shaken = angle[:, None] + rng.uniform(-0.3, 0.3, (41, 3)) * angle[1]
    outer = np.stack(
        [2.0 * np.cos(shaken), 2.0 * np.sin(shaken), np.broadcast_to(height, (41, 3))], axis=2
    )
    inner = 0.8 * outer[:, [0, 2]] + [[[0.0, 0.0, 0.0], [0.0, 0.0, 0.06]]]
    vertices = np.concatenate([outer, inner], axis=1)
    low, right = np.arange(40)[:, None] * 5, np.array([[0, 1], [1, 2], [2, 4], [4, 3], [3, 0]])
    cells = np.stack(
        [
            low + right[:, 0],
            low + 5 + right[:, 0],
            low + 5 + right[:, 1],
            low + right[:, 1],
        ],
        axis=-1,
    ).reshape(-1, 4)
    triangles = np.concatenate([cells[:, [0, 1, 2]], cells[:, [0, 2, 3]]])
    surface = build_surface(mesh_from_polygons(vertices.reshape(-1, 3), triangles.tolist()))
    limit = resolve_tolerance(0.0, 0.0, surface.mesh.diagonal)
    result = segment(surface, estimate_curvature(surface), limit)
    # Two plane sides, the outer and the inner one.
    assert sorted(result.regions.region_class.tolist()) == [0, 0, 1, 1]
