# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Why a model has no lines, in words."""

from __future__ import annotations

import numpy as np
from bpy.types import Scene

from ..bridge import units
from ..geometry.lines.endings import PARABOLIC
from .fields import Field


def absence(field: Field, scene: Scene, *, is_asymptotic: bool = False) -> str:
    """Return why no lines were traced on an object.

    Parameters
    ----------
    field : Field
    scene : Scene
    is_asymptotic : bool
        Whether lines without normal curvature were asked for.

    Returns
    -------
    str
        Begins with the name of the object.
    """
    name = field.subject.source.name
    if (field.lines.umbilics.triangle_area >= 0).all():
        return f"{name} is flat or spherical everywhere, where there are no directions to follow"
    if is_asymptotic and not _has_saddle(field):
        return f"{name} is a saddle nowhere, and only saddles have asymptotic lines"
    spacing = units.length_text(scene, field.sizes.spacing)
    return f"{name} has no room for lines {spacing} apart: take a smaller spacing"


def _has_saddle(field: Field) -> bool:
    """Return whether asymptotic lines do not end as soon as they start."""
    directions = field.lines.field
    balance = np.abs(directions.mean) / np.maximum(directions.strength, 1e-300)
    return bool((balance < np.sqrt(1.0 - PARABOLIC**2)).any())
