# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""In a real window, by mouse: classes and legend on the screen, curvature, selection, undo."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from played import Played

#: Hue in degrees of the class colors, which studio light darkens but does not turn.
HUES = {"SINGLE": 201.0, "ELLIPTIC": 41.0, "HYPERBOLIC": 327.0}


@pytest.fixture
def played(play: Callable[..., Played], models: Path) -> Played:
    return play("designing", str(models / "pavilion.obj"))


def hue(picture: np.ndarray) -> np.ndarray:
    """Return the hue of every pixel in degrees, -1 where it has hardly any."""
    red, green, blue = (picture[..., i].astype(float) for i in range(3))
    high, spread = picture.max(axis=-1), np.ptp(picture, axis=-1).astype(float)
    safe = np.maximum(spread, 1.0)
    angle = np.where(
        high == red,
        (green - blue) / safe % 6,
        np.where(high == green, (blue - red) / safe + 2, (red - green) / safe + 4),
    )
    return np.where(spread > 50, 60.0 * angle, -1.0)


def test_every_class_has_its_color_on_the_screen(played: Played) -> None:
    box = tuple(played.record["view"])
    before, after = hue(played.part("before", box)), hue(played.part("classes", box))
    for name, degrees in HUES.items():
        near = [(np.abs(seen - degrees) < 12).sum() for seen in (before, after)]
        assert near[1] - near[0] > 4000, name
    assert played.record["color_type"] == "VERTEX"


def test_shares_add_up(played: Played) -> None:
    assert sum(played.record["shares"].values()) == pytest.approx(1.0, abs=1e-6)


def test_legend_fills_one_box_and_nothing_else(played: Played) -> None:
    assert played.record["legend_after_press"] is False
    box = tuple(played.record["view"])
    # The right side is the sidebar, where the check box changes as well.
    with_key, without = (played.part(name, box)[:, :700] for name in ("classes", "no_legend"))
    rows, columns = np.nonzero(np.abs(with_key - without).sum(axis=-1) > 40)
    height = with_key.shape[0]
    inside = (columns < 340) & (rows > height - 330)
    assert inside.sum() > 15000
    # A few stray pixels differ elsewhere: the viewport refines its anti-aliasing over time.
    elsewhere = with_key.shape[0] * with_key.shape[1] - 340 * 330
    assert (~inside).sum() < 0.02 * elsewhere


def test_analyze_shows_gaussian_curvature(played: Played) -> None:
    assert played.record["active_colors"] == "Gaussian Curvature"
    assert played.record["limit"] > 0.0
    box = tuple(played.record["view"])
    classes, curvature = played.part("classes", box), played.part("gaussian", box)
    assert (np.abs(classes - curvature).sum(axis=-1) > 40).sum() > 20000


def test_arrow_of_a_class_selects_its_faces_in_edit_mode(played: Played) -> None:
    assert played.record["selected"] == played.record["flat"] > 0


def test_undo_brings_the_classes_back(played: Played) -> None:
    box = tuple(played.record["view"])
    after = hue(played.part("undone", box))
    for name, degrees in HUES.items():
        assert (np.abs(after - degrees) < 12).sum() > 4000, name
