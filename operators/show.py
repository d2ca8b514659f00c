# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Choose what the viewport shows."""

from __future__ import annotations

from bpy.props import EnumProperty
from bpy.types import Context, Operator

from ..addon import polls
from ..addon.bridge import display
from ..addon.bridge.mode import object_mode
from ..addon.properties.items import QUANTITY_ITEMS


class CURVATURE_OT_show(Operator):
    """Show a quantity in color on every analyzed model of the scene."""

    bl_idname = "curvature.show"
    bl_label = "Show Curvature"
    bl_description = "Choose what the colors of all analyzed models of the scene show"
    bl_options = {"REGISTER", "UNDO"}

    quantity: EnumProperty(
        name="Quantity",
        description="What the colors show",
        items=QUANTITY_ITEMS,
        default="GAUSSIAN",
        options={"SKIP_SAVE"},
    )

    @classmethod
    def poll(cls, context: Context) -> bool:
        """Ask for an analyzed model."""
        return polls.has_results(cls, context)

    def execute(self, context: Context) -> set[str]:
        """Color the models, unless the quantity has not been computed."""
        objects = display.analyzed_objects(context.scene)
        is_segmented = any(obj.data.curvature.is_segmented for obj in objects)
        if self.quantity in {"CLASS", "REGION"} and not is_segmented:
            self.report({"ERROR"}, "There are no classes yet: press Segment first")
            return {"CANCELLED"}
        with object_mode(context):
            context.scene.curvature.quantity = self.quantity
            changed = display.changed_objects(context, context.scene)
        if changed:
            names = ", ".join(obj.name for obj in changed)
            self.report({"WARNING"}, f"Changed since the analysis: {names}; analyze again")
        return {"FINISHED"}
