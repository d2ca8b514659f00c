# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Select the faces of a region and look at them."""

from __future__ import annotations

from bpy.props import BoolProperty, IntProperty
from bpy.types import Context, Operator

from ..addon import polls
from ..addon.bridge import names, viewport
from ..addon.bridge.attributes import read_attribute
from ..addon.bridge.mode import object_mode
from ..addon.bridge.region_list import region_names
from ..addon.bridge.selection import select_faces
from ..addon.bridge.subject import carrier_of
from ..addon.selecting import SelectOperator


class CURVATURE_OT_select_region(SelectOperator, Operator):
    """Select the faces of one region of the active mesh."""

    bl_idname = "curvature.select_region"
    bl_label = "Select Region"
    bl_description = "Select the faces of a region of the active mesh; Shift keeps the selection"
    bl_options = {"REGISTER", "UNDO"}

    region: IntProperty(
        name="Region",
        description="Number of the region, 0 for the largest; -1 takes the one chosen in the list",
        default=-1,
        min=-1,
        options={"SKIP_SAVE"},
    )
    zoom: BoolProperty(
        name="Zoom",
        description="Let the viewport look at the region",
        default=False,
        options={"SKIP_SAVE"},
    )

    @classmethod
    def poll(cls, context: Context) -> bool:
        """Ask for a segmented mesh."""
        return polls.has_classes(cls, context)

    def execute(self, context: Context) -> set[str]:
        """Select on the mesh that has the active object's regions."""
        active = context.active_object
        carrier = carrier_of(active) if active is not None and active.type == "MESH" else None
        if carrier is None or not carrier.data.curvature.is_segmented:
            self.report({"ERROR"}, "The active object has no regions: press Segment first")
            return {"CANCELLED"}
        results = carrier.data.curvature
        number = results.active_region if self.region < 0 else self.region
        with object_mode(context):
            regions = read_attribute(carrier.data, names.REGION)
            if regions is None or not (regions == number).any():
                self.report({"ERROR"}, f"{carrier.name} has no region {number}")
                return {"CANCELLED"}
            selected = select_faces(carrier.data, regions == number, self.extend)
            if self.zoom:
                viewport.frame_faces(context, carrier, regions == number)
        results.active_region = min(number, max(len(results.regions) - 1, 0))
        self.report({"INFO"}, f"{region_names(carrier.data)[number]}: {selected} faces selected")
        return {"FINISHED"}
