# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators take what they are told, and the scene's settings for the rest."""

from __future__ import annotations

import json
import math
from pathlib import Path

import bpy
import numpy as np
import pytest
from bpy.types import Object
from models import STRICT, add_surface, barrel, dome, only_select, stored

SETTINGS = {
    "analyze": {"smoothing", "smoothing_length", "crease_angle", "flip_normals"},
    "segment": {
        *("criterion", "panel_size", "deviation", "smallest_radius"),
        *("gaussian_limit", "mean_limit", "crease_angle", "min_area"),
    },
    "show": {"quantity"},
    "select_class": {"surface_class", "extend"},
    "export_report": {"filepath"},
    "trace_lines": {"spacing", "families", "kind", "smoothing_length", "thickness"},
    "trace_through": {"points", "families", "kind"},
    "hatch": {"tone", "spacing", "light"},
    "export_lines": {"filepath"},
    "find_umbilics": set(),
    "clear": set(),
}


def _rna(name: str) -> dict[str, object]:
    rna = getattr(bpy.ops.curvature, name).get_rna_type()
    return {key: value for key, value in rna.properties.items() if key != "rna_type"}


def _used(obj: Object) -> tuple[float, float]:
    report = json.loads(obj.data.curvature.report)
    return report["panel_size"], report["deviation"]


@pytest.mark.parametrize("name", SETTINGS)
def test_operator_has_the_documented_properties(name: str) -> None:
    assert SETTINGS[name] <= _rna(name).keys()


@pytest.mark.parametrize("name", SETTINGS)
def test_settings_of_one_run_do_not_leak_into_the_next(name: str) -> None:
    properties = _rna(name)
    for key in SETTINGS[name]:
        assert properties[key].is_skip_save, key


def test_nothing_said_anywhere_takes_defaults_from_the_model() -> None:
    obj = add_surface(barrel)
    bpy.ops.curvature.segment()
    # The box of the barrel: 2 x 2 and its rise of 2 - sqrt(3).
    diagonal = math.sqrt(4.0 + 4.0 + (2.0 - math.sqrt(3.0)) ** 2)
    assert _used(obj) == pytest.approx((diagonal / 20.0, diagonal / 20.0 / 200.0), rel=1e-6)


def test_scene_settings_are_used() -> None:
    obj = add_surface(barrel)
    bpy.context.scene.curvature.panel_size = 1.2
    bpy.context.scene.curvature.deviation = 0.003
    bpy.ops.curvature.segment()
    assert _used(obj) == pytest.approx((1.2, 0.003), rel=1e-12)


def test_operator_goes_before_the_scene() -> None:
    obj = add_surface(barrel)
    bpy.context.scene.curvature.panel_size = 1.2
    bpy.context.scene.curvature.deviation = 0.003
    bpy.ops.curvature.segment(panel_size=0.8)
    assert _used(obj) == pytest.approx((0.8, 0.003), rel=1e-12)


def test_zero_takes_the_setting_of_the_scene() -> None:
    obj = add_surface(barrel)
    bpy.context.scene.curvature.panel_size = 1.2
    bpy.ops.curvature.segment(panel_size=0.0, deviation=0.0)
    assert _used(obj) == pytest.approx((1.2, 1.2 / 200.0), rel=1e-12)


def test_operator_does_not_change_the_settings_of_the_scene() -> None:
    add_surface(barrel)
    bpy.ops.curvature.segment(panel_size=0.8, deviation=0.01, crease_angle=0.3)
    settings = bpy.context.scene.curvature
    assert (settings.panel_size, settings.deviation) == (0.0, 0.0)
    assert settings.crease_angle == pytest.approx(math.radians(30.0))


def test_run_without_a_value_does_not_repeat_the_run_before() -> None:
    obj = add_surface(barrel)
    bpy.ops.curvature.segment(**STRICT)
    bpy.ops.curvature.segment()
    assert _used(obj)[0] != STRICT["panel_size"]


def test_class_follows_the_tolerance() -> None:
    """A barrel of radius 2 is flat at a panel whose limit radius is below 2: s² / (8 d) < 2."""
    obj = add_surface(barrel)
    bpy.ops.curvature.segment(panel_size=1.0, deviation=1.0 / 8.0 / 1.9)
    assert (stored(obj, "curvature_class") == 0).all()
    bpy.ops.curvature.segment(panel_size=1.0, deviation=1.0 / 8.0 / 2.1)
    assert (stored(obj, "curvature_class") == 1).all()


def test_flipped_normals_change_the_signs_and_not_the_classes() -> None:
    obj = add_surface(barrel)
    bpy.ops.curvature.segment(**STRICT)
    k1, k2, gaussian = (
        stored(obj, f"curvature_{name}").copy() for name in ("k1", "k2", "gaussian")
    )
    classes = stored(obj, "curvature_class").tolist()
    bpy.context.scene.curvature.flip_normals = True
    bpy.ops.curvature.segment(**STRICT)
    assert stored(obj, "curvature_k1") == pytest.approx(-k2)
    assert stored(obj, "curvature_k2") == pytest.approx(-k1)
    assert stored(obj, "curvature_gaussian") == pytest.approx(gaussian)
    assert stored(obj, "curvature_class").tolist() == classes


def test_minimum_area_absorbs_small_regions() -> None:
    """A flat roof with a small dome in its middle."""
    obj = add_surface(lambda x, y: 0.1 * np.maximum(1.0 - (x**2 + y**2) / 0.25, 0.0) ** 2)
    given = {"panel_size": 1.0, "deviation": 0.01, "crease_angle": math.pi}
    bpy.ops.curvature.segment(**given, min_area=1e-6)
    assert len(set(stored(obj, "curvature_region").tolist())) > 1
    bpy.ops.curvature.segment(**given, min_area=3.0)
    assert set(stored(obj, "curvature_region").tolist()) == {0}


def test_lengths_shown_in_the_panel_are_in_units_of_the_scene() -> None:
    scene = bpy.context.scene
    scene.unit_settings.scale_length = 0.001
    scene.curvature.panel_size_shown = 1200.0
    scene.curvature.deviation_shown = 3.0
    assert scene.curvature.panel_size == pytest.approx(1.2, rel=1e-6)
    assert scene.curvature.deviation == pytest.approx(0.003, rel=1e-6)
    scene.unit_settings.scale_length = 1.0
    assert scene.curvature.panel_size_shown == pytest.approx(1.2, rel=1e-6)


def test_settings_are_of_the_scene() -> None:
    bpy.context.scene.curvature.panel_size = 1.2
    other = bpy.data.scenes.new("Other")
    assert other.curvature.panel_size == 0.0


def test_settings_and_results_are_stored_in_the_file(tmp_path: Path) -> None:
    obj = add_surface(dome)
    bpy.context.scene.curvature.range_mode = "FIXED"
    bpy.context.scene.curvature.range_limit = 0.25
    bpy.ops.curvature.segment(**STRICT)
    report, classes = obj.data.curvature.report, stored(obj, "curvature_class").tolist()
    file = str(tmp_path / "design.blend")
    bpy.ops.wm.save_as_mainfile(filepath=file)
    bpy.ops.wm.open_mainfile(filepath=file)
    obj = bpy.data.objects["Roof"]
    only_select(obj)
    assert obj.data.curvature.report == report
    assert stored(obj, "curvature_class").tolist() == classes
    assert bpy.context.scene.curvature.range_limit == 0.25
    assert bpy.context.scene.curvature.quantity == "CLASS"
