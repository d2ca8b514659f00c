# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Classes by tolerance, at and around every limit."""

from __future__ import annotations

import numpy as np
import pytest
from architectural_curvature.addon.geometry.classification import (
    PointType,
    SurfaceClass,
    classify,
)
from hypothesis import given, settings
from hypothesis import strategies as st

FLAT, SINGLE = SurfaceClass.FLAT, SurfaceClass.SINGLE
ELLIPTIC, HYPERBOLIC = SurfaceClass.ELLIPTIC, SurfaceClass.HYPERBOLIC
UNDEFINED = SurfaceClass.UNDEFINED

LIMIT = 0.1
ABOVE = np.nextafter(LIMIT, 1.0)


def _class(k1: float, k2: float, limit: float = LIMIT) -> int:
    return int(classify(np.array([k1]), np.array([k2]), limit, np.array([True]))[0])


@pytest.mark.parametrize(
    ("k1", "k2", "expected"),
    [
        (0.0, 0.0, FLAT),
        (LIMIT, LIMIT, FLAT),
        (LIMIT, -LIMIT, FLAT),
        (ABOVE, 0.0, SINGLE),
        (ABOVE, LIMIT, SINGLE),
        (ABOVE, -LIMIT, SINGLE),
        (0.0, -ABOVE, SINGLE),
        (LIMIT, -ABOVE, SINGLE),
        (ABOVE, ABOVE, ELLIPTIC),
        (-ABOVE, -ABOVE, ELLIPTIC),
        (2.0, 1.0, ELLIPTIC),
        (-1.0, -2.0, ELLIPTIC),
        (ABOVE, -ABOVE, HYPERBOLIC),
        (2.0, -1.0, HYPERBOLIC),
    ],
)
def test_every_limit_is_still_within_tolerance(
    k1: float, k2: float, expected: SurfaceClass
) -> None:
    assert _class(k1, k2) == expected


def test_where_curvature_means_nothing_there_is_no_class() -> None:
    values = np.array([0.0, 1.0, 1.0])
    assert classify(values, -values, LIMIT, np.zeros(3, dtype=bool)).tolist() == [UNDEFINED] * 3


def test_point_types_have_the_numbers_of_classes() -> None:
    assert [int(t) for t in PointType] == [int(c) for c in SurfaceClass] == [-1, 0, 1, 2, 3]


@settings(deadline=None, derandomize=True, database=None)
@given(st.floats(-2, 2), st.floats(-2, 2), st.floats(1e-3, 1.0))
def test_classes_do_not_depend_on_the_side_of_the_normals(a: float, b: float, limit: float) -> None:
    assert _class(max(a, b), min(a, b), limit) == _class(-min(a, b), -max(a, b), limit)


@settings(deadline=None, derandomize=True, database=None)
@given(st.floats(-2, 2), st.floats(-2, 2), st.floats(1e-3, 1.0), st.integers(-20, 20))
def test_classes_do_not_depend_on_units(a: float, b: float, limit: float, power: int) -> None:
    unit = 2.0**power
    assert _class(a, b, limit) == _class(a * unit, b * unit, limit * unit)


@settings(deadline=None, derandomize=True, database=None)
@given(st.floats(-2, 2), st.floats(-2, 2), st.floats(1e-3, 1.0), st.floats(1.0, 4.0))
def test_a_looser_tolerance_never_bends_a_panel_more(
    a: float, b: float, limit: float, factor: float
) -> None:
    bends = {FLAT: 0, SINGLE: 1, ELLIPTIC: 2, HYPERBOLIC: 2}
    tight, loose = (SurfaceClass(_class(a, b, limit * f)) for f in (1.0, factor))
    assert bends[loose] <= bends[tight]
