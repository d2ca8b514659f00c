# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""One step back takes everything back, one step forward brings it again."""

from __future__ import annotations

import bpy
import pytest
from bpy.types import Object
from models import STRICT, add_surface, dome, own_attributes


def _roof() -> Object:
    return bpy.data.objects["Roof"]


@pytest.fixture(autouse=True)
def _steps() -> None:
    add_surface(dome)
    bpy.ops.ed.undo_push(message="Model")


def _segment() -> None:
    assert bpy.ops.curvature.segment(**STRICT) == {"FINISHED"}
    bpy.ops.ed.undo_push(message="Segment")


def test_undo_takes_the_results_away() -> None:
    _segment()
    bpy.ops.ed.undo()
    assert not own_attributes(_roof())
    assert not _roof().data.curvature.fingerprint
    assert bpy.context.scene.curvature.quantity == "NONE"


def test_redo_brings_the_results_back() -> None:
    _segment()
    before = own_attributes(_roof())
    bpy.ops.ed.undo()
    bpy.ops.ed.redo()
    assert own_attributes(_roof()) == before
    assert _roof().data.curvature.is_segmented
    assert bpy.context.scene.curvature.quantity == "CLASS"


def test_undo_of_clear_brings_the_results_back() -> None:
    _segment()
    before = own_attributes(_roof())
    bpy.ops.curvature.clear()
    bpy.ops.ed.undo_push(message="Clear")
    bpy.ops.ed.undo()
    assert own_attributes(_roof()) == before
    assert _roof().data.curvature.is_segmented


def test_undo_removes_the_copy_and_shows_the_source_again() -> None:
    _roof().modifiers.new("Subdivision", "SUBSURF").levels = 1
    bpy.ops.ed.undo_push(message="Modifier")
    _segment()
    assert "Roof Curvature" in bpy.data.objects
    bpy.ops.ed.undo()
    assert list(bpy.data.objects) == [_roof()]
    assert "Roof Curvature" not in bpy.data.collections
    assert not _roof().hide_get()


def test_results_can_be_made_again_after_undo() -> None:
    _segment()
    bpy.ops.ed.undo()
    _segment()
    assert _roof().data.curvature.is_segmented


@pytest.mark.parametrize(
    "name",
    ["analyze", "segment", "show", "clear", "select_class", "select_region", "outline"]
    + ["assign_class", "merge_regions", "split_region"],
)
def test_operator_that_changes_the_scene_is_one_undo_step(name: str) -> None:
    options = getattr(bpy.types, f"CURVATURE_OT_{name}").bl_options
    assert options == {"REGISTER", "UNDO"}
