# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Regions have names that stick, and are listed, selected and looked at."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import bpy
import numpy as np
import pytest
from bpy.types import Object
from layout_stub import Layout
from models import STRICT, add_surface, deselect_all, dome, only_select, stored


def _half_bent(x: np.ndarray, _y: np.ndarray) -> np.ndarray:
    """Flat left of the middle, single-curved right of it."""
    return -0.25 * np.maximum(x, 0.0) ** 2


@pytest.fixture
def roof() -> Object:
    """A model of two regions, none of its faces selected."""
    obj = add_surface(_half_bent)
    bpy.ops.curvature.segment(**STRICT)
    assert obj.data.curvature.region_count == 2
    deselect_all(obj)
    return obj


def _names(obj: Object) -> list[str]:
    return [row.name for row in obj.data.curvature.regions]


def _named(obj: Object, surface_class: str) -> str:
    rows = obj.data.curvature.regions
    return next(row.name for row in rows if row.surface_class == surface_class)


def _rename(obj: Object, surface_class: str, name: str) -> None:
    for row in obj.data.curvature.regions:
        if row.surface_class == surface_class:
            row.name = name


def _selected(obj: Object) -> np.ndarray:
    return np.array([polygon.select for polygon in obj.data.polygons])


def test_regions_are_named_and_measured_by_falling_area(roof: Object) -> None:
    assert _names(roof) == ["Region 1", "Region 2"]
    rows = list(roof.data.curvature.regions)
    assert rows[0].area >= rows[1].area
    regions = stored(roof, "curvature_region")
    assert [row.faces for row in rows] == np.bincount(regions).tolist()


def test_names_follow_their_regions_when_the_tolerance_changes(roof: Object) -> None:
    _rename(roof, "SINGLE", "Vault")
    _rename(roof, "FLAT", "Terrace")
    bpy.ops.curvature.segment(panel_size=1.3, deviation=0.01)
    assert (_named(roof, "SINGLE"), _named(roof, "FLAT")) == ("Vault", "Terrace")


@pytest.mark.parametrize("with_analysis", [False, True])
def test_names_follow_their_regions_when_the_model_changes(
    roof: Object, with_analysis: bool
) -> None:
    _rename(roof, "SINGLE", "Vault")
    for vertex in roof.data.vertices:
        vertex.co.z *= 1.1
    roof.data.update()
    if with_analysis:
        bpy.ops.curvature.analyze()
    bpy.ops.curvature.segment(**STRICT)
    assert _named(roof, "SINGLE") == "Vault"
    assert ".curvature_former_region" not in roof.data.attributes


def test_names_follow_their_regions_where_faces_are_added(roof: Object) -> None:
    _rename(roof, "SINGLE", "Vault")
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.mesh.subdivide()
    bpy.ops.object.mode_set(mode="OBJECT")
    bpy.ops.curvature.segment(**STRICT)
    assert len(roof.data.polygons) == 4 * 256
    assert _named(roof, "SINGLE") == "Vault"


def test_names_follow_on_the_copy_that_carries_the_results() -> None:
    obj = add_surface(_half_bent)
    obj.modifiers.new("Triangulate", "TRIANGULATE")
    bpy.ops.curvature.segment(**STRICT)
    _rename(bpy.data.objects["Roof Curvature"], "SINGLE", "Vault")
    for vertex in obj.data.vertices:
        vertex.co.z *= 1.1
    obj.data.update()
    bpy.ops.curvature.segment(**STRICT)
    assert _named(bpy.data.objects["Roof Curvature"], "SINGLE") == "Vault"


def test_names_are_in_reports_and_separate_objects(roof: Object, tmp_path: Path) -> None:
    _rename(roof, "SINGLE", "Vault")
    path = tmp_path / "report.json"
    bpy.ops.curvature.export_report(filepath=str(path))
    (block,) = json.loads(path.read_text(encoding="utf-8"))["objects"]
    assert {row["class"]: row["name"] for row in block["regions"]}["single_curved"] == "Vault"
    bpy.ops.curvature.separate(by="REGION")
    assert "Roof Vault" in bpy.data.objects


def test_name_that_was_emptied_is_given_again(roof: Object) -> None:
    roof.data.curvature.regions[1].name = " "
    bpy.ops.curvature.segment(**STRICT)
    assert _names(roof) == ["Region 1", "Region 2"]


