# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Evaluated geometry is analyzed; where its faces are other than the base mesh's, on a copy."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import bpy
import numpy as np
import pytest
from bpy.types import Object
from mathutils import Matrix
from models import (
    RADIUS,
    STRICT,
    add_surface,
    barrel,
    dome,
    only_select,
    own_attributes,
    plate,
    saddle,
    stored,
)


def _add_deformation(obj: Object) -> None:
    """Lift a plate to a barrel: its vertices keep their weights as heights."""
    lifts = obj.vertex_groups.new(name="Lift")
    for vertex in obj.data.vertices:
        rise = float(barrel(np.array(vertex.co.x), np.array(vertex.co.y))) - np.sqrt(RADIUS**2 - 1)
        lifts.add([vertex.index], rise, "REPLACE")
    modifier = obj.modifiers.new("Lift", "DISPLACE")
    modifier.direction, modifier.strength, modifier.mid_level = "Z", 1.0, 0.0
    modifier.vertex_group = "Lift"


def _add(kind: str, obj: Object) -> None:
    modifier = obj.modifiers.new(kind.title(), kind)
    if kind == "SUBSURF":
        modifier.levels = 1
    if kind == "MIRROR":
        modifier.use_axis = (False, False, True)
        modifier.use_mirror_merge = False
    if kind == "SOLIDIFY":
        modifier.thickness = 0.1


FACES = {"SUBSURF": lambda n: 4 * n, "MIRROR": lambda n: 2 * n, "SOLIDIFY": lambda n: 2 * n + 64}
"""Faces that each modifier makes of a grid of n = 16 x 16 quads; its rim has 64 edges."""


def _snapshot(obj: Object) -> tuple[object, ...]:
    """What must stay of a source."""
    return (
        obj.name,
        obj.data,
        [(modifier.name, modifier.type, modifier.show_viewport) for modifier in obj.modifiers],
        tuple(tuple(row) for row in obj.matrix_world),
        [tuple(vertex.co) for vertex in obj.data.vertices],
        own_attributes(obj),
        [slot.material for slot in obj.material_slots],
        list(obj.users_collection),
    )


def test_deformed_mesh_gets_the_results_itself() -> None:
    obj = add_surface(plate)
    _add_deformation(obj)
    bpy.ops.curvature.segment(**STRICT)
    assert list(bpy.data.objects) == [obj]
    assert (stored(obj, "curvature_class") == 1).all()
    radii = {row.surface_class: row.min_radius for row in obj.data.curvature.classes}
    assert radii["SINGLE"] == pytest.approx(RADIUS, rel=0.02)


def test_shape_keys_count() -> None:
    obj = add_surface(plate)
    obj.shape_key_add(name="Basis")
    key = obj.shape_key_add(name="Barrel")
    for point, vertex in zip(key.data, obj.data.vertices, strict=True):
        point.co.z = float(barrel(np.array(vertex.co.x), np.array(vertex.co.y)))
    key.value = 1.0
    bpy.ops.curvature.segment(**STRICT)
    assert list(bpy.data.objects) == [obj]
    assert (stored(obj, "curvature_class") == 1).all()


def test_hidden_modifier_does_not_count() -> None:
    obj = add_surface(plate)
    _add_deformation(obj)
    obj.modifiers["Lift"].show_viewport = False
    bpy.ops.curvature.segment(**STRICT)
    assert (stored(obj, "curvature_class") == 0).all()


@pytest.mark.parametrize("kind", FACES)
def test_other_faces_go_to_an_object_of_their_own(kind: str) -> None:
    obj = add_surface(dome)
    _add(kind, obj)
    bpy.ops.curvature.segment(**STRICT)
    copy = bpy.data.objects["Roof Curvature"]
    assert len(copy.data.polygons) == FACES[kind](256)
    assert len(stored(copy, "curvature_class")) == FACES[kind](256)
    assert not copy.modifiers
    assert list(copy.users_collection) == [bpy.data.collections["Roof Curvature"]]
    assert "Roof Curvature" in bpy.context.scene.collection.children


def test_copy_stands_where_the_source_stands() -> None:
    obj = add_surface(dome)
    obj.matrix_world = Matrix.Translation((5.0, 6.0, 7.0)) @ Matrix.Rotation(0.5, 4, "X")
    _add("SUBSURF", obj)
    bpy.context.view_layer.update()
    bpy.ops.curvature.segment(**STRICT)
    bpy.context.view_layer.update()
    copy = bpy.data.objects["Roof Curvature"]
    assert np.array(copy.matrix_world) == pytest.approx(np.array(obj.matrix_world))


