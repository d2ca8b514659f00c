# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the mouse points at."""

from __future__ import annotations

import numpy as np
from bpy.types import Context, Object
from bpy_extras.view3d_utils import region_2d_to_origin_3d, region_2d_to_vector_3d
from mathutils import Vector

from ..geometry.types import Floats
from .evaluation import evaluated_object


def pointed_at(context: Context, pixel: tuple[int, int], obj: Object) -> Floats | None:
    """Return the place in the world that a pixel of the region shows of an object, None if none."""
    region, view = context.region, context.region_data
    is_inside = 0 <= pixel[0] < region.width and 0 <= pixel[1] < region.height
    if view is None or not is_inside:
        return None
    origin = region_2d_to_origin_3d(region, view, pixel)
    direction = region_2d_to_vector_3d(region, view, pixel)
    return cast_ray(context, origin, direction, obj)


def cast_ray(context: Context, origin: Vector, direction: Vector, obj: Object) -> Floats | None:
    """Return the place in the world where a ray meets an object, None where it does not."""
    into = obj.matrix_world.inverted_safe()
    start = into @ origin
    towards = (into.to_3x3() @ direction).normalized()
    with evaluated_object(obj, context.evaluated_depsgraph_get()) as evaluated:
        is_hit, place, _, _ = evaluated.ray_cast(start, towards)
    return np.array(obj.matrix_world @ place, dtype=np.float64) if is_hit else None
