# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sub-panel with the curves that can be made of the results."""

from __future__ import annotations

from bpy.types import Context, Panel

from ..bridge import units
from .base import SidebarPanel, active_results_mesh


class CURVATURE_PT_outlines(SidebarPanel, Panel):
    """Region borders and parabolic curves, with their lengths."""

    bl_idname = "CURVATURE_PT_outlines"
    bl_label = "Curves"
    bl_parent_id = "CURVATURE_PT_results"
    bl_options = {"DEFAULT_CLOSED"}

    @classmethod
    def poll(cls, context: Context) -> bool:
        """Appear where there are regions."""
        mesh = active_results_mesh(context)
        return mesh is not None and mesh.curvature.is_segmented

    def draw(self, context: Context) -> None:
        """Draw a button per kind, and how many curves there are."""
        layout = self.layout
        layout.column(align=True).operator_enum("curvature.outline", "kind")
        mesh = active_results_mesh(context)
        for row in mesh.curvature.outlines if mesh else ():
            line = layout.row()
            line.label(text=f"{row.curves:,} {_NOUNS[row.kind]}")
            length = line.row()
            length.alignment = "RIGHT"
            length.label(text=units.length_text(context.scene, row.length))
        if mesh and mesh.curvature.outlines:
            layout.operator("curvature.export_lines", icon="EXPORT")


_NOUNS = {"BORDERS": "borders", "PARABOLIC": "parabolic curves"}
