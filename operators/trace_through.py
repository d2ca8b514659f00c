# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Trace curvature lines through given points."""

from __future__ import annotations

from bpy.props import EnumProperty
from bpy.types import Context, Event, Operator

from ..addon import polls, tasks
from ..addon.bridge.subject import selected_subjects
from ..addon.choices import LINE_NAMES, adopt_kind, adopt_settings, line_plan
from ..addon.properties.lines import LineChoices
from ..addon.running import RunningOperator
from ..addon.steps import Steps
from ..addon.tracing.lines import trace_seeds


class CURVATURE_OT_trace_through(LineChoices, RunningOperator, Operator):
    """Trace the curvature lines through the 3D cursor or the selected vertices."""

    bl_idname = "curvature.trace_through"
    bl_label = "Trace Through Points"
    bl_description = (
        "Trace the lines through points of your own, and add them to those picked before"
    )
    bl_options = {"REGISTER", "UNDO"}
    verb = "Traced"

    points: EnumProperty(
        name="Points",
        description="Which points the lines run through",
        items=(
            ("CURSOR", "3D Cursor", "The points of the meshes nearest to the 3D cursor", 0),
            ("VERTICES", "Selected Vertices", "The vertices selected in Edit Mode", 1),
        ),
        default="CURSOR",
        options={"SKIP_SAVE"},
    )

    @classmethod
    def poll(cls, context: Context) -> bool:
        """Ask for a mesh and a mode in which it can be read."""
        return polls.has_mesh(cls, context)

    def invoke(self, context: Context, _event: Event) -> set[str]:
        """Start from the scene's settings."""
        adopt_settings(self, context, LINE_NAMES)
        adopt_kind(self, context)
        return self.start(context)

    def steps(self, context: Context) -> Steps[tasks.Outcome]:
        """Measure where needed, trace, and add the lines."""
        plan = line_plan(context, self)
        return trace_seeds(context, selected_subjects(context), plan, self.points)
