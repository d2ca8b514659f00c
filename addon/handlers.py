# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Handlers of Blender's events."""

from __future__ import annotations

import bpy
from bpy.app.handlers import persistent

from .bridge import cache


@persistent
def _forget(*_arguments: object) -> None:
    """Let go of analyses of the file that was open before."""
    cache.clear()


def register() -> None:
    """Listen to the loading of files."""
    bpy.app.handlers.load_post.append(_forget)


def unregister() -> None:
    """Stop listening, and let go of what was kept."""
    bpy.app.handlers.load_post.remove(_forget)
    cache.clear()
