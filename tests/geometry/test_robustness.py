# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whatever passes validation is analyzed without a warning of numpy, and without NaN."""

from __future__ import annotations

import warnings

import numpy as np
import pytest
from architectural_curvature.addon.geometry.analysis import analyze
from architectural_curvature.addon.geometry.mesh import mesh_from_polygons
from architectural_curvature.addon.geometry.segmentation import segment
from architectural_curvature.addon.geometry.settings import AnalysisSettings, Smoothing
from architectural_curvature.addon.geometry.tolerance import Tolerance
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from solids import capped_cylinder, cube, pointed_vault
from surfaces.catalogue import PATCHES
from surfaces.sampling import sample_patch
from surfaces.spheres import sample_ellipsoid

Array = NDArray[np.float64]

robust = settings(deadline=None, derandomize=True, max_examples=150, database=None)
scales = st.sampled_from([1e-3, 1.0, 1e3])
offsets = st.sampled_from([0.0, 1e5])
seeds = st.integers(0, 2**32 - 1)

SMOOTHINGS = [
    (Smoothing.AUTO, 0.0),
    (Smoothing.NONE, 0.0),
    (Smoothing.LENGTH, 1e-6),
    (Smoothing.LENGTH, 0.3),
    (Smoothing.LENGTH, 1e6),
]


def _check(vertices: Array, faces: object, smoothing: Smoothing, length: float) -> None:
    """Analyze a mesh as Blender stores it; whatever is not defined must be zero."""
    stored = np.asarray(vertices, dtype=np.float32).astype(np.float64)
    step = float(np.spacing(np.float32(np.abs(stored).max(initial=1e-30))))
    with warnings.catch_warnings(), np.errstate(all="raise", under="ignore"):
        warnings.simplefilter("error")
        mesh = mesh_from_polygons(stored, faces, resolution=step)  # pyright: ignore[reportArgumentType]
        settings = AnalysisSettings(0.5, smoothing=smoothing, smoothing_length=length)
        curvature = analyze(mesh, settings).curvature
        result = segment(analyze(mesh, settings).surface, curvature, Tolerance(1.0, 0.01))
    for name in curvature.__dataclass_fields__:
        assert np.isfinite(getattr(curvature, name)).all(), name
    assert (curvature.k1 >= curvature.k2).all()
    assert (curvature.face_k1 >= curvature.face_k2).all()
    assert not curvature.k1[~curvature.is_defined].any()
    assert not curvature.face_k1[~curvature.is_face_defined].any()
    lengths = np.linalg.norm(curvature.direction_1, axis=1)
    assert ((lengths == 0.0) | (np.abs(lengths - 1.0) < 1e-9)).all()
    assert len(result.face_class) == mesh.polygon_count


@robust
@given(seeds, st.integers(3, 25), st.integers(1, 60), scales, offsets, st.sampled_from(SMOOTHINGS))
def test_random_triangles(
    seed: int, points: int, count: int, scale: float, offset: float, how: tuple[Smoothing, float]
) -> None:
    random = np.random.default_rng(seed)
    # A coarse grid of positions gives duplicates, needles and triangles without area.
    vertices = random.integers(0, 4, (points, 3)) * random.choice([1.0, 1e-5], 3)
    faces = random.integers(0, points, (count, 3))
    _check((vertices + offset) * scale, faces, *how)


@robust
@given(seeds, st.integers(4, 20), st.integers(1, 20), scales, st.sampled_from(SMOOTHINGS))
def test_random_polygons(
    seed: int, points: int, count: int, scale: float, how: tuple[Smoothing, float]
) -> None:
    random = np.random.default_rng(seed)
    vertices = random.normal(size=(points, 3)) * scale
    faces = [random.integers(0, points, random.integers(3, 8)).tolist() for _ in range(count)]
    _check(vertices, faces, *how)


@robust
@given(seeds, scales, offsets, st.sampled_from(SMOOTHINGS), st.sampled_from(sorted(PATCHES)))
def test_spoiled_surfaces(
    seed: int, scale: float, offset: float, how: tuple[Smoothing, float], name: str
) -> None:
    random = np.random.default_rng(seed)
    sample = sample_patch(PATCHES[name], random.choice(["regular", "irregular"]), (14, 9), 1)
    position, triangles = sample.shape.position.copy(), sample.polygons.copy()
    lost = random.integers(0, len(triangles), 6)
    triangles[lost] = triangles[lost][:, ::-1]
    triangles = np.delete(triangles, random.integers(0, len(triangles), 9), axis=0)
    triangles = np.concatenate([triangles, triangles[:3], triangles[:2, [0, 0, 1]]])
    # Merged positions make needles and faces without area; a far point makes huge ones.
    position[random.integers(0, len(position), 5)] = position[0]
    position[random.integers(0, len(position))] *= 100.0
    position += random.normal(size=position.shape) * random.choice([0.0, 1e-3, 0.05])
    _check((position + offset) * scale, triangles, *how)


@pytest.mark.parametrize("how", SMOOTHINGS)
@pytest.mark.parametrize("scale", [1e-3, 1.0, 1e3])
def test_solids(scale: float, how: tuple[Smoothing, float]) -> None:
    for vertices, faces in (cube(1), cube(2), capped_cylinder(1.0, 2.0, 10, 2), pointed_vault(3)):
        _check(np.asarray(vertices) * scale, faces, *how)


def test_two_cones_that_touch_in_one_vertex() -> None:
    sample = sample_ellipsoid((1.0, 1.0, 1.0), "geodesic", 3)
    position, triangles = sample.shape.position, sample.polygons
    top = int(np.argmax(position[:, 2]))
    mirrored = position * [1.0, 1.0, -1.0] + [0.0, 0.0, 2.0 * position[top, 2]]
    other = triangles[:, ::-1] + len(position)
    other[other == top + len(position)] = top
    vertices = np.concatenate([position, mirrored])
    _check(vertices, np.concatenate([triangles, other]), Smoothing.AUTO, 0.0)
    surface = analyze(
        mesh_from_polygons(vertices, np.concatenate([triangles, other])), AnalysisSettings(3.0)
    ).surface
    assert (surface.sector_vertex == top).sum() == 2


def test_a_vertex_that_ten_thousand_faces_share() -> None:
    turn = np.linspace(0.0, 2.0 * np.pi, 10_000, endpoint=False)
    rim = np.stack([np.cos(turn), np.sin(turn), 0.0 * turn], axis=1)
    hub = len(turn)
    faces = np.stack([np.arange(hub), np.roll(np.arange(hub), -1), np.full(hub, hub)], axis=1)
    for height in (0.0, 0.02, 1.0):
        _check(np.concatenate([rim, [[0.0, 0.0, height]]]), faces, Smoothing.AUTO, 0.0)
