# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sub-panel that hands the classes on."""

from __future__ import annotations

from bpy.types import Context, Panel

from .base import SidebarPanel, active_results_mesh


class CURVATURE_PT_delivery(SidebarPanel, Panel):
    """Objects, materials, groups and face sets of the classes."""

    bl_idname = "CURVATURE_PT_delivery"
    bl_label = "Delivery"
    bl_parent_id = "CURVATURE_PT_results"
    bl_options = {"DEFAULT_CLOSED"}

    @classmethod
    def poll(cls, context: Context) -> bool:
        """Appear where there are classes."""
        mesh = active_results_mesh(context)
        return mesh is not None and mesh.curvature.is_segmented

    def draw(self, _context: Context) -> None:
        """Draw a button per form."""
        layout = self.layout
        row = layout.row(align=True)
        row.operator_enum("curvature.separate", "by")
        col = layout.column(align=True)
        col.operator_enum("curvature.deliver", "form")
