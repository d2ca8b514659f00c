# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Panel with what was found."""

from __future__ import annotations

from bpy.types import Context, Mesh, Panel, PropertyGroup, Scene, UILayout

from ..bridge import units
from ..bridge.results import settings_of
from ..bridge.segmentation_settings import segmentation_settings_of
from ..choices import analysis_settings, segmentation_settings
from ..geometry.classification import SurfaceClass
from ..geometry.display.palette import CLASS_NAMES
from ..geometry.errors import InvalidSettingError
from ..geometry.settings import SegmentationSettings
from ..preset_text import LIMITS
from .base import SidebarPanel, active_results_mesh
from .text import wrap

_OTHER_SETTINGS = "Made with other settings than those above"


class CURVATURE_PT_results(SidebarPanel, Panel):
    """Measures of every class."""

    bl_idname = "CURVATURE_PT_results"
    bl_label = "Results"
    bl_order = 1

    def draw(self, context: Context) -> None:
        """Draw a row of figures per class."""
        layout = self.layout
        mesh = active_results_mesh(context)
        if mesh is None or not mesh.curvature.is_segmented:
            layout.label(text="Segment a model to see its classes", icon="INFO")
            return
        if _has_other_settings(context, mesh):
            col = layout.column(align=True)
            for number, line in enumerate(wrap(_OTHER_SETTINGS, context)):
                col.label(text=line, icon="BLANK1" if number else "INFO")
        for row in mesh.curvature.classes:
            if row.faces or row.surface_class != SurfaceClass.UNDEFINED.name:
                _draw_class(layout, context.scene, row)
        layout.operator("curvature.export_report", icon="EXPORT")


def _has_other_settings(context: Context, mesh: Mesh) -> bool:
    """Return whether pressing Segment would ask for something else than what is shown."""
    try:
        wanted = segmentation_settings(context), analysis_settings(context)
    except InvalidSettingError:
        return True
    return (_limits(wanted[0]), wanted[1]) != (
        _limits(segmentation_settings_of(mesh)),
        settings_of(mesh),
    )


def _limits(settings: SegmentationSettings) -> tuple[object, ...]:
    """Return the settings that count with their criterion."""
    names = ("panel_size", "min_area", *LIMITS[settings.criterion.name])
    return settings.criterion, *(getattr(settings, name) for name in names)


def _draw_class(layout: UILayout, scene: Scene, measure: PropertyGroup) -> None:
    surface_class = SurfaceClass[measure.surface_class]
    box = layout.box().column(align=True)
    row = box.row(align=True)
    swatch = row.row()
    swatch.scale_x = 0.3
    swatch.prop(scene.curvature, f"color_{surface_class.name.lower()}", text="")
    row.label(text=f" {CLASS_NAMES[surface_class]}")
    share = row.row()
    share.alignment = "RIGHT"
    share.label(text=f"{100.0 * measure.share:.1f} %")
    row.operator(
        "curvature.select_class", text="", icon="RESTRICT_SELECT_OFF", emboss=False
    ).surface_class = surface_class.name
    if measure.faces:
        _draw_figures(box, scene, measure)


def _draw_figures(box: UILayout, scene: Scene, measure: PropertyGroup) -> None:
    flow = box.grid_flow(columns=2, even_columns=True, align=True, row_major=True)
    flow.active = False
    flow.label(text=units.area_text(scene, measure.area))
    flow.label(text=f"{measure.regions:,} {'region' if measure.regions == 1 else 'regions'}")
    flow.label(text=f"{measure.faces:,} {'face' if measure.faces == 1 else 'faces'}")
    if measure.min_radius:
        flow.label(text=f"R \u2265 {units.length_text(scene, measure.min_radius)}")
