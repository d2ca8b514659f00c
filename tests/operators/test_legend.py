# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The legend says what the colors mean that are shown."""

from __future__ import annotations

from pathlib import Path

import bpy
import numpy as np
import pytest
from architectural_curvature.addon.geometry.display.legend import ClassKey, ColorBar
from architectural_curvature.addon.overlay.content import legend_of
from bpy.types import Object
from models import STRICT, add_surface, barrel, dome, only_select, plate

UNITS = {"GAUSSIAN": "1/m²", "MEAN": "1/m", "K1": "1/m", "K2": "1/m"}
TITLES = {
    "GAUSSIAN": "Gaussian Curvature",
    "MEAN": "Mean Curvature",
    "K1": "Principal Curvature 1",
    "K2": "Principal Curvature 2",
}


def _legend(active: Object | None = None) -> ColorBar | ClassKey | None:
    return legend_of(bpy.context.scene, active or bpy.context.view_layer.objects.active)


def _shares(active: Object | None = None) -> dict[str, str]:
    return {name: share for _color, name, share in _legend(active).rows}


def test_nothing_analyzed_has_no_legend() -> None:
    add_surface(dome)
    assert _legend() is None


@pytest.mark.parametrize("quantity", UNITS)
def test_color_bar_follows_quantity_map_and_range(quantity: str) -> None:
    add_surface(dome)
    bpy.ops.curvature.analyze()
    settings = bpy.context.scene.curvature
    settings.color_map = "PURPLE_ORANGE"
    settings.range_mode, settings.range_limit = "FIXED", 0.75
    bpy.ops.curvature.show(quantity=quantity)
    legend = _legend()
    assert isinstance(legend, ColorBar)
    assert (legend.title, legend.unit) == (TITLES[quantity], UNITS[quantity])
    assert legend.color_map.name == "PURPLE_ORANGE"
    assert legend.limit == pytest.approx(0.75)


def test_share_beyond_the_range_is_said() -> None:
    add_surface(dome)
    bpy.ops.curvature.analyze()
    settings = bpy.context.scene.curvature
    settings.range_mode, settings.range_limit = "FIXED", 0.1
    bpy.ops.curvature.show(quantity="MEAN")
    assert _legend().notes == ("100.0 % of the area lies beyond",)
    settings.range_limit = 10.0
    assert _legend().notes == ()


def test_class_key_has_the_shares_of_the_active_object() -> None:
    roof, canopy = add_surface(plate, "Roof"), add_surface(dome, "Canopy")
    bpy.ops.curvature.segment(**STRICT)
    assert _shares(roof)["Flat"] == "100.0 %"
    assert _shares(canopy)["Flat"] == "0.0 %"
    assert "Undefined" not in _shares(roof)


def test_class_key_has_the_shares_of_all_models_where_none_is_active() -> None:
    add_surface(plate, "A")
    add_surface(plate, "B")
    bpy.ops.curvature.segment(**STRICT)
    only_select()
    assert _shares()["Flat"] == "100.0 %"


def test_shares_of_several_models_are_weighted_by_area() -> None:
    add_surface(plate, "Large").scale = (2.0, 2.0, 2.0)
    add_surface(barrel, "Small")
    bpy.context.view_layer.update()
    bpy.ops.curvature.segment(**STRICT)
    only_select()
    flat = 16.0
    bent = sum(row.area for row in bpy.data.objects["Small"].data.curvature.classes)
    assert _shares()["Flat"] == f"{100.0 * flat / (flat + bent):.1f} %"


def test_tolerance_is_said_in_units_of_the_scene() -> None:
    add_surface(barrel)
    bpy.context.scene.unit_settings.system = "METRIC"
    bpy.ops.curvature.segment(panel_size=1.2, deviation=0.006)
    notes = " ".join(_legend().notes)
    # The limit radius is s² / (8 d) = 30 m.
    for part in ("6 mm", "1.2 m", "30 m"):
        assert part in notes, notes


