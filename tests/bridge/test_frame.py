# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lengths in meters from an object's coordinates: S of M = R S, times the scene's unit."""

from __future__ import annotations

import bpy
import numpy as np
import pytest
from architectural_curvature.addon.bridge.frame import meters_from_object
from architectural_curvature.addon.geometry.errors import InvalidMeshError
from mathutils import Euler, Matrix
from models import add_surface, dome

TURN = Euler((0.3, -0.7, 1.1)).to_matrix().to_4x4()

SHEAR = Matrix(((1, 0.5, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1)))

PLACEMENTS = {
    "as modeled": Matrix.Identity(4),
    "moved": Matrix.Translation((100.0, -20.0, 3.0)),
    "turned": TURN,
    "scaled": Matrix.Scale(2.5, 4),
    "stretched": Matrix.Diagonal((1.0, 2.0, 0.5, 1.0)),
    "turned and stretched": TURN @ Matrix.Diagonal((1.0, 2.0, 0.5, 1.0)),
    "mirrored": Matrix.Diagonal((-1.0, 1.0, 1.0, 1.0)),
    "sheared": SHEAR,
    "turned and sheared": TURN @ SHEAR,
}


def _matrix_in_meters(world: Matrix) -> np.ndarray:
    parent = bpy.data.objects.new("Parent", None)
    bpy.context.scene.collection.objects.link(parent)
    obj = add_surface(dome, steps=1)
    obj.parent = parent
    # Any matrix can stand here; an object's own location, rotation and scale cannot shear it.
    obj.matrix_parent_inverse = world
    bpy.context.view_layer.update()
    return meters_from_object(obj, bpy.context.scene)


@pytest.mark.parametrize("placement", PLACEMENTS)
def test_distances_are_those_in_the_world(placement: str) -> None:
    world = PLACEMENTS[placement]
    vectors = np.random.default_rng(7).normal(size=(20, 3))
    expected = np.linalg.norm(vectors @ np.array(world.to_3x3()).T, axis=1)
    lengths = np.linalg.norm(vectors @ _matrix_in_meters(world), axis=1)
    # Blender keeps matrices with 24 bits.
    assert lengths == pytest.approx(expected, rel=1e-6)


@pytest.mark.parametrize("placement", PLACEMENTS)
def test_matrix_neither_turns_nor_mirrors(placement: str) -> None:
    matrix = _matrix_in_meters(PLACEMENTS[placement])
    assert matrix == pytest.approx(matrix.T, abs=1e-12)
    assert np.linalg.eigvalsh(matrix).min() > 0.0


def test_unit_of_the_scene_multiplies() -> None:
    bpy.context.scene.unit_settings.scale_length = 0.001
    matrix = _matrix_in_meters(Matrix.Scale(2.0, 4))
    assert matrix == pytest.approx(0.002 * np.eye(3), rel=1e-6)


def test_scale_of_parents_multiplies() -> None:
    parent = bpy.data.objects.new("Parent", None)
    bpy.context.scene.collection.objects.link(parent)
    parent.scale = (2.0, 2.0, 2.0)
    obj = add_surface(dome, steps=1)
    obj.parent = parent
    obj.scale = (1.0, 3.0, 1.0)
    bpy.context.view_layer.update()
    assert meters_from_object(obj, bpy.context.scene) == pytest.approx(
        np.diag([2.0, 6.0, 2.0]), rel=1e-6
    )


@pytest.mark.parametrize("scale", [(1, 1, 0), (0, 1, 1), (0, 0, 0)])
def test_scale_of_zero_is_refused_in_words(scale: tuple[int, int, int]) -> None:
    with pytest.raises(InvalidMeshError, match="scale of the object is zero along an axis"):
        _matrix_in_meters(Matrix.Diagonal((*scale, 1)))
