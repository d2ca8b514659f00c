# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Faces keep the class, and regions the shape, that users gave them by hand."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import bmesh
import bpy
import numpy as np
import pytest
from bpy.types import Object
from models import (
    STRICT,
    add_folded_roof,
    add_surface,
    deselect_all,
    only_select,
    own_attributes,
    plate,
    stored,
)

WIDER = {"panel_size": 1.1, "deviation": 0.01}


def select(obj: Object, wanted: np.ndarray) -> None:
    """Select faces, and nothing else, in Object Mode."""
    deselect_all(obj)
    obj.data.polygons.foreach_set("select", wanted)


def left(obj: Object, limit: float = 0.0) -> np.ndarray:
    """Return which faces lie left of a place."""
    centers = np.empty(3 * len(obj.data.polygons), dtype=np.float32)
    obj.data.polygons.foreach_get("center", centers)
    return centers.reshape(-1, 3)[:, 0] < limit


@pytest.fixture
def roof() -> Object:
    """A flat roof, segmented: one region."""
    obj = add_surface(plate)
    bpy.ops.curvature.segment(**STRICT)
    assert set(stored(obj, "curvature_region")) == {0}
    return obj


@pytest.mark.parametrize("mode", ["OBJECT", "EDIT"])
def test_assigned_faces_keep_their_class_in_later_runs(
    roof: Object, mode: str, run: Callable[..., Any]
) -> None:
    wanted = left(roof)
    select(roof, wanted)
    bpy.ops.object.mode_set(mode=mode)
    result, report = run("assign_class", surface_class="ELLIPTIC")
    assert result == {"FINISHED"}
    assert report.startswith("Info: Assigned Double-Curved, Dome to 128 faces of Roof: flat 50.0 %")
    assert roof.mode == mode
    bpy.ops.object.mode_set(mode="OBJECT")
    for again in (False, True):
        if again:
            bpy.ops.curvature.segment(**WIDER)
        assert (stored(roof, "curvature_class")[wanted] == 2).all()
        assert (stored(roof, "curvature_class")[~wanted] == 0).all()
    assert own_attributes(roof)["curvature_locked"] == ("FACE", "INT")
    assert (stored(roof, "curvature_locked") == np.where(wanted, 2, -1)).all()


def test_edit_uses_the_settings_of_the_segmentation_and_shows_classes(roof: Object) -> None:
    bpy.ops.curvature.show(quantity="MEAN")
    select(roof, left(roof))
    bpy.ops.curvature.assign_class(surface_class="SINGLE")
    assert roof.data.curvature.panel_size == pytest.approx(STRICT["panel_size"])
    assert bpy.context.scene.curvature.quantity == "CLASS"
    assert roof.data.color_attributes.active_color_name == "Curvature Class"


def test_freed_faces_are_segmented_as_before(roof: Object, run: Callable[..., Any]) -> None:
    select(roof, left(roof))
    bpy.ops.curvature.assign_class(surface_class="SINGLE")
    result, report = run("assign_class", surface_class="UNDEFINED")
    assert (result, report.split(":")[1]) == ({"FINISHED"}, " Freed 128 faces of Roof")
    assert (stored(roof, "curvature_class") == 0).all()
    assert "curvature_locked" not in roof.data.attributes


def test_selected_faces_are_split_off_and_merged_again(roof: Object) -> None:
    wanted = left(roof)
    select(roof, wanted)
    assert bpy.ops.curvature.split_region() == {"FINISHED"}
    bpy.ops.curvature.segment(**WIDER)
    regions = stored(roof, "curvature_region")
    assert len(set(regions[wanted])) == len(set(regions[~wanted])) == 1
    assert regions[wanted][0] != regions[~wanted][0]
    assert (stored(roof, "curvature_class") == 0).all()
    assert own_attributes(roof)["curvature_cut"] == ("FACE", "INT")
    select(roof, np.ones(len(wanted), dtype=bool))
    assert bpy.ops.curvature.merge_regions() == {"FINISHED"}
    assert set(stored(roof, "curvature_region")) == {0}
    assert "curvature_cut" not in roof.data.attributes


def test_merged_regions_take_the_class_that_covers_most(roof: Object) -> None:
    select(roof, left(roof, -0.5))
    bpy.ops.curvature.assign_class(surface_class="HYPERBOLIC")
    assert roof.data.curvature.region_count == 2
    # One face of either is enough.
    wanted = np.zeros(len(roof.data.polygons), dtype=bool)
    wanted[[0, -1]] = True
    select(roof, wanted)
    bpy.ops.curvature.merge_regions()
    bpy.ops.curvature.segment(**WIDER)
    assert roof.data.curvature.region_count == 1
    assert (stored(roof, "curvature_class") == 0).all()


def test_regions_at_a_crease_stay_apart_and_that_is_said(run: Callable[..., Any]) -> None:
    obj = add_folded_roof()
    bpy.ops.curvature.segment(**STRICT)
    select(obj, np.ones(len(obj.data.polygons), dtype=bool))
    result, report = run("merge_regions")
    assert result == {"FINISHED"}
    assert report.startswith("Warning: Merged 2 regions of Fold")
    assert "meet at a crease, stay apart" in report


@pytest.mark.parametrize("name", ["assign_class", "merge_regions", "split_region"])
def test_without_selected_faces_nothing_happens(
    roof: Object, name: str, run: Callable[..., Any]
) -> None:
    deselect_all(roof)
    before = own_attributes(roof)
    result, report = run(name)
    assert result == {"CANCELLED"}
    assert report.startswith("Error: Select faces first")
    assert own_attributes(roof) == before


