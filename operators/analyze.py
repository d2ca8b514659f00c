# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measure curvature."""

from __future__ import annotations

from math import pi

from bpy.props import BoolProperty, EnumProperty, FloatProperty
from bpy.types import Context, Event, Operator

from ..addon import polls, tasks
from ..addon.bridge.subject import selected_subjects
from ..addon.choices import adopt_settings, analysis_settings, point_settings
from ..addon.properties.items import SMOOTHING_ITEMS
from ..addon.running import RunningOperator
from ..addon.steps import Steps

_NAMES = ("smoothing", "smoothing_length", "crease_angle", "flip_normals")


class CURVATURE_OT_analyze(RunningOperator, Operator):
    """Measure the curvature of the selected meshes and store it as attributes."""

    bl_idname = "curvature.analyze"
    bl_label = "Analyze Curvature"
    bl_description = (
        "Measure Gaussian, mean and principal curvatures of the selected meshes, "
        "store them as attributes and show them in color"
    )
    bl_options = {"REGISTER", "UNDO"}
    verb = "Analyzed"

    smoothing: EnumProperty(
        name="Smoothing",
        description="Which detail of the surface is noise",
        items=SMOOTHING_ITEMS,
        default="AUTO",
        options={"SKIP_SAVE"},
    )
    smoothing_length: FloatProperty(
        name="Smoothing Length (m)",
        description="Detail below this length in meters is noise, where smoothing is by length; "
        "0 takes the scene's setting",
        default=0.0,
        min=0.0,
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
    flip_normals: BoolProperty(
        name="Flip Normals",
        description="Look at the surface from its other side: mean curvature changes its sign",
        default=False,
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
        """Measure, write and show."""
        return tasks.analyze_objects(
            context,
            selected_subjects(context),
            analysis_settings(context, self),
            point_settings(context),
        )
