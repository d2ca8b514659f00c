# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects of their own for classes and regions."""

from __future__ import annotations

import bpy
import numpy as np
from bpy.types import Mesh, Object, Scene

from ..geometry.classification import SurfaceClass
from ..geometry.display.palette import CLASS_NAMES
from ..geometry.types import Flags
from . import names
from .attributes import read_attribute
from .collection import discard, link_beside
from .mesh import corner_vertices, polygon_sizes, positions, read_array
from .region_list import region_names
from .subject import source_of


def separate(carrier: Object, scene: Scene, by_region: bool) -> list[Object]:
    """Make an object of the faces of every class or region; the model itself stays.

    Objects of an earlier run are replaced.

    Parameters
    ----------
    carrier : Object
        Carries classes and regions.
    scene : Scene
    by_region : bool
        Whether to make one object per region instead of one per class.

    Returns
    -------
    list of Object
    """
    source = source_of(carrier)
    labels = read_attribute(carrier.data, names.REGION if by_region else names.FACE_CLASS)
    if labels is None:
        return []
    discard_parts(source)
    found = region_names(carrier.data)
    made = []
    for label in np.unique(labels[labels >= 0]).tolist():
        part = found[label] if by_region else CLASS_NAMES[SurfaceClass(label)]
        mesh = _part_of(carrier.data, labels == label, f"{source.name} {part}")
        obj = bpy.data.objects.new(f"{source.name} {part}", mesh)
        obj.curvature.part_of = source
        obj.matrix_world = carrier.matrix_world
        link_beside(source, obj, scene)
        made.append(obj)
    return made


def discard_parts(source: Object) -> bool:
    """Remove the objects that were made of a source's parts; return whether there were any."""
    parts = [each for each in bpy.data.objects if each.curvature.part_of == source]
    return discard(source, parts)


def _part_of(mesh: Mesh, is_wanted: Flags, name: str) -> Mesh:
    """Return a new mesh of some faces of another."""
    sizes = polygon_sizes(mesh)
    corners = corner_vertices(mesh)[np.repeat(is_wanted, sizes)]
    used, compact = np.unique(corners, return_inverse=True)
    starts = np.concatenate([[0], np.cumsum(sizes[is_wanted])[:-1]])
    part = bpy.data.meshes.new(name)
    part.vertices.add(len(used))
    part.loops.add(len(corners))
    part.polygons.add(int(is_wanted.sum()))
    position = positions(mesh)[used]
    part.vertices.foreach_set("co", position.ravel())
    part.loops.foreach_set("vertex_index", compact.reshape(-1).astype(np.int32))
    part.polygons.foreach_set("loop_start", starts.astype(np.int32))
    part.update(calc_edges=True)
    for material in mesh.materials:
        part.materials.append(material)
    indices = read_array(mesh.polygons, "material_index", np.int32)[is_wanted]
    part.polygons.foreach_set("material_index", indices)
    return part
