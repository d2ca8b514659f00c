# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""One call from a mesh to its curvature and warnings."""

from __future__ import annotations

import numpy as np
import pytest
from architectural_curvature.addon.geometry.analysis import analyze
from architectural_curvature.addon.geometry.mesh import mesh_from_polygons
from architectural_curvature.addon.geometry.settings import AnalysisSettings
from solids import pointed_vault
from surfaces.catalogue import PATCHES
from surfaces.sampling import sample_patch


def test_the_crease_angle_of_the_settings_is_used() -> None:
    mesh = mesh_from_polygons(*pointed_vault(6))
    assert analyze(mesh, AnalysisSettings(np.radians(60.0))).surface.has_creases
    assert not analyze(mesh, AnalysisSettings(np.radians(80.0))).surface.has_creases


def test_flipping_normals_shows_the_other_side() -> None:
    mesh = mesh_from_polygons(*pointed_vault(6))
    plain = analyze(mesh, AnalysisSettings(0.5)).curvature
    flipped = analyze(mesh, AnalysisSettings(0.5, flip_normals=True)).curvature
    assert np.array_equal(flipped.k1, -plain.k2)
    assert np.array_equal(flipped.k2, -plain.k1)
    assert np.array_equal(flipped.gaussian, plain.gaussian)


def test_warnings_come_with_the_analysis() -> None:
    vertices, faces = pointed_vault(4)
    mesh = mesh_from_polygons(np.concatenate([vertices, [[9.0, 9, 9]]]), faces)
    assert analyze(mesh, AnalysisSettings(0.5)).warnings == (
        "1 vertex has no faces and no curvature",
    )


def test_analyzing_twice_gives_the_same_bits() -> None:
    mesh = mesh_from_polygons(*pointed_vault(6))
    one, other = (analyze(mesh, AnalysisSettings(0.5)).curvature for _ in range(2))
    assert np.array_equal(one.k1, other.k1)
    assert np.array_equal(one.direction_1, other.direction_1)


@pytest.mark.parametrize("noise", [0.0, 0.01])
def test_progress_rises_and_whoever_listens_can_stop_the_work(noise: float) -> None:
    sample = sample_patch(PATCHES["torus"], "regular", (200, 150))
    random = np.random.default_rng(0)
    edge = np.sqrt(26.0 / len(sample.shape.position))  # of a torus of about 26 m²
    height = noise * edge * random.standard_normal(len(sample.shape.position))
    vertices = sample.shape.position + height[:, None] * sample.shape.normal
    mesh = mesh_from_polygons(vertices, sample.polygons)
    shares: list[float] = []
    analyze(mesh, AnalysisSettings(crease_angle=np.pi), shares.append)
    assert len(shares) > 3
    assert min(shares) >= 0.0
    assert max(shares) <= 1.0
    # Blocks run side by side, so one may report after a later one has.
    assert np.all(np.diff(shares) > -0.3)

    class EnoughError(Exception):
        pass

    def stop(share: float) -> None:
        if share > 0.3:
            raise EnoughError

    with pytest.raises(EnoughError):
        analyze(mesh, AnalysisSettings(crease_angle=np.pi), stop)
