# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Classes and regions in the forms that other tools of Blender work with."""

from __future__ import annotations

import bpy
import numpy as np
from bpy.types import Material, Mesh, Object, PropertyGroup

from ..geometry.classification import SurfaceClass
from ..geometry.display.palette import CLASS_NAMES
from . import names
from .attributes import read_attribute, write_attribute
from .display import class_colors
from .mesh import corner_vertices, polygon_sizes

_FACE_SETS = ".sculpt_face_set"


def write_materials(obj: Object, settings: PropertyGroup) -> None:
    """Give every class of faces a material slot with the color of the class.

    Slots of an earlier run are used again; other slots of the mesh stay, without faces.
    """
    mesh = obj.data
    classes = _read(mesh, names.FACE_CLASS)
    slots = np.zeros(len(SurfaceClass), dtype=np.int32)
    for kind, color in class_colors(settings).items():
        if (classes == kind).any():
            material = _class_material(kind, color)
            if material.name not in mesh.materials:
                mesh.materials.append(material)
            slots[kind + 1] = mesh.materials.find(material.name)
    mesh.polygons.foreach_set("material_index", slots[classes + 1])
    mesh.update()


def write_face_sets(obj: Object) -> None:
    """Make every region a face set of Sculpt Mode; faces without a region get one of their own."""
    regions = _read(obj.data, names.REGION)
    # Sculpt Mode counts face sets from 1.
    write_attribute(obj.data, _FACE_SETS, "FACE", "INT", regions + 2)
    obj.data.update()


def write_vertex_groups(obj: Object) -> None:
    """Make a vertex group of the vertices of every class, with weights of 1."""
    mesh = obj.data
    classes = _read(mesh, names.FACE_CLASS)
    at_corner = np.repeat(classes, polygon_sizes(mesh))
    vertices = corner_vertices(mesh)
    for kind, name in CLASS_NAMES.items():
        group = obj.vertex_groups.get(name)
        if group is not None:
            obj.vertex_groups.remove(group)
        members = np.unique(vertices[at_corner == kind])
        if len(members):
            obj.vertex_groups.new(name=name).add(members.tolist(), 1.0, "REPLACE")


def _read(mesh: Mesh, name: str) -> np.ndarray:
    values = read_attribute(mesh, name)
    return np.full(len(mesh.polygons), -1) if values is None else values


def _class_material(kind: SurfaceClass, color: tuple[float, float, float]) -> Material:
    name = f"Curvature {CLASS_NAMES[kind]}"
    material = bpy.data.materials.get(name)
    if material is None or material.library is not None:
        material = bpy.data.materials.new(name)
    if material.node_tree is None:
        # Blender 5.0 gives every material its nodes and deprecates the switch.
        material.use_nodes = True
    material.diffuse_color = (*color, 1.0)
    for node in material.node_tree.nodes:
        if node.type == "BSDF_PRINCIPLED":
            node.inputs["Base Color"].default_value = (*color, 1.0)
    return material
