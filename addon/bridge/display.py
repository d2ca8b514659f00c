# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the viewport shows: quantities as color attributes on every analyzed model of a scene."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from bpy.types import Context, Mesh, Object, PropertyGroup, Scene

from ..geometry.analysis import Analysis
from ..geometry.classification import SurfaceClass
from ..geometry.display.colormap import ColorMap, map_colors
from ..geometry.display.palette import class_color_table, region_colors
from ..geometry.display.range import clipped_share, percentile_limit
from ..geometry.errors import CurvatureError
from ..geometry.types import Floats
from . import cache, material, names, viewport
from .attributes import read_attribute, show_color_attribute, write_attribute
from .mesh import polygon_sizes
from .numbers import as_typed
from .results import settings_of
from .subject import read_object, source_of, users_of

CURVATURES = ("GAUSSIAN", "MEAN", "K1", "K2")
"""Quantities that a color map shows; the others have a color per class or region."""


@dataclass(frozen=True)
class _Model:
    mesh: Mesh
    analysis: Analysis


def class_colors(settings: PropertyGroup) -> dict[SurfaceClass, tuple[float, float, float]]:
    """Return the scene-linear colors that the user gave to the classes."""
    return {
        surface_class: tuple(getattr(settings, f"color_{surface_class.name.lower()}"))
        for surface_class in SurfaceClass
    }


def analyzed_objects(scene: Scene) -> list[Object]:
    """Return the objects of a scene that carry results, each mesh once."""
    found: dict[str, Object] = {}
    for obj in scene.objects:
        if obj.type == "MESH" and obj.data.curvature.fingerprint:
            found.setdefault(obj.data.name_full, obj)
    return list(found.values())


def changed_objects(context: Context, scene: Scene) -> list[Object]:
    """Return the sources whose shape is no longer the one that was analyzed."""
    objects = [obj for obj in analyzed_objects(scene) if obj.mode != "EDIT"]
    return [source_of(obj) for obj in objects if _current_model(context, scene, obj) is None]


def refresh(context: Context, scene: Scene) -> None:
    """Color every analyzed model of a scene as its settings say.

    Models that have changed since their analysis keep the colors that they have.
    """
    quantity = scene.curvature.quantity
    objects = [obj for obj in analyzed_objects(scene) if obj.mode != "EDIT"]
    if quantity in CURVATURES:
        _color_by_curvature(context, scene, objects, quantity)
    elif quantity != "NONE":
        for obj in objects:
            _color_by_class(obj.data, scene.curvature, quantity)
    for obj in objects:
        if quantity != "NONE" and names.COLORS[quantity] in obj.data.color_attributes:
            show_color_attribute(obj.data, names.COLORS[quantity])
        for user in users_of(obj.data):
            material.show(user, scene.curvature.use_material and quantity != "NONE")
        obj.data.update()
    viewport.show_colors(context, quantity != "NONE" and bool(objects))


def write_curvature_colors(mesh: Mesh, analysis: Analysis, settings: PropertyGroup) -> None:
    """Write the colors of Gaussian and mean curvature over the range of this one model."""
    for quantity in ("GAUSSIAN", "MEAN"):
        limit = _common_limit([_Model(mesh, analysis)], quantity, settings.range_percentile)
        _write_colors(_Model(mesh, analysis), quantity, limit, ColorMap[settings.color_map])


def write_class_colors(mesh: Mesh, settings: PropertyGroup) -> None:
    """Write the colors of the classes that the mesh carries."""
    _color_by_class(mesh, settings, "CLASS")


def _current_model(context: Context, scene: Scene, obj: Object) -> _Model | None:
    """Return the analysis of a carrier, None where its source changed in the meantime."""
    written = cache.just_written(obj.data.name_full)
    if written is not None:
        return _Model(obj.data, written)
    # Objects that share a mesh may differ in scale: the results are those of one of them.
    found = (_analysis_of_results(context, scene, user) for user in users_of(obj.data))
    return next((_Model(obj.data, analysis) for analysis in found if analysis is not None), None)


def _analysis_of_results(context: Context, scene: Scene, obj: Object) -> Analysis | None:
    """Return the analysis of a carrier as it is now, None where its results are of another one."""
    results = obj.data.curvature
    try:
        reading = read_object(
            source_of(obj),
            scene,
            context.evaluated_depsgraph_get(),
            settings_of(obj.data),
        )
        if reading.fingerprint != results.fingerprint:
            return None
        return reading.analyzed().analysis
    except CurvatureError:
        return None


def _color_by_curvature(
    context: Context, scene: Scene, objects: list[Object], quantity: str
) -> None:
    settings = scene.curvature
    found = [_current_model(context, scene, obj) for obj in objects]
    models = [model for model in found if model is not None]
    if not models:
        return
    limit = (
        as_typed(settings.range_limit)
        if settings.range_mode == "FIXED"
        else _common_limit(models, quantity, settings.range_percentile)
    )
    for model in models:
        _write_colors(model, quantity, limit, ColorMap[settings.color_map])
    settings.shown_limit = limit
    settings.shown_clipped = clipped_share(*_joined(models, quantity), limit)


def _values(analysis: Analysis, quantity: str) -> Floats:
    curvature = analysis.curvature
    return {
        "GAUSSIAN": curvature.gaussian,
        "MEAN": curvature.mean,
        "K1": curvature.k1,
        "K2": curvature.k2,
    }[quantity]


def _joined(models: list[_Model], quantity: str) -> tuple[Floats, Floats]:
    """Return the values and areas of all models in one."""
    analyses = [model.analysis for model in models]
    return (
        np.concatenate([_values(analysis, quantity) for analysis in analyses]),
        np.concatenate([a.surface.sector_area * a.curvature.is_defined for a in analyses]),
    )


def _common_limit(models: list[_Model], quantity: str, percent: float) -> float:
    values, areas = _joined(models, quantity)
    larger = np.concatenate(
        [
            np.maximum(np.abs(m.analysis.curvature.k1), np.abs(m.analysis.curvature.k2))
            for m in models
        ]
    )
    scale = percentile_limit(larger, areas, percent, 0.0) if larger.any() else 0.0
    return percentile_limit(values, areas, percent, scale**2 if quantity == "GAUSSIAN" else scale)


def _write_colors(model: _Model, quantity: str, limit: float, color_map: ColorMap) -> None:
    """Write colors per vertex, or per corner where creases give a vertex several values."""
    surface = model.analysis.surface
    colors = map_colors(_values(model.analysis, quantity), limit, color_map)
    undefined = class_color_table({})[0]
    colors[~model.analysis.curvature.is_defined] = undefined
    if surface.has_creases:
        domain, rows = "CORNER", colors[surface.corner_sector]
    else:
        domain = "POINT"
        at_vertex = surface.vertex_sector
        rows = np.where((at_vertex >= 0)[:, None], colors[at_vertex], undefined)
    write_attribute(model.mesh, names.COLORS[quantity], domain, "FLOAT_COLOR", rows)


def _color_by_class(mesh: Mesh, settings: PropertyGroup, quantity: str) -> None:
    stored = read_attribute(mesh, names.FACE_CLASS if quantity == "CLASS" else names.REGION)
    if stored is None or len(stored) != len(mesh.polygons):
        return
    if quantity == "CLASS":
        colors = class_color_table(class_colors(settings))[stored + 1]
    else:
        colors = region_colors(stored)
    write_attribute(
        mesh,
        names.COLORS[quantity],
        "CORNER",
        "FLOAT_COLOR",
        np.repeat(colors, polygon_sizes(mesh), axis=0),
    )
