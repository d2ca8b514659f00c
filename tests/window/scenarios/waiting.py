# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Segment a large model, cancel by Esc while it is measured, then let it end."""

import bpy
import numpy as np
from buttons import press
from session import Steps, in_view3d, key, record, region, shot, show_sidebar, until, wait

_SIDE = 500


def scenario() -> Steps:
    for obj in list(bpy.data.objects):
        bpy.data.objects.remove(obj)
    obj = _wavy_sheet()
    yield from show_sidebar("Curvature")
    with in_view3d():
        bpy.ops.view3d.view_all()
    view = region("WINDOW")
    record(view=[view.x, view.y, view.width, view.height])
    yield wait(1.0)
    yield shot("before")

    yield from press("curvature.segment")
    yield until(_is_running)
    yield wait(0.4)
    yield shot("running")
    record(was_running=_is_running(), attributes_while_running=_attributes(obj))
    yield key("Escape")
    yield until(lambda: not _is_running())
    yield wait(1.0)
    record(
        attributes_after_escape=_attributes(obj),
        fingerprint_after_escape=obj.data.curvature.fingerprint,
        colors_after_escape=[each.name for each in obj.data.color_attributes],
    )
    yield shot("cancelled")

    yield from press("curvature.segment")
    yield until(lambda: obj.data.curvature.is_segmented, 90.0)
    yield until(lambda: not _is_running())
    yield wait(1.0)
    yield shot("finished")
    yield key("ctrl+z")
    yield until(lambda: not bpy.data.objects["Sheet"].data.curvature.is_segmented)
    record(undone=True)


def _wavy_sheet() -> bpy.types.Object:
    x, y = (axis.ravel() for axis in np.meshgrid(*2 * [np.linspace(-1.0, 1.0, _SIDE)]))
    points = np.column_stack([x, y, 0.1 * np.sin(4.0 * x) * np.cos(3.0 * y)])
    start = (np.arange(_SIDE - 1)[:, None] * _SIDE + np.arange(_SIDE - 1)).ravel()
    faces = start[:, None] + np.array([0, 1, _SIDE + 1, _SIDE])
    mesh = bpy.data.meshes.new("Sheet")
    mesh.from_pydata(points, [], faces.tolist())
    obj = bpy.data.objects.new("Sheet", mesh)
    bpy.context.scene.collection.objects.link(obj)
    bpy.context.view_layer.objects.active = obj
    obj.select_set(True)
    # The step that Ctrl+Z goes back to.
    with in_view3d():
        bpy.ops.ed.undo_push(message="Sheet")
    return obj


def _is_running() -> bool:
    window = bpy.context.window_manager.windows[0]
    return any(each.bl_idname == "CURVATURE_OT_segment" for each in window.modal_operators)


def _attributes(obj: bpy.types.Object) -> list[str]:
    return [each.name for each in obj.data.attributes if "urvature" in each.name]
