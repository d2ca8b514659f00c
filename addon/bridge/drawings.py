# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Curve objects as drawings for other programs."""

from __future__ import annotations

import numpy as np
from bpy.types import Object, Scene

from ..export.drawing import Drawing, Layer, Polyline
from ..geometry.display.colormap import srgb_from_linear
from .companions import ROLES, companions
from .curves import polylines
from .units import meters_per_unit

LINE_ROLES = tuple(role for role in ROLES if "LINES" in role or "ASYMPTOTIC" in role)
"""Roles of the objects that show lines of curvature."""

DRAWN_ROLES = (*LINE_ROLES, "BORDERS", "PARABOLIC")
"""Roles of the objects that drawings show."""


def drawing_of(sources: list[Object], scene: Scene) -> Drawing:
    """Return the curves of models, a layer per role, in world coordinates and meters."""
    layers = []
    for role in DRAWN_ROLES:
        objects = [each for source in sources for each in companions(source, (role,))]
        lines = [Polyline(*line) for obj in objects for line in polylines(obj, scene)]
        if lines:
            thickness = 2.0 * objects[0].data.bevel_depth * meters_per_unit(scene)
            red, green, blue = srgb_from_linear(np.array(ROLES[role].color)).tolist()
            layers.append(Layer(ROLES[role].ending, (red, green, blue), thickness, tuple(lines)))
    return Drawing(", ".join(source.name for source in sources), tuple(layers))
