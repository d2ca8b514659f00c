# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Menu of the presets, as Blender's own menus of presets are."""

from __future__ import annotations

from bpy.types import Context, Menu

from ..preset_text import PRESET_FOLDER


class CURVATURE_MT_presets(Menu):
    """Materials with the radius that they bend to, and what users saved."""

    bl_idname = "CURVATURE_MT_presets"
    bl_label = "Presets"
    preset_subdir = PRESET_FOLDER
    preset_operator = "script.execute_preset"

    def draw(self, context: Context) -> None:
        """List the files of presets."""
        self.draw_preset(context)
