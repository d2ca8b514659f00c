# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The command gives the numbers of the operators, and keeps its streams apart."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import bpy
import pytest
from models import add_surface, barrel, dome, only_select, saddle


def _of_operators(tmp_path: Path, **properties: float) -> dict:
    path = tmp_path / "operators.json"
    only_select(*[obj for obj in bpy.context.scene.objects if obj.type == "MESH"])
    bpy.ops.curvature.segment(**properties)
    bpy.ops.curvature.export_report(filepath=str(path))
    return json.loads(path.read_text(encoding="utf-8"))


@pytest.mark.parametrize(
    ("arguments", "properties"),
    [
        ([], {}),
        (["--panel-size", 1.0, "--deviation", 0.01], {"panel_size": 1.0, "deviation": 0.01}),
        (["--crease-angle", 5], {"crease_angle": math.radians(5.0)}),
        (
            ["--smallest-radius", 3.0, "--panel-size", 0.7],
            {"smallest_radius": 3.0, "panel_size": 0.7},
        ),
        (
            ["--gaussian-limit", 0.2, "--mean-limit", 0.4],
            {"gaussian_limit": 0.2, "mean_limit": 0.4},
        ),
        (["--min-area", 0.5, "--panel-size", 0.7], {"min_area": 0.5, "panel_size": 0.7}),
    ],
)
def test_numbers_are_those_of_the_operators(
    arguments: list,
    properties: dict,
    command: Callable[..., Any],
    save: Callable[..., Any],
    tmp_path: Path,
) -> None:
    add_surface(lambda x, y: 0.2 * dome(x, y) - 0.4 * abs(x), "A")
    add_surface(saddle, "B").location.x = 3.0
    ours = command("segment", save("model.blend"), "--json", *arguments).report
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "model.blend"))
    theirs = _of_operators(tmp_path, **properties)
    for report in (ours, theirs):
        report["objects"].sort(key=lambda block: block["name"])
        for block in report["objects"]:
            block["source"] = ""
    assert ours["objects"] == theirs["objects"]
    assert ours["settings"] == theirs["settings"]


def test_flipped_normals_flip_the_sign(command: Callable[..., Any], roof: Path) -> None:
    plain = command("segment", roof, "--json").report["objects"][0]
    flipped = command("segment", roof, "--json", "--flip-normals").report["objects"][0]
    assert flipped["mean_curvature"]["mean"] == pytest.approx(-plain["mean_curvature"]["mean"])
    assert flipped["classes"] == plain["classes"]


def test_one_line_per_object_goes_to_the_standard_output(
    command: Callable[..., Any], save: Callable[..., Any]
) -> None:
    add_surface(barrel, "Vault")
    add_surface(dome, "Dome")
    ended = command("segment", save("model.blend"), "--panel-size", 1.0, "--deviation", 0.01)
    lines = sorted(ended.out.splitlines())
    assert len(lines) == 2
    assert lines[0].startswith("model.blend: Dome: ")
    assert "double-curved dome 100.0 %" in lines[0]
    assert lines[1].startswith("model.blend: Vault: ")
    assert "single-curved 100.0 %" in lines[1]
    assert "1 region" in lines[1]
    assert "smallest radius 1.99 m" in lines[1] or "smallest radius 2.00 m" in lines[1]


def test_json_is_all_that_is_on_the_standard_output(
    command: Callable[..., Any], roof: Path
) -> None:
    ended = command("segment", roof, "--json")
    assert ended.report["schema"] == 1
    assert ended.out.lstrip().startswith("{")
    assert ended.out.rstrip().endswith("}")


def test_progress_goes_to_the_standard_error_and_can_be_silenced(
    command: Callable[..., Any], roof: Path, tmp_path: Path
) -> None:
    loud = command("segment", roof, "--report", tmp_path / "a.json")
    assert f"[1/1] {roof}" in loud.err
    assert "100 %" in loud.err
    assert f"wrote {tmp_path / 'a.json'}" in loud.err
    quiet = command("segment", roof, "--report", tmp_path / "b.json", "--quiet")
    assert quiet.err == ""
    assert quiet.out == loud.out


def test_warnings_are_told(command: Callable[..., Any], save: Callable[..., Any]) -> None:
    add_surface(dome).data.vertices.add(1)
    ended = command("segment", save("model.blend"), "--json")
    assert ended.status == 0
    assert "warning: Roof: 1 vertex has no faces" in ended.err
    assert len(ended.report["objects"][0]["warnings"]) == 1


@pytest.mark.parametrize("quantity", ["GAUSSIAN", "MEAN", "K1", "K2", "CLASS", "REGION"])
def test_quantity_is_the_one_that_the_file_shows(
    quantity: str, command: Callable[..., Any], roof: Path, tmp_path: Path
) -> None:
    out = tmp_path / "out.blend"
    ended = command(
        "segment",
        roof,
        "--output",
        out,
        "--quantity",
        quantity,
        "--color-map",
        "PURPLE_ORANGE",
        "--range",
        0.75,
    )
    assert ended.status == 0
    bpy.ops.wm.open_mainfile(filepath=str(out))
    settings = bpy.context.scene.curvature
    assert settings.quantity == quantity
    assert settings.color_map == "PURPLE_ORANGE"
    assert (settings.range_mode, settings.range_limit) == ("FIXED", 0.75)


def test_second_run_on_the_output_gives_the_same(
    command: Callable[..., Any], save: Callable[..., Any], tmp_path: Path
) -> None:
    """The output holds the copy that carries the results: it is no model of its own."""
    add_surface(dome).modifiers.new("Subdivision", "SUBSURF").levels = 1
    out = tmp_path / "out.blend"
    first = command("segment", save("model.blend"), "--output", out, "--json").report
    second = command("segment", out, "--json").report
    for report in (first, second):
        report["objects"][0]["source"] = ""
    assert second == first
