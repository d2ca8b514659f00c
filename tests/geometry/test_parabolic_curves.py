# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Parabolic curves lie where domes turn into saddles, and nowhere else."""

from __future__ import annotations

from math import pi, radians

import numpy as np
import pytest
from architectural_curvature.addon.geometry.analysis import Analysis, analyze
from architectural_curvature.addon.geometry.mesh import mesh_from_polygons
from architectural_curvature.addon.geometry.outlines.level_curves import parabolic_curves
from architectural_curvature.addon.geometry.settings import AnalysisSettings

BEND, PIPE = 1.0, 0.4
LIMIT = 0.08


def _grid(points: np.ndarray, closed: bool) -> Analysis:
    """Return the analysis of points (n, m, 3) joined by quads; rows may close."""
    rows, columns = points.shape[:2]
    number = np.arange(rows * columns).reshape(rows, columns)
    if closed:
        number = np.pad(number, ((0, 1), (0, 1)), mode="wrap")
    corners = [number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]]
    faces = np.stack(corners, axis=-1).reshape(-1, 4)
    mesh = mesh_from_polygons(points.reshape(-1, 3), faces.tolist())
    return analyze(mesh, AnalysisSettings(crease_angle=radians(30.0)))


def _torus(turns: int, sides: int, offset: float) -> Analysis:
    u = 2.0 * pi * np.arange(turns)[:, None] / turns
    v = 2.0 * pi * (np.arange(sides)[None, :] + offset) / sides
    rho = BEND + PIPE * np.cos(v)
    x, y, z = rho * np.cos(u), rho * np.sin(u), PIPE * np.sin(v) + 0.0 * u
    return _grid(np.stack([x, y, z], axis=-1), closed=True)


@pytest.mark.parametrize("offset", [0.0, 0.37])
@pytest.mark.parametrize("reach", [0.0, 0.5])
def test_torus_has_two_closed_circles(offset: float, reach: float) -> None:
    """Also where a row of vertices, with no curvature but its error, lies on the circle."""
    turns = 96
    analysis = _torus(turns, 64, offset)
    curves = parabolic_curves(analysis.surface, analysis.curvature, LIMIT, reach)
    assert curves.is_closed.tolist() == [True, True]
    step = 2.0 * pi * BEND / turns
    np.testing.assert_allclose(curves.lengths, 2.0 * pi * BEND, rtol=step**2)
    rho = np.hypot(curves.points[:, 0], curves.points[:, 1])
    np.testing.assert_allclose(rho, BEND, atol=step**2)


def _wave(width: float) -> Analysis:
    """A ribbon along y, bent along x: dome, cylinder of a width, saddle."""
    x = np.linspace(-1.0, 1.0, 61)[:, None]
    y = np.linspace(-0.5, 0.5, 31)[None, :]
    beyond = np.sign(x) * np.maximum(np.abs(x) - 0.5 * width, 0.0)
    z = -0.25 * y**2 - 0.5 * beyond**2 * np.sign(-beyond)
    noise = 1e-7 * np.random.default_rng(3).standard_normal((61, 31))
    return _grid(np.stack([x + 0.0 * y, y + 0.0 * x, z + noise], axis=-1), closed=False)


def test_narrow_cylinder_between_dome_and_saddle_has_one_curve() -> None:
    analysis = _wave(0.2)
    curves = parabolic_curves(analysis.surface, analysis.curvature, LIMIT, 0.4)
    assert curves.count == 1
    # Within the cylinder, and as long as the ribbon is wide.
    assert np.abs(curves.points[:, 0]).max() < 0.1 + 1.0 / 30.0
    assert curves.lengths[0] == pytest.approx(1.0, rel=0.1)


def test_wide_cylinder_has_none() -> None:
    analysis = _wave(1.0)
    curves = parabolic_curves(analysis.surface, analysis.curvature, LIMIT, 0.4)
    assert curves.count == 0
