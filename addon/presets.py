# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The presets that ship with the extension, made known to Blender."""

from __future__ import annotations

from importlib import resources
from pathlib import Path

import bpy


def _folder() -> str:
    """Return the folder in which Blender finds our `presets`."""
    return str(Path(str(resources.files(__package__))).parent / "assets")


def register() -> None:
    """Let Blender's menus of presets look into our folder, too."""
    bpy.utils.register_preset_path(_folder())


def unregister() -> None:
    """Take the folder away again."""
    bpy.utils.unregister_preset_path(_folder())
