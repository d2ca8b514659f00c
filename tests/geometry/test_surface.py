# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A surface is the mesh cut along its creases."""

from __future__ import annotations

import numpy as np
import pytest
from architectural_curvature.addon.geometry.creases import DEFAULT_CREASE_ANGLE
from architectural_curvature.addon.geometry.mesh import mesh_from_polygons
from architectural_curvature.addon.geometry.surface import build_surface
from solids import cube, pointed_vault


def test_the_default_crease_angle_is_30_degrees() -> None:
    assert pytest.approx(np.radians(30.0), rel=1e-15) == DEFAULT_CREASE_ANGLE


def test_the_areas_of_sectors_share_out_the_surface() -> None:
    surface = build_surface(mesh_from_polygons(*cube(3)))
    assert surface.sector_area.sum() == pytest.approx(6.0, rel=1e-14)
    # Each corner of a quad of 1/9 stands for a quarter of it.
    corners = np.bincount(surface.corner_sector)
    np.testing.assert_allclose(surface.sector_area, corners / 36.0, rtol=1e-13)


def test_positions_are_measured_from_the_middle() -> None:
    vertices, faces = cube(2)
    surface = build_surface(mesh_from_polygons(vertices + 1e5, faces))
    np.testing.assert_array_equal(surface.sector_position.max(axis=0), 0.5)
    np.testing.assert_array_equal(surface.sector_position.min(axis=0), -0.5)


def test_the_triangles_of_the_cut_mesh_keep_to_one_side_of_a_crease() -> None:
    vertices, faces = pointed_vault(6)
    surface = build_surface(mesh_from_polygons(vertices, faces))
    triangles = surface.sector_triangles
    middle = surface.sector_position[triangles].mean(axis=1)[:, 0]
    right, left = triangles[middle > 0.0], triangles[middle < 0.0]
    assert not set(right.ravel()) & set(left.ravel())
    assert len(right) + len(left) == len(triangles)


def test_the_crease_angle_decides_what_is_cut() -> None:
    mesh = mesh_from_polygons(*pointed_vault(6))
    # The arcs meet at 60°, and half a step of 10° on either side tilts the faces further.
    assert build_surface(mesh, np.radians(69.0)).has_creases
    assert not build_surface(mesh, np.radians(71.0)).has_creases
