# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Names of regions stick across runs."""

from __future__ import annotations

import numpy as np
from architectural_curvature.addon.geometry.matching import carry_names, match_regions
from numpy.typing import NDArray

AREAS = np.ones(8)


def _regions(text: str) -> NDArray[np.int64]:
    return np.array(["-0123456789".index(letter) - 1 for letter in text])


def test_regions_that_share_most_are_the_same() -> None:
    assert match_regions(_regions("00011122"), _regions("11110022"), AREAS).tolist() == [1, 0, 2]


def test_a_region_is_continued_once_by_the_larger_part() -> None:
    assert match_regions(_regions("00000000"), _regions("00000111"), AREAS).tolist() == [0, -1]
    assert match_regions(_regions("00000111"), _regions("00000000"), AREAS).tolist() == [0]


def test_area_counts_and_not_the_number_of_faces() -> None:
    areas = np.array([10.0, 1, 1, 1, 1, 1, 1, 1])
    assert match_regions(_regions("00000000"), _regions("01111111"), areas).tolist() == [0, -1]


def test_what_has_nothing_in_common_is_new() -> None:
    assert match_regions(_regions("0000----"), _regions("----0000"), AREAS).tolist() == [-1]
    assert match_regions(_regions("0000----"), _regions("--------"), AREAS).tolist() == []


def test_names_go_with_their_regions_and_new_ones_are_free() -> None:
    names = carry_names(["Roof", "Region 1"], _regions("00000111"), _regions("11100222"), AREAS)
    assert names == ["Region 2", "Roof", "Region 1"]
