# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Hatch models for illustrations."""

from __future__ import annotations

from bpy.props import EnumProperty, FloatProperty, FloatVectorProperty
from bpy.types import Context, Event, Operator

from ..addon import polls, tasks
from ..addon.bridge.subject import selected_subjects
from ..addon.choices import adopt_hatching, hatch_settings, line_plan
from ..addon.properties.items import TONE_ITEMS
from ..addon.running import RunningOperator
from ..addon.steps import Steps
from ..addon.tracing.hatching import hatch_objects


class CURVATURE_OT_hatch(RunningOperator, Operator):
    """Draw the selected meshes with strokes along the directions of curvature."""

    bl_idname = "curvature.hatch"
    bl_label = "Hatch"
    bl_description = (
        "Draw the selected meshes with strokes along the directions of curvature, for illustrations"
    )
    bl_options = {"REGISTER", "UNDO"}
    verb = "Hatched"

    tone: EnumProperty(
        name="Density",
        description="Where the strokes are dense",
        items=TONE_ITEMS,
        default="SHADE",
        options={"SKIP_SAVE"},
    )
    spacing: FloatProperty(
        name="Spacing (m)",
        description="Distance between strokes where they are densest, in meters; "
        "0 takes the scene's setting, or a fraction of the model",
        default=0.0,
        min=0.0,
        precision=4,
        options={"SKIP_SAVE"},
    )
    light: FloatVectorProperty(
        name="Light",
        description="Direction that the light comes from, in the world",
        subtype="DIRECTION",
        default=(-0.45, -0.55, 0.7),
        options={"SKIP_SAVE"},
    )

    @classmethod
    def poll(cls, context: Context) -> bool:
        """Ask for a mesh and a mode in which it can be read."""
        return polls.has_mesh(cls, context)

    def invoke(self, context: Context, _event: Event) -> set[str]:
        """Start from the scene's settings."""
        adopt_hatching(self, context)
        return self.start(context)

    def steps(self, context: Context) -> Steps[tasks.Outcome]:
        """Measure where needed, trace, and lay strokes."""
        objects = selected_subjects(context)
        return hatch_objects(context, objects, line_plan(context), hatch_settings(context, self))
