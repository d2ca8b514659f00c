# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Make objects of classes and regions."""

from __future__ import annotations

from bpy.props import EnumProperty
from bpy.types import Context, Operator

from ..addon import polls
from ..addon.bridge.mode import object_mode
from ..addon.bridge.separation import separate
from ..addon.bridge.subject import carrier_of, selected_subjects


class CURVATURE_OT_separate(Operator):
    """Make separate objects of the classes or regions of the selected meshes."""

    bl_idname = "curvature.separate"
    bl_label = "Separate by Class"
    bl_description = (
        "Make an object of every class or region of the selected meshes, in a collection of its own"
    )
    bl_options = {"REGISTER", "UNDO"}

    by: EnumProperty(
        name="By",
        description="What each object holds",
        items=(
            ("CLASS", "Class", "All faces of a class", 0),
            ("REGION", "Region", "The faces of one region", 1),
        ),
        default="CLASS",
        options={"SKIP_SAVE"},
    )

    @classmethod
    def poll(cls, context: Context) -> bool:
        """Ask for a segmented mesh."""
        return polls.has_classes(cls, context)

    def execute(self, context: Context) -> set[str]:
        """Separate every selected mesh that has classes."""
        made = 0
        with object_mode(context):
            for source in selected_subjects(context):
                by_region = self.by == "REGION"
                made += len(separate(carrier_of(source), context.scene, by_region))
        if not made:
            self.report({"ERROR"}, "The selected meshes have no classes: press Segment first")
            return {"CANCELLED"}
        self.report({"INFO"}, f"Made {made} objects")
        return {"FINISHED"}
