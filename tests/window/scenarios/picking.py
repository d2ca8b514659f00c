# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a designer does to pick lines: open the panel, point, click, point elsewhere, end."""

from math import radians

import bpy
from buttons import find, press
from mathutils import Euler
from session import (
    Steps,
    click,
    in_view3d,
    key,
    move,
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
        obj = bpy.context.view_layer.objects.active
        view3d().spaces.active.region_3d.view_rotation = Euler((radians(40), 0, 0)).to_quaternion()
        bpy.ops.view3d.view_selected()
    view3d().spaces.active.shading.color_type = "OBJECT"
    yield from show_sidebar("Curvature")
    view = region("WINDOW")
    record(view=[view.x, view.y, view.width, view.height])
    # The closed sub-panel with the button lies below this one.
    x, y = yield from find("curvature.find_umbilics")
    yield click(x, y - 26 * bpy.context.preferences.system.ui_scale)
    yield wait(0.5)
    yield shot("panel")
    yield from press("curvature.pick_lines")
    yield wait(3.0)
    x, y = view.x + 0.36 * view.width, view.y + 0.36 * view.height
    yield move(x + 2, y)
    yield move(x, y)
    yield wait(4.0)
    yield shot("preview")
    yield click(x, y)
    yield until(lambda: f"{obj.name} Picked Lines 1" in names())
    yield move(x - 60, y + 40)
    yield wait(3.0)
    yield shot("second")
    yield key("Escape")
    yield wait(1.0)
    record(objects=sorted(names()))
    yield shot("ended")
    yield from press("curvature.trace_lines")
    yield until(lambda: any("Lines 2" in name and "Picked" not in name for name in names()))
    yield wait(1.0)
    record(traced=sorted(names()), source=obj.name)
    yield shot("traced")


def names() -> list[str]:
    return [obj.name for obj in bpy.data.objects]
