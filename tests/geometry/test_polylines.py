# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Segments are chained into curves."""

from __future__ import annotations

import numpy as np
from architectural_curvature.addon.geometry.outlines.polylines import chain_segments


def test_an_open_path_in_any_order() -> None:
    points = np.c_[np.arange(6.0), np.zeros(6), np.zeros(6)]
    segments = np.array([[3, 2], [0, 1], [4, 5], [1, 2], [3, 4]])
    curves = chain_segments(segments, points)
    assert curves.is_closed.tolist() == [False]
    assert curves.lengths.tolist() == [5.0]
    assert curves.source.tolist() in ([0, 1, 2, 3, 4, 5], [5, 4, 3, 2, 1, 0])


def test_loops_and_paths_together() -> None:
    turn = 2 * np.pi * np.arange(50) / 50
    loop = np.c_[np.cos(turn), np.sin(turn), 0 * turn]
    points = np.concatenate([loop, [[5.0, 0, 0], [6.0, 0, 0]]])
    segments = np.concatenate([np.c_[np.arange(50), (np.arange(50) + 1) % 50], [[50, 51]]])
    curves = chain_segments(np.random.default_rng(0).permutation(segments), points)
    assert curves.is_closed.tolist() == [True, False]
    np.testing.assert_allclose(curves.lengths, [100 * np.sin(np.pi / 50), 1.0], rtol=1e-12)


def test_curves_end_where_three_meet() -> None:
    points = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [-1, 0, 0]])
    curves = chain_segments(np.array([[0, 1], [0, 2], [3, 0]]), points)
    assert curves.is_closed.tolist() == [False] * 3


def test_no_segments_are_no_curves() -> None:
    curves = chain_segments(np.zeros((0, 2), dtype=np.int64), np.zeros((4, 3)))
    assert curves.count == 0
    assert curves.lengths.tolist() == []
