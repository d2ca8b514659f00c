# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Umbilics are found where they are exactly, counted and shown."""

from __future__ import annotations

import math

import bpy
import numpy as np
import pytest
from models import add_mesh, report_of
from surfaces.spheres import sample_ellipsoid


def test_ellipsoid_has_four_umbilics_at_the_exact_places() -> None:
    a, b, c = 1.5, 1.2, 1.0
    sample = sample_ellipsoid((a, b, c), "geodesic", 32)
    obj = add_mesh("Egg", sample.shape.position, sample.polygons)
    obj.location = (3.0, 0.0, 1.0)
    bpy.context.view_layer.update()
    bpy.ops.curvature.find_umbilics()
    marks = bpy.data.objects["Egg Umbilics"]
    mesh = marks.data
    assert [mesh.attributes["umbilic_index"].data[n].value for n in range(4)] == [0.5] * 4
    assert {mesh.attributes["umbilic_kind"].data[n].value for n in range(4)} == {1}
    assert len(mesh.vertices) == 4
    x = a * math.sqrt((a * a - b * b) / (a * a - c * c))
    z = c * math.sqrt((b * b - c * c) / (a * a - c * c))
    exact = np.array([(s * x, 0.0, t * z) for s in (1, -1) for t in (1, -1)])
    edge = 1.5 * 1.2 / 32
    found = np.array([entry["position"] for entry in report_of(obj)["umbilics"]])
    place = np.array([(marks.matrix_world @ v.co)[:] for v in mesh.vertices])
    np.testing.assert_allclose(place, found, atol=1e-5)
    near = np.linalg.norm(found[:, None] - (exact + (3.0, 0.0, 1.0)), axis=2)
    assert near.min(axis=1).max() < edge
    assert sorted(near.argmin(axis=1)) == [0, 1, 2, 3]
    assert {entry["kind"] for entry in report_of(obj)["umbilics"]} == {"lemon"}


def test_umbilics_are_visible() -> None:
    sample = sample_ellipsoid((1.5, 1.2, 1.0), "geodesic", 24)
    add_mesh("Egg", sample.shape.position, sample.polygons)
    bpy.ops.curvature.find_umbilics()
    depsgraph = bpy.context.evaluated_depsgraph_get()
    shown = [
        each.matrix_world.to_scale().x
        for each in depsgraph.object_instances
        if each.is_instance and each.parent.original.name == "Egg Umbilics"
    ]
    assert len(shown) == 4
    # A tenth of the spacing, which is a twentieth of the diagonal.
    diagonal = 2.0 * math.sqrt(1.5**2 + 1.2**2 + 1.0)
    assert shown == pytest.approx([0.1 * diagonal / 20.0] * 4, rel=0.1)
