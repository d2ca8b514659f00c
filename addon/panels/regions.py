# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sub-panel with the list of regions, and how to change them."""

from __future__ import annotations

from bpy.types import Context, Panel, PropertyGroup, UILayout, UIList

from ..bridge import units
from ..geometry.classification import SurfaceClass
from ..geometry.display.palette import CLASS_NAMES
from .base import SidebarPanel, active_results_mesh

#: Sidebars wider than this, in pixels, have room for all figures.
_WIDE = 330.0


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
        split = row.split(factor=0.36 if _is_wide(context) else 0.58)
        split.prop(item, "name", text="", emboss=False)
        texts = [units.area_text(scene, item.area)]
        if _is_wide(context):
            texts += [_radius_text(context, item), f"{item.faces:,}"]
        for text in texts:
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
        layout.template_list(
            CURVATURE_UL_regions.bl_idname, "", results, "regions", results, "active_region", rows=5
        )
        hidden = results.region_count - len(results.regions)
        if hidden > 0:
            layout.label(text=f"and {hidden:,} smaller regions")
        if results.active_region < len(results.regions):
            _draw_figures(layout, context, results.regions[results.active_region])
        row = layout.row(align=True)
        row.operator("curvature.select_region", text="Select", icon="RESTRICT_SELECT_OFF")
        row.operator("curvature.select_region", text="Zoom", icon="ZOOM_SELECTED").zoom = True
        col = layout.column(align=True)
        col.label(text="Edit Selected Faces")
        row = col.row(align=True)
        row.operator_menu_enum("curvature.assign_class", "surface_class", text="Assign")
        row.operator("curvature.merge_regions", text="Merge")
        row.operator("curvature.split_region", text="Split")


def _is_wide(context: Context) -> bool:
    """Return whether the sidebar has room for all figures of a region in one row."""
    scale = context.preferences.system.ui_scale
    return context.region is not None and context.region.width > _WIDE * scale


def _radius_text(context: Context, region: PropertyGroup) -> str:
    if not region.min_radius:
        return "\u2013"
    return f"R \u2265 {units.length_text(context.scene, region.min_radius)}"


def _draw_figures(layout: UILayout, context: Context, region: PropertyGroup) -> None:
    """Draw what the list has no room for, of the chosen region."""
    col = layout.column(align=True)
    col.active = False
    col.label(text=CLASS_NAMES[SurfaceClass[region.surface_class]])
    row = col.row()
    row.label(text=f"{region.faces:,} {'face' if region.faces == 1 else 'faces'}")
    row.label(text=_radius_text(context, region))
