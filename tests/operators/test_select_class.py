# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The faces of a class are selected, in either mode, with their edges and vertices."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from types import SimpleNamespace
from typing import Any

import bmesh
import bpy
import numpy as np
import pytest
from architectural_curvature.operators.select_class import CURVATURE_OT_select_class
from bpy.types import Object
from models import STRICT, add_surface, deselect_all, dome, only_select, plate, stored


def _half_bent(x: np.ndarray, _y: np.ndarray) -> np.ndarray:
    """Flat left of the middle, single-curved right of it."""
    return -0.25 * np.maximum(x, 0.0) ** 2


@pytest.fixture
def roof() -> Object:
    """A model with flat and single-curved faces, none selected."""
    obj = add_surface(_half_bent)
    bpy.ops.curvature.segment(**STRICT)
    deselect_all(obj)
    return obj


def _selected(obj: Object) -> list[bool]:
    if obj.mode == "EDIT":
        return [face.select for face in bmesh.from_edit_mesh(obj.data).faces]
    return [polygon.select for polygon in obj.data.polygons]


def _of_class(obj: Object, *numbers: int) -> list[bool]:
    if obj.mode == "EDIT":
        bpy.ops.object.mode_set(mode="OBJECT")
        found = np.isin(stored(obj, "curvature_class"), numbers).tolist()
        bpy.ops.object.mode_set(mode="EDIT")
        return found
    return np.isin(stored(obj, "curvature_class"), numbers).tolist()


@pytest.mark.parametrize("mode", ["OBJECT", "EDIT"])
@pytest.mark.parametrize(("name", "number"), [("FLAT", 0), ("SINGLE", 1), ("HYPERBOLIC", 3)])
def test_exactly_the_faces_of_the_class_are_selected(
    roof: Object, mode: str, name: str, number: int
) -> None:
    bpy.ops.object.mode_set(mode=mode)
    assert bpy.ops.curvature.select_class(surface_class=name) == {"FINISHED"}
    assert roof.mode == mode
    assert _selected(roof) == _of_class(roof, number)


@pytest.mark.parametrize("mode", ["OBJECT", "EDIT"])
def test_next_class_replaces_the_selection_or_extends_it(roof: Object, mode: str) -> None:
    bpy.ops.object.mode_set(mode=mode)
    bpy.ops.curvature.select_class(surface_class="FLAT")
    bpy.ops.curvature.select_class(surface_class="SINGLE", extend=True)
    assert _selected(roof) == _of_class(roof, 0, 1)
    bpy.ops.curvature.select_class(surface_class="SINGLE")
    assert _selected(roof) == _of_class(roof, 1)


def test_edges_and_vertices_of_the_faces_are_selected_and_no_others(roof: Object) -> None:
    bpy.ops.curvature.select_class(surface_class="FLAT")
    mesh = roof.data
    chosen = [polygon for polygon in mesh.polygons if polygon.select]
    vertices = {vertex for polygon in chosen for vertex in polygon.vertices}
    edges = {key for polygon in chosen for key in polygon.edge_keys}
    assert {vertex.index for vertex in mesh.vertices if vertex.select} == vertices
    assert {edge.key for edge in mesh.edges if edge.select} == edges


def test_selection_survives_entering_edit_mode_with_face_selection(roof: Object) -> None:
    bpy.ops.curvature.select_class(surface_class="FLAT")
    bpy.context.scene.tool_settings.mesh_select_mode = (False, False, True)
    bpy.ops.object.mode_set(mode="EDIT")
    assert _selected(roof) == _of_class(roof, 0)


@pytest.mark.parametrize("with_shift", [False, True])
def test_button_enters_edit_mode_to_show_the_faces(roof: Object, with_shift: bool) -> None:
    """Blender without a window never invokes: what the button calls is called here."""
    bpy.ops.curvature.select_class(surface_class="SINGLE")
    operator = SimpleNamespace(surface_class="FLAT", extend=False, report=lambda *_: None)
    operator.execute = partial(CURVATURE_OT_select_class.execute, operator)
    event = SimpleNamespace(shift=with_shift)
    CURVATURE_OT_select_class.invoke(operator, bpy.context, event)
    assert roof.mode == "EDIT"
    assert tuple(bpy.context.scene.tool_settings.mesh_select_mode) == (False, False, True)
    assert _selected(roof) == _of_class(roof, *((0, 1) if with_shift else (0,)))


def test_hidden_faces_stay_hidden(roof: Object) -> None:
    roof.data.polygons[0].hide = True
    bpy.ops.curvature.select_class(surface_class="FLAT")
    assert roof.data.polygons[0].hide


def test_all_selected_models_take_part_and_no_others() -> None:
    models = [add_surface(plate, name) for name in ("A", "B", "C")]
    bpy.ops.curvature.segment(**STRICT)
    for obj in models:
        deselect_all(obj)
    only_select(*models[:2])
    bpy.ops.curvature.select_class(surface_class="FLAT")
    assert [all(_selected(obj)) for obj in models] == [True, True, False]


def test_number_of_faces_is_reported(roof: Object, run: Callable[..., Any]) -> None:
    count = sum(_of_class(roof, 0))
    assert run("select_class", surface_class="FLAT") == (
        {"FINISHED"},
        f"Info: {count} faces selected",
    )


def test_faces_are_selected_on_the_copy_that_carries_the_results() -> None:
    obj = add_surface(dome)
    obj.modifiers.new("Subdivision", "SUBSURF").levels = 1
    bpy.ops.curvature.segment(**STRICT)
    bpy.ops.curvature.select_class(surface_class="ELLIPTIC")
    copy = bpy.data.objects["Roof Curvature"]
    assert sum(_selected(copy)) == (stored(copy, "curvature_class") == 2).sum()
