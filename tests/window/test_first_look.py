# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""In a real window the extension's tab is there, and its button works when pressed by mouse."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from played import Played


@pytest.fixture
def played(play: Callable[..., Played], models: Path) -> Played:
    return play("first_look", str(models / "pavilion.obj"))


def test_no_picture_is_blank(played: Played) -> None:
    for name in ("opened", "sidebar", "segmented"):
        picture = played.picture(name)
        assert len(np.unique(picture.reshape(-1, 3), axis=0)) > 200


def test_tab_is_shown(played: Played) -> None:
    assert played.record["tab"] == "Curvature"
    x, y, width, height = played.record["sidebar"]
    box = (x, y, width, height)
    before, after = played.part("opened", box), played.part("sidebar", box)
    assert (np.abs(before - after).sum(axis=-1) > 40).sum() > 2000


def test_pressing_the_button_colors_the_model(played: Played) -> None:
    box = tuple(played.record["view"])
    before, after = played.part("sidebar", box), played.part("segmented", box)
    spread = [np.ptp(picture, axis=-1) > 60 for picture in (before, after)]
    assert spread[1].sum() > spread[0].sum() + 5000
