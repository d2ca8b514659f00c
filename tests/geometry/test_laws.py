# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Curvature follows the model through scaling, motion, renumbering and flipping.

These are laws: they hold to rounding on any mesh, however coarse, whatever the estimator's error.
"""

from __future__ import annotations

import numpy as np
import pytest
from architectural_curvature.addon.geometry.classification import SurfaceClass
from architectural_curvature.addon.geometry.curvature import Curvature, estimate_curvature
from architectural_curvature.addon.geometry.mesh import mesh_from_polygons
from architectural_curvature.addon.geometry.segmentation import segment
from architectural_curvature.addon.geometry.surface import Surface, build_surface
from architectural_curvature.addon.geometry.tolerance import resolve_tolerance
from hypothesis import Phase, given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation
from surfaces.catalogue import PATCHES
from surfaces.sampling import sample_patch
from surfaces.spheres import sample_ellipsoid

Array = NDArray[np.float64]
Faces = NDArray[np.int64]

MODELS = {
    "waves": sample_patch(PATCHES["waves"], "irregular", (9, 9)),
    "torus": sample_patch(PATCHES["torus"], "irregular", (20, 10)),
    "ellipsoid": sample_ellipsoid((1.0, 0.8, 0.6), "irregular", 4),
    "saddle": sample_patch(PATCHES["monkey saddle"], "alternating", (8, 8)),
}

#: Fits solve systems of some twenty equations whose entries span h² to h⁴: with h of about 0.2 a
#: rounding of 1e-16 grows by less than 1e6.
ROUNDING = 1e-10

models = st.sampled_from(sorted(MODELS))
seeds = st.integers(0, 2**32 - 1)
# Shrinking a failure would take longer than all the rest.
laws = settings(
    deadline=None,
    derandomize=True,
    max_examples=20,
    database=None,
    phases=[Phase.explicit, Phase.generate],
)


def _model(name: str) -> tuple[Array, Faces]:
    return MODELS[name].shape.position, MODELS[name].polygons


def _measure(vertices: Array, faces: Faces) -> tuple[Surface, Curvature]:
    surface = build_surface(mesh_from_polygons(vertices, faces), np.pi)
    return surface, estimate_curvature(surface)


def _classes(surface: Surface, curvature: Curvature) -> Faces:
    tolerance = resolve_tolerance(0.0, 0.0, surface.mesh.diagonal)
    return segment(surface, curvature, tolerance).face_class


def _form(curvature: Curvature) -> Array:
    """The second fundamental form as matrices: it does not care for the directions' signs."""
    return sum(
        k[:, None, None] * d[:, :, None] * d[:, None, :]
        for k, d in (
            (curvature.k1, curvature.direction_1),
            (curvature.k2, curvature.direction_2),
        )
    )  # pyright: ignore[reportReturnType]


def _assert_close(actual: Array, expected: Array, rounding: float = ROUNDING) -> None:
    np.testing.assert_allclose(actual, expected, rtol=0.0, atol=rounding * np.abs(expected).max())


@laws
@given(models, st.floats(-4.0, 4.0))
def test_curvatures_scale_inversely_with_size(name: str, exponent: float) -> None:
    vertices, faces = _model(name)
    size = 10.0**exponent
    surface, curvature = _measure(vertices, faces)
    scaled_surface, scaled = _measure(vertices * size, faces)
    _assert_close(scaled.k1 * size, curvature.k1)
    _assert_close(scaled.k2 * size, curvature.k2)
    _assert_close(scaled.mean * size, curvature.mean)
    _assert_close(scaled.gaussian * size**2, curvature.gaussian)
    assert np.array_equal(_classes(scaled_surface, scaled), _classes(surface, curvature))


@laws
@given(models, seeds)
def test_curvatures_follow_rotations(name: str, seed: int) -> None:
    vertices, faces = _model(name)
    turn = Rotation.from_quat(np.random.default_rng(seed).normal(size=4)).as_matrix()
    _, curvature = _measure(vertices, faces)
    _, turned = _measure(vertices @ turn.T, faces)
    _assert_close(turned.k1, curvature.k1)
    _assert_close(turned.k2, curvature.k2)
    _assert_close(_form(turned), turn @ _form(curvature) @ turn.T)


