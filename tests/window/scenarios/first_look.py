# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Open a model, look at the sidebar's tab, press the primary button."""

import bpy
from buttons import press
from session import (
    Steps,
    in_view3d,
    record,
    region,
    shot,
    show_sidebar,
    until,
    view3d,
    wait,
)


def scenario(model: str) -> Steps:
    for obj in list(bpy.data.objects):
        bpy.data.objects.remove(obj)
    with in_view3d():
        bpy.ops.wm.obj_import(filepath=model)
        bpy.ops.view3d.view_selected()
    obj = bpy.context.view_layer.objects.active
    yield wait(0.5)
    view, sidebar = region("WINDOW"), region("UI")
    record(view=[view.x, view.y, view.width, view.height], faces=len(obj.data.polygons))
    yield shot("opened")

    yield from show_sidebar("Curvature")
    sidebar = region("UI")
    record(
        tab=sidebar.active_panel_category,
        sidebar=[sidebar.x, sidebar.y, sidebar.width, sidebar.height],
    )
    yield shot("sidebar")

    yield from press("curvature.segment")
    yield until(lambda: "Curvature Class" in obj.data.color_attributes)
    yield wait(1.0)
    record(color_type=view3d().spaces.active.shading.color_type)
    yield shot("segmented")
