# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Segment models by class."""

from __future__ import annotations

from math import pi

from bpy.props import EnumProperty, FloatProperty
from bpy.types import Context, Event, Operator

from ..addon import polls, tasks
from ..addon.bridge.subject import selected_subjects
from ..addon.choices import (
    adopt_criterion,
    adopt_settings,
    analysis_settings,
    segmentation_settings,
)
from ..addon.properties.items import CRITERION_FIELDS, CRITERION_ITEMS
from ..addon.running import RunningOperator
from ..addon.steps import Steps

_LIMITS = ("panel_size", "deviation", "smallest_radius", "gaussian_limit", "mean_limit")
_NAMES = ("criterion", *_LIMITS, "crease_angle", "min_area")


class CURVATURE_OT_segment(RunningOperator, Operator):
    """Segment the selected meshes into flat, single-curved and double-curved areas."""

    bl_idname = "curvature.segment"
    bl_label = "Segment by Curvature"
    bl_description = (
        "Find which parts of the selected meshes are flat, single-curved, domes or saddles "
        "at the tolerance of the panels"
    )
    bl_options = {"REGISTER", "UNDO"}
    verb = "Segmented"

    criterion: EnumProperty(
        name="Criterion",
        description="What decides between flat, single-curved and double-curved; "
        "a limit that is given brings its own",
        items=CRITERION_ITEMS,
        default="PANEL",
        options={"SKIP_SAVE"},
    )
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
    smallest_radius: FloatProperty(
        name="Smallest Radius (m)",
        description="Radius in meters beyond which a panel counts as straight; "
        "0 takes the scene's setting",
        default=0.0,
        min=0.0,
        options={"SKIP_SAVE"},
    )
    gaussian_limit: FloatProperty(
        name="Gaussian Limit",
        description="Largest |K| in 1/m² of what counts as flat or single-curved; "
        "0 takes the scene's setting",
        default=0.0,
        min=0.0,
        precision=5,
        options={"SKIP_SAVE"},
    )
    mean_limit: FloatProperty(
        name="Mean Limit",
        description="Largest |H| in 1/m of what counts as flat; 0 takes the scene's setting",
        default=0.0,
        min=0.0,
        precision=5,
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
        adopt_criterion(self)
        adopt_settings(self, context, _NAMES)
        return self.start(context)

    def draw(self, _context: Context) -> None:
        """Draw what matters to the criterion."""
        layout = self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        for name in ("criterion", *CRITERION_FIELDS[self.criterion], "crease_angle", "min_area"):
            layout.prop(self, name)

    def steps(self, context: Context) -> Steps[tasks.Outcome]:
        """Measure where needed, segment, write and show."""
        return tasks.segment_objects(
            context,
            selected_subjects(context),
            analysis_settings(context, self),
            segmentation_settings(context, self),
        )
