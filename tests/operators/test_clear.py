# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Clearing removes everything of ours, and nothing else."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import bpy
import pytest
from bpy.types import Object
from models import STRICT, add_surface, dome, only_select, own_attributes, saddle


def _state(obj: Object) -> tuple[object, ...]:
    return (
        sorted(attribute.name for attribute in obj.data.attributes),
        [slot.material for slot in obj.material_slots],
        list(obj.data.materials),
        obj.hide_get(),
        obj.select_get(),
        list(obj.users_collection),
        obj.data.curvature.fingerprint,
        obj.data.curvature.report,
        len(obj.data.curvature.classes),
        len(obj.data.curvature.warnings),
    )


@pytest.mark.parametrize("modifier", [None, "SUBSURF"])
@pytest.mark.parametrize("with_material", [False, True])
def test_everything_is_as_before_the_analysis(modifier: str | None, with_material: bool) -> None:
    obj = add_surface(dome)
    obj.data.attributes.new("mine", "FLOAT", "POINT")
    if modifier:
        obj.modifiers.new("Modifier", modifier)
    before = _state(obj)
    objects, meshes = set(bpy.data.objects), set(bpy.data.meshes)
    collections = set(bpy.data.collections)
    bpy.ops.curvature.segment(**STRICT)
    for quantity in ("GAUSSIAN", "MEAN", "K1", "K2", "REGION"):
        bpy.ops.curvature.show(quantity=quantity)
    bpy.context.scene.curvature.use_material = with_material
    assert bpy.ops.curvature.clear() == {"FINISHED"}
    assert _state(obj) == before
    assert set(bpy.data.objects) == objects
    assert set(bpy.data.meshes) == meshes
    assert set(bpy.data.collections) == collections
    assert bpy.context.view_layer.objects.active == obj


def test_other_models_keep_their_results() -> None:
    one, two = add_surface(dome, "One"), add_surface(saddle, "Two")
    bpy.ops.curvature.segment(**STRICT)
    before = own_attributes(two)
    only_select(one)
    bpy.ops.curvature.clear()
    assert not own_attributes(one)
    assert own_attributes(two) == before
    assert two.data.curvature.is_segmented


def test_objects_of_the_user_in_our_collection_stay() -> None:
    obj = add_surface(dome)
    obj.modifiers.new("Subdivision", "SUBSURF")
    bpy.ops.curvature.segment(**STRICT)
    guest = bpy.data.objects.new("Guest", None)
    bpy.data.collections["Roof Curvature"].objects.link(guest)
    bpy.ops.curvature.clear()
    assert list(bpy.data.collections["Roof Curvature"].objects) == [guest]


def test_number_of_models_is_reported(run: Callable[..., Any]) -> None:
    add_surface(dome, "One")
    add_surface(dome, "Two")
    bpy.ops.curvature.segment(**STRICT)
    assert run("clear") == ({"FINISHED"}, "Info: Cleared 2 models")


def test_nothing_to_clear_is_said_and_makes_no_undo_step(run: Callable[..., Any]) -> None:
    add_surface(dome)
    assert run("clear") == (
        {"CANCELLED"},
        "Info: The selected meshes have no curvature results",
    )


def test_source_that_was_renamed_is_cleared_too() -> None:
    obj = add_surface(dome)
    obj.modifiers.new("Subdivision", "SUBSURF")
    bpy.ops.curvature.segment(**STRICT)
    obj.name = "Canopy"
    bpy.ops.curvature.clear()
    assert list(bpy.data.objects) == [obj]
    assert not bpy.data.collections
