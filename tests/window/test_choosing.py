# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""In a real window, by mouse: a material from the menu decides, and one's own is saved."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from played import Played


@pytest.fixture
def played(play: Callable[..., Played], models: Path) -> Played:
    return play("choosing", str(models / "pavilion.obj"))


def changed(played: Played, before: str, after: str) -> int:
    """Return how many pixels differ between two pictures."""
    pictures = [played.picture(name).astype(int) for name in (before, after)]
    return int((np.abs(pictures[0] - pictures[1]).sum(axis=-1) > 40).sum())


def test_the_menu_opens_over_the_panel(played: Played) -> None:
    assert changed(played, "panel", "menu") > 20000


def test_the_preset_decides(played: Played) -> None:
    assert played.record["preset"] == played.record["expected"]
    assert played.record["criterion"] == "RADIUS"


def test_saving_asks_for_a_name(played: Played) -> None:
    assert changed(played, "classes", "dialog") > 5000


def test_a_preset_of_ones_own_is_shown(played: Played) -> None:
    assert played.record["saved"] == "North Roof"
    assert changed(played, "classes", "saved") > 200