@pytest.mark.parametrize(
    ("name", "sentence"),
    [("merge_regions", "at least two regions"), ("split_region", "but not all of them")],
)
def test_selection_that_changes_nothing_is_refused(
    roof: Object, name: str, sentence: str, run: Callable[..., Any]
) -> None:
    select(roof, np.ones(len(roof.data.polygons), dtype=bool))
    result, report = run(name)
    assert result == {"CANCELLED"}
    assert sentence in report


def test_edits_take_part_in_several_objects_at_once() -> None:
    models = [add_surface(plate, name) for name in ("A", "B", "C")]
    bpy.ops.curvature.segment(**STRICT)
    for obj in models[:2]:
        select(obj, left(obj))
    deselect_all(models[2])
    only_select(*models)
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.curvature.assign_class(surface_class="SINGLE")
    assert [obj.mode for obj in models] == ["EDIT"] * 3
    bpy.ops.object.mode_set(mode="OBJECT")
    counts = [int((stored(obj, "curvature_class") == 1).sum()) for obj in models]
    assert counts == [128, 128, 0]


def test_edits_hold_on_the_copy_that_carries_the_results() -> None:
    obj = add_surface(plate)
    obj.modifiers.new("Array", "ARRAY")
    bpy.ops.curvature.segment(**STRICT)
    copy = bpy.data.objects["Roof Curvature"]
    wanted = left(copy, 0.0)
    select(copy, wanted)
    bpy.ops.curvature.assign_class(surface_class="ELLIPTIC")
    assert (stored(copy, "curvature_class")[wanted] == 2).all()
    # The copy is made anew where the source changes; its faces stay the same ones.
    obj.data.vertices[0].co.z += 0.01
    obj.data.update()
    bpy.ops.curvature.segment(**STRICT)
    copy = bpy.data.objects["Roof Curvature"]
    assert (stored(copy, "curvature_class")[wanted] == 2).all()
    assert "curvature_locked" not in obj.data.attributes


def test_moved_vertices_keep_edits_and_new_faces_drop_them_with_a_warning(roof: Object) -> None:
    wanted = left(roof)
    select(roof, wanted)
    bpy.ops.curvature.assign_class(surface_class="SINGLE")
    select(roof, left(roof, -0.5))
    bpy.ops.curvature.split_region()
    roof.data.vertices[5].co.z += 0.001
    roof.data.update()
    bpy.ops.curvature.analyze()
    bpy.ops.curvature.segment(**STRICT)
    assert (stored(roof, "curvature_class")[wanted] == 1).all()
    mesh = bmesh.new()
    mesh.from_mesh(roof.data)
    mesh.faces.ensure_lookup_table()
    bmesh.ops.delete(mesh, geom=[mesh.faces[0]], context="FACES")
    mesh.to_mesh(roof.data)
    mesh.free()
    bpy.ops.curvature.segment(**STRICT)
    assert not {"curvature_locked", "curvature_cut"} & own_attributes(roof).keys()
    warnings = [warning.text for warning in roof.data.curvature.warnings]
    assert any("classes given by hand and splits were dropped" in text for text in warnings)
    bpy.ops.curvature.segment(**STRICT)
    assert not any("dropped" in warning.text for warning in roof.data.curvature.warnings)


def test_faces_that_changed_since_are_not_edited(roof: Object, run: Callable[..., Any]) -> None:
    mesh = bmesh.new()
    mesh.from_mesh(roof.data)
    mesh.faces.ensure_lookup_table()
    bmesh.ops.delete(mesh, geom=[mesh.faces[0]], context="FACES")
    mesh.to_mesh(roof.data)
    mesh.free()
    select(roof, left(roof))
    result, report = run("assign_class", surface_class="SINGLE")
    assert result == {"CANCELLED"}
    assert "the faces have changed: press Segment first" in report


def test_edits_and_names_are_saved_with_the_file(roof: Object, tmp_path: Path) -> None:
    wanted = left(roof)
    select(roof, wanted)
    bpy.ops.curvature.assign_class(surface_class="SINGLE")
    roof.data.curvature.regions[0].name = "Entrance"
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "roof.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "roof.blend"))
    roof = bpy.data.objects["Roof"]
    bpy.ops.curvature.segment(**WIDER)
    assert (stored(roof, "curvature_class")[wanted] == 1).all()
    assert roof.data.curvature.regions[0].name == "Entrance"


@pytest.mark.parametrize("name", ["assign_class", "split_region"])
def test_edit_is_undone(roof: Object, name: str) -> None:
    select(roof, left(roof))
    bpy.ops.ed.undo_push(message="Select")
    before = stored(roof, "curvature_class").tolist(), stored(roof, "curvature_region").tolist()
    getattr(bpy.ops.curvature, name)(**({"surface_class": "SINGLE"} if "class" in name else {}))
    bpy.ops.ed.undo_push(message="Edit")
    bpy.ops.ed.undo()
    roof = bpy.data.objects["Roof"]
    found = stored(roof, "curvature_class").tolist(), stored(roof, "curvature_region").tolist()
    assert found == before
    assert not {"curvature_locked", "curvature_cut"} & own_attributes(roof).keys()


def test_clear_removes_edits(roof: Object) -> None:
    select(roof, left(roof))
    bpy.ops.curvature.split_region()
    bpy.ops.curvature.assign_class(surface_class="SINGLE")
    bpy.ops.curvature.clear()
    assert not own_attributes(roof)
    bpy.ops.curvature.segment(**STRICT)
    assert set(stored(roof, "curvature_class")) == {0}
    assert roof.data.curvature.region_count == 1
