# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""An operator that cannot run says what to do first."""

from __future__ import annotations

import bpy
import pytest
from models import STRICT, add_surface, dome, saddle

LINES = ("trace_lines", "trace_through", "pick_lines", "find_umbilics", "hatch")
NEED_CLASSES = (
    *("select_class", "select_region", "assign_class", "merge_regions", "split_region"),
    *("outline", "separate", "deliver"),
)
NEED_A_MESH = ("analyze", "segment", "clear", *NEED_CLASSES, "export_lines", *LINES)
NEED_RESULTS = ("show", "export_report")
ALL = (*(name for name in NEED_A_MESH if name != "export_lines"), *NEED_RESULTS)


def _refusal(name: str) -> str:
    operator = getattr(bpy.ops.curvature, name)
    assert not operator.poll()
    with pytest.raises(RuntimeError) as refused:
        operator()
    return str(refused.value)


@pytest.mark.parametrize("name", NEED_A_MESH)
def test_mesh_is_asked_for(name: str) -> None:
    assert "failed, context is incorrect" not in _refusal(name)
    assert _refusal(name).rstrip().endswith("Select a mesh object")


@pytest.mark.parametrize("name", NEED_A_MESH)
@pytest.mark.parametrize("kind", ["curve", "light", "camera", "empty"])
def test_other_objects_are_no_mesh(name: str, kind: str) -> None:
    add = {
        "curve": bpy.ops.curve.primitive_bezier_circle_add,
        "light": bpy.ops.object.light_add,
        "camera": bpy.ops.object.camera_add,
        "empty": bpy.ops.object.empty_add,
    }
    add[kind]()
    assert _refusal(name).rstrip().endswith("Select a mesh object")


@pytest.mark.parametrize("name", NEED_A_MESH)
def test_mesh_that_is_not_selected_is_not_taken(name: str) -> None:
    add_surface(dome).select_set(False)
    assert _refusal(name).rstrip().endswith("Select a mesh object")


@pytest.mark.parametrize("name", ALL)
@pytest.mark.parametrize("mode", ["SCULPT", "VERTEX_PAINT", "WEIGHT_PAINT"])
def test_mode_is_asked_for(name: str, mode: str) -> None:
    add_surface(dome)
    bpy.ops.curvature.segment(**STRICT)
    bpy.ops.object.mode_set(mode=mode)
    assert _refusal(name).rstrip().endswith("Switch to Object or Edit Mode")


@pytest.mark.parametrize("name", NEED_RESULTS)
def test_results_are_asked_for(name: str) -> None:
    add_surface(dome)
    assert _refusal(name).rstrip().endswith("Analyze or segment a model first")


@pytest.mark.parametrize("name", NEED_CLASSES)
def test_classes_are_asked_for(name: str) -> None:
    add_surface(dome)
    bpy.ops.curvature.analyze()
    assert _refusal(name).rstrip().endswith("Segment the model first")


def test_lines_are_asked_for() -> None:
    add_surface(saddle, steps=32)
    assert _refusal("export_lines").rstrip().endswith("Trace curvature lines first")
    # Strokes are an illustration, which no drawing shows.
    bpy.ops.curvature.hatch(tone="CURVATURE", spacing=0.08)
    assert bpy.data.objects["Roof Hatching"].data.splines
    assert _refusal("export_lines").rstrip().endswith("Trace curvature lines first")


@pytest.mark.parametrize("name", ALL)
@pytest.mark.parametrize("mode", ["OBJECT", "EDIT"])
def test_everything_can_run_on_a_segmented_mesh(name: str, mode: str) -> None:
    add_surface(dome)
    bpy.ops.curvature.segment(**STRICT)
    bpy.ops.object.mode_set(mode=mode)
    assert getattr(bpy.ops.curvature, name).poll()
