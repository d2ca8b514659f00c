# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Classes follow the criterion: panel and deviation, smallest radius, or raw limits."""

from __future__ import annotations

import importlib
import json
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import bpy
import pytest
from bpy.types import Object
from layout_stub import Layout
from models import RADIUS, STRICT, add_surface, barrel, dome, inner_vertices, stored

#: Share by which a fit over two rings of cells of 1/8 m may miss a curvature of 1/2.
MISFIT = 0.02
FLAT, SINGLE, ELLIPTIC = 0, 1, 2
Report = Callable[..., tuple[set[str], str]]


def _block(obj: Object) -> dict[str, Any]:
    return json.loads(obj.data.curvature.report)


def _classes(obj: Object) -> set[int]:
    return set(stored(obj, "curvature_class").tolist())


def test_a_barrel_is_flat_to_a_material_that_bends_to_its_radius() -> None:
    obj = add_surface(barrel)
    bpy.ops.curvature.segment(criterion="RADIUS", smallest_radius=RADIUS * (1.0 - MISFIT))
    assert _classes(obj) == {FLAT}
    bpy.ops.curvature.segment(criterion="RADIUS", smallest_radius=RADIUS * (1.0 + MISFIT))
    assert _classes(obj) == {SINGLE}


def test_the_radius_goes_through_the_scene() -> None:
    obj = add_surface(barrel)
    settings = bpy.context.scene.curvature
    settings.criterion, settings.smallest_radius = "RADIUS", RADIUS / 2.0
    bpy.ops.curvature.segment()
    assert _classes(obj) == {FLAT}
    bpy.ops.curvature.segment(smallest_radius=2.0 * RADIUS)
    assert _classes(obj) == {SINGLE}
    assert settings.smallest_radius == RADIUS / 2.0


@pytest.mark.parametrize(
    ("model", "gaussian", "mean", "expected"),
    [
        (dome, (1.0 + 2 * MISFIT) / RADIUS**2, (1.0 + MISFIT) / RADIUS, FLAT),
        (dome, (1.0 - 2 * MISFIT) / RADIUS**2, (1.0 + MISFIT) / RADIUS, ELLIPTIC),
        (barrel, 0.01, 0.5 * (1.0 + MISFIT) / RADIUS, FLAT),
        (barrel, 0.01, 0.5 * (1.0 - MISFIT) / RADIUS, SINGLE),
    ],
)
def test_raw_limits_are_of_gaussian_and_mean_curvature(
    model: Callable[..., Any], gaussian: float, mean: float, expected: int
) -> None:
    """A sphere of radius R has K = 1/R² and H = 1/R, a cylinder K = 0 and H = 1/2R."""
    obj = add_surface(model)
    bpy.ops.curvature.segment(criterion="RAW", gaussian_limit=gaussian, mean_limit=mean)
    assert _classes(obj) == {expected}
    # Points and faces are told apart by the same limits.
    types = stored(obj, "curvature_point_type")[inner_vertices(obj)]
    assert set(types.tolist()) == {expected}


@pytest.mark.parametrize(
    ("told", "criterion"),
    [
        ({"deviation": 0.01}, "PANEL"),
        ({"smallest_radius": 3.0}, "RADIUS"),
        ({"gaussian_limit": 0.1, "mean_limit": 0.2}, "RAW"),
        ({"panel_size": 1.0}, "RADIUS"),
    ],
)
def test_a_limit_brings_its_criterion(told: dict[str, float], criterion: str) -> None:
    """The panel size counts with every criterion, and leaves the scene's."""
    obj = add_surface(dome)
    settings = bpy.context.scene.curvature
    settings.criterion, settings.smallest_radius = "RADIUS", 5.0
    bpy.ops.curvature.segment(**told)
    assert obj.data.curvature.criterion == criterion
    assert _block(obj)["criterion"] == criterion


def test_a_limit_that_a_button_gives_brings_its_criterion() -> None:
    obj = add_surface(dome)
    bpy.ops.curvature.segment("INVOKE_DEFAULT", smallest_radius=3.0)
    assert obj.data.curvature.criterion == "RADIUS"


def test_limits_of_two_criteria_are_refused(run: Report) -> None:
    obj = add_surface(dome)
    result, words = run("segment", deviation=0.01, smallest_radius=3.0)
    assert result == {"CANCELLED"}
    assert "deviation and smallest radius belong to different criteria" in words
    assert not obj.data.curvature.fingerprint


@pytest.mark.parametrize(
    ("criterion", "words"), [("RADIUS", "smallest radius"), ("RAW", "limit of |H|")]
)
def test_missing_limits_are_asked_for_but_measuring_goes_on(
    criterion: str, words: str, run: Report
) -> None:
    obj = add_surface(dome)
    bpy.context.scene.curvature.criterion = criterion
    result, said = run("segment")
    assert result == {"CANCELLED"}
    assert f"the {words} must be greater than zero" in said
    assert not obj.data.curvature.fingerprint
    assert run("analyze")[0] == {"FINISHED"}
    assert obj.data.curvature.fingerprint


