# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Time of the segmentation after the analysis, each run in a process of its own.

Machines differ and are shared: what counts is the ratio to the analysis in the same run, and the
time of the processor, which is the most that it takes on a machine at rest.
"""

from __future__ import annotations

import json
import subprocess
import sys
import time
from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from .engine import ROOT, geometry, tests

if TYPE_CHECKING:
    from composites.composite import Composite, Recipe

Mesh = tuple[NDArray[np.float64], NDArray[np.int64]]

_SIZES = (100_000, 1_000_000)
_QUICK = (20_000,)
#: Meshes so large are measured with noise only, which takes longer.
_LARGE = 1_000_000
_NOISE = 0.01
#: Waves of a free form, and how many radians they turn by across it, as a standard deviation.
_WAVES, _TURN = 12, 12.0


def _composite(make: Callable[[Recipe], Composite], faces: int, noise: float) -> Mesh:
    recipe: type[Recipe] = tests("composites.composite").Recipe
    shape = make(recipe(count=faces // 2, kind="triangles", noise=noise))
    return shape.vertices, shape.polygons


def _box(faces: int, noise: float) -> Mesh:
    return _composite(tests("composites.boxes").rounded_box, faces, noise)


def _torus(faces: int, noise: float) -> Mesh:
    return _composite(tests("composites.tubes").torus, faces, noise)


def _free_form(faces: int, noise: float) -> Mesh:
    """Return a height field of waves in all directions: borders everywhere, and nothing else."""
    random = np.random.default_rng(5)
    rows = round(np.sqrt(faces / 2)) + 1
    grid = np.stack(np.meshgrid(*[np.linspace(0.0, 1.0, rows)] * 2, indexing="ij"), axis=-1)
    place = (grid + random.uniform(-0.3, 0.3, grid.shape) / rows).reshape(-1, 2)
    turn, phase = _TURN * random.normal(size=(_WAVES, 2)), random.uniform(0.0, 7.0, _WAVES)
    rise = random.normal(size=_WAVES) / np.linalg.norm(turn, axis=1)
    height = 0.1 * np.sin(place @ turn.T + phase) @ rise
    height += noise / rows * random.normal(size=len(place))
    polygons = tests("composites.composite").quads(rows, rows)
    triangles = np.concatenate([polygons[:, [0, 1, 2]], polygons[:, [0, 2, 3]]])
    return np.column_stack([place, height]), triangles


_SHAPES: dict[str, Callable[[int, float], Mesh]] = {
    "torus": _torus,
    "rounded box": _box,
    "free form": _free_form,
}


def measure(*, quick: bool = False, largest: int = 0) -> str:
    """Return a table of the processor's seconds: analysis, segmentation, and their ratio."""
    lines = [
        "| triangles | faces | analysis | segmentation | ratio |",
        "|---|---|---|---|---|",
    ]
    for size in _QUICK if quick else _SIZES:
        if largest and size > largest:
            continue
        for shape in _SHAPES:
            for noise in (0.0, _NOISE) if size < _LARGE else (_NOISE,):
                done = subprocess.run(
                    [
                        sys.executable,
                        "-m",
                        "tools.benchmark.segmenting",
                        shape,
                        str(size),
                        f"{noise}",
                    ],
                    capture_output=True,
                    text=True,
                    check=True,
                    cwd=ROOT,
                )
                analysis, segmentation = json.loads(done.stdout.splitlines()[-1])
                name = f"{shape}, noise {noise:.0%}".replace("%", " %") if noise else shape
                lines.append(
                    f"| {name} | {size:,} | {analysis:.2f} s | {segmentation:.2f} s "
                    f"| {segmentation / analysis:.2f} |"
                )
                print(lines[-1], flush=True)
    return "\n".join(lines)


def _seconds(mesh: Mesh) -> tuple[float, float]:
    """Return the processor's seconds for analysis and segmentation with the default panel."""
    read = geometry("mesh").mesh_from_polygons(mesh[0], mesh[1].tolist())
    limit = geometry("tolerance").resolve_tolerance(0.0, 0.0, read.diagonal)
    angle = geometry("creases").DEFAULT_CREASE_ANGLE
    settings = geometry("settings").AnalysisSettings(crease_angle=angle)
    start = time.process_time()
    analysis = geometry("analysis").analyze(read, settings)
    middle = time.process_time()
    geometry("segmentation").segment(analysis.surface, analysis.curvature, limit)
    return middle - start, time.process_time() - middle


def _alone(shape: str, size: int, noise: float) -> None:
    """Measure one shape and print its seconds."""
    _seconds(_box(2_000, 0.0))  # libraries load before the clock starts
    # The better of two runs: other work on the machine only ever adds.
    mesh = _SHAPES[shape](size, noise)
    runs = [_seconds(mesh) for _ in range(2)]
    print(json.dumps([min(times) for times in zip(*runs, strict=True)]))


if __name__ == "__main__":
    _alone(sys.argv[1], int(sys.argv[2]), float(sys.argv[3]))
