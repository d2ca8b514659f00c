# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a designer does: segment, read the key, look at curvature, select a class, undo."""

from math import radians

import bpy
from buttons import press
from mathutils import Euler, Vector
from session import (
    Steps,
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
    look_at(obj)
    yield from show_sidebar("Curvature")
    view, settings = region("WINDOW"), bpy.context.scene.curvature
    record(view=[view.x, view.y, view.width, view.height])
    yield shot("before")

    yield from press("curvature.segment")
    yield until(lambda: "Curvature Class" in obj.data.color_attributes)
    # Anti-aliasing goes on for a while after the colors are there.
    yield wait(2.5)
    record(
        color_type=view3d().spaces.active.shading.color_type,
        shares={row.surface_class: row.share for row in obj.data.curvature.classes},
    )
    yield shot("classes")

    yield from press("curvature.show_legend")
    record(legend_after_press=settings.show_legend)
    yield wait(2.5)
    yield shot("no_legend")
    yield from press("curvature.show_legend")

    yield from press("curvature.analyze")
    yield until(lambda: settings.quantity == "GAUSSIAN")
    yield wait(1.0)
    record(active_colors=obj.data.color_attributes.active_color_name, limit=settings.shown_limit)
    yield shot("gaussian")

    yield from press("curvature.select_class")
    yield until(lambda: obj.mode == "EDIT")
    yield wait(0.5)
    obj.update_from_editmode()
    record(
        selected=sum(face.select for face in obj.data.polygons),
        flat=next(r.faces for r in obj.data.curvature.classes if r.surface_class == "FLAT"),
    )
    yield shot("selected")

    yield from to_view()
    yield key("ctrl+z")
    yield until(lambda: bpy.context.mode == "OBJECT")
    yield key("ctrl+z")
    yield until(lambda: bpy.context.scene.curvature.quantity == "CLASS")
    yield wait(0.5)
    yield shot("undone")


def look_at(obj: bpy.types.Object) -> None:
    """Look at an object from the front, from above, close."""
    space = view3d().spaces.active
    space.region_3d.view_rotation = Euler((radians(62), 0, radians(24))).to_quaternion()
    with in_view3d():
        bpy.ops.object.select_all(action="DESELECT")
        obj.select_set(True)
        bpy.ops.view3d.view_selected()
    space.region_3d.view_distance *= 0.74
    # The sidebar covers the right part: the model moves out of its way.
    right = space.region_3d.view_rotation @ Vector((1, 0, 0))
    space.region_3d.view_location += right * 0.05 * space.region_3d.view_distance
    bpy.ops.object.select_all(action="DESELECT")
    bpy.context.view_layer.objects.active = obj
    obj.select_set(True)


def to_view() -> Steps:
    """Put the mouse over the model, where keys mean the 3D Viewport."""
    view = region("WINDOW")
    yield move(view.x + view.width * 0.4, view.y + view.height * 0.6)
    yield wait(0.3)
