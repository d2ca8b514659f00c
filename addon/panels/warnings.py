# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sub-panel with what is unsound about the model."""

from __future__ import annotations

from bpy.types import Context, Panel

from .base import SidebarPanel, active_results_mesh
from .text import wrap


class CURVATURE_PT_warnings(SidebarPanel, Panel):
    """Warnings of the last analysis, each with what to do."""

    bl_idname = "CURVATURE_PT_warnings"
    bl_label = "Warnings"
    bl_parent_id = "CURVATURE_PT_results"

    @classmethod
    def poll(cls, context: Context) -> bool:
        """Appear only where there is something to warn of."""
        mesh = active_results_mesh(context)
        return mesh is not None and len(mesh.curvature.warnings) > 0

    def draw(self, context: Context) -> None:
        """Draw each sentence over as many lines as it needs."""
        mesh = active_results_mesh(context)
        for warning in mesh.curvature.warnings if mesh else ():
            col = self.layout.column(align=True)
            for number, line in enumerate(wrap(warning.text, context)):
                col.label(text=line, icon="BLANK1" if number else "ERROR")
