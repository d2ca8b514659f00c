# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The panels of lines say what there is, what zeros stand for, and what is out of date."""

from __future__ import annotations

import bpy
from layout_stub import draw_panel
from models import add_surface, barrel, dome, only_select, plate, report_of


def test_lines_panel_counts_what_the_model_has() -> None:
    add_surface(dome)
    shown = draw_panel("lines")
    assert shown.operators == ["curvature.trace_lines", "curvature.find_umbilics"]
    assert "fit_tolerance_shown" not in shown.properties
    bpy.context.scene.curvature.fit_curves = True
    assert "fit_tolerance_shown" in draw_panel("lines").properties
    bpy.context.scene.curvature.fit_curves = False
    only_select(add_surface(barrel, "Vault"))
    bpy.ops.curvature.trace_lines(spacing=0.25)
    bpy.ops.curvature.find_umbilics()
    shown = draw_panel("lines")
    count = len(bpy.data.objects["Vault Lines 1"].data.splines)
    words = " ".join(shown.texts)
    assert f"Lines 1 {count} lines, " in words
    assert "Umbilics 0 points" in words
    assert "Spacing 25 cm" in words
    assert "Off the Surface" not in words
    assert shown.operators[-1] == "curvature.export_lines"
    only_select(bpy.data.objects["Vault Lines 2"])
    assert draw_panel("lines").texts == shown.texts
    bpy.ops.curvature.trace_lines(spacing=0.25, fit_curves=True)
    deviation = report_of(bpy.data.objects["Vault"])["curvature_lines"]["deviation"]
    text = bpy.utils.units.to_string("METRIC", "LENGTH", float(f"{deviation:.3g}"), precision=3)
    assert f"Off the Surface {text}" in " ".join(draw_panel("lines").texts)


def test_hatching_panel_asks_for_a_light_only_where_it_shades() -> None:
    assert "hatch_light" in draw_panel("hatching").properties
    bpy.context.scene.curvature.hatch_tone = "CURVATURE"
    assert "hatch_light" not in draw_panel("hatching").properties


def test_single_lines_can_be_picked_or_run_through_points() -> None:
    shown = draw_panel("picking")
    assert shown.operators == ["curvature.pick_lines", *["curvature.trace_through"] * 2]
    assert shown.buttons[1:] == ["Through 3D Cursor", "Through Selected Vertices"]


def _has_hint() -> bool:
    return any(text.startswith("Made before the model") for text in draw_panel("lines").texts)


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
    assert "Lines 14.1 cm apart, 5.66 mm thick" in " ".join(draw_panel("lines").texts)
    settings.spacing, settings.thickness, settings.fit_curves = 0.5, 0.01, True
    assert "Lines 50 cm apart, 1 cm thick, within 1 mm" in " ".join(draw_panel("lines").texts)
    settings.spacing = 1e-5
    assert "is too fine for a model of 2.83 m" in " ".join(draw_panel("lines").texts)
    only_select()
    assert "apart" not in " ".join(draw_panel("lines").texts)
