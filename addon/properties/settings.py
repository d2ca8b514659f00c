# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Settings of a scene."""

from __future__ import annotations

from math import pi

from bpy.props import (
    BoolProperty,
    EnumProperty,
    FloatProperty,
    FloatVectorProperty,
    StringProperty,
)
from bpy.types import Context, PropertyGroup

from ..bridge import display, viewport
from ..geometry.classification import SurfaceClass
from ..geometry.creases import DEFAULT_CREASE_ANGLE
from ..geometry.display.colormap import ColorMap
from ..geometry.display.palette import CLASS_NAMES, default_class_colors
from ..geometry.settings import CriterionKind, Smoothing
from .items import CRITERION_ITEMS, QUANTITY_ITEMS, SMOOTHING_ITEMS
from .lengths import in_scene_units as _in_scene_units
from .lines import LineProperties

_COLORS = default_class_colors()


def _refresh(settings: PropertyGroup, context: Context) -> None:
    """Recolor what is analyzed; the arrays are at hand, so that it keeps up with a slider."""
    display.refresh(context, settings.id_data)


def _redraw(_settings: PropertyGroup, context: Context) -> None:
    viewport.redraw(context)


def _forget_preset(settings: PropertyGroup, _context: Context) -> None:
    """Forget the preset of a limit that is set by hand, and the source it had from there."""
    settings.criterion_preset = settings.criterion_source = ""


def _forget_panel_preset(settings: PropertyGroup, context: Context) -> None:
    """Forget the preset if it is one of panels: the others say nothing about their size."""
    if settings.criterion == CriterionKind.PANEL.name:
        _forget_preset(settings, context)


def _color(surface_class: SurfaceClass) -> object:
    name = CLASS_NAMES[surface_class]
    return FloatVectorProperty(
        name=f"{name} Color",
        description=f"Color of faces of the class {name.lower()}",
        subtype="COLOR",
        min=0.0,
        max=1.0,
        default=_COLORS[surface_class],
        update=_refresh,
    )


