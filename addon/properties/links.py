# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What an object has to do with curvature: its source, and the materials that are covered."""

from __future__ import annotations

import bpy
from bpy.props import (
    BoolProperty,
    CollectionProperty,
    FloatProperty,
    PointerProperty,
    StringProperty,
)
from bpy.types import Object, PropertyGroup


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
    companion_of: PointerProperty(
        type=Object,
        name="Companion Of",
        description="Object whose lines, borders, umbilics or hatching this object shows",
    )
    role: StringProperty(name="Role", description="What this object shows of its model")
    fingerprint: StringProperty(
        name="Fingerprint", description="State of the model that this object was made on"
    )
    tolerance: FloatProperty(
        name="Tolerance", description="How far borders were moved at most, in meters"
    )
    straighten: BoolProperty(name="Straighten", description="Whether borders were straightened")
    include_rims: BoolProperty(
        name="Include Rims", description="Whether the edges of the surface count as borders"
    )
    slots: CollectionProperty(
        type=CURVATURE_PG_slot, name="Slots", description="Materials to bring back"
    )
    has_material: BoolProperty(
        name="Has Curvature Material", description="Whether the slots show curvature colors"
    )
