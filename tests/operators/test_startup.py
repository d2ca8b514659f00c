# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Blender's start pays for nothing that is not used yet."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import bpy
from models import STRICT, add_surface, dome

_HEAVY = ("scipy", "igl")

_SESSION = """
import json, sys
import bpy, addon_utils
extension, file, do = sys.argv[1:]
addon_utils.enable(extension)
if file:
    bpy.ops.wm.open_mainfile(filepath=file)
exec(do)
print("RESULT", json.dumps(sorted({name.split(".")[0] for name in sys.modules})))
"""

_DRAW = """
sys.path.insert(0, {tests!r})
from types import SimpleNamespace
from importlib import import_module
from layout_stub import Layout
for name in dir(bpy.types):
    if name.startswith("CURVATURE_PT_"):
        panel = getattr(bpy.types, name)
        if not hasattr(panel, "poll") or panel.poll(bpy.context):
            panel.draw(SimpleNamespace(layout=Layout()), bpy.context)
content = import_module(extension + ".addon.overlay.content")
assert content.legend_of(bpy.context.scene, bpy.context.object) is not None
"""


def _session(extension: str, file: str = "", do: str = "") -> list[str]:
    """Return the modules that a fresh Blender with the extension has loaded."""
    ended = subprocess.run(  # noqa: S603 - the session above, in the Python of these tests
        [sys.executable, "-c", _SESSION, extension, file, do],
        capture_output=True,
        text=True,
        check=False,
    )
    lines = [line for line in ended.stdout.splitlines() if line.startswith("RESULT ")]
    assert lines, ended.stdout + ended.stderr
    return json.loads(lines[0].removeprefix("RESULT "))


def test_enabling_loads_no_library(extension: str) -> None:
    modules = _session(extension)
    assert "numpy" in modules
    assert not set(_HEAVY) & set(modules)


def test_showing_stored_results_loads_no_library(
    extension: str, tmp_path: Path, repository: Path
) -> None:
    """Panels and the legend draw from what the file holds; they compute nothing."""
    add_surface(dome)
    bpy.ops.curvature.segment(**STRICT)
    file = str(tmp_path / "design.blend")
    bpy.ops.wm.save_as_mainfile(filepath=file)
    modules = _session(extension, file, _DRAW.format(tests=str(repository / "tests")))
    assert not set(_HEAVY) & set(modules)


def test_analysis_loads_the_libraries(extension: str) -> None:
    """Else the two tests above would prove nothing."""
    # scipy serves every analysis, libigl those of faces that point to opposite sides.
    do = (
        "bpy.ops.mesh.primitive_uv_sphere_add(); mesh = bpy.context.object.data; "
        "mesh.polygons[40].flip(); mesh.update(); bpy.ops.curvature.analyze()"
    )
    modules = _session(extension, do=do)
    assert set(_HEAVY) <= set(modules)
