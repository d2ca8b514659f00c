# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Settings of a scene."""

from __future__ import annotations

from math import pi

from bpy.props import BoolProperty, EnumProperty, FloatProperty, FloatVectorProperty
from bpy.types import Context, PropertyGroup

from ..bridge import display, units, viewport
from ..geometry.classification import SurfaceClass
from ..geometry.creases import DEFAULT_CREASE_ANGLE
from ..geometry.display.colormap import ColorMap
from ..geometry.display.palette import CLASS_NAMES, default_class_colors
from ..geometry.settings import Smoothing
from .items import QUANTITY_ITEMS, SMOOTHING_ITEMS

_COLORS = default_class_colors()


def _refresh(settings: PropertyGroup, context: Context) -> None:
    """Recolor what is analyzed; the arrays are at hand, so that it keeps up with a slider."""
    display.refresh(context, settings.id_data)


def _redraw(_settings: PropertyGroup, context: Context) -> None:
    viewport.redraw(context)


def _in_scene_units(name: str, dimension: int = 1) -> dict[str, object]:
    """Return accessors that show a length (or area, dimension 2) in meters in the scene's units."""

    def read(settings: PropertyGroup) -> float:
        return getattr(settings, name) / units.meters_per_unit(settings.id_data) ** dimension

    def write(settings: PropertyGroup, value: float) -> None:
        setattr(settings, name, value * units.meters_per_unit(settings.id_data) ** dimension)

    return {"get": read, "set": write}


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


class CURVATURE_PG_settings(PropertyGroup):
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
    panel_size: FloatProperty(
        name="Panel Size (m)",
        description="Edge length of the panels in meters; 0 takes a twentieth of the model",
        default=0.0,
        min=0.0,
    )
    deviation: FloatProperty(
        name="Deviation (m)",
        description="Allowed distance between panel and surface in meters; "
        "0 takes a two-hundredth of the panel size",
        default=0.0,
        min=0.0,
        precision=5,
    )
    min_area: FloatProperty(
        name="Minimum Area (m²)",
        description="Regions below this area in m² join a neighbor; 0 keeps all regions",
        default=0.0,
        min=0.0,
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
        description="Regions below this area join a neighbor; 0 keeps all regions",
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
<<<<<<< HEAD:addon/properties/settings.py
=======


class CURVATURE_PG_warning(PropertyGroup):
    """One sentence about what is unsound."""

    text: StringProperty(name="Text", description="What is wrong, where, and what to do")


class CURVATURE_PG_class(PropertyGroup):
    """How much of the mesh belongs to one class."""

    surface_class: EnumProperty(
        name="Class", description="Class that the measures are of", items=CLASS_ITEMS
    )
    area: FloatProperty(name="Area", description="Area of the faces in m²")
    share: FloatProperty(name="Share", description="Share of the whole area, 0 to 1")
    faces: IntProperty(name="Faces", description="Number of faces")
    regions: IntProperty(name="Regions", description="Number of connected areas")
    min_radius: FloatProperty(
        name="Smallest Radius",
        description="Radius in meters that 99 % of the area does not fall below; 0 if flat",
    )


class CURVATURE_PG_region(PropertyGroup):
    """One connected area of a class."""

    surface_class: EnumProperty(
        name="Class", description="Class of the region's faces", items=CLASS_ITEMS
    )
    area: FloatProperty(name="Area", description="Area of the faces in m²")
    min_radius: FloatProperty(
        name="Smallest Radius",
        description="Radius in meters that 99 % of the area does not fall below; 0 if flat",
    )


class CURVATURE_PG_results(PropertyGroup):
    """Results that a mesh carries beside its attributes; empty where nothing was analyzed."""

    fingerprint: StringProperty(
        name="Fingerprint", description="Tells whether the model has changed since its analysis"
    )
    crease_angle: FloatProperty(
        name="Crease Angle", description="Crease angle used, in radians", subtype="ANGLE"
    )
    flip_normals: BoolProperty(name="Flip Normals", description="Whether signs were flipped")
    smoothing: EnumProperty(name="Smoothing", description="Smoothing used", items=SMOOTHING_ITEMS)
    smoothing_length: FloatProperty(
        name="Smoothing Length", description="Smoothing length used, in meters"
    )
    is_segmented: BoolProperty(
        name="Segmented", description="Whether the faces have classes and regions"
    )
    panel_size: FloatProperty(name="Panel Size", description="Panel size used, in meters")
    deviation: FloatProperty(name="Deviation", description="Deviation used, in meters")
    curvature_limit: FloatProperty(
        name="Curvature Limit", description="Curvature in 1/m up to which panels count as straight"
    )
    classes: CollectionProperty(
        type=CURVATURE_PG_class, name="Classes", description="Measures of every class"
    )
    previous: CollectionProperty(
        type=CURVATURE_PG_class,
        name="Previous Classes",
        description="Measures of every class before the model or its tolerance was changed",
    )
    regions: CollectionProperty(
        type=CURVATURE_PG_region, name="Regions", description="The largest regions, by area"
    )
    region_count: IntProperty(name="Region Count", description="Number of all regions")
    warnings: CollectionProperty(
        type=CURVATURE_PG_warning, name="Warnings", description="What is unsound about the model"
    )
    report: StringProperty(
        name="Report", description="Everything measured, as the JSON that reports are made of"
    )


class CURVATURE_PG_slot(PropertyGroup):
    """A material slot as it was before the curvature colors took its place."""

    link: StringProperty(name="Link", description="Whether the mesh or the object had the material")
    material: PointerProperty(
        type=bpy.types.Material, name="Material", description="Material of the object's slot"
    )


class CURVATURE_PG_object(PropertyGroup):
    """What an object has to do with curvature."""

    source: PointerProperty(
        type=Object,
        name="Source",
        description="Object whose modified geometry this object carries the results of",
    )
    part_of: PointerProperty(
        type=Object,
        name="Part Of",
        description="Object whose class or region this object was made of",
    )
    slots: CollectionProperty(
        type=CURVATURE_PG_slot, name="Slots", description="Materials to bring back"
    )
    has_material: BoolProperty(
        name="Has Curvature Material", description="Whether the slots show curvature colors"
    )


_CLASSES = (
    CURVATURE_PG_settings,
    CURVATURE_PG_warning,
    CURVATURE_PG_class,
    CURVATURE_PG_region,
    CURVATURE_PG_results,
    CURVATURE_PG_slot,
    CURVATURE_PG_object,
)
_register_classes, _unregister_classes = bpy.utils.register_classes_factory(_CLASSES)


def register() -> None:
    """Add the properties to scenes, meshes and objects."""
    _register_classes()
    bpy.types.Scene.curvature = PointerProperty(type=CURVATURE_PG_settings)
    bpy.types.Mesh.curvature = PointerProperty(type=CURVATURE_PG_results)
    bpy.types.Object.curvature = PointerProperty(type=CURVATURE_PG_object)


def unregister() -> None:
    """Take the properties away again."""
    del bpy.types.Object.curvature
    del bpy.types.Mesh.curvature
    del bpy.types.Scene.curvature
    _unregister_classes()
>>>>>>> 19bda3e (Show what changed since the segmentation before):addon/properties.py
