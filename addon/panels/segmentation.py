# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Panel with the tolerance and the main button."""

from __future__ import annotations

from bpy.types import Context, Panel

from ..bridge import units
from ..geometry.errors import CurvatureError
from ..geometry.tolerance import Tolerance, resolve_tolerance
from .base import SidebarPanel


class CURVATURE_PT_segmentation(SidebarPanel, Panel):
    """Panel size, deviation, and the button that segments."""

    bl_idname = "CURVATURE_PT_segmentation"
    bl_label = "Segmentation"
    bl_order = 0

    def draw(self, context: Context) -> None:
        """Draw the settings, what they mean in words, and the button."""
        layout = self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        settings = context.scene.curvature

        col = layout.column(align=True)
        col.prop(settings, "panel_size_shown")
        col.prop(settings, "deviation_shown")
        col.prop(settings, "min_area_shown")
        layout.prop(settings, "crease_angle")

        tolerance = _tolerance(context)
        if tolerance is not None:
            col = layout.column(align=True)
            col.active = False
            for line in _tolerance_lines(context, tolerance):
                col.label(text=line)

        row = layout.row()
        row.scale_y = 1.4
        row.operator("curvature.segment", text="Segment", icon="MOD_EXPLODE")


def _tolerance(context: Context) -> Tolerance | None:
    """Return the tolerance for the active object; its dimensions are known without its mesh."""
    settings, active = context.scene.curvature, context.object
    diagonal = 0.0
    if active is not None and active.type == "MESH":
        diagonal = active.dimensions.length * units.meters_per_unit(context.scene)
    try:
        return resolve_tolerance(settings.panel_size, settings.deviation, diagonal)
    except CurvatureError:
        return None


def _tolerance_lines(context: Context, tolerance: Tolerance) -> tuple[str, str]:
    scene = context.scene
    return (
        f"{units.length_text(scene, tolerance.deviation)} over "
        f"{units.length_text(scene, tolerance.panel_size)} panels:",
        f"straight above a radius of {units.length_text(scene, tolerance.radius_limit)}",
    )
