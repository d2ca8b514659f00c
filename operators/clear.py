# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Remove results."""

from __future__ import annotations

from bpy.types import Context, Operator

from ..addon import polls, tasks
from ..addon.bridge.subject import selected_subjects


class CURVATURE_OT_clear(Operator):
    """Remove what the extension stored on the selected meshes or made for them."""

    bl_idname = "curvature.clear"
    bl_label = "Clear Curvature"
    bl_description = (
        "Remove the curvature attributes, colors and objects of the selected meshes "
        "and bring their own materials back"
    )
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context: Context) -> bool:
        """Ask for a mesh and a mode in which it can be written."""
        return polls.has_mesh(cls, context)

    def execute(self, context: Context) -> set[str]:
        """Remove, and say how many models had anything."""
        cleared = tasks.clear_objects(context, selected_subjects(context))
        if not cleared:
            self.report({"INFO"}, "The selected meshes have no curvature results")
            return {"CANCELLED"}
        self.report({"INFO"}, f"Cleared {cleared} {'model' if cleared == 1 else 'models'}")
        return {"FINISHED"}
