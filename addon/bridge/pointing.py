# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the mouse points to."""

from __future__ import annotations

import numpy as np
from bpy.types import Context
from bpy_extras.view3d_utils import region_2d_to_origin_3d, region_2d_to_vector_3d

from ..geometry.types import Floats


def ray_through(context: Context, pixel: tuple[int, int]) -> tuple[Floats, Floats] | None:
    """Return origin and direction in the world of the ray that a pixel of the region shows.

    Each (3,) float64; None where the pixel lies outside of the region.
    """
    region, view = context.region, context.region_data
    is_inside = 0 <= pixel[0] < region.width and 0 <= pixel[1] < region.height
    if view is None or not is_inside:
        return None
    origin = region_2d_to_origin_3d(region, view, pixel)
    direction = region_2d_to_vector_3d(region, view, pixel)
    return np.array(origin, dtype=np.float64), np.array(direction, dtype=np.float64)
