# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every kind of defect has a sentence with a count; a sound surface has none."""

from __future__ import annotations

import numpy as np
import pytest
from architectural_curvature.addon.geometry.diagnosis import (
    diagnose,
    duplicate_polygon_count,
)
from architectural_curvature.addon.geometry.mesh import mesh_from_polygons
from architectural_curvature.addon.geometry.surface import Surface, build_surface
from solids import capped_cylinder, cube, grid, pointed_vault

SQUARE = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [2, 0, 0], [2, 1, 0], [3, 0, 0]])


def _surface(faces: object, vertices: object = SQUARE, **marks: object) -> Surface:
    return build_surface(mesh_from_polygons(vertices, faces, **marks))  # pyright: ignore[reportArgumentType]


def _warnings(faces: list[list[int]], used: int) -> tuple[str, ...]:
    return diagnose(_surface(faces, SQUARE[:used]))


@pytest.mark.parametrize("solid", [cube(2), capped_cylinder(1.0, 2.0, 12, 3), pointed_vault(4)])
def test_a_sound_surface_has_no_warnings(solid: tuple[np.ndarray, list[list[int]]]) -> None:
    assert diagnose(_surface(solid[1], solid[0])) == ()


def test_faces_without_area_are_counted() -> None:
    (one,) = _warnings([[0, 1, 2, 3], [1, 4, 5, 2], [0, 4, 1]], 6)
    assert one.startswith("1 face has no area and gets no class: Mesh > Clean Up")


def test_several_faces_without_area_are_counted_in_the_plural() -> None:
    first, *_ = diagnose(_surface([[0, 1, 2, 3], [1, 4, 5, 2], [0, 4, 1], [1, 6, 4]]))
    assert first.startswith("2 faces have no area and get no class")


def test_repeated_faces_are_counted_whatever_corner_they_start_at() -> None:
    surface = _surface([[0, 1, 2, 3], [2, 3, 0, 1], [3, 2, 1, 0], [1, 4, 5, 2]], SQUARE[:6])
    assert duplicate_polygon_count(surface) == 2
    assert diagnose(surface)[0].startswith("2 faces repeat others and count twice")


def test_faces_of_the_same_corners_in_part_are_no_repetition() -> None:
    assert duplicate_polygon_count(_surface([[0, 1, 2], [0, 1, 2, 3]])) == 0


def test_inner_faces_are_counted_by_their_edges() -> None:
    vertices = np.concatenate([SQUARE[:6], [[1, 0, 1.0], [1, 1, 1]]])
    surface = _surface([[0, 1, 2, 3], [1, 4, 5, 2], [1, 2, 7, 6]], vertices)
    assert diagnose(surface) == (
        "1 edge has more than two faces and counts as a crease: delete inner faces",
    )


def test_mixed_winding_is_counted_by_edges() -> None:
    assert _warnings([[0, 1, 2, 3], [2, 5, 4, 1]], 6) == (
        "1 edge has faces that point to opposite sides and counts as a crease (1 face to turn): "
        "Mesh > Normals > Recalculate Outside",
    )


def test_lone_vertices_are_counted() -> None:
    assert _warnings([[0, 1, 2, 3]], 5) == ("1 vertex has no faces and no curvature",)
    assert _warnings([[0, 1, 2, 3]], 7) == ("3 vertices have no faces and no curvature",)


def test_coarse_rounding_is_told_with_its_size() -> None:
    vertices, faces = grid(lambda u, v: (u, v, 0.0), (10, 10))
    assert diagnose(_surface(faces, vertices, resolution=9e-6)) == ()
    (sentence,) = diagnose(_surface(faces, vertices, resolution=2e-5))
    assert "rounded to 2e-05 m" in sentence


def test_all_defects_are_told_at_once() -> None:
    faces = [[0, 1, 2, 3], [0, 1, 2, 3], [0, 4, 1]]
    assert len(diagnose(_surface(faces))) >= 3


def _gable(step: float) -> tuple[np.ndarray, list[list[int]]]:
    """Return three quads side by side, each a little steeper than the one before."""
    turn = step * np.arange(4)
    x, z = np.cumsum(np.cos(turn)) - 1.0, np.cumsum(np.sin(turn))
    near = np.stack([x, 0.0 * x, z], axis=1)
    vertices = np.concatenate([near, near + [0.0, 1.0, 0.0]])
    return vertices, [[i, i + 1, i + 5, i + 4] for i in range(3)]


def test_edges_that_only_shading_marked_sharp_are_told() -> None:
    vertices, faces = _gable(0.1)
    (sentence,) = diagnose(_surface(faces, vertices, sharp_edges=[(1, 5), (2, 6)]))
    assert sentence.startswith("2 of 2 edges are creases only because they are marked sharp")


def test_marks_on_true_folds_are_no_shading() -> None:
    vertices, faces = _gable(1.0)
    assert diagnose(_surface(faces, vertices, sharp_edges=[(1, 5), (2, 6)])) == ()
