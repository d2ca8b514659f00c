# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Settings of a scene and results of a mesh, as Blender stores them in its files."""

from __future__ import annotations

import bpy
from bpy.props import PointerProperty

from .links import CURVATURE_PG_object, CURVATURE_PG_slot
from .results import (
    CURVATURE_PG_class,
    CURVATURE_PG_curves,
    CURVATURE_PG_region,
    CURVATURE_PG_results,
    CURVATURE_PG_warning,
)
from .settings import CURVATURE_PG_settings

_CLASSES = (
    CURVATURE_PG_settings,
    CURVATURE_PG_warning,
    CURVATURE_PG_class,
    CURVATURE_PG_region,
    CURVATURE_PG_curves,
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
