# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What cannot be analyzed is refused in words, and nothing is changed by the attempt."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import bpy
import numpy as np
import pytest
from bpy.types import Object
from models import STRICT, add_mesh, add_surface, dome, grid, own_attributes, stored


def _empty() -> Object:
    return add_mesh("Bad", [], [])


def _points() -> Object:
    return add_mesh("Bad", [(0, 0, 0), (1, 0, 0), (0, 1, 0)], [])


def _edges() -> Object:
    mesh = bpy.data.meshes.new("Bad")
    mesh.from_pydata([(0, 0, 0), (1, 0, 0)], [(0, 1)], [])
    obj = bpy.data.objects.new("Bad", mesh)
    bpy.context.scene.collection.objects.link(obj)
    obj.select_set(True)
    bpy.context.view_layer.objects.active = obj
    return obj


def _with_coordinate(value: float) -> Object:
    vertices, faces = grid(dome)
    vertices[0, 2] = vertices[5, 0] = value
    return add_mesh("Bad", vertices, faces)


def _flattened() -> Object:
    obj = add_surface(dome, "Bad")
    obj.scale = (0.0, 1.0, 1.0)
    bpy.context.view_layer.update()
    return obj


def _one_place() -> Object:
    return add_mesh("Bad", [(1, 1, 1)] * 4, [(0, 1, 2, 3)])


BAD = {
    "the mesh is empty": _empty,
    "the mesh has no faces: add faces": _points,
    "the mesh has no faces": _edges,
    "2 of 289 vertices have coordinates that are not finite": lambda: _with_coordinate(np.nan),
    "coordinates that are not finite": lambda: _with_coordinate(np.inf),
    "the scale of the object is zero": _flattened,
}


def _everything() -> dict[str, object]:
    """What a run that refuses must leave as it was."""
    scene = bpy.context.scene
    return {
        "objects": {
            obj.name: (obj.data, obj.hide_get(), obj.select_get(), own_attributes(obj))
            for obj in bpy.data.objects
        },
        "data": [len(kind) for kind in (bpy.data.meshes, bpy.data.collections, bpy.data.materials)],
        "reports": {mesh.name: mesh.curvature.report for mesh in bpy.data.meshes},
        "quantity": scene.curvature.quantity,
        "active": bpy.context.view_layer.objects.active,
        "mode": bpy.context.mode,
    }


@pytest.mark.parametrize("operator", ["analyze", "segment"])
@pytest.mark.parametrize("words", BAD)
def test_bad_mesh_is_refused_in_words_and_nothing_changes(
    words: str, operator: str, run: Callable[..., Any]
) -> None:
    BAD[words]()
    before = _everything()
    result, message = run(operator)
    assert result == {"CANCELLED"}
    assert message.startswith("Error: Bad: ")
    assert words in message
    assert _everything() == before


@pytest.mark.parametrize("words", BAD)
def test_refused_object_does_not_stop_the_others(words: str, run: Callable[..., Any]) -> None:
    sound = [add_surface(dome, "Before")]
    BAD[words]()
    sound.append(add_surface(dome, "Later"))
    result, message = run("segment", **STRICT)
    assert result == {"FINISHED"}
    assert message.startswith("Warning: Segmented 2 models; Bad: ")
    assert words in message
    for obj in sound:
        assert (stored(obj, "curvature_class") == 2).all()
    assert not bpy.data.objects["Bad"].data.curvature.fingerprint


def test_earlier_results_survive_a_refusal(run: Callable[..., Any]) -> None:
    obj = add_surface(dome)
    bpy.ops.curvature.segment(**STRICT)
    obj.data.vertices[0].co.x = np.nan
    before = _everything()
    assert run("segment")[0] == {"CANCELLED"}
    assert _everything() == before


def test_faces_without_area_make_no_crash_and_no_class(run: Callable[..., Any]) -> None:
    obj = _one_place()
    before = own_attributes(obj)
    result, message = run("segment", **STRICT)
    assert result in ({"FINISHED"}, {"CANCELLED"})
    if result == {"CANCELLED"}:
        assert own_attributes(obj) == before
        assert message.startswith("Error: Bad: ")
    else:
        assert stored(obj, "curvature_class").tolist() == [-1]


def test_unsound_parts_are_counted_and_the_rest_is_classified(run: Callable[..., Any]) -> None:
    """A dome with a repeated face, an inner face, a vertex without faces and a lone edge."""
    vertices, faces = grid(dome)
    faces = [tuple(face) for face in faces]
    inner = (faces[100][0], faces[100][1], len(vertices))
    vertices = np.vstack([vertices, [[0.0, 0.0, 0.0]], [[5.0, 5.0, 5.0]]])
    add_mesh("Roof", vertices, [*faces, faces[0], inner])
    result, message = run("segment", **STRICT)
    assert result == {"FINISHED"}
    assert message.startswith("Warning: Segmented Roof")
    texts = [warning.text for warning in bpy.context.object.data.curvature.warnings]
    assert any(text.startswith("1 face repeats") for text in texts)
    assert any("more than two faces" in text for text in texts)
    assert any(text.startswith("1 vertex has no faces") for text in texts)
    classes = stored(bpy.context.object, "curvature_class")[: len(faces)]
    assert (classes == 2).mean() > 0.9


def test_faces_wound_both_ways_are_warned_of(run: Callable[..., Any]) -> None:
    vertices, faces = grid(dome)
    faces = [face[::-1] if number % 16 < 8 else face for number, face in enumerate(faces)]
    obj = add_mesh("Roof", vertices, faces)
    assert run("segment", **STRICT)[0] == {"FINISHED"}
    assert any("opposite sides" in warning.text for warning in obj.data.curvature.warnings)
    # The dome is a dome from either side.
    assert (stored(obj, "curvature_class") == 2).all()


def test_result_is_reported_in_numbers(run: Callable[..., Any]) -> None:
    add_surface(dome)
    result, message = run("segment", **STRICT)
    assert result == {"FINISHED"}
    assert message == "Info: Segmented Roof: double-curved dome 100.0 %"
