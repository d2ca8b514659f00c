# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What is drawn over the viewport: the legend of the colors."""

from __future__ import annotations

from bpy.types import SpaceView3D

from . import preview
from .legend import draw_legend

_handles: list[object] = []


def enable() -> None:
    """Draw the legend in every 3D viewport from now on; does nothing where it is drawn."""
    if not _handles:
        _handles.append(SpaceView3D.draw_handler_add(draw_legend, (), "WINDOW", "POST_PIXEL"))


def disable() -> None:
    """Stop drawing; does nothing where nothing is drawn."""
    preview.hide()
    while _handles:
        SpaceView3D.draw_handler_remove(_handles.pop(), "WINDOW")


def is_enabled() -> bool:
    """Return whether the legend is drawn."""
    return bool(_handles)


register, unregister = enable, disable
