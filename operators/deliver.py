# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Hand the classes on to other tools of Blender."""

from __future__ import annotations

from bpy.props import EnumProperty
from bpy.types import Context, Operator

from ..addon import polls
from ..addon.bridge import delivery
from ..addon.bridge.mode import object_mode
from ..addon.bridge.subject import carrier_of, selected_subjects


class CURVATURE_OT_deliver(Operator):
    """Write the classes or regions of the selected meshes in a form that other tools work with."""

    bl_idname = "curvature.deliver"
    bl_label = "Deliver Classes"
    bl_description = "Turn the classes of the selected meshes into what other tools work with"
    bl_options = {"REGISTER", "UNDO"}

    form: EnumProperty(
        name="Form",
        description="What to make of the classes",
        items=(
            ("MATERIALS", "Materials", "A material slot per class, in the color of the class", 0),
            ("VERTEX_GROUPS", "Vertex Groups", "A vertex group per class", 1),
            ("FACE_SETS", "Face Sets", "A face set of Sculpt Mode per region", 2),
        ),
        default="MATERIALS",
        options={"SKIP_SAVE"},
    )

    @classmethod
    def poll(cls, context: Context) -> bool:
        """Ask for a segmented mesh."""
        return polls.has_classes(cls, context)

    def execute(self, context: Context) -> set[str]:
        """Write to every selected mesh that has classes."""
        with object_mode(context):
            carriers = [carrier_of(source) for source in selected_subjects(context)]
            carriers = [obj for obj in carriers if obj.data.curvature.is_segmented]
            for carrier in carriers:
                if self.form == "MATERIALS":
                    delivery.write_materials(carrier, context.scene.curvature)
                elif self.form == "VERTEX_GROUPS":
                    delivery.write_vertex_groups(carrier)
                else:
                    delivery.write_face_sets(carrier)
        if not carriers:
            self.report({"ERROR"}, "The selected meshes have no classes: press Segment first")
            return {"CANCELLED"}
        form = self.form.replace("_", " ").lower()
        self.report({"INFO"}, f"Wrote {form} to {len(carriers)} models")
        return {"FINISHED"}
