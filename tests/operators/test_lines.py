# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Curvature lines become curves that lie on the model, and a later run replaces its own only."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

import bpy
import numpy as np
import pytest
from mathutils import Euler, Matrix
from models import (
    RING,
    TUBE,
    add_surface,
    add_torus,
    barrel,
    dome,
    only_select,
    plate,
    report_of,
    saddle,
    world_points,
)


def _off_torus(points: np.ndarray) -> np.ndarray:
    ring = np.linalg.norm(points[:, :2], axis=1) - RING
    return np.abs(np.hypot(ring, points[:, 2]) - TUBE)


def test_all_lines_of_a_torus_are_closed(run: Callable[..., Any]) -> None:
    obj = add_torus()
    result, text = run("trace_lines", spacing=0.8)
    assert result == {"FINISHED"}
    assert text.startswith("Info: Traced Ring: ")
    for number, family in ((1, "family_1"), (2, "family_2")):
        curve = bpy.data.objects[f"Ring Lines {number}"]
        splines = curve.data.splines
        assert all(spline.use_cyclic_u for spline in splines)
        assert all(spline.type == "POLY" for spline in splines)
        measured = report_of(obj)["curvature_lines"][family]
        assert measured["count"] == len(splines) == len(curve.data.get("curvature_lengths"))
        assert measured["length"] == pytest.approx(sum(curve.data.get("curvature_lengths")))
        assert {end for line in measured["lines"] for end in line["ends"]} == {"closed"}
        points = sum(len(spline.points) for spline in splines)
        assert len(curve.data.get("curvature_along")) == points
        assert [each.name for each in curve.users_collection] == ["Ring Curvature"]
        # The faces' middles lie within the sagitta of a side inside the torus.
        assert _off_torus(world_points(curve)).max() < 0.02
    # Along the tube k1 = 1/TUBE everywhere.
    along = bpy.data.objects["Ring Lines 1"].data.get("curvature_along")
    assert np.abs(np.array(along) * TUBE - 1.0).max() < 0.05
    assert {line["length"] for line in report_of(obj)["curvature_lines"]["family_1"]["lines"]}


def test_lines_have_two_materials_and_a_thickness_in_meters() -> None:
    add_torus()
    bpy.context.scene.unit_settings.scale_length = 0.5
    bpy.ops.curvature.trace_lines(spacing=0.5, thickness=0.04)
    one, two = (bpy.data.objects[f"Ring Lines {number}"] for number in (1, 2))
    assert one.data.bevel_depth == pytest.approx(0.04)
    names = {each.data.materials[0].name for each in (one, two)}
    assert names == {"Curvature Lines 1", "Curvature Lines 2"}


MATRICES = {
    "moved": Matrix.Translation((1000.0, -20.0, 3.0)),
    "turned": Euler((0.4, 1.1, -2.0)).to_matrix().to_4x4(),
    "stretched": Matrix.LocRotScale((1.0, 2.0, 3.0), Euler((0.3, 0.2, 0.1)), (3.0, 1.0, 0.5)),
    "mirrored": Matrix.LocRotScale((1.0, 2.0, 3.0), Euler((0.3, 0.2, 0.1)), (-1.0, 1.0, 2.0)),
}


@pytest.mark.parametrize("name", MATRICES)
@pytest.mark.parametrize("unit", [1.0, 0.01])
def test_lines_lie_on_the_model_however_it_is_placed(name: str, unit: float) -> None:
    obj = add_torus()
    obj.matrix_world = MATRICES[name]
    bpy.context.scene.unit_settings.scale_length = unit
    bpy.context.view_layer.update()
    bpy.ops.curvature.trace_lines(spacing=unit)
    inverse = np.linalg.inv(np.array(obj.matrix_world))
    for number in (1, 2):
        curve = bpy.data.objects[f"Ring Lines {number}"]
        assert len(curve.data.splines) >= 3
        assert tuple(curve.matrix_world.to_scale()) == pytest.approx((1.0, 1.0, 1.0), abs=1e-5)
        points = world_points(curve) @ inverse[:3, :3].T + inverse[:3, 3]
        assert _off_torus(points).max() < 0.02


