# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Select the faces of a class."""

from __future__ import annotations

from bpy.props import EnumProperty
from bpy.types import Context, Operator

from ..addon import polls
from ..addon.bridge import names
from ..addon.bridge.attributes import read_attribute
from ..addon.bridge.mode import object_mode
from ..addon.bridge.selection import select_faces
from ..addon.bridge.subject import carrier_of, selected_subjects
from ..addon.geometry.classification import SurfaceClass
from ..addon.properties.items import CLASS_ITEMS
from ..addon.selecting import SelectOperator


class CURVATURE_OT_select_class(SelectOperator, Operator):
    """Select the faces of one class on the selected meshes."""

    bl_idname = "curvature.select_class"
    bl_label = "Select Class"
    bl_description = "Select the faces of a class on the selected meshes"
    bl_options = {"REGISTER", "UNDO"}

    surface_class: EnumProperty(
        name="Class",
        description="Class of the faces to select",
        items=CLASS_ITEMS,
        default=SurfaceClass.SINGLE.name,
        options={"SKIP_SAVE"},
    )

    @classmethod
    def poll(cls, context: Context) -> bool:
        """Ask for a segmented mesh."""
        return polls.has_classes(cls, context)

    def execute(self, context: Context) -> set[str]:
        """Select on every mesh that has classes."""
        wanted = SurfaceClass[self.surface_class]
        selected = 0
        with object_mode(context):
            for source in selected_subjects(context):
                mesh = carrier_of(source).data
                classes = read_attribute(mesh, names.FACE_CLASS)
                if classes is not None:
                    selected += select_faces(mesh, classes == wanted, self.extend)
        self.report({"INFO"}, f"{selected} faces selected")
        return {"FINISHED"}
