# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines drawn over the model while the user points at it; they are not part of the file."""

from __future__ import annotations

from dataclasses import dataclass

import bpy
import gpu
import numpy as np
from bpy.types import SpaceView3D
from gpu_extras.batch import batch_for_shader

from ..geometry.types import Floats

_WIDTH = 2.5
#: Share of the distance to the eye by which lines are drawn in front of the surface they lie on.
_LIFT = 0.002


@dataclass(frozen=True)
class PreviewLine:
    """Points in world coordinates, (p, 3) float64, and a color with alpha."""

    points: Floats
    is_closed: bool
    color: tuple[float, float, float, float]


_lines: list[PreviewLine] = []
_handles: list[object] = []


def show(lines: list[PreviewLine]) -> None:
    """Draw lines in every 3D viewport, in place of those drawn before."""
    _lines[:] = lines
    if not _handles:
        _handles.append(SpaceView3D.draw_handler_add(_draw, (), "WINDOW", "POST_VIEW"))


def hide() -> None:
    """Stop drawing; does nothing where nothing is drawn."""
    _lines.clear()
    while _handles:
        SpaceView3D.draw_handler_remove(_handles.pop(), "WINDOW")


def shown() -> list[PreviewLine]:
    """Return the lines that are drawn."""
    return list(_lines)


def segments(line: PreviewLine, eye: Floats) -> Floats:
    """Return the ends of the straight pieces of a line, moved a little towards the eye, (n, 3)."""
    points = line.points + _LIFT * (eye - line.points)
    following = np.roll(points, -1, axis=0)
    pairs = np.stack([points, following], axis=1)
    return (pairs if line.is_closed else pairs[:-1]).reshape(-1, 3)


def _draw() -> None:
    context = bpy.context
    eye = np.array(context.region_data.view_matrix.inverted().translation)
    shader = gpu.shader.from_builtin("POLYLINE_UNIFORM_COLOR")
    gpu.state.blend_set("ALPHA")
    gpu.state.depth_test_set("LESS_EQUAL")
    for line in _lines:
        places = segments(line, eye).astype(np.float32)
        batch = batch_for_shader(shader, "LINES", {"pos": places})
        shader.bind()
        shader.uniform_float("viewportSize", (context.region.width, context.region.height))
        shader.uniform_float("lineWidth", _WIDTH * context.preferences.system.ui_scale)
        shader.uniform_float("color", line.color)
        batch.draw(shader)
    gpu.state.depth_test_set("NONE")
    gpu.state.blend_set("NONE")
