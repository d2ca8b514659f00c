# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Hatching makes strokes where it is dark, or where the surface bends."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import bpy
import numpy as np
from bpy.types import Object
from mathutils import Euler
from models import add_surface, only_select, plate, saddle


def _strokes() -> tuple[np.ndarray, list[np.ndarray]]:
    """Return all points of the strokes in the world, and their radii stroke by stroke."""
    obj: Object = bpy.data.objects["Roof Hatching"]
    world = np.array(obj.matrix_world)
    points = np.array([point.co[:3] for spline in obj.data.splines for point in spline.points])
    radii = [np.array([point.radius for point in spline.points]) for spline in obj.data.splines]
    return points @ world[:3, :3].T + world[:3, 3], radii


def test_strokes_are_tapered_and_lie_on_the_model(run: Callable[..., Any]) -> None:
    add_surface(saddle, steps=32)
    result, text = run("hatch", tone="CURVATURE", spacing=0.08)
    assert result == {"FINISHED"}
    points, radii = _strokes()
    assert text == f"Info: Hatched Roof: {len(radii):,} strokes"
    assert len(radii) > 10
    assert max(each[0] for each in radii) < 0.3 < max(each.max() for each in radii) <= 1.0
    exact = saddle(points[:, 0], points[:, 1])
    assert np.abs(points[:, 2] - exact).max() < 0.005
    assert len(bpy.data.objects["Roof Hatching"].data.materials) == 1


def test_the_side_away_from_the_light_is_darker() -> None:
    obj = add_surface(saddle, steps=32)
    # In the world the light comes from the right, whatever the model's own axes.
    obj.rotation_euler = Euler((0.0, 0.0, 1.0))
    bpy.context.view_layer.update()
    bpy.ops.curvature.hatch(tone="SHADE", spacing=0.08, light=(1.0, 0.0, 0.4))
    right = _strokes()[0]
    bpy.ops.curvature.hatch(tone="SHADE", spacing=0.08, light=(-1.0, 0.0, 0.4))
    left = _strokes()[0]
    assert abs(np.median(right[:, 0]) + np.median(left[:, 0])) < 0.2
    assert len([obj for obj in bpy.data.objects if "Hatching" in obj.name]) == 1


def test_scene_remembers_the_settings() -> None:
    add_surface(saddle)
    settings = bpy.context.scene.curvature
    settings.hatch_tone = "CURVATURE"
    settings.hatch_spacing = 0.2
    bpy.ops.curvature.hatch()
    coarse = len(_strokes()[1])
    settings.hatch_spacing = 0.1
    bpy.ops.curvature.hatch()
    assert len(_strokes()[1]) > coarse


def test_a_model_without_strokes_is_told_why(run: Callable[..., Any]) -> None:
    add_surface(plate)
    result, text = run("hatch")
    assert (result, text.split(";")[0]) == ({"FINISHED"}, "Warning: Hatched Roof: 0 strokes")
    assert "is flat or spherical everywhere" in text
    assert len(bpy.data.objects) == 1
    only_select(add_surface(saddle, "Roof Two"))
    result, text = run("hatch", light=(0.0, 0.0, 1.0), spacing=0.1)
    assert "Roof Two lies in the light" in text
    result, text = run("hatch", light=(0.0, 0.0, -1.0), spacing=100.0)
    assert "Roof Two has no room for lines 100 m apart" in text
