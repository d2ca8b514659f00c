# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Find umbilics."""

from __future__ import annotations

from bpy.types import Context, Event, Operator

from ..addon import polls, tasks
from ..addon.bridge.subject import selected_subjects
from ..addon.choices import line_plan
from ..addon.running import RunningOperator
from ..addon.steps import Steps
from ..addon.tracing.umbilics import mark_umbilics


class CURVATURE_OT_find_umbilics(RunningOperator, Operator):
    """Mark the points where the curvature is the same in all directions."""

    bl_idname = "curvature.find_umbilics"
    bl_label = "Find Umbilics"
    bl_description = (
        "Mark the points of the selected meshes where curvature is the same in all directions, "
        "around which curvature lines turn"
    )
    bl_options = {"REGISTER", "UNDO"}
    verb = "Searched"

    @classmethod
    def poll(cls, context: Context) -> bool:
        """Ask for a mesh and a mode in which it can be read."""
        return polls.has_mesh(cls, context)

    def invoke(self, context: Context, _event: Event) -> set[str]:
        """Run beside the window."""
        return self.start(context)

    def steps(self, context: Context) -> Steps[tasks.Outcome]:
        """Measure where needed, find and mark."""
        return mark_umbilics(context, selected_subjects(context), line_plan(context))