def test_a_later_run_replaces_its_own_output_only() -> None:
    obj = add_torus()
    bpy.ops.curvature.find_umbilics()
    bpy.ops.curvature.trace_lines(kind="ASYMPTOTIC", spacing=0.5)
    bpy.ops.curvature.trace_lines(spacing=0.5)
    guest = bpy.data.objects.new("Ring Lines 3", None)
    bpy.data.collections["Ring Curvature"].objects.link(guest)
    before = {
        each.name: len(getattr(each.data, "splines", ())) for each in bpy.data.objects if each.data
    }
    bpy.ops.curvature.trace_lines(spacing=1.0)
    after = {
        each.name: len(getattr(each.data, "splines", ())) for each in bpy.data.objects if each.data
    }
    assert before.keys() == after.keys()
    assert {name for name in before if before[name] != after[name]} == {
        "Ring Lines 1",
        "Ring Lines 2",
    }
    assert len(bpy.data.curves) == 4
    assert report_of(obj)["asymptotic_lines"]["family_1"]["count"] > 0
    assert report_of(obj)["curvature_lines"]["spacing"] == pytest.approx(1.0)


def test_a_model_can_be_traced_again_from_its_own_lines() -> None:
    obj = add_torus()
    for spacing in (0.8, 0.9, 1.0):
        bpy.ops.curvature.trace_lines(spacing=spacing)
        only_select(bpy.data.objects["Ring Lines 1"])
    bpy.ops.curvature.trace_lines(spacing=0.7)
    assert bpy.context.view_layer.objects.active == obj
    assert obj.select_get()
    only_select(bpy.data.objects["Ring Lines 2"])
    bpy.ops.curvature.clear()
    assert bpy.context.view_layer.objects.active == obj


def test_one_family_only_drops_the_other_of_the_run_before() -> None:
    obj = add_torus()
    bpy.ops.curvature.trace_lines(spacing=0.8)
    bpy.ops.curvature.trace_lines(spacing=0.8, families="SECOND")
    assert "Ring Lines 1" not in bpy.data.objects
    assert "Ring Lines 2" in bpy.data.objects
    assert "family_1" not in report_of(obj)["curvature_lines"]


def test_clearing_removes_lines_umbilics_and_hatching() -> None:
    obj = add_torus()
    before = set(bpy.data.objects)
    bpy.ops.curvature.trace_lines(spacing=0.8)
    bpy.ops.curvature.find_umbilics()
    bpy.ops.curvature.trace_through()
    assert len(bpy.data.objects) > 4
    only_select(obj)
    bpy.ops.curvature.clear()
    assert set(bpy.data.objects) == before
    assert not bpy.data.curves
    assert not bpy.data.collections


def test_spacing_defaults_to_the_panel_size() -> None:
    obj = add_torus()
    bpy.context.scene.curvature.panel_size = 0.75
    bpy.ops.curvature.trace_lines()
    assert report_of(obj)["curvature_lines"]["spacing"] == pytest.approx(0.75)
    bpy.context.scene.curvature.spacing = 0.9
    bpy.ops.curvature.trace_lines()
    assert report_of(obj)["curvature_lines"]["spacing"] == pytest.approx(0.9)


def test_fitted_curves_have_few_knots_and_stay_on_the_surface() -> None:
    obj = add_torus()
    bpy.ops.curvature.trace_lines(spacing=0.8, fit_curves=True, fit_tolerance=0.005)
    curve = bpy.data.objects["Ring Lines 1"]
    assert all(spline.type == "BEZIER" and spline.use_cyclic_u for spline in curve.data.splines)
    assert max(len(spline.bezier_points) for spline in curve.data.splines) <= 16
    # Its chords of 5 m / 32 stay off the torus by a sagitta of 4 mm.
    assert report_of(obj)["curvature_lines"]["deviation"] < 0.01
    points = np.array([p.co for s in curve.data.splines for p in s.bezier_points])
    assert _off_torus(points).max() < 0.02


