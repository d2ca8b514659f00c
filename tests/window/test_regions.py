# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""In a real window: regions are listed, selected by mouse and outlined."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from played import Played


@pytest.fixture
def played(play: Callable[..., Played], models: Path) -> Played:
    return play("regions", str(models / "pavilion.obj"))


def test_button_selects_the_region_chosen_in_the_list(played: Played) -> None:
    assert played.record["selected"] == played.record["listed"] > 0


def test_zoom_moves_the_view(played: Played) -> None:
    box = tuple(played.record["view"])
    before, after = (played.part(name, box)[:, :700] for name in ("listed", "zoomed"))
    assert (np.abs(before - after).sum(axis=-1) > 40).mean() > 0.1


def test_borders_are_drawn(played: Played) -> None:
    assert played.record["borders"] == played.record["splines"] > 0
    box = tuple(played.record["view"])
    before, after = (played.part(name, box)[:, :700] for name in ("listed", "outlined"))
    darker = (before.max(axis=-1).astype(int) - after.max(axis=-1).astype(int)) > 60
    assert darker.sum() > 500
