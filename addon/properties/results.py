# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Results that a mesh carries beside its attributes."""

from __future__ import annotations

from bpy.props import (
    BoolProperty,
    CollectionProperty,
    EnumProperty,
    FloatProperty,
    IntProperty,
    StringProperty,
)
from bpy.types import PropertyGroup

from .items import CLASS_ITEMS, CRITERION_ITEMS, OUTLINE_ITEMS, SMOOTHING_ITEMS


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

    name: StringProperty(
        name="Name", description="Name of the region, which it keeps when it is segmented again"
    )
    surface_class: EnumProperty(
        name="Class", description="Class of the region's faces", items=CLASS_ITEMS
    )
    area: FloatProperty(name="Area", description="Area of the faces in m²")
    min_radius: FloatProperty(
        name="Smallest Radius",
        description="Radius in meters that 99 % of the area does not fall below; 0 if flat",
    )
    faces: IntProperty(name="Faces", description="Number of faces")


class CURVATURE_PG_curves(PropertyGroup):
    """Curves that were made of the results."""

    kind: EnumProperty(name="Kind", description="What the curves follow", items=OUTLINE_ITEMS)
    curves: IntProperty(name="Curves", description="Number of curves")
    length: FloatProperty(name="Length", description="Length of all curves together in meters")


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
    criterion: EnumProperty(
        name="Criterion", description="Criterion of the classes", items=CRITERION_ITEMS
    )
    criterion_preset: StringProperty(
        name="Preset", description="Preset that the limits are of, empty where set by hand"
    )
    criterion_source: StringProperty(
        name="Source", description="Where the preset has its limits from"
    )
    previous_criterion: StringProperty(
        name="Previous Criterion", description="Criterion of the previous classes in words"
    )
    panel_size: FloatProperty(name="Panel Size", description="Panel size used, in meters")
    deviation: FloatProperty(name="Deviation", description="Deviation used, in meters")
    curvature_limit: FloatProperty(
        name="Curvature Limit", description="Curvature in 1/m up to which panels count as straight"
    )
    gaussian_limit: FloatProperty(
        name="Gaussian Limit", description="Limit of |K| used, in 1/m²; 0 without raw limits"
    )
    min_area: FloatProperty(name="Minimum Area", description="Minimum area used, in m²")
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
    active_region: IntProperty(
        name="Active Region", description="Region that is chosen in the list, 0 for the largest"
    )
    outlines: CollectionProperty(
        type=CURVATURE_PG_curves, name="Outlines", description="Curves made of these results"
    )
    topology: StringProperty(
        name="Topology", description="Tells whether the faces are those that were segmented"
    )
    segmentation: StringProperty(
        name="Segmentation", description="Settings of the segmentation, as JSON"
    )
    warnings: CollectionProperty(
        type=CURVATURE_PG_warning, name="Warnings", description="What is unsound about the model"
    )
    report: StringProperty(
        name="Report", description="Everything measured, as the JSON that reports are made of"
    )
