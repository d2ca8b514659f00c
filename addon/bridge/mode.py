# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Blender's modes: mesh data can be read and written in Object Mode only."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import bpy
from bpy.types import Context


@contextmanager
def object_mode(context: Context) -> Iterator[None]:
    """Run a block in Object Mode and return to the mode that the user was in."""
    active = context.view_layer.objects.active
    mode = active.mode if active is not None else "OBJECT"
    if mode != "OBJECT":
        bpy.ops.object.mode_set(mode="OBJECT")
    try:
        yield
    finally:
        if mode != "OBJECT":
            bpy.ops.object.mode_set(mode=mode)


def enter_face_select(context: Context) -> None:
    """Enter Edit Mode on the selected meshes with face selection."""
    # Not `context.tool_settings`: that makes the scene the owner of `bpy.context`, for good. With
    # another file open, setting `bpy.context.window.scene` then writes into freed memory.
    context.scene.tool_settings.mesh_select_mode = (False, False, True)
    bpy.ops.object.mode_set(mode="EDIT")
