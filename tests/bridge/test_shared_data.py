# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes that several objects use, and meshes that a library owns."""

from __future__ import annotations

from pathlib import Path

import bpy
import pytest
from architectural_curvature.addon.bridge import display
from bpy.types import Object
from models import STRICT, add_object, add_surface, dome, only_select, own_attributes, stored


def _link_from_library(folder: Path) -> Object:
    """Link a dome from another file."""
    file = str(folder / "library.blend")
    add_surface(dome, "Dome")
    bpy.ops.wm.save_as_mainfile(filepath=file)
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    with bpy.data.libraries.load(file, link=True) as (_found, wanted):
        wanted.objects = ["Dome"]
    obj = bpy.data.objects["Dome"]
    bpy.context.scene.collection.objects.link(obj)
    obj.select_set(True)
    bpy.context.view_layer.objects.active = obj
    return obj


def test_shared_mesh_carries_one_set_of_results_and_says_so() -> None:
    one = add_surface(dome, "One")
    two = add_object("Two", one.data)
    two.location.x = 10.0
    assert bpy.ops.curvature.segment(**STRICT) == {"FINISHED"}
    assert one.data is two.data
    assert (stored(two, "curvature_class") == 2).all()
    texts = [warning.text for warning in one.data.curvature.warnings]
    assert texts == [
        "the mesh is shared by 2 objects: all show the results at the scale of this one"
    ]


def test_fake_user_does_not_count_as_sharing() -> None:
    obj = add_surface(dome)
    obj.data.use_fake_user = True
    bpy.ops.curvature.segment(**STRICT)
    assert not obj.data.curvature.warnings


def test_linked_mesh_gets_its_results_on_an_object_of_this_file(tmp_path: Path) -> None:
    obj = _link_from_library(tmp_path)
    assert bpy.ops.curvature.segment(**STRICT) == {"FINISHED"}
    copy = bpy.data.objects["Dome Curvature"]
    assert copy.library is None
    assert copy.data.library is None
    assert (stored(copy, "curvature_class") == 2).all()
    assert not own_attributes(obj)


def test_results_of_a_linked_mesh_can_be_cleared(tmp_path: Path) -> None:
    obj = _link_from_library(tmp_path)
    bpy.ops.curvature.segment(**STRICT)
    assert bpy.ops.curvature.clear() == {"FINISHED"}
    assert list(bpy.data.objects) == [obj]


def test_linked_mesh_of_a_local_object_is_not_written(tmp_path: Path) -> None:
    linked = _link_from_library(tmp_path)
    obj = add_object("Local", linked.data)
    linked.select_set(False)
    assert bpy.ops.curvature.segment(**STRICT) == {"FINISHED"}
    assert not own_attributes(obj)
    assert (stored(bpy.data.objects["Local Curvature"], "curvature_class") == 2).all()


def test_file_with_results_on_a_linked_mesh_can_be_saved_and_opened(tmp_path: Path) -> None:
    _link_from_library(tmp_path)
    bpy.ops.curvature.segment(**STRICT)
    file = str(tmp_path / "design.blend")
    bpy.ops.wm.save_as_mainfile(filepath=file)
    bpy.ops.wm.open_mainfile(filepath=file)
    copy = bpy.data.objects["Dome Curvature"]
    assert copy.curvature.source == bpy.data.objects["Dome"]
    assert copy.data.curvature.is_segmented


@pytest.mark.parametrize("count", [3, 5])
def test_every_mesh_is_analyzed_once_however_many_objects_use_it(count: int) -> None:
    first = add_surface(dome, "First")
    for number in range(count - 1):
        add_object(f"Copy {number}", first.data)
    bpy.ops.curvature.segment(**STRICT)
    assert f"shared by {count} objects" in first.data.curvature.warnings[0].text


@pytest.mark.parametrize("analyzed", ["One", "Two"])
def test_results_are_current_at_the_scale_of_the_object_they_were_made_for(analyzed: str) -> None:
    one = add_surface(dome, "One")
    two = add_object("Two", one.data)
    two.scale = (3.0, 3.0, 3.0)
    only_select(bpy.data.objects[analyzed])
    bpy.ops.curvature.segment(**STRICT)
    assert not display.changed_objects(bpy.context, bpy.context.scene)
    before = stored(one, "Mean Curvature")
    bpy.context.scene.curvature.color_map = "PURPLE_ORANGE"
    bpy.ops.curvature.show(quantity="MEAN")
    assert (stored(one, "Mean Curvature") != before).any()


def test_clearing_one_object_uncovers_all_that_share_its_mesh() -> None:
    one = add_surface(dome, "One")
    two = add_object("Two", one.data)
    bpy.ops.curvature.segment(**STRICT)
    bpy.context.scene.curvature.use_material = True
    only_select(one)
    bpy.ops.curvature.clear()
    assert not own_attributes(two)
    assert not one.material_slots
    assert not two.material_slots
