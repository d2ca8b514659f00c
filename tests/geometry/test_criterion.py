# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Limits in the terms of a designer decide the classes."""

from __future__ import annotations

import numpy as np
import pytest
from architectural_curvature.addon.geometry.cleaning.likelihood import class_costs
from architectural_curvature.addon.geometry.criterion import (
    Criterion,
    classify_by,
    panel_criterion,
    radius_criterion,
    raw_criterion,
    resolve_criterion,
)
from architectural_curvature.addon.geometry.errors import InvalidSettingError
from architectural_curvature.addon.geometry.settings import CriterionKind, SegmentationSettings
from architectural_curvature.addon.geometry.tolerance import Tolerance

ALL = np.ones(4, dtype=np.bool_)


def test_a_radius_is_the_limit_of_the_panel_that_deviates_as_much() -> None:
    panel = panel_criterion(Tolerance(1.5, 0.005))
    radius = radius_criterion(1.5**2 / (8 * 0.005), 1.5)
    assert radius.curvature_limit == pytest.approx(panel.curvature_limit, rel=1e-12)
    assert radius.tolerance.deviation == pytest.approx(0.005, rel=1e-12)


def test_raw_limits_look_at_gaussian_and_mean_curvature() -> None:
    k1, k2 = np.array([0.05, 1.0, 1.0, 1.0]), np.array([0.0, 0.0, 1.0, -1.0])
    assert classify_by(k1, k2, raw_criterion(0.01, 0.1, 1.0), ALL).tolist() == [0, 1, 2, 3]
    # Strongly curved one way, hardly the other: K tells more than the smaller curvature.
    k1, k2 = np.full(4, 10.0), np.full(4, 0.05)
    assert (classify_by(k1, k2, raw_criterion(0.1, 0.1, 1.0), ALL) == 2).all()
    assert (classify_by(k1, k2, radius_criterion(10.0, 1.0), ALL) == 1).all()


@pytest.mark.parametrize(
    "criterion", [radius_criterion(10.0, 1.0), raw_criterion(0.01, 0.1, 1.0)], ids=["k", "KH"]
)
def test_the_most_probable_class_is_that_of_the_limits(criterion: Criterion) -> None:
    rng = np.random.default_rng(0)
    k1, k2 = (rng.choice([-1, 1], 400) * 10.0 ** rng.uniform(-3, 1, 400) for _ in range(2))
    cost = class_costs(k1, k2, np.full(400, 1e-4), criterion)
    exact = classify_by(k1, k2, criterion, np.ones(400, dtype=np.bool_))
    assert cost.min() == 0.0
    # Within a few percent of a limit the class is open.
    clear = np.sort(cost, axis=1)[:, 1] > 1.0
    assert clear.mean() > 0.9
    assert (cost.argmin(axis=1) == exact)[clear].all()


def test_settings_without_values_take_those_of_the_model() -> None:
    criterion = resolve_criterion(SegmentationSettings(), 20.0)
    assert criterion == panel_criterion(Tolerance(1.0, 0.005))


def test_settings_name_the_limits_that_count() -> None:
    radius = SegmentationSettings(criterion=CriterionKind.RADIUS, smallest_radius=4.0)
    assert resolve_criterion(radius, 20.0).curvature_limit == pytest.approx(0.25, rel=1e-12)
    raw = SegmentationSettings(
        criterion=CriterionKind.RAW, gaussian_limit=0.02, mean_limit=0.3, panel_size=2.0
    )
    found = resolve_criterion(raw, 20.0)
    assert found.gaussian_limit == 0.02
    assert found.curvature_limit == pytest.approx(0.3, rel=1e-12)
    assert found.tolerance.panel_size == 2.0


@pytest.mark.parametrize("kind", [CriterionKind.RADIUS, CriterionKind.RAW])
def test_limits_that_are_missing_are_asked_for(kind: CriterionKind) -> None:
    with pytest.raises(InvalidSettingError, match="must be greater than zero, not 0"):
        resolve_criterion(SegmentationSettings(criterion=kind), 20.0)


def test_a_criterion_says_itself_in_words() -> None:
    words = panel_criterion(Tolerance(1.5, 0.005)).words
    assert words == "single-curved: within 5 mm of a cylinder over a 1.5 m panel"
    assert radius_criterion(4.0, 1.0).words == "straight: radius of at least 4 m"
    assert "|K| at most 0.02 1/m²" in raw_criterion(0.02, 0.3, 1.0).words
