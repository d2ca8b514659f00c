# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sub-panel with lines through points of the user's own."""

from __future__ import annotations

from bpy.types import Context, Panel

from .base import SidebarPanel

_THROUGH = (
    ("CURSOR", "Through 3D Cursor", "PIVOT_CURSOR"),
    ("VERTICES", "Through Selected Vertices", "VERTEXSEL"),
)


class CURVATURE_PT_picking(SidebarPanel, Panel):
    """Lines picked with the mouse, or through given points."""

    bl_idname = "CURVATURE_PT_picking"
    bl_label = "Single Lines"
    bl_parent_id = "CURVATURE_PT_lines"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, _context: Context) -> None:
        """Draw a button per way to say where."""
        layout = self.layout
        layout.operator("curvature.pick_lines", icon="RESTRICT_SELECT_OFF")
        col = layout.column(align=True)
        for points, text, icon in _THROUGH:
            col.operator("curvature.trace_through", text=text, icon=icon).points = points
