# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A model of the command line, read into a scene with the settings of the command line."""

from __future__ import annotations

import math
from argparse import Namespace
from pathlib import Path

import bpy
from bpy.types import Object

from ..bridge import importing
from .streams import silent_importers


def load(model: Path, options: Namespace) -> list[Object]:
    """Read a model, and return its mesh objects.

    Raises
    ------
    ImportRefusedError
        If it cannot be read.
    """
    with silent_importers():
        objects = importing.load_model(bpy.context, model, options.up)
    _apply_settings(options)
    return objects


def _apply_settings(options: Namespace) -> None:
    scene = bpy.context.scene
    if options.meters_per_unit:
        scene.unit_settings.scale_length = options.meters_per_unit
    settings = scene.curvature
    settings.panel_size = options.panel_size
    settings.deviation = options.deviation
    settings.criterion = options.criterion.name
    settings.smallest_radius = options.smallest_radius
    settings.gaussian_limit = options.gaussian_limit
    settings.mean_limit = options.mean_limit
    settings.min_area = options.min_area
    settings.crease_angle = math.radians(options.crease_angle)
    settings.flip_normals = options.flip_normals
    smoothing, settings.smoothing_length = options.smoothing
    settings.smoothing = smoothing.name
    settings.color_map = options.color_map
    if options.range:
        settings.range_mode = "FIXED"
        settings.range_limit = options.range
