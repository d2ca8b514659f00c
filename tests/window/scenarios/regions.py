# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Look through the list of regions, zoom to one, split faces off, trace the borders."""

import bpy
from buttons import press
from session import Steps, in_view3d, move, record, region, shot, show_sidebar, until, wait


def scenario(model: str) -> Steps:
    for obj in list(bpy.data.objects):
        bpy.data.objects.remove(obj)
    with in_view3d():
        bpy.ops.wm.obj_import(filepath=model)
    obj = bpy.context.view_layer.objects.active
    _look_at(obj)
    _show_only("results", "regions", "outlines")
    yield from show_sidebar("Curvature")
    view = region("WINDOW")
    record(view=[view.x, view.y, view.width, view.height])
    with in_view3d():
        bpy.ops.curvature.segment()
    results = obj.data.curvature
    results.regions[0].name = "Entrance Hall"
    results.active_region = 3
    yield wait(0.5)
    yield from _leave_sidebar()
    yield wait(0.5)
    yield shot("listed")

    yield from press("curvature.select_region")
    yield until(lambda: obj.mode == "EDIT")
    yield wait(0.5)
    obj.update_from_editmode()
    record(
        selected=sum(face.select for face in obj.data.polygons),
        listed=results.regions[3].faces,
    )
    with in_view3d():
        bpy.ops.curvature.select_region(zoom=True)
    yield wait(0.5)
    yield shot("zoomed")

    with in_view3d():
        bpy.ops.object.mode_set(mode="OBJECT")
    _look_at(obj)
    yield from press("curvature.outline")
    yield until(lambda: bool(results.outlines))
    yield wait(0.5)
    record(borders=results.outlines[0].curves, splines=len(bpy.data.curves[0].splines))
    yield from _leave_sidebar()
    yield wait(0.5)
    yield shot("outlined")


def _look_at(obj: bpy.types.Object) -> None:
    with in_view3d():
        bpy.ops.object.select_all(action="DESELECT")
        obj.select_set(True)
        bpy.ops.view3d.view_selected()


def _leave_sidebar() -> Steps:
    """Put the mouse over the model, so that no tooltip covers the sidebar."""
    view = region("WINDOW")
    yield move(view.x + view.width * 0.4, view.y + view.height * 0.9)
    yield wait(0.3)


def _show_only(*names: str) -> None:
    """Open these panels, the parent first, and take all others away, so that they fit in."""
    panels = {
        name.removeprefix("CURVATURE_PT_"): getattr(bpy.types, name)
        for name in dir(bpy.types)
        if name.startswith("CURVATURE_PT_")
    }
    for panel in sorted(panels.values(), key=lambda panel: not hasattr(panel, "bl_parent_id")):
        bpy.utils.unregister_class(panel)
        panel.bl_options = set()
    for name in names:
        bpy.utils.register_class(panels[name])
