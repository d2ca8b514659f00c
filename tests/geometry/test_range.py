# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Ranges of color maps: symmetric, round, and never blowing up noise."""

from __future__ import annotations

import math

import numpy as np
import pytest
from architectural_curvature.addon.geometry.display.range import (
    clipped_share,
    percentile_limit,
    round_up,
)
from hypothesis import given, settings
from hypothesis import strategies as st

ONES = np.ones(100)


@pytest.mark.parametrize(
    ("value", "expected"),
    [
        (1.0, 1.0),
        (1.01, 1.1),
        (0.0996, 0.1),
        (0.25, 0.25),
        (0.2500001, 0.26),
        (123.0, 130.0),
        (99.5, 100.0),
        (3e-7, 3e-7),
    ],
)
def test_limits_are_rounded_up_to_two_digits(value: float, expected: float) -> None:
    assert round_up(value) == pytest.approx(expected, rel=1e-15)


@settings(deadline=None, derandomize=True, database=None)
@given(st.floats(1e-8, 1e8))
def test_rounding_up_never_falls_below_and_adds_a_tenth_at_most(value: float) -> None:
    rounded = round_up(value)
    # What lies within a millionth of a digit above a round number counts as that number.
    assert value * (1.0 - 1e-6) <= rounded <= value * 1.1 * (1.0 + 1e-9)
    assert float(f"{rounded:.2g}") == rounded


def test_the_limit_bounds_the_share_of_the_area_by_size_whatever_the_sign() -> None:
    values = np.linspace(-1.0, 0.2, 100)
    expected = np.percentile(np.abs(values), 95.0, method="averaged_inverted_cdf")
    assert percentile_limit(values, ONES, 95.0, 0.0) == round_up(expected)
    assert percentile_limit(-values, ONES, 95.0, 0.0) == round_up(expected)


def test_areas_weigh() -> None:
    values = np.array([1.0, 10.0])
    assert percentile_limit(values, np.array([999.0, 1.0]), 95.0, 0.0) == 1.0
    assert percentile_limit(values, np.array([1.0, 999.0]), 95.0, 0.0) == 10.0


def test_rounding_noise_is_not_blown_up() -> None:
    noise = np.full(100, 1e-12)
    assert percentile_limit(noise, ONES, 95.0, scale=4.0) == 0.04


@pytest.mark.parametrize("values", [np.zeros(100), np.empty(0)])
def test_a_plane_has_the_limit_one(values: np.ndarray) -> None:
    assert percentile_limit(values, np.ones(len(values)), 95.0, 0.0) == 1.0


def test_the_clipped_share_is_what_lies_beyond_the_limit() -> None:
    values, areas = np.array([-3.0, -1.0, 1.0, 2.0]), np.array([1.0, 2.0, 3.0, 4.0])
    assert clipped_share(values, areas, 1.0) == 0.5
    assert clipped_share(values, areas, 3.0) == 0.0
    assert clipped_share(values, 0.0 * areas, 1.0) == 0.0
    assert math.isfinite(clipped_share(np.empty(0), np.empty(0), 1.0))
