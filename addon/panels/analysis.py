# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Panel with the measurement of curvature and its colors."""

from __future__ import annotations

from bpy.types import Context, Panel

from ..bridge.display import CURVATURES
from .base import SidebarPanel


class CURVATURE_PT_analysis(SidebarPanel, Panel):
    """Which quantity is shown in which colors, and the button that measures."""

    bl_idname = "CURVATURE_PT_analysis"
    bl_label = "Analysis"
    bl_order = 2

    def draw(self, context: Context) -> None:
        """Draw the settings that matter for the quantity shown, and the buttons."""
        layout = self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        settings = context.scene.curvature

        row = layout.row(align=True)
        row.operator("curvature.analyze", text="Analyze", icon="SHADING_RENDERED")
        row.operator("curvature.clear", text="", icon="TRASH")

        layout.prop(settings, "quantity")
        if settings.quantity in CURVATURES:
            layout.prop(settings, "color_map")
            layout.row().prop(settings, "range_mode", expand=True)
            is_fixed = settings.range_mode == "FIXED"
            layout.prop(settings, "range_limit" if is_fixed else "range_percentile")
        col = layout.column(heading="Show")
        col.prop(settings, "show_legend")
        col.prop(settings, "use_material")
        layout.column(heading="Normals").prop(settings, "flip_normals", text="Flip")
        layout.prop(settings, "smoothing")
        if settings.smoothing == "LENGTH":
            layout.prop(settings, "smoothing_length_shown")
