# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Results of an earlier shape are told from those of the present one."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import bpy
import pytest
from architectural_curvature.addon.bridge import display
from bpy.types import Object
from models import STRICT, add_surface, dome, own_attributes, saddle, stored


def _move_vertex(obj: Object) -> None:
    obj.data.vertices[0].co.z += 0.01
    obj.data.update()


def _add_faces(_obj: Object) -> None:
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.mesh.subdivide()
    bpy.ops.object.mode_set(mode="OBJECT")


def _mark_sharp(obj: Object) -> None:
    obj.data.edges[100].use_edge_sharp = True


def _scale(obj: Object) -> None:
    obj.scale = (1.0, 1.0, 2.0)
    bpy.context.view_layer.update()


def _change_unit(_obj: Object) -> None:
    bpy.context.scene.unit_settings.scale_length = 0.001


def _deform(obj: Object) -> None:
    obj.modifiers.new("Cast", "CAST").factor = 0.5


CHANGES = [_move_vertex, _add_faces, _mark_sharp, _scale, _change_unit, _deform]


def _changed() -> list[Object]:
    bpy.context.view_layer.update()
    return display.changed_objects(bpy.context, bpy.context.scene)


@pytest.fixture
def roof() -> Object:
    """A segmented dome."""
    obj = add_surface(dome)
    bpy.ops.curvature.segment(**STRICT)
    return obj


def test_results_of_an_unchanged_model_are_current(roof: Object) -> None:
    roof.location = (3.0, 4.0, 5.0)
    roof.rotation_euler = (0.0, 0.0, math.pi / 3.0)
    bpy.ops.object.select_all(action="DESELECT")
    roof.data.materials.append(bpy.data.materials.new("Glass"))
    assert not _changed()


@pytest.mark.parametrize("change", CHANGES, ids=lambda change: change.__name__.strip("_"))
def test_changed_shape_is_noticed(roof: Object, change: Callable[..., Any]) -> None:
    change(roof)
    assert _changed() == [roof]


@pytest.mark.parametrize("change", CHANGES, ids=lambda change: change.__name__.strip("_"))
def test_analysis_of_a_changed_model_drops_its_old_classes(
    roof: Object, change: Callable[..., Any]
) -> None:
    change(roof)
    bpy.ops.curvature.analyze()
    assert not roof.data.curvature.is_segmented
    assert not len(roof.data.curvature.classes)
    assert "curvature_class" not in own_attributes(roof)
    assert "curvature_region" not in own_attributes(roof)
    assert "Curvature Class" not in own_attributes(roof)
    assert not _changed()


def test_analysis_of_an_unchanged_model_keeps_its_classes(roof: Object) -> None:
    before = stored(roof, "curvature_class").tolist()
    bpy.ops.curvature.analyze()
    assert roof.data.curvature.is_segmented
    assert stored(roof, "curvature_class").tolist() == before


def test_segmentation_measures_a_changed_model_anew(roof: Object) -> None:
    roof.scale = (2.0, 2.0, 2.0)
    bpy.context.view_layer.update()
    before = stored(roof, "curvature_k1").copy()
    bpy.ops.curvature.segment(**STRICT)
    assert stored(roof, "curvature_k1") == pytest.approx(before / 2.0, rel=1e-5)


def test_show_says_which_models_have_changed(
    roof: Object, capfd: pytest.CaptureFixture[str]
) -> None:
    add_surface(saddle, "Canopy")
    bpy.ops.curvature.segment(**STRICT)
    _move_vertex(roof)
    capfd.readouterr()
    bpy.ops.curvature.show(quantity="MEAN")
    assert "Changed since the analysis: Roof; analyze again" in capfd.readouterr().out


def test_source_of_a_copy_is_the_one_that_has_changed() -> None:
    obj = add_surface(dome)
    obj.modifiers.new("Subdivision", "SUBSURF").levels = 1
    bpy.ops.curvature.segment(**STRICT)
    assert not _changed()
    obj.modifiers[0].levels = 2
    assert _changed() == [obj]
