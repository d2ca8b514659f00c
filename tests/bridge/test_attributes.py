# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What is stored on the mesh has exactly the documented names, domains, types and values."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import bpy
import numpy as np
import pytest
from bpy.types import Object
from models import (
    RADIUS,
    STRICT,
    add_folded_roof,
    add_mesh,
    add_surface,
    barrel,
    dome,
    grid,
    inner_vertices,
    own_attributes,
    plate,
    saddle,
    stored,
)

CURVATURE = {
    "curvature_gaussian": ("POINT", "FLOAT"),
    "curvature_mean": ("POINT", "FLOAT"),
    "curvature_k1": ("POINT", "FLOAT"),
    "curvature_k2": ("POINT", "FLOAT"),
    "curvature_direction_1": ("POINT", "FLOAT_VECTOR"),
    "curvature_direction_2": ("POINT", "FLOAT_VECTOR"),
    "curvature_point_type": ("POINT", "INT"),
}
SMOOTH_COLORS = dict.fromkeys(("Gaussian Curvature", "Mean Curvature"), ("POINT", "FLOAT_COLOR"))
CREASED_COLORS = dict.fromkeys(SMOOTH_COLORS, ("CORNER", "FLOAT_COLOR"))
CLASSES = {
    "curvature_class": ("FACE", "INT"),
    "curvature_region": ("FACE", "INT"),
    "Curvature Class": ("CORNER", "FLOAT_COLOR"),
}


def _segmented(obj: Object) -> Object:
    assert bpy.ops.curvature.segment(**STRICT) == {"FINISHED"}
    return obj


def _middle(obj: Object) -> int:
    return len(obj.data.vertices) // 2


def test_analysis_stores_curvatures_and_their_colors_per_vertex() -> None:
    obj = add_surface(dome)
    bpy.ops.curvature.analyze()
    assert own_attributes(obj) == CURVATURE | SMOOTH_COLORS


def test_segmentation_adds_classes_and_regions_per_face() -> None:
    obj = _segmented(add_surface(dome))
    assert own_attributes(obj) == CURVATURE | SMOOTH_COLORS | CLASSES


def test_creases_give_colors_per_corner() -> None:
    obj = _segmented(add_folded_roof())
    assert own_attributes(obj) == CURVATURE | CREASED_COLORS | CLASSES


@pytest.mark.parametrize("name", [*CURVATURE, *CLASSES, *SMOOTH_COLORS])
def test_attribute_of_the_same_name_but_another_kind_is_replaced(name: str) -> None:
    """There is never a second attribute with .001 behind its name."""
    obj = add_surface(dome)
    obj.data.attributes.new(name, "INT8", "EDGE")
    _segmented(obj)
    assert own_attributes(obj) == CURVATURE | SMOOTH_COLORS | CLASSES


def test_second_run_writes_into_the_same_attributes() -> None:
    obj = _segmented(add_surface(dome))
    names = obj.data.attributes.keys()
    _segmented(obj)
    bpy.ops.curvature.analyze(flip_normals=True)
    _segmented(obj)
    assert obj.data.attributes.keys() == names


@pytest.mark.parametrize(
    ("height", "k1", "k2", "surface_class"),
    [
        (plate, 0.0, 0.0, 0),
        (barrel, 1.0 / RADIUS, 0.0, 1),
        (dome, 1.0 / RADIUS, 1.0 / RADIUS, 2),
        (saddle, 1.0 / RADIUS, -1.0 / RADIUS, 3),
    ],
)
def test_values_are_those_of_the_surface(
    height: Callable[..., Any], k1: float, k2: float, surface_class: int
) -> None:
    obj = _segmented(add_surface(height))
    middle = _middle(obj)
    # A fit over two rings of edges h = 1/8 is off by about (2 h / R)² of the curvature.
    error = (2 / 8 / RADIUS) ** 2 / RADIUS
    assert stored(obj, "curvature_k1")[middle] == pytest.approx(k1, abs=error)
    assert stored(obj, "curvature_k2")[middle] == pytest.approx(k2, abs=error)
    assert (stored(obj, "curvature_class") == surface_class).all()
    assert (stored(obj, "curvature_point_type")[inner_vertices(obj)] == surface_class).all()


