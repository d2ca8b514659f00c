# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""From panel size and deviation to a limit of curvature."""

from __future__ import annotations

import math

import pytest
from architectural_curvature.addon.geometry.errors import InvalidSettingError
from architectural_curvature.addon.geometry.tolerance import Tolerance, resolve_tolerance


def test_the_limit_is_eight_deviations_over_the_squared_size() -> None:
    tolerance = Tolerance(panel_size=2.0, deviation=0.01)
    assert tolerance.curvature_limit == 0.02
    assert tolerance.radius_limit == 50.0


@pytest.mark.parametrize("radius", [5.0, 50.0, 500.0])
def test_a_chord_at_the_limit_has_the_sagitta_of_the_deviation(radius: float) -> None:
    size = 1.0
    sagitta = radius - math.sqrt(radius**2 - 0.25 * size**2)
    # The formula leaves out the next term of the series, s⁴ / (128 R³).
    limit = Tolerance(size, sagitta).radius_limit
    assert limit == pytest.approx(radius, abs=size**2 / (16.0 * radius) * 1.01)


def test_defaults_are_a_twentieth_of_the_diagonal_and_a_two_hundredth_of_that() -> None:
    assert resolve_tolerance(0.0, 0.0, 40.0) == Tolerance(2.0, 0.01)
    assert resolve_tolerance(1.0, 0.0, 40.0) == Tolerance(1.0, 0.005)
    assert resolve_tolerance(0.0, 0.002, 40.0) == Tolerance(2.0, 0.002)
    assert resolve_tolerance(0.5, 0.002, 40.0) == Tolerance(0.5, 0.002)


@pytest.mark.parametrize("value", [0.0, -1.0, math.nan, math.inf])
def test_sizes_that_give_no_limit_are_refused_by_name(value: float) -> None:
    with pytest.raises(InvalidSettingError, match="the panel size must be greater than zero"):
        Tolerance(value, 0.01)
    with pytest.raises(InvalidSettingError, match="the deviation must be greater than zero"):
        Tolerance(1.0, value)


def test_a_model_without_extent_needs_a_size() -> None:
    with pytest.raises(InvalidSettingError, match="the panel size must be greater than zero"):
        resolve_tolerance(0.0, 0.0, 0.0)


def test_negative_settings_are_not_taken_for_defaults() -> None:
    with pytest.raises(InvalidSettingError):
        resolve_tolerance(-1.0, 0.0, 10.0)
    with pytest.raises(InvalidSettingError):
        resolve_tolerance(0.0, -0.1, 10.0)
