# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators work on all selected objects, from Object and Edit Mode, and leave the mode."""

from __future__ import annotations

import bpy
import pytest
from bpy.types import Object
from models import (
    STRICT,
    add_object,
    add_surface,
    barrel,
    dome,
    only_select,
    own_attributes,
    saddle,
    stored,
)

CALLS = {
    "analyze": {},
    "segment": STRICT,
    "show": {"quantity": "MEAN"},
    "select_class": {"surface_class": "ELLIPTIC"},
    "clear": {},
}


def _three_models() -> list[Object]:
    return [add_surface(dome, "Dome"), add_surface(barrel, "Barrel"), add_surface(saddle, "Saddle")]


def _edit() -> None:
    bpy.ops.object.mode_set(mode="EDIT")


def _leave() -> None:
    bpy.ops.object.mode_set(mode="OBJECT")


@pytest.mark.parametrize("mode", ["OBJECT", "EDIT"])
def test_every_selected_object_is_segmented(mode: str) -> None:
    models = _three_models()
    bpy.ops.object.mode_set(mode=mode)
    assert bpy.ops.curvature.segment(**STRICT) == {"FINISHED"}
    _leave()
    classes = [set(stored(obj, "curvature_class").tolist()) for obj in models]
    assert classes == [{2}, {1}, {3}]


def test_other_objects_are_left_alone() -> None:
    bystander = add_surface(dome, "Bystander")
    obj = add_surface(dome)
    only_select(obj)
    bpy.ops.curvature.segment(**STRICT)
    assert not bystander.data.curvature.fingerprint
    assert not own_attributes(bystander)


def test_object_in_edit_mode_is_taken_though_it_is_not_selected() -> None:
    obj = add_surface(dome)
    _edit()
    obj.select_set(False)
    assert bpy.ops.curvature.segment(**STRICT) == {"FINISHED"}
    assert obj.mode == "EDIT"
    _leave()
    assert (stored(obj, "curvature_class") == 2).all()


@pytest.mark.parametrize("name", CALLS)
def test_edit_mode_is_kept_on_all_objects(name: str) -> None:
    models = _three_models()
    bpy.ops.curvature.segment(**STRICT)
    _edit()
    assert getattr(bpy.ops.curvature, name)(**CALLS[name]) == {"FINISHED"}
    assert [obj.mode for obj in models] == ["EDIT"] * 3
    assert bpy.context.view_layer.objects.active == models[-1]


@pytest.mark.parametrize("name", CALLS)
def test_object_mode_and_selection_are_kept(name: str) -> None:
    models = _three_models()
    bpy.ops.curvature.segment(**STRICT)
    assert getattr(bpy.ops.curvature, name)(**CALLS[name]) == {"FINISHED"}
    assert [obj.mode for obj in models] == ["OBJECT"] * 3
    assert set(bpy.context.selected_objects) == set(models)


def test_edits_are_seen_without_leaving_edit_mode() -> None:
    """The mesh of Edit Mode is ahead of the object's: it must be analyzed, not the old one."""
    obj = add_surface(dome)
    _edit()
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.transform.resize(value=(1.0, 1.0, 0.0))
    bpy.ops.curvature.segment(**STRICT)
    _leave()
    assert (stored(obj, "curvature_class") == 0).all()


def test_refused_run_keeps_edit_mode() -> None:
    obj = add_surface(dome)
    obj.scale = (1.0, 1.0, 0.0)
    bpy.context.view_layer.update()
    _edit()
    with pytest.raises(RuntimeError):
        bpy.ops.curvature.segment(**STRICT)
    assert obj.mode == "EDIT"


def test_edit_mode_with_a_modifier_that_changes_the_faces() -> None:
    obj = add_surface(dome)
    obj.modifiers.new("Subdivision", "SUBSURF").levels = 1
    _edit()
    assert bpy.ops.curvature.segment(**STRICT) == {"FINISHED"}
    _leave()
    copy = bpy.data.objects["Roof Curvature"]
    assert len(stored(copy, "curvature_class")) == 4 * 256


def test_shared_mesh_is_segmented_from_edit_mode() -> None:
    one = add_surface(dome, "One")
    two = add_object("Two", one.data)
    _edit()
    assert bpy.ops.curvature.segment(**STRICT) == {"FINISHED"}
    _leave()
    assert (stored(two, "curvature_class") == 2).all()
