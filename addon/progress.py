# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Progress shown at the mouse pointer while an operator works."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from bpy.types import WindowManager

from .geometry.types import Progress

_STEPS = 1000


@contextmanager
def progress(window_manager: WindowManager) -> Iterator[Progress]:
    """Give a function that takes the share of the work that is done, 0 to 1."""
    window_manager.progress_begin(0, _STEPS)
    try:
        yield lambda share: window_manager.progress_update(round(share * _STEPS))
    finally:
        window_manager.progress_end()
