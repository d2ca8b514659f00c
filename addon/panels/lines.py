# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Panel with curvature lines."""

from __future__ import annotations

from bpy.types import Context, Object, Panel, UILayout

from ..bridge import units
from ..bridge.companions import ROLES, companions, is_outdated
from ..bridge.curves import DEVIATION, SPACING, line_lengths, stored_length
from ..bridge.drawings import LINE_ROLES
from ..bridge.subject import source_of
from ..choices import line_sizes
from ..geometry.errors import CurvatureError
from .base import SidebarPanel
from .text import wrap

_OUTDATED = "Made before the model or its settings changed: trace again"


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

        col = layout.column(align=True)
        col.active = False
        for line in wrap(_sizes_sentence(context), context):
            col.label(text=line)

        row = layout.row()
        row.scale_y = 1.4
        row.operator("curvature.trace_lines", text="Trace Lines", icon="CURVE_DATA")
        layout.operator("curvature.find_umbilics", icon="DOT")
        if context.object is not None:
            _draw_found(layout, context, source_of(context.object))


def _sizes_sentence(context: Context) -> str:
    """Return what the lengths are for the active object, where 0 stands for a default."""
    active = context.object
    if active is None or source_of(active).type != "MESH":
        return ""
    diagonal = source_of(active).dimensions.length * units.meters_per_unit(context.scene)
    if not diagonal:
        return ""
    try:
        sizes = line_sizes(context, diagonal)
    except CurvatureError as error:
        return f"{error}".capitalize()
    lengths = (sizes.spacing, sizes.thickness, sizes.tolerance)
    apart, thick, off = (units.length_text(context.scene, length) for length in lengths)
    fit = f", within {off}" if context.scene.curvature.fit_curves else ""
    return f"Lines {apart} apart, {thick} thick{fit}"


def _draw_found(layout: UILayout, context: Context, source: Object) -> None:
    """Draw a row per object of lines and markers, and the export."""
    found = companions(source, (*LINE_ROLES, "UMBILICS"))
    if not found:
        return
    outdated = [obj for obj in found if is_outdated(obj)]
    if outdated:
        col = layout.column(align=True)
        for number, line in enumerate(wrap(_OUTDATED, context)):
            col.label(text=line, icon="BLANK1" if number else "INFO")
    col = layout.box().column(align=True)
    for obj in found:
        row = col.row()
        icon = "FILE_REFRESH" if obj in outdated else "NONE"
        row.label(text=ROLES[obj.curvature.role].ending, icon=icon)
        _draw_figure(row, _figure(context, obj))
    for name, key in (("Spacing", SPACING), ("Off the Surface", DEVIATION)):
        lengths = {stored_length(obj, key) for obj in found} - {0.0}
        if lengths:
            row = col.row()
            row.label(text=name)
            _draw_figure(
                row, ", ".join(units.length_text(context.scene, x) for x in sorted(lengths))
            )
    if any(obj.type == "CURVE" for obj in found):
        layout.operator("curvature.export_lines", icon="EXPORT")


def _draw_figure(row: UILayout, text: str) -> None:
    figure = row.row()
    figure.alignment = "RIGHT"
    figure.active = False
    figure.label(text=text)


def _figure(context: Context, obj: Object) -> str:
    if obj.type != "CURVE":
        count = len(obj.data.vertices)
        return f"{count:,} {'point' if count == 1 else 'points'}"
    lengths = line_lengths(obj)
    noun = "line" if len(lengths) == 1 else "lines"
    return f"{len(lengths):,} {noun}, {units.length_text(context.scene, sum(lengths))}"
