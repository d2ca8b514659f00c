# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""From the coordinates of an object to meters."""

from __future__ import annotations

import numpy as np
from bpy.types import Object, Scene

from ..geometry.errors import InvalidMeshError
from ..geometry.types import Floats
from .units import meters_per_unit

#: A direction that an object's scale shrinks below this share of the largest one is lost.
_FLATTENED = 1e-9


def meters_from_object(obj: Object, scene: Scene) -> Floats:
    """Return the matrix that gives an object's coordinates their true lengths in meters.

    It is the symmetric part S = (MᵀM)^½ of the object's world matrix M = R S. The rotation does
    not matter for curvature. A mirrored object keeps the winding of its faces, for Blender turns
    their normals outward again as well.

    Parameters
    ----------
    obj : Object
    scene : Scene
        Gives the length of a Blender unit.

    Returns
    -------
    (3, 3) float64

    Raises
    ------
    InvalidMeshError
        If the scale of the object is zero along some direction.
    """
    world = np.array(obj.matrix_world, dtype=np.float64)[:3, :3] * meters_per_unit(scene)
    if not np.isfinite(world).all():
        raise InvalidMeshError("the transform of the object is not finite: reset its scale")
    _, stretch, axes = np.linalg.svd(world)
    if stretch[2] <= _FLATTENED * stretch[0]:
        raise InvalidMeshError("the scale of the object is zero along an axis: reset its scale")
    return (axes.T * stretch) @ axes