@pytest.mark.parametrize("mode", ["OBJECT", "EDIT"])
def test_exactly_the_faces_of_the_region_are_selected(
    roof: Object, mode: str, run: Callable[..., Any]
) -> None:
    expected = stored(roof, "curvature_region") == 1
    bpy.ops.object.mode_set(mode=mode)
    result, report = run("select_region", region=1, zoom=True)
    assert result == {"FINISHED"}
    assert report == f"Info: Region 2: {expected.sum()} faces selected"
    assert roof.mode == mode
    bpy.ops.object.mode_set(mode="OBJECT")
    assert (_selected(roof) == expected).all()
    assert roof.data.curvature.active_region == 1


def test_region_chosen_in_the_list_is_selected_and_extended(roof: Object) -> None:
    roof.data.curvature.active_region = 1
    bpy.ops.curvature.select_region()
    assert (_selected(roof) == (stored(roof, "curvature_region") == 1)).all()
    bpy.ops.curvature.select_region(region=0, extend=True)
    assert _selected(roof).all()


def test_missing_region_is_refused(roof: Object, run: Callable[..., Any]) -> None:
    result, report = run("select_region", region=7)
    assert (result, report) == ({"CANCELLED"}, "Error: Roof has no region 7")
    other = add_surface(dome, "Other")
    only_select(roof, other)
    assert run("select_region")[1].startswith("Error: The active object has no regions")


def test_zoom_turns_every_viewport_about_the_region(roof: Object) -> None:
    roof.location = (10.0, 0.0, 0.0)
    bpy.context.view_layer.update()
    bpy.ops.curvature.select_region(region=0, zoom=True)
    wanted = stored(roof, "curvature_region") == 0
    corners = np.array(
        [
            roof.matrix_world @ roof.data.vertices[vertex].co
            for polygon in roof.data.polygons
            if wanted[polygon.index]
            for vertex in polygon.vertices
        ]
    )
    middle = 0.5 * (corners.min(axis=0) + corners.max(axis=0))
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            if area.type == "VIEW_3D":
                found = area.spaces.active.region_3d.view_location
                np.testing.assert_allclose(found, middle, atol=1e-4)


class _Context:
    """Blender's context with a region of a width, which it lacks without a window."""

    preferences = SimpleNamespace(system=SimpleNamespace(ui_scale=1.0))

    def __init__(self, width: int) -> None:
        self.region = SimpleNamespace(width=width)

    def __getattr__(self, name: str) -> object:
        return getattr(bpy.context, name)


def _draw(name: str, width: int = 280) -> Layout:
    context, layout = _Context(width), Layout(context=_Context(width))
    panel = getattr(bpy.types, f"CURVATURE_PT_{name}")
    if panel.poll(context):
        panel.draw(SimpleNamespace(layout=layout), context)
    return layout


def test_panel_lists_every_region_with_its_figures(roof: Object) -> None:
    roof.data.curvature.active_region = 1
    narrow, shown = _draw("regions", 240), _draw("regions", 500)
    assert shown.properties.count("name") == narrow.properties.count("name") == 2
    assert {"color_flat", "color_single"} <= set(shown.properties)
    rows = roof.data.curvature.regions
    assert [f"{row.faces:,}" in shown.texts for row in rows] == [True, True]
    assert f"{rows[1].faces:,} faces" in narrow.texts
    assert sum("m²" in text for text in narrow.texts) == 2
    assert shown.operators == [
        "curvature.select_region",
        "curvature.select_region",
        "curvature.assign_class",
        "curvature.merge_regions",
        "curvature.split_region",
    ]


def test_panel_of_curves_tells_their_lengths(roof: Object) -> None:
    bpy.ops.curvature.outline(kind="BORDERS")
    shown = _draw("outlines")
    assert f"{roof.data.curvature.outlines[0].curves} borders" in shown.texts
    assert shown.operators == ["curvature.outline", "curvature.export_lines"]


@pytest.mark.parametrize("name", ["regions", "outlines"])
def test_panels_appear_only_where_there_are_regions(name: str) -> None:
    add_surface(dome)
    assert not _draw(name).operators
