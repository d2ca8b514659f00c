# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Bézier curves through points of known curves stay within the tolerance, with few knots."""

from __future__ import annotations

import numpy as np
import pytest
from architectural_curvature.addon.geometry.fitting import fit_bezier


def _ellipse(count: int, turn: float = 2.0 * np.pi) -> np.ndarray:
    t = np.linspace(0.0, turn, count, endpoint=turn < 6.0)
    return np.stack([2.0 * np.cos(t), np.sin(t), 0.3 * np.sin(2.0 * t)], axis=1)


def _off(points: np.ndarray) -> float:
    """Return the largest distance from the exact curve."""
    from scipy.spatial import cKDTree

    return float(cKDTree(_ellipse(100_000)).query(points)[0].max())


@pytest.mark.parametrize("tolerance", [1e-2, 1e-3, 1e-4])
@pytest.mark.parametrize("is_closed", [True, False])
def test_curve_stays_within_the_tolerance(tolerance: float, is_closed: bool) -> None:
    points = _ellipse(400) if is_closed else _ellipse(240, 4.0)
    curve = fit_bezier(points, is_closed, tolerance)
    # Between the points, which the tolerance is about, it is checked too.
    assert _off(curve.samples()) < 1.5 * tolerance
    # A cubic arc of the length h is off by some h^4/100 here, and arcs are halved.
    assert len(curve.knots) <= 8 * (1e-2 / tolerance) ** 0.5


@pytest.mark.parametrize("is_closed", [True, False])
def test_knots_are_points_of_the_line_and_handles_are_in_line(is_closed: bool) -> None:
    points = _ellipse(400) if is_closed else _ellipse(240, 4.0)
    curve = fit_bezier(points, is_closed, 1e-3)
    np.testing.assert_array_equal(curve.knots, points[curve.point])
    inner = slice(None) if is_closed else slice(1, -1)
    one = (curve.knots - curve.before)[inner]
    two = (curve.after - curve.knots)[inner]
    cosine = (one * two).sum(axis=1) / np.linalg.norm(one, axis=1) / np.linalg.norm(two, axis=1)
    assert cosine.min() > 1.0 - 1e-9
    if not is_closed:
        np.testing.assert_array_equal(curve.knots[[0, -1]], points[[0, -1]])


def test_straight_and_tiny_lines() -> None:
    line = np.linspace([0.0, 0.0, 0.0], [3.0, 0.0, 0.0], 50)
    curve = fit_bezier(line, False, 1e-6)
    assert len(curve.knots) == 2
    assert np.abs(curve.samples()[:, 1:]).max() < 1e-12
    assert len(fit_bezier(line[:2], False, 1e-6).knots) == 2
    triangle = np.eye(3)
    assert np.isfinite(fit_bezier(triangle, True, 1e-3).samples()).all()


def test_doubled_points_do_no_harm() -> None:
    points = np.repeat(_ellipse(60, 4.0), 2, axis=0)
    samples = fit_bezier(points, False, 1e-3).samples()
    assert np.isfinite(samples).all()
    assert _off(samples) < 0.02
