# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Files are written whole, never over others without being told, and named after their models."""

from __future__ import annotations

import csv
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import bpy
import pytest
from models import add_surface, barrel, dome, saddle, stored

OPTIONS = {"--output": ".blend", "--report": ".json", "--image": ".png"}
SMALL = ("--image-size", "160x100")


def _arguments(folder: Path) -> list[object]:
    return [part for option, end in OPTIONS.items() for part in (option, folder / f"out{end}")]


def test_blender_file_holds_the_results(
    command: Callable[..., Any], roof: Path, tmp_path: Path
) -> None:
    out = tmp_path / "out.blend"
    assert command("segment", roof, "--output", out, "--panel-size", 1).status == 0
    bpy.ops.wm.open_mainfile(filepath=str(out))
    obj = bpy.data.objects["Roof"]
    assert (stored(obj, "curvature_class") == 2).all()
    assert obj.data.curvature.is_segmented
    assert bpy.context.scene.curvature.quantity == "CLASS"
    assert obj.data.color_attributes.active_color.name == "Curvature Class"
    assert obj.material_slots[0].material.name == "Curvature Colors"


def test_reports_in_both_formats_are_written(
    command: Callable[..., Any], roof: Path, tmp_path: Path
) -> None:
    ended = command("segment", roof, "--report", tmp_path / "a.json", "--json")
    assert json.loads((tmp_path / "a.json").read_text(encoding="utf-8")) == ended.report
    assert command("segment", roof, "--report", tmp_path / "a.csv").status == 0
    rows = list(csv.reader((tmp_path / "a.csv").open(encoding="utf-8-sig", newline="")))
    assert rows[0] == ["object", "group", "name", "measure", "value", "unit"]


@pytest.mark.parametrize("option", OPTIONS)
def test_existing_file_is_not_replaced(
    option: str, command: Callable[..., Any], roof: Path, tmp_path: Path
) -> None:
    path = tmp_path / f"out{OPTIONS[option]}"
    path.write_bytes(b"precious")
    ended = command("segment", roof, option, path)
    assert ended.status == 1
    assert ended.err == f"curvature: {path}: the file exists; give --overwrite to replace it\n"
    assert path.read_bytes() == b"precious"


def test_existing_files_are_replaced_on_request(
    command: Callable[..., Any], roof: Path, tmp_path: Path
) -> None:
    arguments = _arguments(tmp_path)
    for path in arguments[1::2]:
        path.write_bytes(b"old")
    assert command("segment", roof, *arguments, "--overwrite", *SMALL).status == 0
    for path in arguments[1::2]:
        assert path.stat().st_size > 100


@pytest.mark.parametrize("with_overwrite", [False, True])
def test_model_is_never_replaced(
    with_overwrite: bool, command: Callable[..., Any], roof: Path
) -> None:
    before = roof.read_bytes()
    extra = ["--overwrite"] if with_overwrite else []
    ended = command("segment", roof, "--output", roof, *extra)
    assert ended.status == 1
    assert "this is one of the models" in ended.err
    assert roof.read_bytes() == before


def test_nothing_but_the_wanted_files_is_left(
    command: Callable[..., Any], roof: Path, tmp_path: Path
) -> None:
    out = tmp_path / "out"
    out.mkdir()
    assert command("segment", roof, *_arguments(out), *SMALL).status == 0
    assert sorted(path.name for path in out.iterdir()) == ["out.blend", "out.json", "out.png"]


def test_failure_leaves_the_old_files(command: Callable[..., Any], tmp_path: Path) -> None:
    arguments = _arguments(tmp_path)
    for path in arguments[1::2]:
        path.write_bytes(b"old")
    ended = command("segment", tmp_path / "missing.obj", *arguments, "--overwrite")
    assert ended.status == 1
    assert sorted(path.name for path in tmp_path.iterdir()) == ["out.blend", "out.json", "out.png"]
    assert {path.read_bytes() for path in arguments[1::2]} == {b"old"}


@pytest.fixture
def three(save: Callable[..., Any]) -> list[Path]:
    """Three models in files of their own."""
    paths = []
    for height, name in ((dome, "dome"), (barrel, "barrel"), (saddle, "saddle")):
        for obj in list(bpy.data.objects):
            bpy.data.objects.remove(obj)
        add_surface(height, name.title())
        paths.append(save(f"{name}.blend"))
    return paths


def test_several_models_get_files_of_their_own_and_one_report(
    command: Callable[..., Any], three: list[Path], tmp_path: Path
) -> None:
    out = tmp_path / "out"
    out.mkdir()
    ended = command("segment", *three, *_arguments(out), *SMALL)
    assert ended.status == 0
    assert sorted(path.name for path in out.iterdir()) == [
        "out-barrel.blend",
        "out-barrel.png",
        "out-dome.blend",
        "out-dome.png",
        "out-saddle.blend",
        "out-saddle.png",
        "out.json",
    ]
    report = json.loads((out / "out.json").read_text(encoding="utf-8"))
    assert [block["name"] for block in report["objects"]] == ["Dome", "Barrel", "Saddle"]
    assert [block["source"] for block in report["objects"]] == [str(path) for path in three]


def test_models_of_one_name_are_numbered(
    command: Callable[..., Any], three: list[Path], tmp_path: Path
) -> None:
    twin = tmp_path / "twin" / three[0].name
    twin.parent.mkdir()
    twin.write_bytes(three[0].read_bytes())
    assert command("segment", three[0], twin, "--output", tmp_path / "o.blend").status == 0
    assert (tmp_path / "o-dome-1.blend").is_file()
    assert (tmp_path / "o-dome-2.blend").is_file()


def test_failing_model_does_not_stop_the_others(
    command: Callable[..., Any], three: list[Path], tmp_path: Path
) -> None:
    models = [three[0], tmp_path / "missing.obj", three[2]]
    ended = command("segment", *models, "--report", tmp_path / "r.json", "--json")
    assert ended.status == 1
    assert [block["name"] for block in ended.report["objects"]] == ["Dome", "Saddle"]
    assert json.loads((tmp_path / "r.json").read_text(encoding="utf-8")) == ended.report
    assert f"curvature: {models[1]}: there is no such file" in ended.err
    assert ended.err.rstrip().endswith("2 of 3 models done")
