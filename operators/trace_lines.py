# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Trace curvature lines."""

from __future__ import annotations

from bpy.props import FloatProperty
from bpy.types import Context, Event, Operator

from ..addon import polls, tasks
from ..addon.bridge.subject import selected_subjects
from ..addon.choices import LINE_NAMES, adopt_kind, adopt_settings, line_plan
from ..addon.properties.lines import LineChoices
from ..addon.running import RunningOperator
from ..addon.steps import Steps
from ..addon.tracing.lines import trace_objects


class CURVATURE_OT_trace_lines(LineChoices, RunningOperator, Operator):
    """Trace evenly spaced curvature lines on the selected meshes."""

    bl_idname = "curvature.trace_lines"
    bl_label = "Trace Curvature Lines"
    bl_description = (
        "Cover the selected meshes with evenly spaced lines along the directions of curvature, "
        "one curve object per family"
    )
    bl_options = {"REGISTER", "UNDO"}
    verb = "Traced"

    spacing: FloatProperty(
        name="Spacing (m)",
        description="Distance between neighboring lines in meters; "
        "0 takes the scene's setting, or the panel size",
        default=0.0,
        min=0.0,
        options={"SKIP_SAVE"},
    )

    @classmethod
    def poll(cls, context: Context) -> bool:
        """Ask for a mesh and a mode in which it can be read."""
        return polls.has_mesh(cls, context)

    def invoke(self, context: Context, _event: Event) -> set[str]:
        """Start from the scene's settings."""
        adopt_settings(self, context, (*LINE_NAMES, "spacing"))
        adopt_kind(self, context)
        return self.start(context)

    def steps(self, context: Context) -> Steps[tasks.Outcome]:
        """Measure where needed, trace, and make curves."""
        return trace_objects(context, selected_subjects(context), line_plan(context, self))
