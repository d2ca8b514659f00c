# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Segmenting again after a change shows what changed."""

from __future__ import annotations

import importlib
import json

import bpy
import pytest
from bpy.types import Object
from models import STRICT, add_surface, dome


@pytest.fixture
def roof() -> Object:
    obj = add_surface(dome)
    bpy.ops.curvature.segment(**STRICT)
    return obj


def _comparison(obj: Object) -> dict[str, dict[str, float]] | None:
    return json.loads(obj.data.curvature.report).get("comparison")


def _flatten(obj: Object) -> None:
    for vertex in obj.data.vertices:
        vertex.co.z = 0.0
    obj.data.update()


def test_the_first_segmentation_has_nothing_to_compare(roof: Object) -> None:
    assert _comparison(roof) is None


def test_the_same_model_has_not_changed(roof: Object) -> None:
    bpy.ops.curvature.segment(**STRICT)
    assert _comparison(roof) is None


def test_a_flattened_dome_turns_from_double_curved_to_flat(roof: Object) -> None:
    before = json.loads(roof.data.curvature.report)["classes"]["double_curved_elliptic"]["area"]
    _flatten(roof)
    bpy.ops.curvature.segment(**STRICT)
    area = sum(face.area for face in roof.data.polygons)
    changes = _comparison(roof)
    assert changes is not None
    assert changes["flat"] == {"before": pytest.approx(0.0), "after": pytest.approx(area)}
    assert changes["double_curved_elliptic"]["before"] == pytest.approx(before)
    assert changes["double_curved_elliptic"]["after"] == 0.0


def test_analyzing_in_between_does_not_forget_what_was_before(roof: Object) -> None:
    _flatten(roof)
    bpy.ops.curvature.analyze()
    bpy.ops.curvature.segment(**STRICT)
    assert _comparison(roof) is not None


def test_a_change_of_tolerance_is_a_change(roof: Object) -> None:
    bpy.ops.curvature.segment(panel_size=1.0, deviation=1.0)
    changes = _comparison(roof)
    assert changes is not None
    assert changes["flat"]["after"] > changes["flat"]["before"]


def test_the_panel_appears_with_the_first_change(roof: Object, extension: str) -> None:
    panel = importlib.import_module(f"{extension}.addon.panels.changes").CURVATURE_PT_changes
    assert not panel.poll(bpy.context)
    _flatten(roof)
    bpy.ops.curvature.segment(**STRICT)
    assert panel.poll(bpy.context)


def test_clear_forgets(roof: Object) -> None:
    _flatten(roof)
    bpy.ops.curvature.segment(**STRICT)
    bpy.ops.curvature.clear()
    bpy.ops.curvature.segment(**STRICT)
    assert _comparison(roof) is None
