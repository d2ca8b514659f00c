# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Panel with the criterion and the main button."""

from __future__ import annotations

from bpy.types import Context, Panel, PropertyGroup, UILayout

from ..bridge import units
from ..bridge.criteria import criterion_lines
from ..choices import segmentation_settings
from ..geometry.criterion import resolve_criterion
from ..geometry.errors import CurvatureError
from ..properties.items import CRITERION_FIELDS
from .base import SidebarPanel
from .text import wrap


class CURVATURE_PT_segmentation(SidebarPanel, Panel):
    """Criterion, its limits, and the button that segments."""

    bl_idname = "CURVATURE_PT_segmentation"
    bl_label = "Segmentation"
    bl_order = 0

    def draw(self, context: Context) -> None:
        """Draw the settings, what they mean in words, and the button."""
        layout = self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        settings = context.scene.curvature

        _draw_presets(layout, settings)
        layout.prop(settings, "criterion")
        col = layout.column(align=True)
        for name in (*CRITERION_FIELDS[settings.criterion], "min_area"):
            shown = f"{name}_shown"
            col.prop(settings, shown if shown in settings.bl_rna.properties else name)
        layout.prop(settings, "crease_angle")

        for sentence in (_criterion_sentence(context), settings.criterion_source):
            col = layout.column(align=True)
            col.active = False
            for line in wrap(sentence, context):
                col.label(text=line)

        row = layout.row()
        row.scale_y = 1.4
        row.operator("curvature.segment", text="Segment", icon="MOD_EXPLODE")


def _draw_presets(layout: UILayout, settings: PropertyGroup) -> None:
    row = layout.row(align=True)
    row.menu("CURVATURE_MT_presets", text=settings.criterion_preset or "Presets")
    row.operator("curvature.preset_add", text="", icon="ADD")
    remove = row.row(align=True)
    remove.enabled = bool(settings.criterion_preset)
    button = remove.operator("curvature.preset_add", text="", icon="REMOVE")
    button.name = settings.criterion_preset
    button.remove_name = True


def _criterion_sentence(context: Context) -> str:
    """Return the criterion for the active object; its dimensions are known without its mesh."""
    active = context.object
    diagonal = 0.0
    if active is not None and active.type == "MESH":
        diagonal = active.dimensions.length * units.meters_per_unit(context.scene)
    try:
        criterion = resolve_criterion(segmentation_settings(context), diagonal)
    except CurvatureError:
        is_panel = context.scene.curvature.criterion == "PANEL"
        return "" if is_panel else "Set the limits, or choose a preset"
    return " ".join(criterion_lines(context.scene, criterion))
