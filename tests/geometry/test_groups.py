# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Groups of connected items."""

from __future__ import annotations

import numpy as np
from architectural_curvature.addon.geometry.groups import connected_groups, sum_by_group


def test_groups_are_numbered_by_their_first_item() -> None:
    pairs = np.array([[5, 1], [3, 0], [1, 4]])
    assert connected_groups(pairs, 6).tolist() == [0, 1, 2, 0, 1, 1]


def test_without_links_every_item_is_a_group() -> None:
    assert connected_groups(np.empty((0, 2), dtype=np.int64), 3).tolist() == [0, 1, 2]


def test_sums_have_an_entry_for_every_group() -> None:
    total = sum_by_group(np.array([0, 2, 0]), np.array([1.0, 2.0, 4.0]), 4)
    assert total.tolist() == [5.0, 0.0, 2.0, 0.0]
    assert sum_by_group(np.empty(0, dtype=np.int64), np.empty(0), 2).tolist() == [0.0, 0.0]
