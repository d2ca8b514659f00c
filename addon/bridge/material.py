# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The materials of our own: plain ones, and the one that shows the color attribute in renders."""

from __future__ import annotations

import bpy
from bpy.types import Material, Object

_NAME = "Curvature Colors"
_ROUGHNESS = 0.8

Color = tuple[float, float, float]
"""Scene-linear red, green and blue."""


def plain_material(name: str, color: Color, is_kept: bool = True) -> Material:
    """Return a material of one color, made where it is missing.

    Parameters
    ----------
    name : str
    color : Color
    is_kept : bool
        Whether a material that is there stays as it is: users may have changed it.

    Returns
    -------
    Material
    """
    found = _own_material(name)
    if found is not None and is_kept:
        return found
    material = found or _new_material(name)
    material.diffuse_color = (*color, 1.0)
    for node in material.node_tree.nodes:
        if node.type == "BSDF_PRINCIPLED":
            node.inputs["Base Color"].default_value = (*color, 1.0)
            node.inputs["Roughness"].default_value = _ROUGHNESS
    return material


def show(obj: Object, is_shown: bool) -> None:
    """Give every slot of an object the curvature material, or bring back what was there.

    The slots are changed on the object, not on its mesh, whose materials stay what they were.

    Parameters
    ----------
    obj : Object
    is_shown : bool
    """
    if is_shown == obj.curvature.has_material:
        return
    if is_shown:
        _cover(obj)
    else:
        _uncover(obj)
    obj.curvature.has_material = is_shown


def _cover(obj: Object) -> None:
    material = _curvature_material()
    obj.curvature.slots.clear()
    for slot in obj.material_slots:
        kept = obj.curvature.slots.add()
        kept.link = slot.link
        if slot.link == "OBJECT":
            kept.material = slot.material
    if not obj.material_slots:
        # An object has as many slots as its mesh has materials: an empty one makes room.
        obj.data.materials.append(None)
    for slot in obj.material_slots:
        slot.link = "OBJECT"
        slot.material = material


def _uncover(obj: Object) -> None:
    for slot, kept in zip(obj.material_slots, obj.curvature.slots, strict=False):
        slot.material = kept.material
        slot.link = kept.link
    if not obj.curvature.slots and len(obj.data.materials) == 1:
        obj.material_slots[0].material = None
        obj.data.materials.clear()
    obj.curvature.slots.clear()


def _curvature_material() -> Material:
    found = _own_material(_NAME)
    if found is not None:
        return found
    material = _new_material(_NAME)
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    output = nodes.new("ShaderNodeOutputMaterial")
    shader = nodes.new("ShaderNodeBsdfPrincipled")
    color = nodes.new("ShaderNodeVertexColor")
    # Without a name the node takes the color attribute that is set to be rendered.
    color.layer_name = ""
    shader.inputs["Roughness"].default_value = _ROUGHNESS
    for node, x in ((color, -220.0), (shader, 0.0), (output, 300.0)):
        node.location.x = x
    links.new(color.outputs["Color"], shader.inputs["Base Color"])
    links.new(shader.outputs["BSDF"], output.inputs["Surface"])
    return material


def _own_material(name: str) -> Material | None:
    material = bpy.data.materials.get(name)
    return None if material is None or material.library is not None else material


def _new_material(name: str) -> Material:
    material = bpy.data.materials.new(name)
    if material.node_tree is None:
        # Blender 5.0 gives every material its nodes and deprecates the switch.
        material.use_nodes = True
    return material
