# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Borders and parabolic curves become curve objects that lie on the model."""

from __future__ import annotations

import json
from collections.abc import Callable
from math import pi
from pathlib import Path
from typing import Any

import bpy
import numpy as np
import pytest
from bpy.types import Object
from models import STRICT, add_folded_roof, add_mesh, add_surface, dome, only_select, saddle

BEND, PIPE = 1.0, 0.4
_TURNS, _SIDES = 96, 64


def add_torus() -> Object:
    """A ring torus about the z axis, of quads, with vertices off its parabolic circles."""
    u = 2.0 * pi * np.arange(_TURNS) / _TURNS
    v = 2.0 * pi * (np.arange(_SIDES) + 0.37) / _SIDES
    along, around = (angles.ravel() for angles in np.meshgrid(u, v, indexing="ij"))
    rho = BEND + PIPE * np.cos(around)
    points = np.column_stack([rho * np.cos(along), rho * np.sin(along), PIPE * np.sin(around)])
    i, j = (index.ravel() for index in np.meshgrid(range(_TURNS), range(_SIDES), indexing="ij"))
    ring = [
        ((i + a) % _TURNS) * _SIDES + (j + b) % _SIDES for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))
    ]
    return add_mesh("Torus", points, np.column_stack(ring))


def _points(obj: Object) -> list[np.ndarray]:
    """Return the points of every curve of an object in the world."""
    bpy.context.view_layer.update()
    world = np.array(obj.matrix_world)
    return [
        np.array([point.co[:3] for point in spline.points]) @ world[:3, :3].T + world[:3, 3]
        for spline in obj.data.splines
    ]


def _line(kind: str, name: str = "Torus") -> Object:
    ending = {"BORDERS": "Region Borders", "PARABOLIC": "Parabolic Curves"}[kind]
    return bpy.data.objects[f"{name} {ending}"]


def test_torus_has_two_parabolic_circles_of_the_exact_radius_and_length(
    run: Callable[..., Any],
) -> None:
    obj = add_torus()
    bpy.ops.curvature.segment(**STRICT)
    result, report = run("outline", kind="PARABOLIC")
    assert result == {"FINISHED"}
    assert report.startswith("Info: Made 2 parabolic curves, 12.6 m long")
    curves = _line("PARABOLIC")
    assert [spline.use_cyclic_u for spline in curves.data.splines] == [True, True]
    step = 2.0 * pi * BEND / _TURNS
    for points in _points(curves):
        # Between vertices the mesh lies inside the torus by the sagitta of its edges.
        assert np.hypot(points[:, 0], points[:, 1]) == pytest.approx(BEND, abs=0.5 * step**2)
        assert np.abs(points[:, 2]) == pytest.approx(PIPE, abs=0.5 * step**2)
    (row,) = obj.data.curvature.outlines
    assert (row.kind, row.curves) == ("PARABOLIC", 2)
    assert row.length == pytest.approx(2 * 2.0 * pi * BEND, rel=2e-3)


def test_curves_lie_in_the_collection_and_are_drawn_thick() -> None:
    obj = add_torus()
    bpy.ops.curvature.segment(**STRICT)
    bpy.ops.curvature.outline(kind="BOTH")
    assert {each.name for each in bpy.data.collections["Torus Curvature"].objects} == {
        "Torus Region Borders",
        "Torus Parabolic Curves",
    }
    for kind in ("BORDERS", "PARABOLIC"):
        assert {spline.type for spline in _line(kind).data.splines} == {"POLY"}
        assert 0.0005 < _line(kind).data.bevel_depth / obj.dimensions.length < 0.005