def test_the_report_names_the_limits_and_what_follows_from_them() -> None:
    obj = add_surface(dome)
    bpy.ops.curvature.segment(criterion="RADIUS", smallest_radius=12.0, panel_size=1.5)
    block = _block(obj)
    assert (block["criterion"], block["smallest_radius"]) == ("RADIUS", 12.0)
    assert block["panel_size"] == 1.5
    assert block["deviation"] == pytest.approx(1.5**2 / (8.0 * 12.0), rel=1e-12)
    assert block["curvature_limit"] == pytest.approx(1.0 / 12.0, rel=1e-12)
    assert "12 m" in block["criterion_words"]
    assert not {"gaussian_limit", "mean_limit", "criterion_preset"} & block.keys()
    bpy.ops.curvature.segment(gaussian_limit=0.01, mean_limit=0.2)
    block = _block(obj)
    assert (block["gaussian_limit"], block["mean_limit"]) == (0.01, 0.2)
    assert "0.01 1/m²" in block["criterion_words"]
    assert "smallest_radius" not in block
    bpy.ops.curvature.segment(panel_size=1.5, deviation=0.005)
    block = _block(obj)
    assert "within 5 mm of a cylinder over a 1.5 m panel" in block["criterion_words"]
    assert not {"gaussian_limit", "mean_limit", "smallest_radius"} & block.keys()


def test_the_exported_settings_have_the_criterion(tmp_path: Path) -> None:
    add_surface(dome)
    bpy.ops.curvature.segment(smallest_radius=3.0, min_area=0.25)
    path = tmp_path / "report.json"
    bpy.ops.curvature.export_report(filepath=str(path))
    settings = json.loads(path.read_text(encoding="utf-8"))["settings"]
    assert settings["criterion"] == "RADIUS"
    assert settings["smallest_radius"] == 3.0
    assert settings["min_area"] == 0.25


def test_the_least_area_that_was_taken_is_told() -> None:
    """One panel, here 0.01 m², or half a percent of the model where that is less."""
    obj = add_surface(barrel)
    bpy.ops.curvature.segment(panel_size=0.1, deviation=0.001)
    assert _block(obj)["min_area"] == pytest.approx(0.01)
    assert obj.data.curvature.min_area == pytest.approx(0.01)
    bpy.ops.curvature.segment(**STRICT)
    assert _block(obj)["min_area"] == pytest.approx(0.005 * _block(obj)["area"])


def test_a_change_of_criterion_is_told_with_what_it_changed() -> None:
    obj = add_surface(dome)
    bpy.ops.curvature.segment(**STRICT)
    bpy.ops.curvature.segment(smallest_radius=RADIUS / 2.0)
    block = _block(obj)
    assert block["comparison"]["flat"]["after"] > block["comparison"]["flat"]["before"]
    assert "within 10 mm of a cylinder over a 1 m panel" in block["previous_criterion"]


def test_a_change_of_the_model_alone_names_no_criterion() -> None:
    obj = add_surface(dome)
    bpy.ops.curvature.segment(**STRICT)
    for vertex in obj.data.vertices:
        vertex.co.z = 0.0
    obj.data.update()
    bpy.ops.curvature.segment(**STRICT)
    assert "comparison" in _block(obj)
    assert "previous_criterion" not in _block(obj)


def test_the_criterion_is_stored_in_the_file(tmp_path: Path) -> None:
    add_surface(dome)
    settings = bpy.context.scene.curvature
    settings.criterion, settings.gaussian_limit, settings.mean_limit = "RAW", 0.125, 0.25
    bpy.ops.curvature.segment()
    file = str(tmp_path / "design.blend")
    bpy.ops.wm.save_as_mainfile(filepath=file)
    bpy.ops.wm.open_mainfile(filepath=file)
    settings = bpy.context.scene.curvature
    assert (settings.criterion, settings.gaussian_limit, settings.mean_limit) == (
        "RAW",
        0.125,
        0.25,
    )
    assert bpy.data.objects["Roof"].data.curvature.criterion == "RAW"


def test_the_radius_is_shown_in_units_of_the_scene() -> None:
    scene = bpy.context.scene
    scene.unit_settings.scale_length = 0.001
    scene.curvature.smallest_radius_shown = 12000.0
    assert scene.curvature.smallest_radius == pytest.approx(12.0, rel=1e-6)


@pytest.mark.parametrize(
    ("criterion", "expected"),
    [
        ("PANEL", ["panel_size", "deviation"]),
        ("RADIUS", ["smallest_radius", "panel_size"]),
        ("RAW", ["gaussian_limit", "mean_limit", "panel_size"]),
    ],
)
def test_the_redo_panel_offers_what_matters(
    criterion: str, expected: list[str], extension: str
) -> None:
    operator = importlib.import_module(f"{extension}.operators.segment").CURVATURE_OT_segment
    rna = bpy.ops.curvature.segment.get_rna_type()
    values = {name: None for name, _ in rna.properties.items()}
    told = SimpleNamespace(**{**values, "criterion": criterion, "bl_rna": rna, "layout": Layout()})
    operator.draw(told, bpy.context)
    assert told.layout.properties == ["criterion", *expected, "crease_angle", "min_area"]
