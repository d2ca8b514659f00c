# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lengths and areas in meters, and as texts in the units of a scene."""

from __future__ import annotations

import bpy
from bpy.types import Scene

_FOOT = 0.3048


def meters_per_unit(scene: Scene) -> float:
    """Return the length of one Blender unit in meters."""
    return float(scene.unit_settings.scale_length)


def length_text(scene: Scene, meters: float) -> str:
    """Return a length as the scene's unit system writes it, with three or four digits."""
    return _text(scene, "LENGTH", meters, _FOOT)


def area_text(scene: Scene, square_meters: float) -> str:
    """Return an area as the scene's unit system writes it, with three or four digits."""
    return _text(scene, "AREA", square_meters, _FOOT**2)


def _text(scene: Scene, category: str, value: float, imperial_unit: float) -> str:
    system = scene.unit_settings.system
    # Digits are those of what is shown: 1.524 m are 5 ft, and 1.52 m are not.
    unit = imperial_unit if system == "IMPERIAL" else 1.0
    return bpy.utils.units.to_string(
        "METRIC" if system == "NONE" else system,
        category,
        float(f"{value / unit:.3g}") * unit,
        precision=3,
    )
