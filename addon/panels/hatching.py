# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sub-panel with strokes for illustrations."""

from __future__ import annotations

from bpy.types import Context, Panel

from .base import SidebarPanel


class CURVATURE_PT_hatching(SidebarPanel, Panel):
    """Strokes along the directions of curvature."""

    bl_idname = "CURVATURE_PT_hatching"
    bl_label = "Hatching"
    bl_parent_id = "CURVATURE_PT_lines"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context: Context) -> None:
        """Draw the settings and the button."""
        layout = self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        settings = context.scene.curvature
        layout.row().prop(settings, "hatch_tone", expand=True)
        if settings.hatch_tone == "SHADE":
            layout.prop(settings, "hatch_light")
        layout.prop(settings, "hatch_spacing_shown")
        layout.operator("curvature.hatch", icon="OUTLINER_OB_GREASEPENCIL")
