# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The shading of 3D viewports."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from bpy.types import Context, Object, SpaceView3D

from ..geometry.types import Flags, Floats
from .mesh import corner_vertices, polygon_sizes, positions


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
    corners = np.concatenate([_in_world(obj, np.array(obj.bound_box)) for obj in objects])
    low, high = corners.min(axis=0), corners.max(axis=0)
    diagonal = float(np.linalg.norm(high - low))
    for space in _viewports(context):
        space.region_3d.view_location = (low + high) / 2.0
        space.region_3d.view_distance = 1.5 * diagonal
        space.clip_start, space.clip_end = 1e-4 * diagonal, 1e2 * diagonal


def frame_faces(context: Context, obj: Object, faces: Flags) -> None:
    """Let the viewport at hand, or all where there is none, look at some faces of an object.

    Directions of view stay: only where the view turns about, and from how far, changes.
    """
    mesh = obj.data
    corners = corner_vertices(mesh)[np.repeat(faces, polygon_sizes(mesh))]
    points = _in_world(obj, positions(mesh)[np.unique(corners)].astype(np.float64))
    low, high = points.min(axis=0), points.max(axis=0)
    diagonal = float(np.linalg.norm(high - low))
    here = context.space_data
    for space in [here] if isinstance(here, SpaceView3D) else _viewports(context):
        if space.region_3d.view_perspective == "CAMERA":
            space.region_3d.view_perspective = "PERSP"
        space.region_3d.view_location = (low + high) / 2.0
        space.region_3d.view_distance = 1.5 * diagonal


def _in_world(obj: Object, points: Floats) -> Floats:
    world = np.array(obj.matrix_world)
    return points @ world[:3, :3].T + world[:3, 3]


def _viewports(context: Context) -> Iterator[SpaceView3D]:
    for window in context.window_manager.windows:
        for area in window.screen.areas:
            if area.type == "VIEW_3D":
                yield from (space for space in area.spaces if isinstance(space, SpaceView3D))
