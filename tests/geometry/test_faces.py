# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Curvature per face: its own side of creases and seams, and no blunt average of its corners."""

from __future__ import annotations

import numpy as np
import pytest
from architectural_curvature.addon.geometry.curvature import Curvature, estimate_curvature
from architectural_curvature.addon.geometry.mesh import mesh_from_polygons
from architectural_curvature.addon.geometry.surface import Surface, build_surface
from numpy.typing import NDArray
from solids import Solid, grid, joined
from surfaces.catalogue import PATCHES
from surfaces.sampling import sample_patch

SQUARE = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
RADIUS = 0.2


def _measure(vertices: object, faces: object, **marks: object) -> tuple[Surface, Curvature]:
    surface = build_surface(mesh_from_polygons(vertices, faces, **marks))  # pyright: ignore[reportArgumentType]
    return surface, estimate_curvature(surface)


def _bend(curvature: Curvature) -> NDArray[np.float64]:
    return np.maximum(np.abs(curvature.face_k1), np.abs(curvature.face_k2))


def _rounded_edge(strips: int, along: int, flat: tuple[int, int]) -> Solid:
    """Return two plates at right angles, joined by a fillet; plates are 1 m wide and 2 m long."""

    def arc(u: float, v: float) -> tuple[float, ...]:
        angle = 0.5 * np.pi * u
        return RADIUS * np.sin(angle), 2.0 * v, RADIUS * (np.cos(angle) - 1.0)

    return joined(
        grid(lambda u, v: (u - 1.0, 2.0 * v, 0.0), flat),
        grid(arc, (strips, along)),
        grid(lambda u, v: (RADIUS, 2.0 * v, -RADIUS - u), flat),
    )


@pytest.mark.parametrize(("strips", "along", "flat"), [(8, 1, (1, 1)), (8, 20, (6, 20))])
def test_plates_beside_a_fillet_are_flat_and_the_fillet_is_round(
    strips: int, along: int, flat: tuple[int, int]
) -> None:
    vertices, faces = _rounded_edge(strips, along, flat)
    surface, curvature = _measure(vertices, faces)
    assert not surface.has_creases
    middle = np.array([vertices[face].mean(axis=0) for face in faces])
    is_plate = (middle[:, 0] < -1e-9) | (middle[:, 2] < -RADIUS - 1e-9)
    bend = _bend(curvature)
    # A panel of 0.5 m bends by 1 mm on a plate that bends by 0.03/m.
    assert bend[is_plate].max() < 0.03
    # The strips at the seams turn by half as much on the plate's side.
    round_middle = ~is_plate & (np.abs(middle[:, 0] + middle[:, 2]) < 0.6 * RADIUS)
    assert round_middle.sum() >= 4 * along
    np.testing.assert_allclose(bend[round_middle], 1.0 / RADIUS, rtol=0.1)


def test_a_large_flat_polygon_whose_corners_all_lie_on_fillets_is_flat() -> None:
    # The top of a tray: a hexagon with a rounded rim all around, of four strips.
    turn = np.linspace(0.0, 2.0 * np.pi, 6, endpoint=False)
    rings = [
        np.stack([r * np.cos(turn), r * np.sin(turn), np.full(6, z)], axis=1)
        for r, z in (
            (1.0 + 0.1 * np.sin(a), 0.1 * np.cos(a) - 0.1) for a in np.linspace(0.0, 0.5 * np.pi, 5)
        )
    ]
    faces: list[list[int]] = [list(range(6))]
    for ring in range(4):
        for i in range(6):
            j = (i + 1) % 6
            faces.append([6 * ring + i, 6 * ring + 6 + i, 6 * ring + 6 + j, 6 * ring + j])
    _, curvature = _measure(np.concatenate(rings), faces)
    # Half of the fold at its sides, six of 1 m around 2.6 m², to all directions alike.
    a = 0.125 * np.pi
    fold = np.arctan2(1.0 - np.cos(a), np.cos(np.pi / 6.0) * np.sin(a))
    turn = 0.5 * 0.5 * fold * 6.0 / (1.5 * np.sqrt(3.0))
    np.testing.assert_allclose(_bend(curvature)[0], turn, rtol=1e-9)
    assert turn < 0.02 / 0.1


def test_a_folded_plate_is_flat_on_both_sides() -> None:
    plate = joined(
        grid(lambda u, v: (u, v, -u), (3, 3)), grid(lambda u, v: (u - 1.0, v, u - 1.0), (3, 3))
    )
    _, curvature = _measure(*plate)
    assert curvature.is_face_defined.all()
    assert not _bend(curvature).any()


def test_every_side_of_a_crease_has_its_own_value() -> None:
    # A quarter of a cylinder meets a plate at a right angle.
    def arc(u: float, v: float) -> tuple[float, ...]:
        angle = 0.5 * np.pi * u
        return np.sin(angle), 2.0 * v, np.cos(angle)

    vertices, faces = joined(
        grid(arc, (12, 16)), grid(lambda u, v: (1.0 + u, 2.0 * v, 0.0), (8, 16))
    )
    surface, curvature = _measure(vertices, faces)
    assert surface.has_creases
    is_plate = np.array([vertices[face, 0].mean() > 1.0 for face in faces])
    assert not _bend(curvature)[is_plate].any()
    np.testing.assert_allclose(_bend(curvature)[~is_plate], 1.0, rtol=0.02)


@pytest.mark.parametrize("kind", ["regular", "quads"])
def test_where_nothing_folds_a_face_lies_between_its_corners(kind: str) -> None:
    sample = sample_patch(PATCHES["torus"], kind, (64, 32))
    surface, curvature = _measure(sample.shape.position, sample.polygons)
    corner = curvature.k1[surface.corner_sector].reshape(sample.polygons.shape)
    # A mean of tensors whose directions turn by an angle a loses up to (k1 - k2) a² of k1.
    turn = 2.0 * np.pi / 32.0
    slack = (sample.shape.k1 - sample.shape.k2).max() * turn**2
    assert (curvature.face_k1 <= corner.max(axis=1) + 1e-12).all()
    assert (curvature.face_k1 >= corner.min(axis=1) - slack).all()


def test_a_face_without_area_is_undefined() -> None:
    vertices = np.concatenate([SQUARE, [[2.0, 0, 0]]])
    _, curvature = _measure(vertices, [[0, 1, 2], [0, 1, 4]])
    assert curvature.is_face_defined.tolist() == [True, False]
    assert curvature.face_k1.tolist() == [0.0, 0.0]
    assert curvature.face_k2.tolist() == [0.0, 0.0]


def test_faces_of_a_fine_sphere_bend_though_its_points_have_no_directions() -> None:
    """Edges of 1/200 of the radius: the fit finds equal curvatures up to rounding."""

    def point(u: float, v: float) -> tuple[float, ...]:
        polar, turn = 1.4 + 0.1 * u, 0.1 * v
        return (np.sin(polar) * np.cos(turn), np.sin(polar) * np.sin(turn), np.cos(polar))

    _, curvature = _measure(*grid(point, (20, 20)))
    np.testing.assert_allclose(np.abs(curvature.face_k1), 1.0, rtol=1e-3)
    np.testing.assert_allclose(np.abs(curvature.face_k2), 1.0, rtol=1e-3)
