# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sentences broken into lines that fit a sidebar."""

from __future__ import annotations

import textwrap

from bpy.types import Context

_PIXELS_PER_LETTER = 6.6
_ICON_AND_MARGINS = 56.0
#: Of a sidebar, for panels that are drawn without a window.
_USUAL_WIDTH = 280.0


def wrap(sentence: str, context: Context) -> list[str]:
    """Return the lines of a sentence for the width of the region at hand."""
    # Without a window, Blender has no region and no scale yet.
    scale = context.preferences.system.ui_scale or 1.0
    region = context.region
    width = region.width if region else _USUAL_WIDTH * scale
    letters = (width / scale - _ICON_AND_MARGINS) / _PIXELS_PER_LETTER
    return textwrap.wrap(sentence, max(int(letters), 16))
