# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Classes and regions in the forms that other tools of Blender work with."""

from __future__ import annotations

import numpy as np
from bpy.types import Mesh, Object, PropertyGroup

from ..geometry.classification import SurfaceClass
from ..geometry.display.palette import CLASS_NAMES
from . import names
from .attributes import read_attribute, write_attribute
from .display import class_colors
from .material import plain_material
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
            name = f"Curvature {CLASS_NAMES[kind]}"
            material = plain_material(name, color, is_kept=False)
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