@pytest.mark.parametrize("height", [plate, barrel, dome, saddle])
def test_identities_hold_at_every_vertex(height: Callable[..., Any]) -> None:
    obj = _segmented(add_surface(height))
    k1, k2, gaussian, mean = (
        stored(obj, f"curvature_{name}").astype(float) for name in ("k1", "k2", "gaussian", "mean")
    )
    assert (k1 >= k2).all()
    rounding = 4.0 * float(np.finfo(np.float32).eps)
    assert gaussian == pytest.approx(k1 * k2, rel=rounding, abs=1e-12)
    assert mean == pytest.approx((k1 + k2) / 2.0, abs=rounding / RADIUS)
    assert (mean**2 >= gaussian - rounding / RADIUS**2).all()


def test_directions_are_unit_tangents_at_right_angles() -> None:
    obj = _segmented(add_surface(saddle))
    one, two = (stored(obj, f"curvature_direction_{n}").astype(float) for n in (1, 2))
    assert np.linalg.norm(one, axis=1) == pytest.approx(1.0, abs=1e-6)
    assert np.linalg.norm(two, axis=1) == pytest.approx(1.0, abs=1e-6)
    assert np.einsum("ij,ij->i", one, two) == pytest.approx(0.0, abs=1e-5)
    # Seen from above, the saddle's normals are up: it is convex, k1, along y in the middle.
    assert abs(one[_middle(obj)] @ [0.0, 1.0, 0.0]) == pytest.approx(1.0, abs=1e-4)


def test_directions_are_in_the_space_of_the_object() -> None:
    obj = add_surface(barrel)
    obj.rotation_euler = (0.4, 0.5, 0.6)
    bpy.context.view_layer.update()
    _segmented(obj)
    # The barrel bends along the object's x and runs along its y.
    inner = inner_vertices(obj)
    along = np.abs(stored(obj, "curvature_direction_2")[inner] @ [0.0, 1.0, 0.0])
    assert along == pytest.approx(1.0, abs=1e-3)


def test_flat_parts_have_no_directions() -> None:
    obj = _segmented(add_surface(plate))
    for number in (1, 2):
        assert not stored(obj, f"curvature_direction_{number}").any()


def test_everything_stored_is_finite() -> None:
    obj = _segmented(add_surface(saddle))
    for name in own_attributes(obj):
        assert np.isfinite(stored(obj, name)).all(), name


def test_undefined_is_minus_one_and_zero() -> None:
    """A face without area and a vertex without faces beside a sound dome."""
    vertices, faces = grid(dome)
    count = len(vertices)
    vertices = np.vstack([vertices, [[3, 0, 0], [4, 0, 0], [5, 0, 0], [9, 9, 9]]])
    obj = add_mesh("Roof", vertices, [*faces, (count, count + 1, count + 2)])
    _segmented(obj)
    assert stored(obj, "curvature_class")[-1] == -1
    assert stored(obj, "curvature_region")[-1] == -1
    assert (stored(obj, "curvature_class")[:-1] == 2).all()
    assert (stored(obj, "curvature_point_type")[-4:] == -1).all()
    for name in ("gaussian", "mean", "k1", "k2", "direction_1", "direction_2"):
        assert not stored(obj, f"curvature_{name}")[-4:].any(), name
    texts = [warning.text for warning in obj.data.curvature.warnings]
    assert any(text.startswith("1 face has no area") for text in texts)
    assert any(text.startswith("1 vertex has no faces") for text in texts)


def test_regions_are_numbered_by_falling_area() -> None:
    obj = _segmented(add_surface(lambda x, _y: -np.maximum(x - 0.5, 0.0)))
    regions = stored(obj, "curvature_region")
    centers = np.array([polygon.center.x for polygon in obj.data.polygons])
    assert (regions[centers < 0.5] == 0).all()
    assert (regions[centers > 0.5] == 1).all()
