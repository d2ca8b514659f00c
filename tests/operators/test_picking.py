# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Single lines are shown under the mouse and kept by a click; all but the mouse is tested here."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import bpy
import numpy as np
import pytest
from architectural_curvature.addon import steps
from architectural_curvature.addon.bridge.pointing import cast_ray
from architectural_curvature.addon.choices import line_plan
from architectural_curvature.addon.overlay import preview
from architectural_curvature.addon.tracing.picking import Picker, prepare_picker
from bpy.types import Object
from mathutils import Euler, Matrix, Vector
from models import RADIUS, add_surface, barrel, only_select, own_attributes


@pytest.fixture
def vault() -> Object:
    """A barrel vault along y that stands turned and stretched in the world."""
    obj = add_surface(barrel, "Vault")
    obj.matrix_world = Matrix.LocRotScale((5.0, 1.0, 0.0), Euler((0.0, 0.0, 0.5)), (2.0, 2.0, 2.0))
    bpy.context.view_layer.update()
    return obj


def _picker(obj: Object) -> Picker:
    return steps.complete(prepare_picker(bpy.context, obj, line_plan(bpy.context)))


def test_ray_meets_the_model(vault: Object) -> None:
    above = Vector((5.0, 1.0, 50.0))
    place = cast_ray(bpy.context, above, Vector((0.0, 0.0, -1.0)), vault)
    assert place is not None
    np.testing.assert_allclose(place, (5.0, 1.0, 2.0 * RADIUS), atol=1e-3)
    assert cast_ray(bpy.context, above, Vector((0.0, 0.0, 1.0)), vault) is None


def test_both_lines_run_through_the_place(vault: Object) -> None:
    picker = _picker(vault)
    place = np.array([5.0, 1.0, 2.0 * RADIUS])
    lines = picker.tracing(place)(lambda _share: None)
    assert sorted(lines.family.tolist()) == [1, 2]
    for points in picker.in_world(lines):
        assert np.linalg.norm(points - place, axis=1).min() < 0.15
    ruling = picker.in_world(lines)[lines.family.tolist().index(2)]
    np.testing.assert_allclose(np.ptp(ruling[:, 2]), 0.0, atol=0.01)


def test_looking_changes_nothing_and_keeping_adds_lines(vault: Object) -> None:
    picker = _picker(vault)
    lines = picker.tracing(np.array([5.0, 1.0, 4.0]))(lambda _share: None)
    assert not own_attributes(vault)
    assert list(bpy.data.objects) == [vault]
    picker.keep(bpy.context, lines)
    picker.keep(bpy.context, lines)
    assert len(bpy.data.objects["Vault Picked Lines 1"].data.splines) == 2
    assert len(bpy.data.objects["Vault Picked Lines 2"].data.splines) == 2
    assert "curvature_k1" in own_attributes(vault)
    bpy.ops.curvature.clear()
    assert list(bpy.data.objects) == [vault]


def test_tracing_lines_leaves_those_that_were_picked(vault: Object) -> None:
    picker = _picker(vault)
    picker.keep(bpy.context, picker.tracing(np.array([5.0, 1.0, 4.0]))(lambda _share: None))
    only_select(vault)
    bpy.ops.curvature.trace_lines(spacing=1.0)
    assert len(bpy.data.objects["Vault Picked Lines 1"].data.splines) == 1


def test_scripts_are_told_what_to_use(vault: Object, run: Callable[..., Any]) -> None:
    del vault
    result, text = run("pick_lines")
    assert result == {"CANCELLED"}
    assert text == "Error: Picking needs a 3D viewport: use Trace Through Points in scripts"


def test_active_mesh_is_asked_for(vault: Object) -> None:
    bpy.context.view_layer.objects.active = None
    with pytest.raises(RuntimeError, match="Make a mesh object the active one"):
        bpy.ops.curvature.pick_lines()
    vault.select_set(False)
    with pytest.raises(RuntimeError, match="Select a mesh object"):
        bpy.ops.curvature.pick_lines()


def test_preview_is_drawn_until_it_is_hidden() -> None:
    line = preview.PreviewLine(np.eye(3), True, (1.0, 0.0, 0.0, 1.0))
    preview.show([line])
    preview.show([line, line])
    assert preview.shown() == [line, line]
    preview.hide()
    preview.hide()
    assert preview.shown() == []


@pytest.mark.parametrize("is_closed", [True, False])
def test_preview_lines_are_lifted_towards_the_eye(is_closed: bool) -> None:
    eye = np.array([0.0, 0.0, 10.0])
    ends = preview.segments(preview.PreviewLine(np.eye(3), is_closed, (1.0, 0.0, 0.0, 1.0)), eye)
    assert len(ends) == (6 if is_closed else 4)
    before = np.linalg.norm(np.eye(3)[0] - eye)
    assert np.linalg.norm(ends[0] - eye) == pytest.approx(0.998 * before)
    np.testing.assert_array_equal(ends[1], ends[2])