@pytest.mark.parametrize("kind", FACES)
def test_source_is_not_touched(kind: str) -> None:
    obj = add_surface(dome)
    obj.data.materials.append(bpy.data.materials.new("Glass"))
    _add(kind, obj)
    before = _snapshot(obj)
    bpy.ops.curvature.segment(**STRICT)
    bpy.context.scene.curvature.use_material = True
    assert _snapshot(obj) == before


def test_copy_takes_the_selection_over_and_the_source_hides_behind_it() -> None:
    obj = add_surface(dome)
    _add("SUBSURF", obj)
    bpy.ops.curvature.segment(**STRICT)
    copy = bpy.data.objects["Roof Curvature"]
    assert bpy.context.selected_objects == [copy]
    assert bpy.context.view_layer.objects.active == copy
    assert obj.hide_get()


def test_second_run_replaces_its_own_output_and_nothing_else() -> None:
    obj = add_surface(dome)
    _add("SUBSURF", obj)
    other = add_surface(plate, "Roof Curvature.001")
    bystander = bpy.data.collections.new("Site")
    only_select(obj)
    bpy.ops.curvature.segment(**STRICT)
    copy = bpy.context.object
    obj.modifiers[0].levels = 2
    bpy.ops.curvature.segment(**STRICT)
    assert set(bpy.data.objects) == {obj, other, copy}
    assert len(copy.data.polygons) == 16 * 256
    assert set(bpy.data.meshes) == {obj.data, other.data, copy.data}
    assert set(bpy.data.collections) == {bystander, bpy.data.collections["Roof Curvature"]}


@pytest.mark.parametrize("selected", ["source", "copy", "both"])
def test_running_on_the_copy_analyzes_the_source(selected: str) -> None:
    obj = add_surface(saddle)
    _add("SUBSURF", obj)
    bpy.ops.curvature.segment(**STRICT)
    copy = bpy.context.object
    obj.hide_set(False)
    only_select(*{"source": [obj], "copy": [copy], "both": [obj, copy]}[selected])
    obj.modifiers[0].levels = 2
    bpy.ops.curvature.segment(**STRICT)
    assert set(bpy.data.objects) == {obj, copy}
    assert len(copy.data.polygons) == 16 * 256


def _hide(obj: Object) -> None:
    obj.hide_set(True)


def _disable(obj: Object) -> None:
    obj.hide_viewport = True


def _disable_collection(_obj: Object) -> None:
    bpy.data.collections["Models"].hide_viewport = True


def _hide_collection(_obj: Object) -> None:
    bpy.context.view_layer.layer_collection.children["Models"].hide_viewport = True


def _exclude(_obj: Object) -> None:
    bpy.context.view_layer.layer_collection.children["Models"].exclude = True


@pytest.mark.parametrize("hide", [_hide, _disable, _disable_collection, _hide_collection, _exclude])
def test_source_that_is_hidden_behind_its_copy_is_followed(hide: Callable[..., Any]) -> None:
    """Blender leaves disabled objects as they are: their modifiers' changes must be seen still."""
    obj = add_surface(dome)
    models = bpy.data.collections.new("Models")
    bpy.context.scene.collection.children.link(models)
    models.objects.link(obj)
    bpy.context.scene.collection.objects.unlink(obj)
    only_select(obj)
    _add("SUBSURF", obj)
    bpy.ops.curvature.segment(**STRICT)
    copy = bpy.context.object
    hide(obj)
    obj.modifiers[0].levels = 2
    only_select(copy)
    bpy.ops.curvature.segment(**STRICT)
    assert len(copy.data.polygons) == 16 * 256
    assert set(bpy.data.objects) == {obj, copy}


def test_results_return_to_the_source_when_its_modifier_goes() -> None:
    obj = add_surface(barrel)
    _add("SUBSURF", obj)
    bpy.ops.curvature.segment(**STRICT)
    obj.modifiers.clear()
    bpy.ops.curvature.segment(**STRICT)
    assert list(bpy.data.objects) == [obj]
    assert (stored(obj, "curvature_class") == 1).all()
    assert not obj.hide_get()
    assert "Roof Curvature" not in bpy.data.collections
