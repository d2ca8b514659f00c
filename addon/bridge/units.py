# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lengths and areas in meters, and as texts in the units of a scene."""

from __future__ import annotations

import bpy
from bpy.types import Scene


def meters_per_unit(scene: Scene) -> float:
    """Return the length of one Blender unit in meters."""
    return float(scene.unit_settings.scale_length)


def length_text(scene: Scene, meters: float) -> str:
    """Return a length as the scene's unit system writes it, with three or four digits."""
    return _text(scene, "LENGTH", meters)


def area_text(scene: Scene, square_meters: float) -> str:
    """Return an area as the scene's unit system writes it, with three or four digits."""
    return _text(scene, "AREA", square_meters)


def _text(scene: Scene, category: str, value: float) -> str:
    system = scene.unit_settings.system
    return bpy.utils.units.to_string(
        "METRIC" if system == "NONE" else system, category, float(f"{value:.3g}"), precision=3
    )
