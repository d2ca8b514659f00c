# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Statistics are weighted by area."""

from __future__ import annotations

import numpy as np
import pytest
from architectural_curvature.addon.geometry.statistics import (
    smallest_radius,
    summarize,
    weighted_percentiles,
)
from hypothesis import given, settings
from hypothesis import strategies as st

PERCENTS = np.array([0.0, 1.0, 5.0, 25.0, 50.0, 75.0, 95.0, 99.0, 100.0])

lists = st.lists(st.tuples(st.floats(-100.0, 100.0), st.integers(1, 6)), min_size=1, max_size=12)


@settings(deadline=None, derandomize=True, database=None)
@given(lists)
def test_a_weight_of_n_counts_as_n_values(pairs: list[tuple[float, int]]) -> None:
    values = np.array([value for value, _ in pairs])
    weights = np.array([weight for _, weight in pairs])
    expected = np.percentile(np.repeat(values, weights), PERCENTS, method="averaged_inverted_cdf")
    found = weighted_percentiles(values, weights.astype(float), PERCENTS)
    np.testing.assert_allclose(found, expected, rtol=1e-12, atol=1e-12)


@settings(deadline=None, derandomize=True, database=None)
@given(lists)
def test_percentiles_of_the_negative_are_mirrored(pairs: list[tuple[float, int]]) -> None:
    values = np.array([value for value, _ in pairs])
    weights = np.array([weight for _, weight in pairs]) / 7.0
    np.testing.assert_array_equal(
        weighted_percentiles(-values, weights, 100.0 - PERCENTS),
        -weighted_percentiles(values, weights, PERCENTS),
    )


def test_what_has_no_weight_does_not_count() -> None:
    values, weights = np.array([-9.0, 1.0, 5.0, 2.0, 9.0]), np.array([0.0, 1.0, 0.0, 1.0, 0.0])
    found = weighted_percentiles(values, weights, np.array([0.0, 50.0, 100.0]))
    assert found.tolist() == [1.0, 1.5, 2.0]


@settings(deadline=None, derandomize=True, database=None)
@given(lists, st.floats(1e-3, 1e3))
def test_percentiles_do_not_depend_on_the_unit_of_areas(
    pairs: list[tuple[float, int]], unit: float
) -> None:
    values = np.array([value for value, _ in pairs])
    weights = np.array([float(weight) for _, weight in pairs])
    np.testing.assert_allclose(
        weighted_percentiles(values, weights * unit, PERCENTS),
        weighted_percentiles(values, weights, PERCENTS),
        rtol=1e-9,
        atol=1e-9,
    )


def test_a_summary_ignores_what_has_no_area() -> None:
    summary = summarize(np.array([1.0, 3.0, 99.0]), np.array([3.0, 1.0, 0.0]))
    assert summary is not None
    assert (summary.min, summary.max, summary.mean) == (1.0, 3.0, 1.5)
    assert (summary.p05, summary.median, summary.p95) == (1.0, 1.0, 3.0)


def test_without_area_there_is_no_summary() -> None:
    assert summarize(np.array([1.0]), np.array([0.0])) is None
    assert summarize(np.empty(0), np.empty(0)) is None


def test_the_smallest_radius_is_that_of_an_evenly_bent_surface() -> None:
    assert smallest_radius(np.full(7, 0.25), np.ones(7)) == 4.0


def test_one_bad_face_in_a_thousand_does_not_set_the_radius() -> None:
    size = np.full(1000, 0.5)
    size[17] = 1e6
    assert smallest_radius(size, np.ones(1000)) == pytest.approx(2.0, rel=1e-12)


def test_a_bad_face_of_a_thousandth_of_the_area_does_not_set_it_either() -> None:
    assert smallest_radius(np.array([0.5, 1e6]), np.array([0.999, 0.001])) == 2.0


def test_two_percent_of_the_area_do_set_it() -> None:
    size = np.full(100, 0.5)
    size[:2] = 5.0
    radius = smallest_radius(size, np.ones(100))
    assert radius == pytest.approx(0.2, rel=1e-12)


@pytest.mark.parametrize("area", [0.0, 1.0])
def test_what_is_straight_or_absent_has_no_radius(area: float) -> None:
    assert smallest_radius(np.zeros(3), np.full(3, area)) is None
    assert smallest_radius(np.empty(0), np.empty(0)) is None
