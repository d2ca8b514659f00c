# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the operator costs beside the analysis: reading, writing and coloring, in Blender."""

from __future__ import annotations

import json
import os
import subprocess
import tempfile
from pathlib import Path

import numpy as np

from .. import build, environments
from ..blenders import DEFAULT_BLENDER
from ..platforms import current_platform
from ..processes import python_environment
from .engine import ROOT
from .meshes import make

_KIND, _SURFACE = "irregular 4:1, float32", "torus"
_SIZES = (100_000, 1_000_000)

# The extension is the built zip; scipy and the engine are loaded before the clock starts.
_SESSION = """
import json, os, sys, time
from pathlib import Path
sys.path.insert(0, str(Path("tests").resolve()))
import bpy, numpy as np
from installed_zip import install_and_alias
install_and_alias(Path(sys.argv[1]), "curvature")
from curvature.addon import choices
from curvature.addon.bridge import cache, mesh
from curvature.addon.geometry import analysis
arrays = np.load(sys.argv[2])

def add(positions, triangles):
    for obj in list(bpy.data.objects):
        bpy.data.objects.remove(obj)
    data = bpy.data.meshes.new("Torus")
    data.vertices.add(len(positions))
    data.vertices.foreach_set("co", positions.astype(np.float32).ravel())
    data.loops.add(triangles.size)
    data.loops.foreach_set("vertex_index", triangles.astype(np.int32).ravel())
    data.polygons.add(len(triangles))
    data.polygons.foreach_set("loop_start", np.arange(0, triangles.size, 3, dtype=np.int32))
    data.update(calc_edges=True)
    obj = bpy.data.objects.new("Torus", data)
    bpy.context.scene.collection.objects.link(obj)
    obj.select_set(True)
    bpy.context.view_layer.objects.active = obj
    return obj

def run(positions, triangles):
    obj = add(positions, triangles)
    read = mesh.read_polygon_mesh(obj.data, np.eye(3))
    cache.clear()
    start = time.perf_counter()
    analysis.analyze(read, choices.analysis_settings(bpy.context))
    alone = time.perf_counter() - start
    start = time.perf_counter()
    bpy.ops.curvature.analyze()
    return alone, time.perf_counter() - start

run(arrays["small"], arrays["small_triangles"])
# The better of two runs: other work on the machine only ever adds.
runs = [run(arrays["large"], arrays["large_triangles"]) for _ in range(2)]
print(json.dumps([min(times) for times in zip(*runs)]))
sys.stdout.flush()
os._exit(0)
"""


def measure() -> str:
    """Return a table of seconds: analysis alone, and the whole of `curvature.analyze`."""
    lines = [
        "| vertices | analysis of the mesh in memory | `curvature.analyze` | ratio |",
        "|---|---|---|---|",
    ]
    python = environments.ensure(DEFAULT_BLENDER.environment)
    zip_file = build.build(DEFAULT_BLENDER.series, [current_platform()])[0]
    small = make(_SURFACE, _KIND, 2_000)
    for size in _SIZES:
        large = make(_SURFACE, _KIND, size)
        with tempfile.TemporaryDirectory() as folder:
            arrays = Path(folder) / "meshes.npz"
            np.savez(
                arrays,
                small=small.positions,
                small_triangles=small.triangles,
                large=large.positions,
                large_triangles=large.triangles,
            )
            done = subprocess.run(
                [python, "-c", _SESSION, zip_file, arrays],
                env=python_environment(BLENDER_USER_RESOURCES=os.fspath(folder)),
                cwd=ROOT,
                capture_output=True,
                text=True,
                check=True,
            )
        alone, whole = json.loads(done.stdout.splitlines()[-1])
        lines.append(f"| {size:,} | {alone:.2f} s | {whole:.2f} s | {whole / alone:.2f} |")
        print(lines[-1], flush=True)
    return "\n".join(lines)