def test_curves_lie_on_a_model_that_is_moved_turned_scaled_and_mirrored() -> None:
    obj = add_folded_roof()
    bpy.context.scene.unit_settings.scale_length = 0.01
    obj.location, obj.rotation_euler, obj.scale = (
        (5.0, -3.0, 2.0),
        (0.3, 0.7, 1.1),
        (2.0, -3.0, 1.5),
    )
    bpy.context.view_layer.update()
    bpy.ops.curvature.segment()
    bpy.ops.curvature.outline(kind="BORDERS", straighten=False)
    (found,) = _points(_line("BORDERS", "Fold"))
    ridge = [obj.matrix_world @ v.co for v in obj.data.vertices if abs(v.co.x) < 1e-6]
    order = np.argsort(found @ (found[-1] - found[0]))
    ridge.sort(key=lambda point: float(np.dot(point, found[-1] - found[0])))
    np.testing.assert_allclose(found[order], np.array(ridge), atol=2e-5)
    # The ridge is 2 units long along y: 6 units of 1 cm.
    assert obj.data.curvature.outlines[0].length == pytest.approx(0.06, rel=1e-5)
    scale = np.array(_line("BORDERS", "Fold").matrix_world.to_scale())
    np.testing.assert_allclose(scale, 1.0, atol=1e-6)


def test_curves_lie_on_the_geometry_that_modifiers_make() -> None:
    obj = add_folded_roof()
    obj.modifiers.new("Array", "ARRAY").relative_offset_displace = (0.0, 0.0, 2.0)
    bpy.ops.curvature.segment(**STRICT)
    bpy.ops.curvature.outline(kind="BORDERS")
    heights = sorted(float(points[:, 2].mean()) for points in _points(_line("BORDERS", "Fold")))
    assert heights == pytest.approx([0.0, 2.0], abs=1e-6)


def test_rims_are_borders_only_on_request() -> None:
    add_folded_roof()
    bpy.ops.curvature.segment(**STRICT)
    bpy.ops.curvature.outline(kind="BORDERS")
    inner = sum(len(points) for points in _points(_line("BORDERS", "Fold")))
    bpy.ops.curvature.outline(kind="BORDERS", include_rims=True)
    assert sum(len(points) for points in _points(_line("BORDERS", "Fold"))) > inner


def test_straightened_borders_are_shorter_and_stay_within_the_tolerance() -> None:
    add_torus()
    bpy.ops.curvature.segment(panel_size=0.5, deviation=0.02)
    found = {}
    for straighten in (False, True):
        bpy.ops.curvature.outline(kind="BORDERS", straighten=straighten, tolerance=0.01)
        found[straighten] = np.concatenate(_points(_line("BORDERS")))
    moved = np.linalg.norm(found[True] - found[False], axis=1)
    assert 0.0 < moved.max() <= 0.01 + 1e-6


def test_running_again_replaces_its_own_output_and_nothing_else() -> None:
    add_torus()
    bpy.ops.curvature.segment(**STRICT)
    bpy.ops.curvature.separate(by="CLASS")
    parts = {obj.name for obj in bpy.data.objects}
    for _ in range(2):
        bpy.ops.curvature.outline(kind="BOTH")
    bpy.ops.curvature.outline(kind="BORDERS")
    lines = {"Torus Region Borders", "Torus Parabolic Curves"}
    assert {obj.name for obj in bpy.data.objects} == parts | lines
    assert {curve.name for curve in bpy.data.curves} == lines
    bpy.ops.curvature.separate(by="CLASS")
    assert lines <= {obj.name for obj in bpy.data.objects}


def test_clear_removes_the_curves() -> None:
    obj = add_torus()
    bpy.ops.curvature.segment(**STRICT)
    bpy.ops.curvature.outline(kind="BOTH")
    bpy.ops.curvature.clear()
    assert list(bpy.data.objects) == [obj]
    assert not bpy.data.collections
    assert not bpy.data.curves


def test_lengths_are_in_the_report(tmp_path: Path) -> None:
    add_torus()
    bpy.ops.curvature.segment(**STRICT)
    bpy.ops.curvature.outline(kind="BOTH")
    path = tmp_path / "report.json"
    bpy.ops.curvature.export_report(filepath=str(path))
    (block,) = json.loads(path.read_text(encoding="utf-8"))["objects"]
    assert block["parabolic_curves"]["count"] == 2
    assert block["parabolic_curves"]["length"] == pytest.approx(4.0 * pi, rel=2e-3)
    assert block["borders"]["count"] == len(_line("BORDERS").data.splines)
    bpy.ops.curvature.export_report(filepath=str(tmp_path / "report.csv"))
    assert "parabolic_curves,length" in (tmp_path / "report.csv").read_text(encoding="utf-8")