def test_asymptotic_lines_stay_in_the_saddle() -> None:
    add_torus()
    bpy.ops.curvature.trace_lines(kind="ASYMPTOTIC", spacing=0.4)
    for number in (1, 2):
        points = world_points(bpy.data.objects[f"Ring Asymptotic {number}"])
        # Inside the circle above and below the middle of the tube the torus is a saddle.
        assert np.linalg.norm(points[:, :2], axis=1).max() < RING + 0.1


def test_segmentation_keeps_the_lines_in_thereport_of() -> None:
    obj = add_torus()
    bpy.ops.curvature.trace_lines(spacing=0.8)
    bpy.ops.curvature.segment()
    assert report_of(obj)["curvature_lines"]["family_1"]["count"] > 0
    assert "classes" in report_of(obj)
    obj.data.vertices[0].co.z += 0.2
    obj.data.update()
    bpy.ops.curvature.analyze()
    assert "curvature_lines" not in report_of(obj)


def test_lines_of_a_model_with_modifiers_belong_to_it() -> None:
    obj = add_surface(saddle)
    obj.modifiers.new("Subdivision", "SUBSURF")
    bpy.ops.curvature.trace_lines(spacing=0.25)
    assert bpy.data.objects["Roof Lines 1"].curvature.companion_of == obj
    assert report_of(bpy.data.objects["Roof Curvature"])["curvature_lines"]["family_1"]["count"] > 3


def test_a_flat_plate_has_no_lines_and_one_umbilic_area(run: Callable[..., Any]) -> None:
    obj = add_surface(plate)
    result, text = run("trace_lines", spacing=0.2)
    assert (result, text) == (
        {"FINISHED"},
        "Warning: Traced Roof: no lines; Roof is flat or spherical everywhere, where there are no "
        "directions to follow",
    )
    assert report_of(obj)["curvature_lines"]["family_1"] == {"count": 0, "length": 0.0, "lines": []}
    assert len(report_of(obj)["umbilic_areas"]) == 1


@pytest.mark.parametrize(
    ("shape", "options", "reason"),
    [
        (dome, {"spacing": 0.2}, "Roof is flat or spherical everywhere"),
        (barrel, {"kind": "ASYMPTOTIC"}, "Roof is a saddle nowhere"),
        (saddle, {"spacing": 50.0}, "Roof has no room for lines 50 m apart"),
    ],
)
def test_a_model_without_lines_is_told_why(
    shape: Callable, options: dict[str, Any], reason: str, run: Callable[..., Any]
) -> None:
    add_surface(shape)
    result, text = run("trace_lines", **options)
    assert result == {"FINISHED"}
    assert text.startswith(f"Warning: Traced Roof: no lines; {reason}")
    assert len(bpy.data.objects) == 1


def test_a_spacing_far_finer_than_the_faces_is_refused(run: Callable[..., Any]) -> None:
    add_surface(saddle, steps=4)
    result, text = run("trace_lines", spacing=0.004)
    assert result == {"CANCELLED"}
    # Sides of triangles over cells of half a meter, diagonals included.
    (size,) = re.findall(r"too fine for faces of ([\d.]+) m", text)
    assert 0.5 <= float(size) <= 1.0
    result, _ = run("trace_lines", spacing=0.02, families="FIRST")
    assert result == {"FINISHED"}
    # A hundred lines cross the saddle, of 2.1 m; some end where two rulings of lines converge.
    assert report_of(bpy.data.objects["Roof"])["curvature_lines"]["family_1"]["length"] > 180.0


def test_too_fine_a_spacing_is_refused(run: Callable[..., Any]) -> None:
    add_surface(dome)
    result, text = run("trace_lines", spacing=1e-5)
    assert result == {"CANCELLED"}
    assert "too fine" in text
    assert len(bpy.data.objects) == 1
