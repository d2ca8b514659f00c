# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""In a real window: long work leaves the window alive, and Esc ends it without a trace."""

from collections.abc import Callable

import numpy as np
import pytest
from played import Played


@pytest.fixture
def played(play: Callable[..., Played]) -> Played:
    return play("waiting")


def test_nothing_is_written_while_the_work_goes_on(played: Played) -> None:
    assert played.record["was_running"]
    assert played.record["attributes_while_running"] == []


def test_the_status_bar_tells_the_progress(played: Played) -> None:
    x, y, width, _ = played.record["view"]
    # Below the 3D view lie the timeline and the status bar.
    box = (x, 0, width, min(y, 24))
    before, running = (played.part(name, box) for name in ("before", "running"))
    assert (np.abs(before.astype(int) - running).sum(axis=-1) > 60).any()


def test_escape_leaves_everything_as_it_was(played: Played) -> None:
    assert played.record["attributes_after_escape"] == []
    assert played.record["colors_after_escape"] == []
    assert played.record["fingerprint_after_escape"] == ""
    box = tuple(played.record["view"])
    before, after = (played.part(name, box)[:, :700] for name in ("before", "cancelled"))
    assert (np.abs(before.astype(int) - after).sum(axis=-1) > 40).mean() < 0.02


def test_a_second_run_ends_and_can_be_undone(played: Played) -> None:
    box = tuple(played.record["view"])
    before, after = (played.part(name, box)[:, :700] for name in ("before", "finished"))
    assert (np.abs(before.astype(int) - after).sum(axis=-1) > 40).mean() > 0.05
    assert played.record["undone"]
