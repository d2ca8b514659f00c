# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Umbilics as points of a mesh, shown as little balls."""

from __future__ import annotations

import bpy
import numpy as np
from bpy.types import Node, NodeTree, Object, Scene

from ..geometry.lines.umbilics import Umbilics
from . import names
from .attributes import read_attribute, write_attribute
from .companions import (
    ROLES,
    add_companion,
    companion_name,
    companion_points,
    discard_companions,
)
from .material import plain_material
from .subject import Subject
from .units import meters_per_unit

SIGN_COLORS = {"Positive": ROLES["UMBILICS"].color, "Negative": (0.0, 0.30, 0.33)}
"""Colors by the sign of the index, which color-blind eyes tell apart too."""

_NODES = "Curvature Umbilics"
_RADIUS = "umbilic_radius"


def write_umbilics(
    subject: Subject, carrier: Object, umbilics: Umbilics, radius: float, scene: Scene
) -> Object:
    """Make a mesh of the umbilic points, in place of the one of an earlier run.

    Parameters
    ----------
    subject : Subject
    carrier : Object
    umbilics : Umbilics
    radius : float
        Of the balls that mark the points, in meters.
    scene : Scene

    Returns
    -------
    Object
    """
    discard_companions(subject.source, ("UMBILICS",))
    mesh = bpy.data.meshes.new(companion_name(subject.source, "UMBILICS"))
    obj = add_companion(subject.source, carrier, mesh, "UMBILICS", scene)
    obj.curvature.fingerprint = subject.fingerprint
    mesh.vertices.add(umbilics.count)
    place = companion_points(subject, obj, umbilics.position).astype(np.float32)
    mesh.vertices.foreach_set("co", place.ravel())
    write_attribute(mesh, names.UMBILIC_INDEX, "POINT", "FLOAT", umbilics.index)
    write_attribute(mesh, names.UMBILIC_KIND, "POINT", "INT", umbilics.kind)
    size = np.full(umbilics.count, radius / meters_per_unit(scene))
    write_attribute(mesh, _RADIUS, "POINT", "FLOAT", size)
    mesh.update()
    obj.modifiers.new("Markers", "NODES").node_group = _marker_nodes()
    return obj


def umbilic_signs(obj: Object) -> dict[str, int]:
    """Return how many umbilics of an object have an index of each sign."""
    index = read_attribute(obj.data, names.UMBILIC_INDEX)
    if index is None:
        return dict.fromkeys(SIGN_COLORS, 0)
    return {"Positive": int((index > 0.0).sum()), "Negative": int((index < 0.0).sum())}


def _marker_nodes() -> NodeTree:
    """Return the nodes that put a ball on every point, in a color by the sign of its index."""
    found = bpy.data.node_groups.get(_NODES)
    if found is not None and found.library is None:
        return found
    tree = bpy.data.node_groups.new(_NODES, "GeometryNodeTree")
    tree.is_modifier = True
    for side in ("INPUT", "OUTPUT"):
        tree.interface.new_socket("Geometry", in_out=side, socket_type="NodeSocketGeometry")
    start, end = _node(tree, "NodeGroupInput", -700.0), _node(tree, "NodeGroupOutput", 700.0)
    index = _named(tree, names.UMBILIC_INDEX, -700.0)
    radius = _named(tree, _RADIUS, -500.0)
    join = _node(tree, "GeometryNodeJoinGeometry", 500.0)
    for sign, color in SIGN_COLORS.items():
        compare = _node(tree, "FunctionNodeCompare", -300.0)
        compare.operation = "GREATER_THAN" if sign == "Positive" else "LESS_THAN"
        ball = _node(tree, "GeometryNodeMeshIcoSphere", -300.0)
        ball.inputs["Radius"].default_value = 1.0
        ball.inputs["Subdivisions"].default_value = 3
        paint = _node(tree, "GeometryNodeSetMaterial", -100.0)
        paint.inputs["Material"].default_value = plain_material(f"Curvature Umbilics {sign}", color)
        place = _node(tree, "GeometryNodeInstanceOnPoints", 200.0)
        link = tree.links.new
        link(index.outputs["Attribute"], compare.inputs[0])
        link(ball.outputs["Mesh"], paint.inputs["Geometry"])
        link(start.outputs["Geometry"], place.inputs["Points"])
        link(compare.outputs["Result"], place.inputs["Selection"])
        link(paint.outputs["Geometry"], place.inputs["Instance"])
        link(radius.outputs["Attribute"], place.inputs["Scale"])
        link(place.outputs["Instances"], join.inputs["Geometry"])
    tree.links.new(join.outputs["Geometry"], end.inputs["Geometry"])
    return tree


def _node(tree: NodeTree, kind: str, left: float) -> Node:
    node = tree.nodes.new(kind)
    node.location.x = left
    return node


def _named(tree: NodeTree, name: str, left: float) -> Node:
    node = _node(tree, "GeometryNodeInputNamedAttribute", left)
    node.data_type = "FLOAT"
    node.inputs["Name"].default_value = name
    return node
