# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""In a process of its own, as scripts call it: exit status, clean streams, all files."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import bpy
import pytest
from models import add_surface, barrel, dome, saddle

# What `blender --command curvature …` does: Blender looks its commands up by name and leaves with
# their status. The bpy module has no command line.
_SESSION = """
import ctypes, os, sys
import bpy, addon_utils
commands = {}
register = bpy.utils.register_cli_command

def remember(name, run):
    commands[name] = run
    return register(name, run)

bpy.utils.register_cli_command = remember
addon_utils.enable(sys.argv[1])
# Blender 5.2 has printed of its start by now, which `--command` keeps it from.
sys.stdout.flush()
ctypes.CDLL(None).fflush(None)
os.dup2(os.open(sys.argv[2], os.O_WRONLY), 1)
sys.exit(commands["curvature"](sys.argv[3:]))
"""


@dataclass
class Ended:
    """How a process ended."""

    status: int
    out: str
    err: str


@pytest.fixture
def blender(extension: str, tmp_path: Path) -> Callable[..., Ended]:
    """Run the command in a Blender of its own."""
    out = tmp_path / "standard output"
    out.touch()

    def run(*arguments: object) -> Ended:
        ended = subprocess.run(  # noqa: S603 - the session above, in the Python of these tests
            [sys.executable, "-c", _SESSION, extension, out, *map(str, arguments)],
            capture_output=True,
            text=True,
            encoding="utf-8",
            check=False,
        )
        return Ended(ended.returncode, out.read_text(encoding="utf-8"), ended.stderr)

    return run


def test_several_models_are_done_and_the_streams_are_clean(
    blender: Callable[..., Any], save: Callable[..., Any], tmp_path: Path
) -> None:
    models = []
    for height, name in ((dome, "dome"), (barrel, "barrel")):
        for obj in list(bpy.data.objects):
            bpy.data.objects.remove(obj)
        add_surface(height, name)
        models.append(save(f"{name}.blend"))
    add_surface(saddle)
    models.append(tmp_path / "saddle.obj")
    bpy.ops.wm.obj_export(filepath=str(models[-1]))
    out = tmp_path / "out"
    out.mkdir()
    ended = blender(
        "segment",
        *models,
        "--json",
        "--quiet",
        "--image-size",
        "320x200",
        "--output",
        out / "o.blend",
        "--report",
        out / "o.json",
        "--image",
        out / "o.png",
    )
    assert ended.status == 0, ended.err
    report = json.loads(ended.out)
    assert report == json.loads((out / "o.json").read_text(encoding="utf-8"))
    assert len(report["objects"]) == 4
    # Software that stands in for a graphics card may say so.
    assert not [line for line in ended.err.splitlines() if "EGL" not in line]
    assert (
        sorted(path.suffix for path in out.iterdir()) == [".blend"] * 3 + [".json"] + [".png"] * 3
    )


@pytest.mark.parametrize(
    ("arguments", "status"),
    [(["segment", "missing.obj"], 1), (["segment"], 2)],
)
def test_exit_status_is_the_documented_one(
    arguments: list[str], status: int, blender: Callable[..., Any]
) -> None:
    ended = blender(*arguments)
    assert ended.status == status
    assert "Traceback" not in ended.err
    assert not ended.out
