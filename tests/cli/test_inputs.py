# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Models come in all formats that Blender reads, with their true size and shape."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import bpy
import pytest
from mathutils import Matrix
from models import RADIUS, add_surface, barrel, dome, plate, saddle

TOLERANCE = ("--panel-size", 1.0, "--deviation", 0.01)


def _usd(path: str) -> None:
    bpy.ops.wm.usd_export(filepath=path, selected_objects_only=True)


WRITERS = {
    ".obj": lambda path: bpy.ops.wm.obj_export(filepath=path),
    ".ply": lambda path: bpy.ops.wm.ply_export(filepath=path),
    ".stl": lambda path: bpy.ops.wm.stl_export(filepath=path),
    ".glb": lambda path: bpy.ops.export_scene.gltf(filepath=path),
    ".gltf": lambda path: bpy.ops.export_scene.gltf(filepath=path, export_format="GLTF_SEPARATE"),
    ".usd": _usd,
    ".usda": _usd,
    ".usdc": _usd,
    ".usdz": _usd,
    ".abc": lambda path: bpy.ops.wm.alembic_export(filepath=path),
    ".fbx": lambda path: bpy.ops.export_scene.fbx(filepath=path),
    ".blend": lambda path: bpy.ops.wm.save_as_mainfile(filepath=path, copy=True),
}


@pytest.mark.parametrize("ending", WRITERS)
def test_model_of_every_format_is_segmented(
    ending: str, command: Callable[..., Any], recorded: Callable[..., Any], tmp_path: Path
) -> None:
    add_surface(barrel)
    path = tmp_path / f"roof{ending}"
    with recorded():
        WRITERS[ending](str(path))
    ended = command("segment", path, "--json", *TOLERANCE)
    assert ended.status == 0, ended.err
    (block,) = ended.report["objects"]
    assert block["source"] == str(path)
    assert block["classes"]["single_curved"]["share"] == pytest.approx(1.0, abs=1e-6)
    # A fit over two rings of edges h = 1/8 is off by about (2 h / R)².
    assert block["classes"]["single_curved"]["min_radius"] == pytest.approx(
        RADIUS, rel=(2 / 8 / RADIUS) ** 2
    )


def test_every_known_ending_is_tested() -> None:
    from architectural_curvature.addon.bridge.importing import ENDINGS

    assert set(WRITERS) == set(ENDINGS)


def test_ending_may_be_in_capitals(command: Callable[..., Any], tmp_path: Path) -> None:
    add_surface(dome)
    bpy.ops.wm.obj_export(filepath=str(tmp_path / "ROOF.OBJ"))
    assert command("segment", tmp_path / "ROOF.OBJ").status == 0


def test_name_may_have_spaces_and_accents(command: Callable[..., Any], tmp_path: Path) -> None:
    add_surface(dome)
    path = tmp_path / "Dach Süd (2).obj"
    bpy.ops.wm.obj_export(filepath=str(path))
    assert command("segment", path, "--json").report["objects"][0]["source"] == str(path)


def test_every_object_of_a_file_is_segmented(
    command: Callable[..., Any], save: Callable[..., Any]
) -> None:
    for height, name in ((plate, "A"), (barrel, "B"), (saddle, "C")):
        add_surface(height, name)
    ended = command("segment", save("all.blend"), "--json", *TOLERANCE)
    shares = {
        block["name"]: max(block["classes"], key=lambda key: block["classes"][key]["share"])
        for block in ended.report["objects"]
    }
    assert shares == {"A": "flat", "B": "single_curved", "C": "double_curved_hyperbolic"}


def test_objects_that_renders_leave_out_are_left_out(
    command: Callable[..., Any], save: Callable[..., Any]
) -> None:
    add_surface(dome, "Shown")
    add_surface(dome, "Hidden").hide_render = True
    ended = command("segment", save("some.blend"), "--json")
    assert [block["name"] for block in ended.report["objects"]] == ["Shown"]


def test_modifiers_of_a_file_count(command: Callable[..., Any], save: Callable[..., Any]) -> None:
    add_surface(dome).modifiers.new("Subdivision", "SUBSURF").render_levels = 1
    (block,) = command("segment", save("roof.blend"), "--json").report["objects"]
    assert block["name"] == "Roof"
    assert block["faces"] == 4 * 256


def test_unit_of_the_file_counts(command: Callable[..., Any], save: Callable[..., Any]) -> None:
    bpy.context.scene.unit_settings.scale_length = 0.001
    add_surface(barrel).data.transform(Matrix.Scale(1000.0, 4))
    (block,) = command("segment", save("mm.blend"), "--json", *TOLERANCE).report["objects"]
    assert block["classes"]["single_curved"]["min_radius"] == pytest.approx(RADIUS, rel=0.02)


def test_unit_can_be_given(command: Callable[..., Any], tmp_path: Path) -> None:
    """A file in millimeters, which .obj cannot say."""
    add_surface(barrel).data.transform(Matrix.Scale(1000.0, 4))
    path = tmp_path / "mm.obj"
    bpy.ops.wm.obj_export(filepath=str(path))
    ended = command("segment", path, "--json", "--meters-per-unit", 0.001, *TOLERANCE)
    (block,) = ended.report["objects"]
    assert block["classes"]["single_curved"]["min_radius"] == pytest.approx(RADIUS, rel=0.02)
    assert ended.report["settings"]["scale_length"] == 0.001


@pytest.mark.parametrize("up", ["Y", "Z"])
def test_axis_that_points_up_can_be_given(
    up: str, command: Callable[..., Any], tmp_path: Path
) -> None:
    add_surface(lambda x, y: 0.01 * dome(x, y))
    path, out = tmp_path / "roof.obj", tmp_path / "out.blend"
    forward = {"Y": "NEGATIVE_Z", "Z": "Y"}[up]
    bpy.ops.wm.obj_export(filepath=str(path), up_axis=up, forward_axis=forward)
    assert command("segment", path, "--up", up, "--output", out).status == 0
    bpy.ops.wm.open_mainfile(filepath=str(out))
    (obj,) = bpy.context.scene.objects
    # The roof lies flat again: 2 x 2 wide and low.
    bpy.context.view_layer.update()
    assert obj.dimensions.z < 0.1 or (obj.matrix_world.to_3x3() @ obj.dimensions).z < 0.1