@pytest.mark.parametrize("name", MODELS)
def test_a_model_far_from_the_origin_has_the_same_curvature(name: str) -> None:
    vertices, faces = _model(name)
    far = 1e5
    # What the coordinates themselves lose, eps · 1e5, weighs 8/h² in a curvature of a chord of h.
    surface, curvature = _measure(vertices, faces)
    edge = np.sqrt(surface.polygon_area.min())
    loss = 8.0 * np.finfo(float).eps * far / edge**2 * 10.0
    moved_surface, moved = _measure(vertices + far, faces)
    np.testing.assert_allclose(moved.k1, curvature.k1, rtol=0.0, atol=loss)
    np.testing.assert_allclose(moved.k2, curvature.k2, rtol=0.0, atol=loss)
    assert np.array_equal(_classes(moved_surface, moved), _classes(surface, curvature))


@laws
@given(models, seeds)
def test_the_order_of_vertices_does_not_matter(name: str, seed: int) -> None:
    vertices, faces = _model(name)
    order = np.random.default_rng(seed).permutation(len(vertices))
    number = np.empty_like(order)
    number[order] = np.arange(len(order))
    surface, curvature = _measure(vertices, faces)
    mixed_surface, mixed = _measure(vertices[order], number[faces])
    _assert_close(mixed.k1, curvature.k1[order])
    _assert_close(mixed.k2, curvature.k2[order])
    _assert_close(_form(mixed), _form(curvature)[order])
    assert np.array_equal(_classes(mixed_surface, mixed), _classes(surface, curvature))


@laws
@given(models, seeds)
def test_the_order_of_faces_does_not_matter(name: str, seed: int) -> None:
    vertices, faces = _model(name)
    random = np.random.default_rng(seed)
    order = random.permutation(len(faces))
    turned = np.stack([np.roll(face, random.integers(3)) for face in faces[order]])
    surface, curvature = _measure(vertices, faces)
    mixed_surface, mixed = _measure(vertices, turned)
    _assert_close(mixed.k1, curvature.k1)
    _assert_close(mixed.k2, curvature.k2)
    _assert_close(_form(mixed), _form(curvature))
    assert np.array_equal(_classes(mixed_surface, mixed), _classes(surface, curvature)[order])


@pytest.mark.parametrize("name", MODELS)
def test_turning_all_faces_over_changes_signs_and_swaps_k1_with_k2(name: str) -> None:
    vertices, faces = _model(name)
    surface, curvature = _measure(vertices, faces)
    over_surface, over = _measure(vertices, faces[:, ::-1])
    _assert_close(over.k1, -curvature.k2)
    _assert_close(over.k2, -curvature.k1)
    _assert_close(over.gaussian, curvature.gaussian)
    _assert_close(_form(over), -_form(curvature))
    assert np.array_equal(_classes(over_surface, over), _classes(surface, curvature))


@pytest.mark.parametrize("name", MODELS)
def test_mirroring_changes_signs_as_normals_follow_the_winding(name: str) -> None:
    vertices, faces = _model(name)
    _, curvature = _measure(vertices, faces)
    _, mirrored = _measure(vertices * [-1.0, 1.0, 1.0], faces)
    _assert_close(mirrored.k1, -curvature.k2)
    _assert_close(mirrored.k2, -curvature.k1)


@laws
@given(models, models, st.integers(0, 20))
def test_components_and_unused_vertices_do_not_touch_each_other(
    first: str, second: str, unused: int
) -> None:
    one, other = _model(first), _model(second)
    lost = np.full((unused, 3), 3.0)
    vertices = np.concatenate([one[0], lost, other[0] + [5.0, 0.0, 0.0]])
    shifted = other[1] + len(one[0]) + unused
    surface, both = _measure(vertices, np.concatenate([one[1], shifted]))
    assert surface.sector_count == len(one[0]) + len(other[0])
    for part, k1 in ((one, both.k1[: len(one[0])]), (other, both.k1[len(one[0]) :])):
        _assert_close(k1, _measure(*part)[1].k1)


@laws
@given(models)
def test_the_definitions_hold_at_every_vertex(name: str) -> None:
    _, curvature = _measure(*_model(name))
    assert (curvature.k1 >= curvature.k2).all()
    assert np.array_equal(curvature.gaussian, curvature.k1 * curvature.k2)
    assert np.array_equal(curvature.mean, 0.5 * (curvature.k1 + curvature.k2))
    square = curvature.mean**2
    assert (square - curvature.gaussian >= -4.0 * np.finfo(float).eps * square.max()).all()


def test_classes_are_those_of_the_enumeration() -> None:
    surface, curvature = _measure(*_model("torus"))
    assert set(_classes(surface, curvature)) <= set(SurfaceClass)
