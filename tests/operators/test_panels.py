# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every panel draws in every state, and measures nothing while it does."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import bpy
import pytest
from architectural_curvature.addon.bridge import display, subject
from layout_stub import draw_panel
from models import STRICT, add_surface, dome, only_select, plate


def _panels() -> list[type]:
    found = [
        getattr(bpy.types, name) for name in dir(bpy.types) if name.startswith("CURVATURE_PT_")
    ]
    assert found
    return sorted(found, key=lambda panel: panel.__name__)


def _nothing() -> None:
    """An empty scene."""


def _light() -> None:
    bpy.ops.object.light_add()


def _mesh() -> None:
    add_surface(dome)


def _empty_mesh() -> None:
    mesh = bpy.data.meshes.new("Empty")
    obj = bpy.data.objects.new("Empty", mesh)
    bpy.context.scene.collection.objects.link(obj)
    only_select(obj)


def _analyzed() -> None:
    add_surface(dome)
    bpy.ops.curvature.analyze()


def _segmented() -> None:
    add_surface(dome)
    bpy.ops.curvature.segment(**STRICT)


def _unsound() -> None:
    obj = add_surface(dome)
    obj.data.vertices.add(2)
    bpy.ops.curvature.segment(**STRICT)


def _on_a_copy() -> None:
    add_surface(dome).modifiers.new("Subdivision", "SUBSURF")
    bpy.ops.curvature.segment(**STRICT)


def _nothing_active() -> None:
    _segmented()
    only_select()


def _in_edit_mode() -> None:
    _segmented()
    bpy.ops.object.mode_set(mode="EDIT")


def _with_lines() -> None:
    add_surface(dome)
    bpy.ops.curvature.trace_lines(spacing=0.3)
    bpy.ops.curvature.find_umbilics()


STATES = [
    _nothing,
    _light,
    _mesh,
    _empty_mesh,
    _analyzed,
    _segmented,
    _unsound,
    _on_a_copy,
    _nothing_active,
    _in_edit_mode,
    _with_lines,
]


