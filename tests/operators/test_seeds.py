# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Single lines run through the 3D cursor or selected vertices."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import bpy
import numpy as np
import pytest
from models import RING, TUBE, add_surface, add_torus, deselect_all, dome, world_points


def test_lines_run_through_the_cursor() -> None:
    add_torus()
    bpy.context.scene.cursor.location = (RING + TUBE + 0.3, 0.0, 0.0)
    bpy.ops.curvature.trace_through()
    for number in (1, 2):
        curve = bpy.data.objects[f"Ring Picked Lines {number}"]
        assert len(curve.data.splines) == 1
        assert curve.data.splines[0].use_cyclic_u
        near = np.linalg.norm(world_points(curve) - (RING + TUBE, 0.0, 0.0), axis=1)
        assert near.min() < 0.1
    bpy.context.scene.cursor.location = (0.0, -5.0, 0.1)
    bpy.ops.curvature.trace_through()
    assert len(bpy.data.objects["Ring Picked Lines 1"].data.splines) == 2


@pytest.mark.parametrize("mode", ["OBJECT", "EDIT"])
def test_lines_run_through_selected_vertices(mode: str, run: Callable[..., Any]) -> None:
    obj = add_torus()
    deselect_all(obj)
    assert run("trace_through", points="VERTICES") == (
        {"CANCELLED"},
        "Error: Ring: no vertices are selected: select some in Edit Mode",
    )
    for number in (3, 500):
        obj.data.vertices[number].select = True
    if mode == "EDIT":
        bpy.ops.object.mode_set(mode="EDIT")
    result, _ = run("trace_through", points="VERTICES", families="FIRST")
    assert result == {"FINISHED"}
    assert obj.mode == mode
    assert "Ring Picked Lines 2" not in bpy.data.objects
    points = world_points(bpy.data.objects["Ring Picked Lines 1"])
    for number in (3, 500):
        place = np.array(obj.data.vertices[number].co)
        assert np.linalg.norm(points - place, axis=1).min() < 0.02


@pytest.mark.parametrize(
    ("kind", "where"),
    [("ASYMPTOTIC", "saddles only"), ("PRINCIPAL", "curved parts only, not spherical")],
)
def test_where_no_lines_run_is_told(kind: str, where: str, run: Callable[..., Any]) -> None:
    add_surface(dome)
    assert run("trace_through", kind=kind) == (
        {"CANCELLED"},
        f"Error: Roof: no lines run through these points: there are some in {where}",
    )


def test_asymptotic_lines_do_not_run_outside_of_saddles(run: Callable[..., Any]) -> None:
    add_torus()
    bpy.context.scene.cursor.location = (RING + TUBE, 0.0, 0.0)
    result, text = run("trace_through", kind="ASYMPTOTIC")
    assert result == {"CANCELLED"}
    assert text.endswith("in saddles only")
    bpy.context.scene.cursor.location = (RING - TUBE, 0.0, 0.0)
    assert run("trace_through", kind="ASYMPTOTIC")[0] == {"FINISHED"}
