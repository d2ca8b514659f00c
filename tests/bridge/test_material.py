# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The curvature material covers an object's own materials, which come back as they were."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import bpy
import pytest
from bpy.types import Material, Object
from models import STRICT, add_object, add_surface, dome, only_select


def _material(name: str) -> Material:
    return bpy.data.materials.new(name)


def _slots(obj: Object) -> list[tuple[str, Material | None]]:
    return [(slot.link, slot.material) for slot in obj.material_slots]


def _no_slot(obj: Object) -> None:
    del obj


def _one_slot(obj: Object) -> None:
    obj.data.materials.append(_material("Glass"))


def _empty_slot(obj: Object) -> None:
    obj.data.materials.append(None)


def _three_slots(obj: Object) -> None:
    for name in ("Glass", "Steel", "Stone"):
        obj.data.materials.append(_material(name))
    for number, polygon in enumerate(obj.data.polygons):
        polygon.material_index = number % 3


def _slot_of_the_object(obj: Object) -> None:
    obj.data.materials.append(_material("Glass"))
    obj.material_slots[0].link = "OBJECT"
    obj.material_slots[0].material = _material("Steel")


def _mixed_slots(obj: Object) -> None:
    _three_slots(obj)
    obj.material_slots[1].link = "OBJECT"
    obj.material_slots[1].material = _material("Brass")


SLOTS = [_no_slot, _one_slot, _empty_slot, _three_slots, _slot_of_the_object, _mixed_slots]


@pytest.fixture(params=SLOTS, ids=lambda give: give.__name__.strip("_"))
def roof(request: pytest.FixtureRequest) -> Object:
    """A segmented dome with some slots."""
    obj = add_surface(dome)
    request.param(obj)
    bpy.ops.curvature.segment(**STRICT)
    return obj


def _cover(is_covered: bool) -> None:
    bpy.context.scene.curvature.use_material = is_covered


def test_own_materials_show_until_the_user_asks(roof: Object) -> None:
    assert "Curvature Colors" not in bpy.data.materials
    assert all(slot.material is None or slot.material.name for slot in roof.material_slots)


def test_every_slot_shows_the_curvature_material(roof: Object) -> None:
    _cover(True)
    assert roof.material_slots
    assert {slot.material.name for slot in roof.material_slots} == {"Curvature Colors"}


def test_materials_of_the_mesh_stay_on_it(roof: Object) -> None:
    before = [material for material in roof.data.materials if material]
    _cover(True)
    assert [material for material in roof.data.materials if material] == before


@pytest.mark.parametrize("way", ["switch", "quantity", "clear"])
def test_slots_come_back_as_they_were(roof: Object, way: str) -> None:
    before, of_mesh = _slots(roof), list(roof.data.materials)
    faces = [polygon.material_index for polygon in roof.data.polygons]
    _cover(True)
    if way == "switch":
        _cover(False)
    elif way == "quantity":
        bpy.ops.curvature.show(quantity="NONE")
    else:
        bpy.ops.curvature.clear()
    assert _slots(roof) == before
    assert list(roof.data.materials) == of_mesh
    assert [polygon.material_index for polygon in roof.data.polygons] == faces


def test_covering_twice_forgets_nothing(roof: Object) -> None:
    before = _slots(roof)
    _cover(True)
    bpy.ops.curvature.segment(**STRICT)
    bpy.ops.curvature.show(quantity="MEAN")
    _cover(False)
    assert _slots(roof) == before


def test_material_shows_the_color_attribute_that_is_rendered() -> None:
    obj = add_surface(dome)
    bpy.ops.curvature.segment(**STRICT)
    _cover(True)
    tree = bpy.data.materials["Curvature Colors"].node_tree
    node = next(node for node in tree.nodes if node.type == "VERTEX_COLOR")
    assert not node.layer_name, "a name would keep it from following the quantity"
    assert node.outputs["Color"].links[0].to_socket.name == "Base Color"
    for quantity, name in (("CLASS", "Curvature Class"), ("GAUSSIAN", "Gaussian Curvature")):
        bpy.ops.curvature.show(quantity=quantity)
        colors = obj.data.color_attributes
        assert colors[colors.render_color_index].name == name
        assert colors.active_color_name == name


def test_all_models_share_one_material() -> None:
    for name in ("A", "B"):
        add_surface(dome, name)
    bpy.ops.curvature.segment(**STRICT)
    _cover(True)
    assert [material.name for material in bpy.data.materials] == ["Curvature Colors"]


@pytest.mark.parametrize("give", SLOTS, ids=lambda give: give.__name__.strip("_"))
def test_every_object_that_shares_a_mesh_is_covered_and_uncovered(give: Callable[..., Any]) -> None:
    one = add_surface(dome, "One")
    give(one)
    two = add_object("Two", one.data)
    only_select(one, two)
    bpy.ops.curvature.segment(**STRICT)
    before = _slots(one), _slots(two)
    _cover(True)
    for obj in (one, two):
        assert {slot.material.name for slot in obj.material_slots} == {"Curvature Colors"}
    _cover(False)
    assert (_slots(one), _slots(two)) == before
