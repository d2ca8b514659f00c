# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""In a real window, by mouse: lines are shown under the mouse, kept by a click, gone after Esc."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from played import Played


@pytest.fixture
def played(play: Callable[..., Played], models: Path) -> Played:
    return play("picking", str(models / "torus.obj"))


def _colored(played: Played, name: str) -> int:
    """Return how many pixels of the viewport are red or blue, left of the sidebar."""
    picture = played.part(name, tuple(played.record["view"]))[:, :900]
    red, green, blue = (picture[..., i] for i in range(3))
    is_red = (red > green + 60) & (red > blue + 60)
    is_blue = (blue > green + 40) & (blue > red + 60)
    return int((is_red | is_blue).sum())


def test_lines_are_shown_under_the_mouse(played: Played) -> None:
    assert _colored(played, "preview") > _colored(played, "ended") // 4
    assert _colored(played, "preview") > 300


def test_click_keeps_them_and_esc_ends(played: Played) -> None:
    kept = [name for name in played.record["objects"] if "Picked Lines" in name]
    assert len(kept) == 2
    # The lines under the mouse that nobody clicked are gone.
    assert _colored(played, "ended") < _colored(played, "second")


def test_button_traces_lines(played: Played) -> None:
    name = played.record["source"]
    assert {f"{name} Lines 1", f"{name} Lines 2"} <= set(played.record["traced"])
    assert np.ptp(played.picture("traced")) > 100
