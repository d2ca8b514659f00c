# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Choose a material from the menu of presets, segment by its radius, save a preset."""

import bpy
from bpy.path import display_name
from buttons import find, press
from session import (
    Steps,
    click,
    in_view3d,
    key,
    leave,
    record,
    region,
    shot,
    show_sidebar,
    until,
    wait,
)

MENU = "CURVATURE_MT_presets"


def scenario(model: str) -> Steps:
    for obj in list(bpy.data.objects):
        bpy.data.objects.remove(obj)
    with in_view3d():
        bpy.ops.wm.obj_import(filepath=model)
        bpy.ops.view3d.view_selected()
    obj = bpy.context.view_layer.objects.active
    settings = bpy.context.scene.curvature
    yield from show_sidebar("Curvature")
    yield shot("panel")

    # The menu is left of the button that saves.
    _, y = yield from find("curvature.preset_add")
    sidebar = region("UI")
    yield click(sidebar.x + sidebar.width * 0.3, y)
    yield wait(1.0)
    yield shot("menu")
    yield key("Escape")
    yield from leave()

    folder = next(path for path in bpy.utils.preset_paths("architectural_curvature"))
    name = "Cold-bent_Glass_8_mm.py"
    with in_view3d():
        bpy.ops.script.execute_preset(filepath=f"{folder}/{name}", menu_idname=MENU)
    yield wait(0.5)
    record(preset=settings.criterion_preset, expected=display_name(name, title_case=False))
    yield shot("chosen")

    yield from press("curvature.segment")
    yield until(lambda: obj.data.curvature.is_segmented)
    yield wait(1.0)
    record(criterion=obj.data.curvature.criterion)
    yield shot("classes")

    # The button that saves is between the menu and the button that removes.
    yield click(sidebar.x + sidebar.width * 0.76, y)
    yield wait(1.5)
    yield shot("dialog")
    yield key("Escape")
    yield from leave()

    settings.smallest_radius = 11.0
    with in_view3d():
        bpy.ops.curvature.preset_add(name="North Roof")
    record(saved=settings.criterion_preset)
    yield wait(0.5)
    yield shot("saved")
