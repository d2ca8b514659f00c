# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Each bad input ends in one clear line, exit status 1, and nothing is written."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import bpy
import numpy as np
import pytest
from models import add_mesh, add_surface, dome, grid


def _missing(folder: Path) -> Path:
    return folder / "missing.obj"


def _a_folder(folder: Path) -> Path:
    path = folder / "folder.obj"
    path.mkdir()
    return path


def _text(folder: Path) -> Path:
    path = folder / "notes.txt"
    path.write_text("not a model", encoding="utf-8")
    return path


def _broken(ending: str) -> Callable[[Path], Path]:
    def write(folder: Path) -> Path:
        path = folder / f"broken{ending}"
        path.write_bytes(b"this is no model\x00\xff")
        return path

    return write


def _no_bytes(folder: Path) -> Path:
    path = folder / "empty.obj"
    path.touch()
    return path


def _saved(make: Callable[[], object]) -> Callable[[Path], Path]:
    def write(folder: Path) -> Path:
        make()
        path = folder / "bad.blend"
        bpy.ops.wm.save_as_mainfile(filepath=str(path), copy=True)
        return path

    return write


def _nan() -> None:
    vertices, faces = grid(dome)
    vertices[7, 2] = np.nan
    add_mesh("Roof", vertices, faces)


def _flattened() -> None:
    add_surface(dome).scale = (1.0, 1.0, 0.0)


BAD = {
    "no file": (_missing, "there is no such file"),
    "a folder": (_a_folder, "there is no such file"),
    "not a model": (_text, "cannot read '.txt' files"),
    "broken obj": (_broken(".obj"), "no mesh"),
    "broken ply": (_broken(".ply"), ""),
    "broken stl": (_broken(".stl"), ""),
    "broken glb": (_broken(".glb"), ""),
    "broken usd": (_broken(".usd"), ""),
    "broken fbx": (_broken(".fbx"), ""),
    "broken blend": (_broken(".blend"), "Blender cannot read it"),
    "no bytes": (_no_bytes, ""),
    "no objects": (_saved(lambda: None), "there is no mesh with faces in it"),
    "no mesh": (_saved(bpy.ops.object.light_add), "there is no mesh with faces in it"),
    "empty mesh": (_saved(lambda: add_mesh("Roof", [], [])), "there is no mesh with faces in it"),
    "lone vertices": (
        _saved(lambda: add_mesh("Roof", [(0, 0, 0), (1, 0, 0)], [])),
        "there is no mesh with faces in it",
    ),
    "NaN coordinates": (_saved(_nan), "Roof: 1 of 289 vertices have coordinates"),
    "no scale": (_saved(_flattened), "the scale of the object is zero"),
}


@pytest.mark.parametrize("kind", BAD)
def test_bad_input_ends_in_one_line_and_writes_nothing(
    kind: str, command: Callable[..., Any], tmp_path: Path
) -> None:
    make, words = BAD[kind]
    model = make(tmp_path)
    out = tmp_path / "out"
    out.mkdir()
    ended = command(
        "segment",
        model,
        "--quiet",
        "--output",
        out / "a.blend",
        "--report",
        out / "a.json",
        "--image",
        out / "a.png",
    )
    assert ended.status == 1
    assert ended.out == ""
    lines = ended.err.splitlines()
    assert len(lines) == 1, ended.err
    assert lines[0].startswith(f"curvature: {model}: ")
    assert words in lines[0]
    assert not list(out.iterdir())


@pytest.mark.parametrize("option", ["--output", "--report", "--image"])
def test_folder_that_cannot_be_written_to_is_refused_before_any_work(
    option: str, command: Callable[..., Any], roof: Path, tmp_path: Path
) -> None:
    """A file in place of the folder stops even the administrator."""
    obstacle = tmp_path / "obstacle"
    obstacle.touch()
    ending = {"--output": ".blend", "--report": ".json", "--image": ".png"}[option]
    path = obstacle / f"out{ending}"
    ended = command("segment", roof, option, path)
    assert ended.status == 1
    assert len(ended.err.splitlines()) == 1
    assert f"{path}: cannot write into the folder" in ended.err
    assert ended.out == ""


@pytest.mark.parametrize("ending", [".json", ".blend", ".png"])
def test_read_only_folder_is_refused(
    ending: str, command: Callable[..., Any], roof: Path, tmp_path: Path
) -> None:
    if not Path("/proc/self").exists():
        pytest.skip("only Linux has a folder that even the administrator cannot write to")
    option = {".blend": "--output", ".json": "--report", ".png": "--image"}[ending]
    ended = command("segment", roof, option, f"/proc/self/out{ending}")
    assert ended.status == 1
    assert "cannot write into the folder /proc/self" in ended.err
    assert [path.name for path in tmp_path.iterdir()] == [roof.name]


def test_one_bad_object_of_a_file_is_said_and_the_others_are_done(
    command: Callable[..., Any], save: Callable[..., Any]
) -> None:
    _nan()
    bpy.context.object.name = "Bad"
    add_surface(dome, "Good")
    ended = command("segment", save("both.blend"), "--json", "--quiet")
    assert ended.status == 1
    assert [block["name"] for block in ended.report["objects"]] == ["Good"]
    assert ended.err.count("\n") == 1
    assert "Bad: 1 of 289 vertices" in ended.err
