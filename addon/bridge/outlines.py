# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Borders of regions and parabolic curves as curve objects of Blender."""

from __future__ import annotations

from typing import Any

import bpy
import numpy as np
from bpy.types import Curve, Material, Mesh, Object, Scene

from ..geometry.outlines.polylines import Polylines
from ..geometry.types import Floats
from .collection import link_beside, own_collections, remove_if_empty
from .numbers import as_typed
from .subject import Subject
from .units import meters_per_unit

_ENDINGS = {"BORDERS": "Region Borders", "PARABOLIC": "Parabolic Curves"}

_KEYS = {"BORDERS": "borders", "PARABOLIC": "parabolic_curves"}

#: Scene-linear colors that none of the classes has: near black, and a deep bluish green.
_COLORS = {"BORDERS": (0.012, 0.012, 0.014), "PARABOLIC": (0.0, 0.17, 0.1)}

#: Radius of the lines as a share of the model's diagonal.
_THICKNESS = {"BORDERS": 0.0012, "PARABOLIC": 0.002}


def write_outline(
    subject: Subject, carrier: Object, curves: Polylines, kind: str, scene: Scene
) -> Object:
    """Make an object of curves on a model, in place of the one of an earlier run.

    Parameters
    ----------
    subject : Subject
        The analysis that the curves were traced on.
    carrier : Object
        Shows the surface that the curves lie on.
    curves : Polylines
        In meters, as the analysis has them.
    kind : str
        BORDERS or PARABOLIC.
    scene : Scene

    Returns
    -------
    Object
        Stands where the model stands, turned as it is, but with a scale of 1: lines have the same
        thickness everywhere.
    """
    source = subject.source
    name = f"{source.name} {_ENDINGS[kind]}"
    discard_outlines(source, (kind,))
    data = bpy.data.curves.new(name, "CURVE")
    data.dimensions = "3D"
    diagonal = subject.analysis.surface.mesh.diagonal / meters_per_unit(scene)
    data.bevel_depth = _THICKNESS[kind] * diagonal
    data.bevel_resolution = 1
    data.use_fill_caps = True
    data.materials.append(_material(kind))
    obj = bpy.data.objects.new(name, data)
    obj.curvature.outline_of = source
    obj.curvature.outline = kind
    obj.color = (*_COLORS[kind], 1.0)
    location, rotation, _scale = carrier.matrix_world.decompose()
    obj.location = location
    obj.rotation_mode = "QUATERNION"
    obj.rotation_quaternion = rotation
    turn = np.array(rotation.to_matrix(), dtype=np.float64)
    _add_splines(data, curves, _placed(subject, carrier, curves.points) @ turn)
    link_beside(source, obj, scene)
    return obj


def outlines_of(source: Object) -> list[Object]:
    """Return the objects that show curves on an object."""
    return [each for each in bpy.data.objects if each.curvature.outline_of == source]


def discard_outlines(source: Object, kinds: tuple[str, ...] = tuple(_ENDINGS)) -> bool:
    """Remove the objects that show curves on a source; return whether there were any."""
    found = [each for each in outlines_of(source) if each.curvature.outline in kinds]
    homes = {home for each in found for home in own_collections(each)}
    for obj in found:
        data = obj.data
        bpy.data.objects.remove(obj)
        if not data.users:
            bpy.data.curves.remove(data)
    remove_if_empty(source, list(homes))
    return bool(found)


def write_measures(mesh: Mesh, kind: str, count: int, length: float) -> None:
    """Keep how many curves of a kind were made of a mesh's results, and their length in meters."""
    rows = mesh.curvature.outlines
    row = next((row for row in rows if row.kind == kind), None) or rows.add()
    row.kind, row.curves, row.length = kind, count, length


def outline_blocks(mesh: Mesh) -> dict[str, Any]:
    """Return the measures of the curves made of a mesh's results, as reports have them."""
    return {
        _KEYS[row.kind]: {"count": row.curves, "length": as_typed(row.length)}
        for row in mesh.curvature.outlines
    }


def _placed(subject: Subject, carrier: Object, points: Floats) -> Floats:
    """Return points in meters as offsets from the carrier's origin, in Blender units."""
    in_object = points @ np.linalg.inv(subject.meters_from_object) + subject.center
    return in_object @ np.array(carrier.matrix_world, dtype=np.float64)[:3, :3].T


def _add_splines(data: Curve, curves: Polylines, points: Floats) -> None:
    rows = np.ones((len(points), 4), dtype=np.float32)
    rows[:, :3] = points
    for number in range(curves.count):
        part = rows[curves.start[number] : curves.start[number + 1]]
        spline = data.splines.new("POLY")
        spline.points.add(len(part) - 1)
        spline.points.foreach_set("co", part.ravel())
        spline.use_cyclic_u = bool(curves.is_closed[number])


def _material(kind: str) -> Material:
    name = f"Curvature {_ENDINGS[kind]}"
    material = bpy.data.materials.get(name)
    if material is not None and material.library is None:
        return material
    material = bpy.data.materials.new(name)
    if material.node_tree is None:
        # Blender 5.0 gives every material its nodes and deprecates the switch.
        material.use_nodes = True
    material.diffuse_color = (*_COLORS[kind], 1.0)
    for node in material.node_tree.nodes:
        if node.type == "BSDF_PRINCIPLED":
            node.inputs["Base Color"].default_value = (*_COLORS[kind], 1.0)
            node.inputs["Roughness"].default_value = 0.8
    return material