@pytest.mark.parametrize("is_analyzed_first", [False, True])
def test_curves_are_drawn_anew_when_the_regions_change(is_analyzed_first: bool) -> None:
    obj = add_folded_roof()
    bpy.ops.curvature.segment()
    bpy.ops.curvature.outline(kind="BORDERS", include_rims=True, straighten=False)
    for vertex in obj.data.vertices:
        vertex.co.y *= 2.0
    obj.data.update()
    if is_analyzed_first:
        # That forgets the regions, but not how their borders are drawn.
        bpy.ops.curvature.analyze()
        assert not obj.data.curvature.outlines
    bpy.ops.curvature.segment()
    (row,) = obj.data.curvature.outlines
    # Ridge and eaves are 4 m long now; four gable edges rise at 45 degrees over 1 m.
    assert row.length == pytest.approx(3 * 4.0 + 4 * 2.0**0.5)
    (shown,) = [each for each in bpy.data.objects if each.curvature.role == "BORDERS"]
    assert sum(len(spline.points) for spline in shown.data.splines) > 0


def test_curves_that_were_deleted_do_not_come_back() -> None:
    obj = add_folded_roof()
    bpy.ops.curvature.segment()
    bpy.ops.curvature.outline(kind="BORDERS")
    bpy.data.objects.remove(_line("BORDERS", "Fold"))
    bpy.ops.curvature.segment()
    assert not obj.data.curvature.outlines
    assert [each for each in bpy.data.objects if each.curvature.role] == []


def test_borders_and_parabolic_curves_are_layers_of_a_drawing(
    run: Callable[..., Any], tmp_path: Path
) -> None:
    add_torus()
    bpy.ops.curvature.segment(**STRICT)
    bpy.ops.curvature.outline(kind="BOTH")
    path = tmp_path / "torus.dxf"
    result, report = run("export_lines", filepath=str(path))
    assert result == {"FINISHED"}
    words = {word.strip() for word in path.read_text(encoding="utf-8").split("\n")}
    assert {"REGION_BORDERS", "PARABOLIC_CURVES"} <= words
    count = len(_line("BORDERS").data.splines) + 2
    assert report == f"Info: Wrote {count} lines to torus.dxf"


def test_model_without_such_curves_says_so(run: Callable[..., Any]) -> None:
    add_surface(dome)
    bpy.ops.curvature.segment(**STRICT)
    result, report = run("outline", kind="PARABOLIC")
    assert result == {"FINISHED"}
    assert report.startswith("Info: Made 0 parabolic curves")


def test_model_that_has_changed_is_refused(run: Callable[..., Any]) -> None:
    obj = add_surface(dome)
    bpy.ops.curvature.segment(**STRICT)
    obj.data.vertices[0].co.z += 0.1
    obj.data.update()
    result, report = run("outline")
    assert result == {"CANCELLED"}
    assert "the model has changed: press Segment first" in report
    assert list(bpy.data.objects) == [obj]


def test_all_selected_models_are_outlined_from_edit_mode(run: Callable[..., Any]) -> None:
    one, two = add_folded_roof("One"), add_surface(saddle, "Two")
    only_select(one, two)
    bpy.ops.curvature.segment(**STRICT)
    bpy.ops.object.mode_set(mode="EDIT")
    assert run("outline", include_rims=True)[0] == {"FINISHED"}
    assert [obj.mode for obj in (one, two)] == ["EDIT", "EDIT"]
    assert {"One Region Borders", "Two Region Borders"} <= set(bpy.data.objects.keys())


def test_undo_takes_the_curves_away() -> None:
    add_torus()
    bpy.ops.curvature.segment(**STRICT)
    bpy.ops.ed.undo_push(message="Segment")
    bpy.ops.curvature.outline(kind="BOTH")
    bpy.ops.ed.undo_push(message="Outline")
    bpy.ops.ed.undo()
    assert set(bpy.data.objects.keys()) == {"Torus"}
    assert not bpy.data.objects["Torus"].data.curvature.outlines
