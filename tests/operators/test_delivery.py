# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Classes reach other tools as materials, groups, face sets and objects, and leave by clear."""

from __future__ import annotations

import bpy
import numpy as np
import pytest
from bpy.types import Object
from models import STRICT, add_folded_roof, add_surface, barrel, stored


@pytest.fixture
def mixed() -> Object:
    """A roof of barrel and plate, segmented: two classes at least."""
    obj = add_surface(lambda x, y: np.where(x > 0, barrel(x, y), barrel(0 * x, y)))
    assert bpy.ops.curvature.segment(**STRICT) == {"FINISHED"}
    assert len(np.unique(stored(obj, "curvature_class"))) > 1
    return obj


def _sizes() -> dict[str, int]:
    return {obj.name: len(obj.data.polygons) for obj in bpy.data.objects}


def test_every_class_has_a_material_in_its_color(mixed: Object) -> None:
    bpy.ops.curvature.deliver(form="MATERIALS")
    classes = stored(mixed, "curvature_class")
    settings = bpy.context.scene.curvature
    for kind, name in ((0, "Flat"), (1, "Single-Curved")):
        for face in np.flatnonzero(classes == kind)[:5].tolist():
            material = mixed.data.materials[mixed.data.polygons[face].material_index]
            assert material.name == f"Curvature {name}"
            color = settings.color_flat if kind == 0 else settings.color_single
            assert tuple(material.diffuse_color)[:3] == pytest.approx(tuple(color))


def test_delivering_again_adds_nothing(mixed: Object) -> None:
    for _ in range(2):
        for form in ("MATERIALS", "VERTEX_GROUPS", "FACE_SETS"):
            assert bpy.ops.curvature.deliver(form=form) == {"FINISHED"}
    kinds = len(np.unique(stored(mixed, "curvature_class")))
    assert len(mixed.data.materials) == len(mixed.vertex_groups) == kinds


def test_vertex_groups_hold_the_vertices_of_their_class(mixed: Object) -> None:
    bpy.ops.curvature.deliver(form="VERTEX_GROUPS")
    group = mixed.vertex_groups["Single-Curved"].index
    members = {v.index for v in mixed.data.vertices if group in {g.group for g in v.groups}}
    classes = stored(mixed, "curvature_class")
    expected = {v for f in mixed.data.polygons if classes[f.index] == 1 for v in f.vertices}
    assert members == expected


def test_face_sets_part_the_regions(mixed: Object) -> None:
    bpy.ops.curvature.deliver(form="FACE_SETS")
    sets, regions = stored(mixed, ".sculpt_face_set"), stored(mixed, "curvature_region")
    assert (sets > 0).all()
    pairs = set(zip(sets.tolist(), regions.tolist(), strict=True))
    assert len(pairs) == len(np.unique(regions))


def test_separate_objects_hold_all_faces_of_their_class(mixed: Object) -> None:
    bpy.ops.curvature.separate(by="CLASS")
    classes, sizes = stored(mixed, "curvature_class"), _sizes()
    assert sizes.pop("Roof") == len(classes)
    expected = {"Roof Flat": (classes == 0).sum(), "Roof Single-Curved": (classes == 1).sum()}
    assert sizes == {name: count for name, count in expected.items() if count} | {
        name: count for name, count in sizes.items() if "Double" in name
    }
    assert sum(sizes.values()) == len(classes)


def test_separate_objects_lie_where_the_model_does(mixed: Object) -> None:
    mixed.location = (3.0, 4.0, 5.0)
    bpy.context.view_layer.update()
    bpy.ops.curvature.separate(by="CLASS")
    made = [obj for obj in bpy.data.objects if obj != mixed]
    corners = np.array([obj.matrix_world @ v.co for obj in made for v in obj.data.vertices])
    own = np.array([mixed.matrix_world @ v.co for v in mixed.data.vertices])
    np.testing.assert_allclose(corners.min(axis=0), own.min(axis=0), atol=1e-6)
    np.testing.assert_allclose(corners.max(axis=0), own.max(axis=0), atol=1e-6)


def test_separating_again_replaces_the_objects_and_clear_removes_them(mixed: Object) -> None:
    bpy.ops.curvature.separate(by="CLASS")
    bpy.ops.curvature.separate(by="REGION")
    names = set(_sizes()) - {"Roof"}
    assert names
    assert all(name.startswith("Roof Region ") for name in names)
    bpy.ops.curvature.clear()
    assert set(_sizes()) == {"Roof"}
    assert not bpy.data.collections.get("Roof Curvature")
    assert mixed.name in bpy.context.view_layer.objects


def test_without_classes_the_operators_say_what_to_press() -> None:
    add_folded_roof()
    for operator in (bpy.ops.curvature.deliver, bpy.ops.curvature.separate):
        with pytest.raises(RuntimeError, match="Segment the model first"):
            operator()
