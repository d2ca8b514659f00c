# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every panel draws in every state, and measures nothing while it does."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import bpy
import pytest
from architectural_curvature.addon.bridge import display, subject
from layout_stub import Layout
from models import STRICT, add_surface, barrel, dome, only_select, plate, report_of


def _panels() -> list[type]:
    found = [
        getattr(bpy.types, name) for name in dir(bpy.types) if name.startswith("CURVATURE_PT_")
    ]
    assert found
    return sorted(found, key=lambda panel: panel.__name__)


def _draw(name: str) -> Layout:
    layout = Layout()
    panel = getattr(bpy.types, f"CURVATURE_PT_{name}")
    context = _Context()
    if hasattr(panel, "poll") and not panel.poll(context):
        return layout
    panel.draw(SimpleNamespace(layout=layout), context)
    return layout


class _Context:
    """Blender's context with a region, which it lacks without a window."""

    region = SimpleNamespace(width=280)
    preferences = SimpleNamespace(system=SimpleNamespace(ui_scale=1.0))

    def __getattr__(self, name: str) -> object:
        return getattr(bpy.context, name)


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
        _draw(panel.__name__.removeprefix("CURVATURE_PT_"))


@pytest.mark.parametrize("quantity", ["NONE", "GAUSSIAN", "MEAN", "K1", "K2", "CLASS", "REGION"])
@pytest.mark.parametrize("range_mode", ["PERCENTILE", "FIXED"])
def test_analysis_panel_offers_what_matters_for_the_quantity(
    quantity: str, range_mode: str
) -> None:
    _segmented()
    settings = bpy.context.scene.curvature
    settings.range_mode = range_mode
    settings.quantity = quantity
    shown = _draw("analysis")
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
    shown = _draw("segmentation")
    words = " ".join(shown.texts)
    # s² / (8 d) = 1.44 / 0.048 = 30 m.
    assert "radius of 30 m" in words
    assert "6 mm" in words
    assert shown.operators[-1] == "curvature.segment"


def test_defaults_of_the_model_are_said_before_it_is_segmented() -> None:
    """A plate with a diagonal of 2 sqrt(2) m: panels of 0.141 m, limit 25 s = 3.54 m."""
    add_surface(plate)
    bpy.context.view_layer.update()
    assert "radius of 3.54 m" in " ".join(_draw("segmentation").texts)


def test_results_panel_asks_for_a_segmentation() -> None:
    _analyzed()
    assert "Segment a model to see its classes" in _draw("results").texts


def test_results_panel_has_every_class_with_its_figures() -> None:
    _segmented()
    shown = _draw("results")
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
    assert hint not in " ".join(_draw("results").texts)
    for name, value in (("deviation", 0.02), ("crease_angle", 0.3), ("smoothing", "NONE")):
        before = getattr(settings, name)
        setattr(settings, name, value)
        assert hint in " ".join(_draw("results").texts)
        setattr(settings, name, before)
    # The limits of criteria that were not chosen do not count.
    settings.smallest_radius = 7.0
    assert hint not in " ".join(_draw("results").texts)
    bpy.ops.curvature.segment(deviation=0.02)
    assert hint in " ".join(_draw("results").texts)


def test_results_of_the_copy_are_shown_for_its_source() -> None:
    _on_a_copy()
    expected = _draw("results").texts
    source = bpy.data.objects["Roof"]
    source.hide_set(False)
    only_select(source)
    assert _draw("results").texts == expected


def test_warnings_are_shown_only_where_there_are_some() -> None:
    _segmented()
    assert not _draw("warnings").texts
    bpy.ops.curvature.clear()
    bpy.context.object.data.vertices.add(2)
    bpy.context.object.data.update()
    bpy.ops.curvature.segment(**STRICT)
    assert " ".join(_draw("warnings").texts).startswith("2 vertices have no faces")


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
    shown = _draw("segmentation")
    assert shown.properties == ["criterion", *fields, "min_area_shown", "crease_angle"]
    asks = "Set the limits, or choose a preset" in " ".join(shown.texts)
    assert asks == (criterion != "PANEL")


