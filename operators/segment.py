# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Segment models by class."""

from __future__ import annotations

from math import pi

from bpy.props import FloatProperty
from bpy.types import Context, Event

from ..addon import polls, tasks
from ..addon.bridge.subject import selected_subjects
from ..addon.choices import adopt_settings, analysis_settings, segmentation_settings
from ..addon.running import RunningOperator
from ..addon.steps import Steps

_NAMES = ("panel_size", "deviation", "crease_angle", "min_area")


class CURVATURE_OT_segment(RunningOperator):
    """Segment the selected meshes into flat, single-curved and double-curved areas."""

    bl_idname = "curvature.segment"
    bl_label = "Segment by Curvature"
    bl_description = (
        "Find which parts of the selected meshes are flat, single-curved, domes or saddles "
        "at the tolerance of the panels"
    )
    bl_options = {"REGISTER", "UNDO"}
    verb = "Segmented"

    panel_size: FloatProperty(
        name="Panel Size (m)",
        description="Edge length of the panels in meters; 0 takes the scene's setting",
        default=0.0,
        min=0.0,
        options={"SKIP_SAVE"},
    )
    deviation: FloatProperty(
        name="Deviation (m)",
        description="Allowed distance between panel and surface in meters; "
        "0 takes the scene's setting",
        default=0.0,
        min=0.0,
        precision=5,
        step=0.1,
        options={"SKIP_SAVE"},
    )
    crease_angle: FloatProperty(
        name="Crease Angle",
        description="Fold between two faces above which their edge separates smooth areas; "
        "0 takes the scene's setting",
        subtype="ANGLE",
        default=0.0,
        min=0.0,
        max=pi,
        options={"SKIP_SAVE"},
    )
    min_area: FloatProperty(
        name="Minimum Area (m²)",
        description="Regions below this area in m² join a neighbor; 0 takes the scene's setting",
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
        adopt_settings(self, context, _NAMES)
        return self.start(context)

    def steps(self, context: Context) -> Steps[tasks.Outcome]:
        """Measure where needed, segment, write and show."""
        return tasks.segment_objects(
            context,
            selected_subjects(context),
            analysis_settings(context, self),
            segmentation_settings(context, self),
        )
