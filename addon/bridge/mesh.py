# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Blender's meshes as arrays."""

from __future__ import annotations

from typing import Any

import numpy as np
from bpy.types import Mesh, bpy_prop_collection

from ..geometry.errors import InvalidMeshError
from ..geometry.mesh import PolygonMesh
from ..geometry.types import AnyArray, Floats


def read_array(
    collection: bpy_prop_collection[Any], name: str, dtype: type, width: int = 1
) -> AnyArray:
    """Return one property of every item of a Blender collection.

    Returns
    -------
    (n,) or (n, width) array
    """
    values = np.empty(len(collection) * width, dtype=dtype)
    collection.foreach_get(name, values)
    return values if width == 1 else values.reshape(-1, width)


def read_polygon_mesh(mesh: Mesh, meters_from_mesh: Floats) -> PolygonMesh:
    """Read a mesh with positions in meters.

    Parameters
    ----------
    mesh : Mesh
        Not in Edit Mode, where Blender hides its data.
    meters_from_mesh : (3, 3) float64
        Applied to the coordinates after they were centered.

    Returns
    -------
    PolygonMesh

    Raises
    ------
    InvalidMeshError
        If the mesh has no faces or coordinates that are not finite.
    """
    stored = read_array(mesh.vertices, "co", np.float32, 3)
    if not len(stored):
        raise InvalidMeshError("the mesh is empty: add faces, or choose another object")
    if not len(mesh.polygons):
        raise InvalidMeshError("the mesh has no faces: add faces, or choose another object")
    position = stored.astype(np.float64)
    resolution = 0.0
    if np.isfinite(stored).all():
        # Meshes with coordinates that are not finite go on to be refused with a count; Blender
        # must not triangulate them before.
        middle = 0.5 * (position.min(axis=0) + position.max(axis=0))
        position = (position - middle) @ meters_from_mesh
        resolution = float(np.spacing(np.abs(stored).max()))
        mesh.calc_loop_triangles()
    return PolygonMesh(
        vertices=position,
        corner_vertex=read_array(mesh.loops, "vertex_index", np.int32).astype(np.int64),
        polygon_start=np.append(
            read_array(mesh.polygons, "loop_start", np.int32), len(mesh.loops)
        ).astype(np.int64),
        corner_edge=read_array(mesh.loops, "edge_index", np.int32).astype(np.int64),
        edge_is_sharp=read_array(mesh.edges, "use_edge_sharp", np.bool_),
        triangle_corner=read_array(mesh.loop_triangles, "loops", np.int32, 3).astype(np.int64),
        triangle_polygon=read_array(mesh.loop_triangles, "polygon_index", np.int32).astype(
            np.int64
        ),
        resolution=resolution * float(np.linalg.norm(meters_from_mesh, 2)),
    )
