# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Presets of the criterion as the text of their files: those that ship, and those of users.

A preset is a Python file that Blender runs, as all its presets are.
"""

from __future__ import annotations

PRESET_FOLDER = "architectural_curvature"
"""Folder of the presets, below Blender's `presets` and below ours."""

LIMITS = {
    "PANEL": ("panel_size", "deviation"),
    "RADIUS": ("smallest_radius",),
    "RAW": ("gaussian_limit", "mean_limit"),
}
"""Settings that a preset of a criterion sets: a material says nothing about the panel's size."""


def preset_text(criterion: str, limits: dict[str, float], name: str, source: str) -> str:
    """Return the text of a preset's file.

    Parameters
    ----------
    criterion : str
        Key of `LIMITS`.
    limits : dict
        The limits of the criterion, in meters, 1/m and 1/m².
    name : str
        What the menu shows.
    source : str
        Where the limits are from; may be empty.
    """
    # Name and source come last: a limit that is set forgets the preset that was there before.
    values = {
        "criterion": criterion,
        **{key: limits[key] for key in LIMITS[criterion]},
        "criterion_preset": name,
        "criterion_source": source,
    }
    lines = [f"settings.{key} = {value!r}" for key, value in values.items()]
    return "\n".join(("import bpy", "settings = bpy.context.scene.curvature", "", *lines, ""))
