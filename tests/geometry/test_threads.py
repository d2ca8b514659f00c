# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Parts on several threads come back in their order, and what one raises ends all."""

from __future__ import annotations

import time
from dataclasses import dataclass

import numpy as np
import pytest
from architectural_curvature.addon.geometry.threads import in_parallel, joined
from numpy.typing import NDArray


@dataclass(frozen=True)
class _Values:
    one: NDArray[np.float64]
    rows: NDArray[np.float64]


def test_results_come_in_the_order_of_the_parts() -> None:
    def slow_at_first(part: int) -> int:
        time.sleep(0.02 if part == 0 else 0.0)
        return part * part

    assert in_parallel(slow_at_first, range(5)) == [0, 1, 4, 9, 16]


def test_what_a_part_raises_is_raised() -> None:
    def work(part: int) -> int:
        if part == 2:
            raise KeyboardInterrupt
        return part

    with pytest.raises(KeyboardInterrupt):
        in_parallel(work, range(5))


def test_parts_are_joined_along_their_last_axis() -> None:
    whole = joined([_Values(np.zeros(many), np.ones((3, many))) for many in (2, 0, 5)])
    assert whole.one.shape == (7,)
    assert whole.rows.shape == (3, 7)
