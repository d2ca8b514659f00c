# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Save and remove presets of the criterion."""

from __future__ import annotations

from pathlib import Path

import bpy
from bl_operators.presets import AddPresetBase
from bpy.props import BoolProperty, StringProperty
from bpy.types import Context, Operator

from ..addon import polls
from ..addon.bridge.numbers import as_typed
from ..addon.preset_text import LIMITS, PRESET_FOLDER, preset_text


class CURVATURE_OT_preset_add(AddPresetBase, Operator):
    """Save the criterion as a preset, or remove a preset."""

    bl_idname = "curvature.preset_add"
    bl_label = "Add Criterion Preset"
    bl_description = "Save the criterion and its limits as a preset, or remove one of your own"
    # Files stay when their making is undone.
    bl_options = {"REGISTER", "INTERNAL"}
    preset_menu = "CURVATURE_MT_presets"
    preset_subdir = PRESET_FOLDER

    name: StringProperty(
        name="Name",
        description="Name of the preset in the menu",
        maxlen=64,
        options={"SKIP_SAVE"},
    )
    source: StringProperty(
        name="Source",
        description="Where the limits are from, as panel and reports will say",
        options={"SKIP_SAVE"},
    )
    remove_name: BoolProperty(
        name="Remove by Name",
        description="Remove the preset of this name",
        default=False,
        options={"HIDDEN", "SKIP_SAVE"},
    )
    remove_active: BoolProperty(
        name="Remove Active",
        description="Remove the preset that was chosen last",
        default=False,
        options={"HIDDEN", "SKIP_SAVE"},
    )

    @classmethod
    def poll(cls, context: Context) -> bool:
        """Ask for a scene, which has the criterion."""
        return polls.has_scene(cls, context)

    def execute(self, context: Context) -> set[str]:
        """Save what is complete, or remove."""
        settings = context.scene.curvature
        is_removing = self.remove_name or self.remove_active
        if not is_removing and settings.criterion != "PANEL" and not all(_limits(context).values()):
            self.report({"ERROR"}, "Set the limits of the criterion first")
            return {"CANCELLED"}
        result = AddPresetBase.execute(self, context)
        if is_removing and "FINISHED" in result:
            settings.criterion_preset = settings.criterion_source = ""
        return result

    def add(self, context: Context, filepath: str) -> None:
        """Write the preset's file; Blender has found its place."""
        settings = context.scene.curvature
        name = bpy.path.display_name(filepath, title_case=False)
        text = preset_text(settings.criterion, _limits(context), name, self.source)
        Path(filepath).write_text(text, encoding="utf-8")
        settings.criterion_preset, settings.criterion_source = name, self.source


def _limits(context: Context) -> dict[str, float]:
    settings = context.scene.curvature
    return {name: as_typed(getattr(settings, name)) for name in LIMITS[settings.criterion]}