@pytest.mark.parametrize("state", STATES, ids=lambda state: state.__name__.strip("_"))
def test_every_panel_draws_and_measures_nothing(
    state: Callable[..., Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    state()

    def refuse(*_arguments: object, **_options: object) -> None:
        pytest.fail("a panel reads or analyzes a mesh while it draws")

    for module in (display, subject):
        monkeypatch.setattr(module, "read_object", refuse)
    for panel in _panels():
        draw_panel(panel.__name__.removeprefix("CURVATURE_PT_"))


@pytest.mark.parametrize("quantity", ["NONE", "GAUSSIAN", "MEAN", "K1", "K2", "CLASS", "REGION"])
@pytest.mark.parametrize("range_mode", ["PERCENTILE", "FIXED"])
def test_analysis_panel_offers_what_matters_for_the_quantity(
    quantity: str, range_mode: str
) -> None:
    _segmented()
    settings = bpy.context.scene.curvature
    settings.range_mode = range_mode
    settings.quantity = quantity
    shown = draw_panel("analysis")
    assert "curvature.analyze" in shown.operators
    assert "quantity" in shown.properties
    has_map = quantity in ("GAUSSIAN", "MEAN", "K1", "K2")
    assert ("color_map" in shown.properties) == has_map
    assert ("range_limit" in shown.properties) == (has_map and range_mode == "FIXED")
    assert ("range_percentile" in shown.properties) == (has_map and range_mode == "PERCENTILE")


def test_segmentation_panel_says_the_radius_limit_in_words() -> None:
    add_surface(plate)
    bpy.context.scene.curvature.panel_size = 1.2
    bpy.context.scene.curvature.deviation = 0.006
    shown = draw_panel("segmentation")
    words = " ".join(shown.texts)
    # s² / (8 d) = 1.44 / 0.048 = 30 m.
    assert "radius of 30 m" in words
    assert "6 mm" in words
    assert shown.operators[-1] == "curvature.segment"


def test_defaults_of_the_model_are_said_before_it_is_segmented() -> None:
    """A plate with a diagonal of 2 sqrt(2) m: panels of 0.141 m, limit 25 s = 3.54 m."""
    add_surface(plate)
    bpy.context.view_layer.update()
    assert "radius of 3.54 m" in " ".join(draw_panel("segmentation").texts)


def test_results_panel_asks_for_a_segmentation() -> None:
    _analyzed()
    assert "Segment a model to see its classes" in draw_panel("results").texts


def test_results_panel_has_every_class_with_its_figures() -> None:
    _segmented()
    shown = draw_panel("results")
    words = " | ".join(shown.texts)
    for part in ("Flat", "Single-Curved", "100.0 %", "0.0 %", "256 faces", "1 region"):
        assert part.lower() in words.lower(), words
    # The dome's radius is 2 m; a fit over two rings is a little off.
    assert "R ≥ 1.98 m" in words or "R ≥ 1.99 m" in words or "R ≥ 2 m" in words, words
    assert shown.operators.count("curvature.select_class") == 4
    assert shown.operators[-1] == "curvature.export_report"


def test_results_panel_tells_when_the_settings_are_others_by_now() -> None:
    hint = "Made with other settings than those above"
    settings = bpy.context.scene.curvature
    settings.deviation = 0.013
    add_surface(dome)
    bpy.ops.curvature.segment()
    assert hint not in " ".join(draw_panel("results").texts)
    for name, value in (("deviation", 0.02), ("crease_angle", 0.3), ("smoothing", "NONE")):
        before = getattr(settings, name)
        setattr(settings, name, value)
        assert hint in " ".join(draw_panel("results").texts)
        setattr(settings, name, before)
    # The limits of criteria that were not chosen do not count.
    settings.smallest_radius = 7.0
    assert hint not in " ".join(draw_panel("results").texts)
    bpy.ops.curvature.segment(deviation=0.02)
    assert hint in " ".join(draw_panel("results").texts)


def test_results_of_the_copy_are_shown_for_its_source() -> None:
    _on_a_copy()
    expected = draw_panel("results").texts
    source = bpy.data.objects["Roof"]
    source.hide_set(False)
    only_select(source)
    assert draw_panel("results").texts == expected


def test_warnings_are_shown_only_where_there_are_some() -> None:
    _segmented()
    assert not draw_panel("warnings").texts
    bpy.ops.curvature.clear()
    bpy.context.object.data.vertices.add(2)
    bpy.context.object.data.update()
    bpy.ops.curvature.segment(**STRICT)
    assert " ".join(draw_panel("warnings").texts).startswith("2 vertices have no faces")


def test_panels_are_in_the_sidebar_tab() -> None:
    for panel in _panels():
        assert (panel.bl_space_type, panel.bl_region_type) == ("VIEW_3D", "UI")
        assert panel.bl_category == "Curvature"


@pytest.mark.parametrize(
    ("criterion", "fields"),
    [
        ("PANEL", ["panel_size_shown", "deviation_shown"]),
        ("RADIUS", ["smallest_radius_shown", "panel_size_shown"]),
        ("RAW", ["gaussian_limit", "mean_limit", "panel_size_shown"]),
    ],
)
def test_segmentation_panel_has_the_fields_that_matter(criterion: str, fields: list[str]) -> None:
    add_surface(plate)
    bpy.context.scene.curvature.criterion = criterion
    shown = draw_panel("segmentation")
    assert shown.properties == ["criterion", *fields, "min_area_shown", "crease_angle"]
    asks = "Set the limits, or choose a preset" in " ".join(shown.texts)
    assert asks == (criterion != "PANEL")


def test_segmentation_panel_names_the_preset_and_its_source() -> None:
    add_surface(plate)
    assert draw_panel("segmentation").texts[0] == "Presets"
    settings = bpy.context.scene.curvature
    settings.criterion, settings.smallest_radius = "RADIUS", 12.0
    settings.criterion_preset, settings.criterion_source = "Cold-bent Glass 8 mm", "By Sedak"
    shown = draw_panel("segmentation")
    assert shown.texts[0] == "Cold-bent Glass 8 mm"
    assert "By Sedak" in shown.texts
    assert "radius of at least 12 m" in " ".join(shown.texts)


def test_changes_panel_names_the_criterion_before() -> None:
    _segmented()
    bpy.ops.curvature.segment(smallest_radius=1.0)
    assert "before: single-curved: within 10 mm" in " ".join(draw_panel("changes").texts)
