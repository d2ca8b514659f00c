# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Results belong to places of the building, not to the order in which its mesh lists them."""

from __future__ import annotations

import bpy
import numpy as np
import pytest
from bpy.types import Object
from models import STRICT, add_mesh, add_surface, grid, only_select, stored

RNG = np.random.default_rng(20)


def _mixed(x: np.ndarray, _y: np.ndarray) -> np.ndarray:
    """Flat left of the middle, bent right of it."""
    return -0.25 * np.maximum(x, 0.0) ** 2


def _shuffled() -> tuple[Object, np.ndarray, np.ndarray]:
    vertices, faces = grid(_mixed)
    vertex_order = RNG.permutation(len(vertices))
    face_order = RNG.permutation(len(faces))
    rank = np.argsort(vertex_order)
    obj = add_mesh("Shuffled", vertices[vertex_order], rank[faces[face_order]])
    return obj, vertex_order, face_order


@pytest.fixture
def pair() -> tuple[Object, Object, np.ndarray, np.ndarray]:
    """A model, the same shuffled, and the orders of its vertices and faces."""
    plain = add_surface(_mixed)
    shuffled, vertex_order, face_order = _shuffled()
    only_select(plain, shuffled)
    assert bpy.ops.curvature.segment(**STRICT) == {"FINISHED"}
    return plain, shuffled, vertex_order, face_order


@pytest.mark.parametrize("name", ["gaussian", "mean", "k1", "k2"])
def test_values_follow_their_vertices(name: str, pair: tuple) -> None:
    plain, shuffled, vertex_order, _ = pair
    expected = stored(plain, f"curvature_{name}")[vertex_order]
    # Sums in another order differ by rounding of 32 bit coordinates over h² = 1/64.
    assert stored(shuffled, f"curvature_{name}") == pytest.approx(expected, abs=1e-5)


@pytest.mark.parametrize("name", ["class", "region"])
def test_labels_follow_their_faces(name: str, pair: tuple) -> None:
    plain, shuffled, _, face_order = pair
    expected = stored(plain, f"curvature_{name}")[face_order]
    assert stored(shuffled, f"curvature_{name}").tolist() == expected.tolist()


def test_measures_are_the_same(pair: tuple) -> None:
    plain, shuffled, _, _ = pair
    for one, other in zip(
        plain.data.curvature.classes, shuffled.data.curvature.classes, strict=True
    ):
        assert (one.faces, one.regions) == (other.faces, other.regions)
        assert one.area == pytest.approx(other.area, rel=1e-6)
        assert one.min_radius == pytest.approx(other.min_radius, rel=1e-4)


def test_order_of_the_objects_does_not_matter() -> None:
    heights = {"A": _mixed, "B": lambda x, y: 0.1 * x * y}
    found = []
    for names in (("A", "B"), ("B", "A")):
        bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
        for name in names:
            add_surface(heights[name], name)
        bpy.ops.curvature.segment(**STRICT)
        found.append([stored(bpy.data.objects[n], "curvature_k1").tolist() for n in ("A", "B")])
    assert found[0] == found[1]