class CURVATURE_PG_settings(LineProperties, PropertyGroup):
    """Settings of a scene: what the operators use where they are not told otherwise."""

    smoothing: EnumProperty(
        name="Smoothing",
        description="Which detail of the surface is noise",
        items=SMOOTHING_ITEMS,
        default=Smoothing.AUTO.name,
    )
    smoothing_length: FloatProperty(
        name="Smoothing Length (m)",
        description="Detail below this length in meters is noise, where smoothing is by length",
        default=0.0,
        min=0.0,
    )
    smoothing_length_shown: FloatProperty(
        name="Length",
        description="Detail below this length is noise",
        unit="LENGTH",
        min=0.0,
        **_in_scene_units("smoothing_length"),
    )
    crease_angle: FloatProperty(
        name="Crease Angle",
        description="Fold between two faces above which their edge separates smooth areas",
        subtype="ANGLE",
        default=DEFAULT_CREASE_ANGLE,
        min=pi / 1800.0,
        max=pi,
    )
    flip_normals: BoolProperty(
        name="Flip Normals",
        description="Look at the surface from its other side: mean curvature changes its sign",
        default=False,
    )
    criterion: EnumProperty(
        name="Criterion",
        description="What decides between flat, single-curved and double-curved",
        items=CRITERION_ITEMS,
        default=CriterionKind.PANEL.name,
        update=_forget_preset,
    )
    criterion_preset: StringProperty(
        name="Preset", description="Preset that the limits are of, empty where set by hand"
    )
    criterion_source: StringProperty(
        name="Source", description="Where the preset has its limits from"
    )
    smallest_radius: FloatProperty(
        name="Smallest Radius (m)",
        description="Radius in meters beyond which a panel counts as straight",
        default=0.0,
        min=0.0,
        update=_forget_preset,
    )
    gaussian_limit: FloatProperty(
        name="Gaussian Limit",
        description="Largest |K| in 1/m² of what counts as flat or single-curved",
        default=0.0,
        min=0.0,
        precision=5,
        update=_forget_preset,
    )
    mean_limit: FloatProperty(
        name="Mean Limit",
        description="Largest |H| in 1/m of what counts as flat",
        default=0.0,
        min=0.0,
        precision=5,
        update=_forget_preset,
    )
    panel_size: FloatProperty(
        name="Panel Size (m)",
        description="Edge length of the panels in meters; 0 takes a twentieth of the model",
        default=0.0,
        min=0.0,
        update=_forget_panel_preset,
    )
    deviation: FloatProperty(
        name="Deviation (m)",
        description="Allowed distance between panel and surface in meters; "
        "0 takes a two-hundredth of the panel size",
        default=0.0,
        min=0.0,
        precision=5,
        update=_forget_preset,
    )
    min_area: FloatProperty(
        name="Minimum Area (m²)",
        description="Regions below this area in m² join a neighbor; 0 takes one panel",
        default=0.0,
        min=0.0,
    )
    smallest_radius_shown: FloatProperty(
        name="Smallest Radius",
        description="Radius beyond which a panel counts as straight",
        unit="LENGTH",
        min=0.0,
        **_in_scene_units("smallest_radius"),
    )
    panel_size_shown: FloatProperty(
        name="Panel Size",
        description="Edge length of the panels; 0 takes a twentieth of the model",
        unit="LENGTH",
        min=0.0,
        **_in_scene_units("panel_size"),
    )
    deviation_shown: FloatProperty(
        name="Deviation",
        description="Allowed distance between panel and surface; "
        "0 takes a two-hundredth of the panel size",
        unit="LENGTH",
        min=0.0,
        precision=5,
        **_in_scene_units("deviation"),
    )
    min_area_shown: FloatProperty(
        name="Minimum Area",
        description="Regions below this area join a neighbor; 0 takes one panel",
        unit="AREA",
        min=0.0,
        **_in_scene_units("min_area", 2),
    )
    quantity: EnumProperty(
        name="Quantity",
        description="What the colors of analyzed models show",
        items=QUANTITY_ITEMS,
        default="NONE",
        update=_refresh,
    )
    color_map: EnumProperty(
        name="Color Map",
        description="Colors from negative over zero to positive curvature",
        items=[
            (color_map.name, color_map.value, f"Color map {color_map.value.lower()}", number)
            for number, color_map in enumerate(ColorMap)
        ],
        default="COOL_WARM",
        update=_refresh,
    )
    range_mode: EnumProperty(
        name="Range",
        description="Which values get the last colors of the map",
        items=(
            ("PERCENTILE", "Percentile", "Values that bound a share of the area", 0),
            ("FIXED", "Fixed", "A value of your own, so that two designs can be compared", 1),
        ),
        default="PERCENTILE",
        update=_refresh,
    )
    range_percentile: FloatProperty(
        name="Percentile",
        description="Share of the area whose values lie within the range",
        subtype="PERCENTAGE",
        default=95.0,
        min=1.0,
        max=100.0,
        soft_min=50.0,
        update=_refresh,
    )
    range_limit: FloatProperty(
        name="Limit",
        description="Value of the last color in 1/m, or 1/m² for Gaussian curvature; "
        "its negative gets the first color",
        default=1.0,
        min=1e-9,
        soft_max=100.0,
        precision=4,
        update=_refresh,
    )
    shown_limit: FloatProperty(
        name="Shown Limit",
        description="Value of the last color as shown now, in the unit of the quantity",
        default=0.0,
    )
    shown_clipped: FloatProperty(
        name="Clipped Share",
        description="Share of the area whose values lie beyond the range",
        default=0.0,
    )
    show_legend: BoolProperty(
        name="Legend",
        description="Draw the key of the colors into the viewport",
        default=True,
        update=_redraw,
    )
    use_material: BoolProperty(
        name="Render Colors",
        description="Give analyzed models a material that shows the colors in renders too; "
        "their own materials come back when it is switched off",
        default=False,
        update=_refresh,
    )
    color_flat: _color(SurfaceClass.FLAT)
    color_single: _color(SurfaceClass.SINGLE)
    color_elliptic: _color(SurfaceClass.ELLIPTIC)
    color_hyperbolic: _color(SurfaceClass.HYPERBOLIC)
    color_undefined: _color(SurfaceClass.UNDEFINED)
