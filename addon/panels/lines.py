# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Panel with curvature lines."""

from __future__ import annotations

from bpy.types import Context, Object, Panel, UILayout

from ..bridge import units
from ..bridge.companions import ROLES, companions
from ..bridge.curves import line_lengths
from ..bridge.drawings import LINE_ROLES
from ..bridge.subject import source_of
from .base import SidebarPanel


class CURVATURE_PT_lines(SidebarPanel, Panel):
    """Which lines to trace how far apart, and what there is of them."""

    bl_idname = "CURVATURE_PT_lines"
    bl_label = "Curvature Lines"
    bl_order = 3

    def draw(self, context: Context) -> None:
        """Draw the settings, the buttons, and the lines that the active model has."""
        layout = self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        settings = context.scene.curvature

        layout.row().prop(settings, "line_kind", expand=True)
        layout.prop(settings, "families")
        col = layout.column(align=True)
        col.prop(settings, "spacing_shown")
        col.prop(settings, "thickness_shown")
        layout.column(heading="Fit").prop(settings, "fit_curves")
        if settings.fit_curves:
            layout.prop(settings, "fit_tolerance_shown")

        row = layout.row()
        row.scale_y = 1.4
        row.operator("curvature.trace_lines", text="Trace Lines", icon="CURVE_DATA")
        layout.operator("curvature.find_umbilics", icon="DOT")
        if context.object is not None:
            _draw_found(layout, context, source_of(context.object))


def _draw_found(layout: UILayout, context: Context, source: Object) -> None:
    """Draw a row per object of lines and markers, and the export."""
    found = companions(source, (*LINE_ROLES, "UMBILICS"))
    if not found:
        return
    col = layout.box().column(align=True)
    for obj in found:
        row = col.row()
        row.label(text=ROLES[obj.curvature.role].ending)
        figure = row.row()
        figure.alignment = "RIGHT"
        figure.active = False
        figure.label(text=_figure(context, obj))
    if any(obj.type == "CURVE" for obj in found):
        layout.operator("curvature.export_lines", icon="EXPORT")


def _figure(context: Context, obj: Object) -> str:
    if obj.type != "CURVE":
        count = len(obj.data.vertices)
        return f"{count:,} {'point' if count == 1 else 'points'}"
    lengths = line_lengths(obj)
    noun = "line" if len(lengths) == 1 else "lines"
    return f"{len(lengths):,} {noun}, {units.length_text(context.scene, sum(lengths))}"
