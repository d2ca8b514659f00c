# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The shading of 3D viewports."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from bpy.types import Context, Object, SpaceView3D


def show_colors(context: Context, is_shown: bool) -> None:
    """Let the solid viewports of all windows show color attributes, or materials again."""
    for space in _viewports(context):
        if is_shown:
            if space.shading.type == "WIREFRAME":
                space.shading.type = "SOLID"
            space.shading.color_type = "VERTEX"
        elif space.shading.color_type == "VERTEX":
            space.shading.color_type = "MATERIAL"


def redraw(context: Context) -> None:
    """Draw the 3D viewports of all windows anew."""
    for window in context.window_manager.windows:
        for area in window.screen.areas:
            if area.type == "VIEW_3D":
                area.tag_redraw()


def frame(context: Context, objects: list[Object]) -> None:
    """Let the viewports of all windows look at objects as a whole."""
    corners = np.concatenate(
        [
            np.array(obj.bound_box) @ np.array(obj.matrix_world)[:3, :3].T
            + np.array(obj.matrix_world)[:3, 3]
            for obj in objects
        ]
    )
    low, high = corners.min(axis=0), corners.max(axis=0)
    diagonal = float(np.linalg.norm(high - low))
    for space in _viewports(context):
        space.region_3d.view_location = (low + high) / 2.0
        space.region_3d.view_distance = 1.5 * diagonal
        space.clip_start, space.clip_end = 1e-4 * diagonal, 1e2 * diagonal


def _viewports(context: Context) -> Iterator[SpaceView3D]:
    for window in context.window_manager.windows:
        for area in window.screen.areas:
            if area.type == "VIEW_3D":
                yield from (space for space in area.spaces if isinstance(space, SpaceView3D))
