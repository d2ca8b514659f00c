# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Results mean the building as it stands in the world, whatever its object's transform."""

from __future__ import annotations

import bpy
import numpy as np
import pytest
from bpy.types import Object
from mathutils import Euler, Matrix
from models import STRICT, add_surface, barrel, dome, only_select, saddle, stored

VALUES = ("curvature_gaussian", "curvature_mean", "curvature_k1", "curvature_k2")
TURN = Euler((0.3, -0.7, 1.1)).to_matrix().to_4x4()

# Coordinates of a mesh 2 units wide are off by 1e-7, as float32 is; over edges h = 1/8 long that is
# 1e-7 / h² in curvature, times the norm of the weights of a second difference of fourth order, and
# k is 1/2. At rims the difference is one-sided: its weights are 35/12, -26/3, 19/2, -14/3, 11/12.
ROUNDING = 1e-7 * 8**2 * float(np.linalg.norm([35 / 12, -26 / 3, 19 / 2, -14 / 3, 11 / 12])) / 0.5


def _analyzed(obj: Object) -> Object:
    bpy.context.view_layer.update()
    only_select(obj)
    assert bpy.ops.curvature.segment(**STRICT) == {"FINISHED"}
    return obj


def _assert_same_values(obj: Object, expected: Object) -> None:
    size = float(np.abs(stored(expected, "curvature_k1")).max())
    for name in VALUES:
        scale = size**2 if name == "curvature_gaussian" else size
        assert stored(obj, name) / scale == pytest.approx(
            stored(expected, name) / scale, abs=ROUNDING
        )


def _applied(matrix: Matrix) -> Object:
    """The saddle with the transform applied to its vertices instead of its object."""
    obj = add_surface(saddle, "Applied")
    obj.data.transform(matrix)
    return _analyzed(obj)


@pytest.mark.parametrize("scale", [(2, 2, 2), (1, 2, 0.5), (0.01, 0.01, 0.01)])
def test_object_scale_counts_like_applied_scale(scale: tuple[float, float, float]) -> None:
    matrix = Matrix.Diagonal((*scale, 1.0))
    obj = add_surface(saddle)
    obj.scale = scale
    _analyzed(obj)
    applied = _applied(matrix)
    _assert_same_values(obj, applied)
    assert stored(obj, "curvature_class").tolist() == stored(applied, "curvature_class").tolist()


def test_turned_and_moved_object_has_the_same_results() -> None:
    obj = _analyzed(add_surface(saddle))
    moved = add_surface(saddle, "Moved")
    moved.matrix_world = Matrix.Translation((1e4, -2e4, 500.0)) @ TURN
    _analyzed(moved)
    _assert_same_values(moved, obj)
    for name in ("curvature_direction_1", "curvature_direction_2"):
        # A direction has no sign.
        along = np.einsum("ij,ij->i", stored(moved, name), stored(obj, name))
        assert np.abs(along) == pytest.approx(1.0, abs=ROUNDING)


def test_mirrored_object_stays_convex_outside() -> None:
    """Blender keeps the normals of a mirrored object outside: a dome is still a dome."""
    obj = add_surface(dome)
    obj.scale = (-1.0, 1.0, 1.0)
    _analyzed(obj)
    assert (stored(obj, "curvature_mean") > 0.4).all()


def test_sheared_object_counts_like_its_applied_shape() -> None:
    parent = bpy.data.objects.new("Parent", None)
    bpy.context.scene.collection.objects.link(parent)
    parent.scale = (1.0, 3.0, 1.0)
    obj = add_surface(saddle)
    obj.parent = parent
    obj.rotation_euler = (0.0, 0.0, 0.6)
    _analyzed(obj)
    # An object of its own cannot be sheared: only its mesh can.
    applied = _applied(obj.matrix_world.copy())
    _assert_same_values(obj, applied)


@pytest.mark.parametrize("scale_length", [0.001, 0.01, 0.3048, 1000.0])
def test_unit_of_the_scene_gives_radii_in_meters(scale_length: float) -> None:
    """A barrel of radius 2 m, modeled in millimeters, centimeters, feet or kilometers."""
    bpy.context.scene.unit_settings.scale_length = scale_length
    obj = add_surface(barrel)
    obj.data.transform(Matrix.Scale(1.0 / scale_length, 4))
    _analyzed(obj)
    assert (stored(obj, "curvature_class") == 1).all()
    # The grid's edges are h = 1/8 long: the fit over two rings is off by about (2 h / R)².
    assert stored(obj, "curvature_k1") == pytest.approx(0.5, rel=(2 / 8 / 2.0) ** 2)
    areas = {row.surface_class: row.area for row in obj.data.curvature.classes}
    # The arc over a chord of 2 is 2 R asin(1/R); the barrel is 2 long.
    assert areas["SINGLE"] == pytest.approx(4.0 * np.pi / 6.0 * 2.0, rel=1e-3)


def test_mesh_far_from_its_origin_has_the_same_classes() -> None:
    obj = add_surface(dome)
    obj.data.transform(Matrix.Translation((1000.0, 2000.0, 0.0)))
    _analyzed(obj)
    assert (stored(obj, "curvature_class") == 2).all()


def test_mesh_so_far_that_its_coordinates_are_rounded_is_warned_of() -> None:
    obj = add_surface(dome)
    obj.data.transform(Matrix.Translation((1e5, 0.0, 0.0)))
    _analyzed(obj)
    texts = [warning.text for warning in obj.data.curvature.warnings]
    assert any("far from the origin" in text for text in texts)


def test_object_of_zero_scale_is_refused_and_not_changed() -> None:
    obj = add_surface(dome)
    obj.scale = (1.0, 1.0, 0.0)
    bpy.context.view_layer.update()
    with pytest.raises(RuntimeError, match="scale of the object is zero along an axis"):
        bpy.ops.curvature.analyze()
    assert not obj.data.curvature.fingerprint