def test_regions_have_a_key_with_their_classes() -> None:
    add_surface(lambda x, _y: -np.abs(x))
    bpy.ops.curvature.segment(**STRICT)
    bpy.ops.curvature.show(quantity="REGION")
    legend = _legend()
    assert isinstance(legend, ClassKey)
    assert [row[1:] for row in legend.rows] == [
        ("Region 1", "Flat"),
        ("Region 2", "Flat"),
    ]


def test_legend_of_the_source_is_that_of_its_copy() -> None:
    obj = add_surface(dome)
    obj.modifiers.new("Subdivision", "SUBSURF").levels = 1
    bpy.ops.curvature.segment(**STRICT)
    assert _legend(obj) == _legend(bpy.data.objects["Roof Curvature"])


def test_legend_follows_undo() -> None:
    add_surface(dome)
    bpy.ops.ed.undo_push(message="Model")
    bpy.ops.curvature.segment(**STRICT)
    bpy.ops.ed.undo_push(message="Segment")
    assert _legend() is not None
    bpy.ops.ed.undo()
    assert _legend() is None
    bpy.ops.ed.redo()
    assert _legend() is not None


def test_legend_of_a_loaded_file_is_that_of_the_saved_one(tmp_path: Path) -> None:
    add_surface(dome)
    bpy.ops.curvature.segment(**STRICT)
    before = _legend()
    file = str(tmp_path / "design.blend")
    bpy.ops.wm.save_as_mainfile(filepath=file)
    bpy.ops.wm.open_mainfile(filepath=file)
    assert _legend() == before


def test_tolerance_is_said_as_a_cylinder_over_a_panel() -> None:
    add_surface(barrel)
    bpy.context.scene.unit_settings.system = "METRIC"
    bpy.ops.curvature.segment(panel_size=1.5, deviation=0.005)
    words = " ".join(_legend().notes)
    assert words.startswith("Single-curved: within 5 mm of a cylinder over a 1.5 m panel")
    # 1.5² / (8 · 0.005) = 56.25 m, with three digits.
    assert words.endswith("straight above a radius of 56.2 m")


def test_tolerance_is_said_in_feet_and_inches_where_the_scene_has_them() -> None:
    add_surface(barrel)
    bpy.context.scene.unit_settings.system = "IMPERIAL"
    bpy.ops.curvature.segment(panel_size=1.524, deviation=0.00635)
    words = " ".join(_legend().notes)
    assert "within 250 thou of a cylinder over a 5' panel" in words
    # (5 ft)² / (8 · 1/4 in) = 25 · 144 / 2 in = 150 ft.
    assert words.endswith("straight above a radius of 150'")


def test_smallest_radius_and_its_preset_are_said() -> None:
    add_surface(barrel)
    settings = bpy.context.scene.curvature
    settings.criterion, settings.smallest_radius = "RADIUS", 12.0
    settings.criterion_preset = "Cold-bent Glass 8 mm"
    bpy.ops.curvature.segment()
    assert _legend().notes == ("Straight: radius of at least 12 m", "Cold-bent Glass 8 mm")


def test_raw_limits_are_said() -> None:
    add_surface(barrel)
    bpy.ops.curvature.segment(gaussian_limit=0.01, mean_limit=0.125)
    assert _legend().notes == (
        "Single-curved: |K| at most 0.01 1/m²",
        "Flat: also |H| at most 0.125 1/m",
    )


def test_objects_of_different_tolerances_have_no_words_in_common() -> None:
    first = add_surface(barrel, "First")
    second = add_surface(barrel, "Second")
    bpy.ops.curvature.segment(**STRICT)
    only_select()
    assert legend_of(bpy.context.scene, None).notes
    only_select(second)
    bpy.ops.curvature.segment(smallest_radius=3.0)
    assert legend_of(bpy.context.scene, None).notes == ()
    assert _legend(first).notes != _legend(second).notes
