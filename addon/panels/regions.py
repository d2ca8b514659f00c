# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sub-panel with the list of regions, and how to change them."""

from __future__ import annotations

from bpy.types import Context, Panel, PropertyGroup, UILayout, UIList

from ..bridge import units
from .base import SidebarPanel, active_results_mesh


class CURVATURE_UL_regions(UIList):
    """Regions by falling area: class, name, area, smallest radius, number of faces."""

    bl_idname = "CURVATURE_UL_regions"

    def draw_item(
        self,
        context: Context,
        layout: UILayout,
        _data: object,
        item: PropertyGroup,
        _icon: int,
        _active_data: object,
        _active_name: str,
    ) -> None:
        """Draw one region as a row of figures."""
        scene = context.scene
        row = layout.row(align=True)
        swatch = row.row()
        swatch.scale_x = 0.3
        swatch.prop(scene.curvature, f"color_{item.surface_class.lower()}", text="")
        split = row.split(factor=0.4)
        split.prop(item, "name", text="", emboss=False)
        radius = units.length_text(scene, item.min_radius) if item.min_radius else "\u2013"
        for text in (units.area_text(scene, item.area), radius, f"{item.faces:,}"):
            cell = split.row()
            cell.alignment = "RIGHT"
            cell.label(text=text)


class CURVATURE_PT_regions(SidebarPanel, Panel):
    """The regions of the active model, to be named, selected and changed."""

    bl_idname = "CURVATURE_PT_regions"
    bl_label = "Regions"
    bl_parent_id = "CURVATURE_PT_results"
    bl_options = {"DEFAULT_CLOSED"}

    @classmethod
    def poll(cls, context: Context) -> bool:
        """Appear where there are regions."""
        mesh = active_results_mesh(context)
        return mesh is not None and mesh.curvature.is_segmented

    def draw(self, context: Context) -> None:
        """Draw the list, what to do with the chosen region, and what with selected faces."""
        layout = self.layout
        mesh = active_results_mesh(context)
        if mesh is None:
            return
        results = mesh.curvature
        _draw_heads(layout)
        layout.template_list(
            CURVATURE_UL_regions.bl_idname, "", results, "regions", results, "active_region", rows=5
        )
        hidden = results.region_count - len(results.regions)
        if hidden > 0:
            layout.label(text=f"and {hidden:,} smaller regions")
        row = layout.row(align=True)
        row.operator("curvature.select_region", text="Select", icon="RESTRICT_SELECT_OFF")
        row.operator("curvature.select_region", text="Zoom", icon="ZOOM_SELECTED").zoom = True
        col = layout.column(align=True)
        col.label(text="Edit Selected Faces")
        row = col.row(align=True)
        row.operator_menu_enum("curvature.assign_class", "surface_class", text="Assign")
        row.operator("curvature.merge_regions", text="Merge")
        row.operator("curvature.split_region", text="Split")


def _draw_heads(layout: UILayout) -> None:
    row = layout.row(align=True)
    row.active = False
    split = row.split(factor=0.4)
    split.label(text="Name")
    for text in ("Area", "Radius", "Faces"):
        cell = split.row()
        cell.alignment = "RIGHT"
        cell.label(text=text)