def test_segmentation_panel_names_the_preset_and_its_source() -> None:
    add_surface(plate)
    assert _draw("segmentation").texts[0] == "Presets"
    settings = bpy.context.scene.curvature
    settings.criterion, settings.smallest_radius = "RADIUS", 12.0
    settings.criterion_preset, settings.criterion_source = "Cold-bent Glass 8 mm", "By Sedak"
    shown = _draw("segmentation")
    assert shown.texts[0] == "Cold-bent Glass 8 mm"
    assert "By Sedak" in shown.texts
    assert "radius of at least 12 m" in " ".join(shown.texts)


def test_changes_panel_names_the_criterion_before() -> None:
    _segmented()
    bpy.ops.curvature.segment(smallest_radius=1.0)
    assert "before: single-curved: within 10 mm" in " ".join(_draw("changes").texts)


def test_lines_panel_counts_what_the_model_has() -> None:
    _mesh()
    shown = _draw("lines")
    assert shown.operators == ["curvature.trace_lines", "curvature.find_umbilics"]
    assert "fit_tolerance_shown" not in shown.properties
    bpy.context.scene.curvature.fit_curves = True
    assert "fit_tolerance_shown" in _draw("lines").properties
    bpy.context.scene.curvature.fit_curves = False
    only_select(add_surface(barrel, "Vault"))
    bpy.ops.curvature.trace_lines(spacing=0.25)
    bpy.ops.curvature.find_umbilics()
    shown = _draw("lines")
    count = len(bpy.data.objects["Vault Lines 1"].data.splines)
    words = " ".join(shown.texts)
    assert f"Lines 1 {count} lines, " in words
    assert "Umbilics 0 points" in words
    assert "Spacing 25 cm" in words
    assert "Off the Surface" not in words
    assert shown.operators[-1] == "curvature.export_lines"
    only_select(bpy.data.objects["Vault Lines 2"])
    assert _draw("lines").texts == shown.texts
    bpy.ops.curvature.trace_lines(spacing=0.25, fit_curves=True)
    deviation = report_of(bpy.data.objects["Vault"])["curvature_lines"]["deviation"]
    text = bpy.utils.units.to_string("METRIC", "LENGTH", float(f"{deviation:.3g}"), precision=3)
    assert f"Off the Surface {text}" in " ".join(_draw("lines").texts)


def test_hatching_panel_asks_for_a_light_only_where_it_shades() -> None:
    assert "hatch_light" in _draw("hatching").properties
    bpy.context.scene.curvature.hatch_tone = "CURVATURE"
    assert "hatch_light" not in _draw("hatching").properties


def test_single_lines_can_be_picked_or_run_through_points() -> None:
    assert _draw("picking").operators == ["curvature.pick_lines", "curvature.trace_through"]


def _has_hint() -> bool:
    return any(text.startswith("Made before the model") for text in _draw("lines").texts)


def test_lines_of_an_earlier_state_are_marked() -> None:
    obj = add_surface(barrel, "Vault")
    bpy.ops.curvature.trace_lines(spacing=0.5)
    assert not _has_hint()
    obj.data.vertices[40].co.z += 0.1
    obj.data.update()
    bpy.ops.curvature.segment()
    assert _has_hint()
    bpy.ops.curvature.find_umbilics()
    assert _has_hint()
    bpy.ops.curvature.trace_lines(spacing=0.5)
    assert not _has_hint()
    # Another object with the same mesh, at another scale, is another state of the same mesh.
    other = bpy.data.objects.new("Other", obj.data)
    bpy.context.scene.collection.objects.link(other)
    other.scale = (2.0, 2.0, 2.0)
    only_select(other)
    bpy.ops.curvature.segment()
    only_select(obj)
    assert not _has_hint()


def test_lines_panel_tells_the_lengths_that_zero_stands_for() -> None:
    add_surface(plate)
    settings = bpy.context.scene.curvature
    # A plate 2 m wide and long: a twentieth of its diagonal, and 4 % of that.
    assert "Lines 14.1 cm apart, 5.66 mm thick" in " ".join(_draw("lines").texts)
    settings.spacing, settings.thickness, settings.fit_curves = 0.5, 0.01, True
    assert "Lines 50 cm apart, 1 cm thick, within 1 mm" in " ".join(_draw("lines").texts)
    settings.spacing = 1e-5
    assert "is too fine for a model of 2.83 m" in " ".join(_draw("lines").texts)
    only_select()
    assert "apart" not in " ".join(_draw("lines").texts)
