# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Curvature per face comes from the face's own side of creases."""

from __future__ import annotations

import numpy as np
from architectural_curvature.addon.geometry.curvature import Curvature
from architectural_curvature.addon.geometry.faces import face_curvature
from architectural_curvature.addon.geometry.mesh import mesh_from_polygons
from architectural_curvature.addon.geometry.surface import Surface, build_surface

SQUARE = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])


def _surface(**marks: object) -> Surface:
    return build_surface(mesh_from_polygons(SQUARE, [[0, 1, 2], [0, 2, 3]], **marks))  # pyright: ignore[reportArgumentType]


def _curvature(k1: list[float], is_defined: list[bool] | None = None) -> Curvature:
    values = np.array(k1)
    flags = np.ones(len(values), dtype=np.bool_) if is_defined is None else np.array(is_defined)
    none = np.zeros((len(values), 3))
    return Curvature(values, -values, none, none, flags)


def test_a_face_has_the_mean_of_its_corners() -> None:
    k1, k2, is_defined = face_curvature(_surface(), _curvature([3.0, 6.0, 9.0, 12.0]))
    assert k1.tolist() == [6.0, 8.0]
    assert k2.tolist() == [-6.0, -8.0]
    assert is_defined.all()


def test_undefined_corners_do_not_count() -> None:
    curvature = _curvature([3.0, 0.0, 9.0, 0.0], [True, False, True, False])
    k1, _, is_defined = face_curvature(_surface(), curvature)
    assert k1.tolist() == [6.0, 6.0]
    assert is_defined.all()


def test_a_face_without_defined_corners_is_undefined_and_zero() -> None:
    curvature = _curvature([5.0, 5.0, 5.0, 5.0], [False, False, False, True])
    k1, _, is_defined = face_curvature(_surface(), curvature)
    assert is_defined.tolist() == [False, True]
    assert k1.tolist() == [0.0, 5.0]


def test_on_a_crease_every_face_has_its_own_side() -> None:
    surface = _surface(sharp_edges=[(0, 2)])
    values = np.zeros(surface.sector_count)
    values[surface.corner_sector[:3]] = 1.0
    values[surface.corner_sector[3:]] = 7.0
    k1, _, _ = face_curvature(surface, _curvature(values.tolist()))
    assert k1.tolist() == [1.0, 7.0]


def test_a_face_without_area_is_undefined() -> None:
    vertices = np.concatenate([SQUARE, [[2.0, 0, 0]]])
    surface = build_surface(mesh_from_polygons(vertices, [[0, 1, 2], [0, 1, 4]]))
    _, _, is_defined = face_curvature(surface, _curvature([1.0] * surface.sector_count))
    assert is_defined.tolist() == [True, False]
