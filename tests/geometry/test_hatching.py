# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Strokes are as dense as the tone asks for, and lie on the lines."""

from __future__ import annotations

import numpy as np
import pytest
from architectural_curvature.addon.geometry.hatching import (
    curvature_tone,
    hatch,
    shade_tone,
)
from architectural_curvature.addon.geometry.lines.field import Family
from architectural_curvature.addon.geometry.lines.lines import CurvatureLines

SPACING = 0.1


@pytest.fixture(scope="module")
def grid() -> CurvatureLines:
    """Two families of straight lines over a square of 4 m."""
    count = round(4.0 / SPACING) + 1
    along, across = np.meshgrid(np.linspace(0.0, 4.0, 161), np.linspace(0.0, 4.0, count))
    one = np.stack([along, across, np.zeros_like(along)], axis=2).reshape(-1, 3)
    points = np.concatenate([one, one[:, [1, 0, 2]]])
    return CurvatureLines(
        points=points,
        triangle=np.zeros(len(points), dtype=np.int64),
        barycentric=np.zeros((len(points), 3)),
        start=np.arange(0, len(points) + 1, 161),
        family=np.repeat([Family.FIRST, Family.SECOND], count).astype(np.int64),
        ends=np.ones((2 * count, 2), dtype=np.int64),
    )


def test_darker_tones_have_more_strokes(grid: CurvatureLines) -> None:
    lengths = [
        hatch(grid, np.full(len(grid.points), tone), SPACING).lengths.sum()
        for tone in (0.0, 0.2, 0.4, 0.55, 0.7, 0.8, 1.0)
    ]
    assert lengths[0] == 0.0
    assert np.diff(lengths).min() > 0.0
    # All lines of both families but for the gaps between strokes.
    assert 0.85 * 2 * 41 * 4.0 < lengths[-1] <= 2 * 41 * 4.0
    # Every fourth line of the first family.
    assert 0.15 * 41 * 4.0 < lengths[1] < 0.35 * 41 * 4.0


def test_lines_of_a_rank_are_evenly_spaced(grid: CurvatureLines) -> None:
    strokes = hatch(grid, np.full(len(grid.points), 0.4), SPACING)
    rows = np.unique(np.round([line[0, 1] for line in strokes.lines], 6))
    gaps = np.diff(rows) / SPACING
    assert gaps.min() > 1.5
    assert gaps.max() < 4.5


def test_strokes_appear_only_where_it_is_dark(grid: CurvatureLines) -> None:
    strokes = hatch(grid, np.where(grid.points[:, 0] > 2.0, 1.0, 0.0), SPACING)
    assert min(line[:, 0].min() for line in strokes.lines) > 2.0


def test_widths_taper_and_lengths_are_true(grid: CurvatureLines) -> None:
    strokes = hatch(grid, np.full(len(grid.points), 1.0), SPACING)
    for line, width, length in zip(strokes.lines, strokes.widths, strokes.lengths, strict=True):
        assert len(line) == len(width)
        assert width[0] == width[-1] == pytest.approx(0.25)
        assert width.max() <= 1.0
        np.testing.assert_allclose(np.linalg.norm(line[-1] - line[0]), length)


def test_same_seed_gives_the_same_strokes(grid: CurvatureLines) -> None:
    tone = np.full(len(grid.points), 0.6)
    one, two = hatch(grid, tone, SPACING), hatch(grid, tone, SPACING)
    np.testing.assert_array_equal(one.lengths, two.lengths)


def test_tones_are_between_0_and_1() -> None:
    class Ball:
        normal = np.array([[0.0, 0.0, 1.0], [0.0, 0.0, -1.0], [1.0, 0.0, 0.0]])

    tone = shade_tone(Ball(), np.array([0.0, 0.0, 5.0]))
    np.testing.assert_allclose(tone, [0.0, 1.0, 0.9])
    assert curvature_tone(np.zeros(3), np.zeros(3)).max() == 0.0
    tone = curvature_tone(np.linspace(0.0, 1.0, 101), np.linspace(0.0, -2.0, 101))
    assert tone.min() == 0.0
    assert tone.max() == 1.0
