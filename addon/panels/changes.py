# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sub-panel with what changed since the segmentation before."""

from __future__ import annotations

from bpy.types import Context, Panel

from ..bridge import units
from ..bridge.comparison import class_changes, previous_criterion
from ..geometry.display.palette import CLASS_NAMES
from .base import SidebarPanel, active_results_mesh
from .text import wrap


class CURVATURE_PT_changes(SidebarPanel, Panel):
    """Area per class before and after a change of the design."""

    bl_idname = "CURVATURE_PT_changes"
    bl_label = "Changes"
    bl_parent_id = "CURVATURE_PT_results"

    @classmethod
    def poll(cls, context: Context) -> bool:
        """Appear only where something changed."""
        mesh = active_results_mesh(context)
        return mesh is not None and bool(class_changes(mesh))

    def draw(self, context: Context) -> None:
        """Draw area before, area after and the difference per class."""
        mesh = active_results_mesh(context)
        for kind, before, after in class_changes(mesh) if mesh else ():
            col = self.layout.column(align=True)
            col.label(text=CLASS_NAMES[kind])
            row = col.row()
            row.active = False
            texts = [units.area_text(context.scene, area) for area in (before, after)]
            row.label(text=f"{texts[0]} \u2192 {texts[1]}")
            sign = "+" if after > before else "\u2212"
            change = row.row()
            change.alignment = "RIGHT"
            change.label(text=f"{sign}{units.area_text(context.scene, abs(after - before))}")
        previous = previous_criterion(mesh) if mesh else ""
        if previous:
            col = self.layout.column(align=True)
            col.active = False
            for line in wrap(f"Criterion before: {previous}", context):
                col.label(text=line)
