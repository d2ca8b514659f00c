# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Settings that make no sense are refused in words."""

from __future__ import annotations

import math

import pytest
from architectural_curvature.addon.geometry.errors import InvalidSettingError
from architectural_curvature.addon.geometry.settings import (
    AnalysisSettings,
    SegmentationSettings,
)


@pytest.mark.parametrize("angle", [0.0, -0.1, 3.2, math.nan, math.inf])
def test_angles_that_no_fold_has_are_refused(angle: float) -> None:
    with pytest.raises(InvalidSettingError, match="above 0 and at most 180 degrees, not"):
        AnalysisSettings(crease_angle=angle)


def test_the_largest_angle_is_180_degrees() -> None:
    assert AnalysisSettings(crease_angle=math.pi).crease_angle == math.pi


@pytest.mark.parametrize("value", [-1e-9, math.nan, math.inf])
@pytest.mark.parametrize("name", ["panel_size", "deviation", "min_area"])
def test_sizes_below_zero_are_refused_by_name(name: str, value: float) -> None:
    message = f"the {name.replace('_', ' ')} must not be negative"
    with pytest.raises(InvalidSettingError, match=message):
        SegmentationSettings(**{name: value})


def test_without_arguments_all_sizes_are_defaults() -> None:
    assert SegmentationSettings() == SegmentationSettings(0.0, 0.0, 0.0)
