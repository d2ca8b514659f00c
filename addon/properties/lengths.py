# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lengths that are stored in meters and shown in a scene's units."""

from __future__ import annotations

from bpy.types import PropertyGroup

from ..bridge import units


def in_scene_units(name: str, dimension: int = 1) -> dict[str, object]:
    """Return accessors that show a length (or area, dimension 2) in meters in the scene's units."""

    def read(settings: PropertyGroup) -> float:
        return getattr(settings, name) / units.meters_per_unit(settings.id_data) ** dimension

    def write(settings: PropertyGroup, value: float) -> None:
        setattr(settings, name, value * units.meters_per_unit(settings.id_data) ** dimension)

    return {"get": read, "set": write}
