# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Nothing is averaged across a crease, and the colors show it."""

from __future__ import annotations

import bpy
import numpy as np
import pytest
from bpy.types import Object
from models import RADIUS, STRICT, Array, add_folded_roof, add_surface, barrel, saddle, stored


def _rows_at_fold(obj: Object) -> tuple[np.ndarray, np.ndarray]:
    """Corners at x = 0 of faces left and right of it."""
    left, right = [], []
    for polygon in obj.data.polygons:
        for corner in polygon.loop_indices:
            if abs(obj.data.vertices[obj.data.loops[corner].vertex_index].co.x) < 1e-6:
                (left if polygon.center.x < 0 else right).append(corner)
    return np.array(left), np.array(right)


def _mark_middle(obj: Object) -> None:
    for edge in obj.data.edges:
        ends = [obj.data.vertices[vertex].co for vertex in edge.vertices]
        edge.use_edge_sharp = all(abs(end.x) < 1e-6 for end in ends)


def _half_barrel(x: Array, _y: Array) -> Array:
    """A barrel left of the middle, upright there; a flat roof at right angles right of it."""
    return np.where(x < 0.0, np.sqrt(np.maximum(1.0 - x**2, 0.0)), 1.0 - 2.0 * x)


def test_two_flat_sides_of_a_fold_are_flat() -> None:
    obj = add_folded_roof()
    bpy.ops.curvature.segment(**STRICT)
    assert (stored(obj, "curvature_class") == 0).all()
    assert not stored(obj, "curvature_k1").any()
    assert sorted(set(stored(obj, "curvature_region").tolist())) == [0, 1]


def test_color_on_each_side_is_that_of_the_side() -> None:
    obj = add_surface(_half_barrel)
    bpy.ops.curvature.segment(**STRICT)
    bpy.ops.curvature.show(quantity="MEAN")
    colors = stored(obj, "Mean Curvature")
    left, right = _rows_at_fold(obj)
    # The flat side has the color of zero, which white, gray or black is; the barrel's is vivid.
    assert np.ptp(colors[right, :3], axis=1) == pytest.approx(0.0, abs=0.02)
    assert (np.ptp(colors[left, :3], axis=1) > 0.1).all()


def test_class_colors_change_sharply_at_the_border() -> None:
    obj = add_surface(_half_barrel)
    bpy.ops.curvature.segment(**STRICT)
    colors = stored(obj, "Curvature Class")
    for polygon, surface_class in zip(
        obj.data.polygons, stored(obj, "curvature_class"), strict=True
    ):
        name = ("flat", "single", "elliptic", "hyperbolic")[surface_class]
        expected = (*getattr(bpy.context.scene.curvature, f"color_{name}"), 1.0)
        for corner in polygon.loop_indices:
            assert colors[corner] == pytest.approx(expected, abs=1e-6)


def test_crease_angle_decides_what_is_a_crease() -> None:
    obj = add_surface(lambda x, _y: -0.5 * np.abs(x))
    fold = 2.0 * np.arctan(0.5)
    bpy.ops.curvature.segment(**STRICT, crease_angle=fold - 0.01)
    assert not stored(obj, "curvature_k1").any()
    bpy.ops.curvature.segment(**STRICT, crease_angle=fold + 0.01)
    assert stored(obj, "curvature_k1").max() > 1.0 / RADIUS


def test_marked_edge_separates_regions() -> None:
    obj = add_surface(barrel)
    _mark_middle(obj)
    bpy.ops.curvature.segment(**STRICT)
    regions = stored(obj, "curvature_region")
    centers = np.array([polygon.center.x for polygon in obj.data.polygons])
    assert len(set(regions[centers < 0])) == len(set(regions[centers > 0])) == 1
    assert regions[centers < 0][0] != regions[centers > 0][0]


def test_marking_an_edge_barely_changes_the_values_of_a_smooth_surface() -> None:
    """Each side is measured on its own, like a rim: worse than inside, but no artifact."""
    obj = add_surface(saddle)
    bpy.ops.curvature.analyze()
    before = stored(obj, "curvature_k1")
    _mark_middle(obj)
    bpy.ops.curvature.analyze()
    assert stored(obj, "curvature_k1") == pytest.approx(before, abs=0.05 / RADIUS)
