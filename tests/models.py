# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Blender objects that tests analyze, and what is stored on them, read without the extension."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from typing import Any

import bpy
import numpy as np
from bpy.types import Mesh, Object
from numpy.typing import NDArray

Array = NDArray[np.float64]
Height = Callable[[Array, Array], Array]

RADIUS = 2.0
"""Radius in Blender units of the curved models below; they are 2 units wide."""

STRICT = {"panel_size": 1.0, "deviation": 0.01}
"""A tolerance at which RADIUS counts as curved: the limit is 0.08/m, a radius of 12.5 m."""

_FIELD = {"FLOAT": "value", "INT": "value", "FLOAT_VECTOR": "vector", "FLOAT_COLOR": "color"}
_WIDTH = {"FLOAT": 1, "INT": 1, "FLOAT_VECTOR": 3, "FLOAT_COLOR": 4}


def plate(x: Array, y: Array) -> Array:
    """A flat roof."""
    del y
    return np.zeros_like(x)


def barrel(x: Array, y: Array) -> Array:
    """A cylinder of RADIUS along y: k1 = 1/RADIUS and k2 = 0 with normals up."""
    del y
    return np.sqrt(RADIUS**2 - x**2)


def dome(x: Array, y: Array) -> Array:
    """A sphere of RADIUS: k1 = k2 = 1/RADIUS with normals up."""
    return np.sqrt(RADIUS**2 - x**2 - y**2)


def saddle(x: Array, y: Array) -> Array:
    """A hyperbolic paraboloid with k1 = 1/RADIUS = -k2 in its middle."""
    return (x**2 - y**2) / (2.0 * RADIUS)


def add_object(name: str, mesh: Mesh) -> Object:
    """Link an object to the scene, select it besides others and make it active."""
    obj = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(obj)
    obj.select_set(True)
    bpy.context.view_layer.objects.active = obj
    return obj


def add_mesh(
    name: str, vertices: Sequence[Sequence[float]] | Array, faces: Sequence[Sequence[int]]
) -> Object:
    """Add an object with a mesh of polygons."""
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(
        np.asarray(vertices, dtype=float).reshape(-1, 3).tolist(),
        [],
        [[int(vertex) for vertex in face] for face in faces],
    )
    return add_object(name, mesh)


def grid(height: Height, steps: int = 16) -> tuple[Array, NDArray[np.int64]]:
    """Return vertices and quads of a height over the square from -1 to 1, normals up."""
    line = np.linspace(-1.0, 1.0, steps + 1)
    x, y = (values.ravel() for values in np.meshgrid(line, line))
    corner = np.arange((steps + 1) ** 2).reshape(steps + 1, steps + 1)[:-1, :-1].ravel()
    faces = corner[:, None] + np.array([0, 1, steps + 2, steps + 1])
    return np.column_stack([x, y, height(x, y)]), faces


def add_surface(height: Height, name: str = "Roof", steps: int = 16) -> Object:
    """Add an object with a grid of quads at a height."""
    return add_mesh(name, *grid(height, steps))


def add_folded_roof(name: str = "Fold") -> Object:
    """Add two flat sides that meet at a right angle along the y axis, 8 x 8 quads each."""
    return add_surface(lambda x, _y: -np.abs(x), name)


def only_select(*objects: Object) -> None:
    """Select these objects and no others; the last becomes active."""
    # Without the update, Blender 4.2 and 4.5 crash where a collection was excluded just before.
    bpy.context.view_layer.update()
    for obj in list(bpy.context.view_layer.objects):
        obj.select_set(obj in objects)
    bpy.context.view_layer.objects.active = objects[-1] if objects else None


def stored(obj: Object, name: str) -> NDArray:
    """Return an attribute's values; fails where the attribute is missing."""
    attribute = obj.data.attributes[name]
    width = _WIDTH[attribute.data_type]
    dtype = np.int32 if attribute.data_type == "INT" else np.float32
    values = np.empty(len(attribute.data) * width, dtype=dtype)
    attribute.data.foreach_get(_FIELD[attribute.data_type], values)
    return values if width == 1 else values.reshape(-1, width)


def own_attributes(obj: Object) -> dict[str, tuple[str, str]]:
    """Return domain and type of every attribute of ours, by name."""
    return {
        attribute.name: (attribute.domain, attribute.data_type)
        for attribute in obj.data.attributes
        if "curvature" in attribute.name.lower()
    }


def inner_vertices(obj: Object, margin: float = 0.7) -> NDArray[np.bool_]:
    """Return which vertices of a grid lie well inside its rim."""
    position = np.array([vertex.co for vertex in obj.data.vertices])
    return np.abs(position[:, :2]).max(axis=1) < margin


def deselect_all(obj: Object) -> None:
    """Deselect the vertices, edges and faces of an object in Object Mode."""
    # Blender 5.0 crashes where edges that are all selected are deselected by its own setter.
    for name in (".select_vert", ".select_edge", ".select_poly"):
        if name in obj.data.attributes:
            obj.data.attributes.remove(obj.data.attributes[name])


RING, TUBE = 2.0, 0.8
"""Radii in Blender units of the torus below."""


def add_torus(name: str = "Ring", around: int = 72, across: int = 32) -> Object:
    """Add a closed torus of quads around the z axis, normals outward."""
    u, v = (
        values.ravel()
        for values in np.meshgrid(
            np.linspace(0.0, 2.0 * np.pi, around, endpoint=False),
            np.linspace(0.0, 2.0 * np.pi, across, endpoint=False),
            indexing="ij",
        )
    )
    radius = RING + TUBE * np.cos(v)
    vertices = np.stack([radius * np.cos(u), radius * np.sin(u), TUBE * np.sin(v)], axis=1)
    i, j = (number.ravel() for number in np.indices((around, across)))
    k, m = (i + 1) % around, (j + 1) % across
    faces = np.stack([i * across + j, k * across + j, k * across + m, i * across + m], axis=1)
    return add_mesh(name, vertices, faces)


def world_points(curve: Object) -> Array:
    """Return the points of all splines of a curve object in the world, (p, 3)."""
    world = np.array(curve.matrix_world)
    points = np.array([point.co[:3] for spline in curve.data.splines for point in spline.points])
    return points @ world[:3, :3].T + world[:3, 3]


def report_of(obj: Object) -> dict[str, Any]:
    """Return what was reported of an object."""
    return json.loads(obj.data.curvature.report)
