# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Viewports show the colors as long as a quantity is shown."""

from __future__ import annotations

import bpy
import pytest
from bpy.types import SpaceView3D
from models import STRICT, add_surface, dome


@pytest.fixture
def viewports() -> list[SpaceView3D]:
    """The viewports of the factory window."""
    bpy.ops.wm.read_homefile(use_empty=False, use_factory_startup=True)
    for obj in list(bpy.data.objects):
        bpy.data.objects.remove(obj)
    found = [
        space
        for window in bpy.context.window_manager.windows
        for area in window.screen.areas
        for space in area.spaces
        if isinstance(space, SpaceView3D)
    ]
    assert found
    return found


def test_colors_are_shown_and_the_shading_before_comes_back(viewports: list[SpaceView3D]) -> None:
    add_surface(dome)
    bpy.ops.curvature.segment(**STRICT)
    assert {space.shading.color_type for space in viewports} == {"VERTEX"}
    bpy.ops.curvature.show(quantity="NONE")
    assert {space.shading.color_type for space in viewports} == {"MATERIAL"}


def test_wireframe_becomes_solid(viewports: list[SpaceView3D]) -> None:
    for space in viewports:
        space.shading.type = "WIREFRAME"
    add_surface(dome)
    bpy.ops.curvature.analyze()
    assert {space.shading.type for space in viewports} == {"SOLID"}


def test_clearing_brings_materials_back(viewports: list[SpaceView3D]) -> None:
    add_surface(dome)
    bpy.ops.curvature.segment(**STRICT)
    bpy.ops.curvature.clear()
    assert {space.shading.color_type for space in viewports} == {"MATERIAL"}


def test_other_shading_than_ours_is_left_alone(viewports: list[SpaceView3D]) -> None:
    add_surface(dome)
    bpy.ops.curvature.segment(**STRICT)
    for space in viewports:
        space.shading.color_type = "RANDOM"
    bpy.ops.curvature.show(quantity="NONE")
    assert {space.shading.color_type for space in viewports} == {"RANDOM"}
