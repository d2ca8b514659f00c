# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Colors of classes and regions, chosen to be told apart by color-blind eyes too."""

from __future__ import annotations

import colorsys

import numpy as np

from ..classification import SurfaceClass
from ..types import Colors, Indices
from .colormap import linear_from_srgb

CLASS_NAMES = {
    SurfaceClass.FLAT: "Flat",
    SurfaceClass.SINGLE: "Single-Curved",
    SurfaceClass.ELLIPTIC: "Double-Curved, Dome",
    SurfaceClass.HYPERBOLIC: "Double-Curved, Saddle",
    SurfaceClass.UNDEFINED: "Undefined",
}
"""What users read, in the order of rising effort to build."""

CLASS_COLORS = {
    SurfaceClass.FLAT: (0.86, 0.86, 0.82),
    SurfaceClass.SINGLE: (0.34, 0.71, 0.91),
    SurfaceClass.ELLIPTIC: (0.90, 0.62, 0.00),
    SurfaceClass.HYPERBOLIC: (0.80, 0.36, 0.60),
    SurfaceClass.UNDEFINED: (0.25, 0.25, 0.25),
}
"""Default sRGB colors; the hues are those of Okabe and Ito (2008)."""

#: Turns of the color wheel from one region to the next: the golden section repeats latest.
_GOLDEN = 0.6180339887498949


def default_class_colors() -> dict[SurfaceClass, tuple[float, float, float]]:
    """Return the default class colors in scene-linear red, green, blue."""
    return {
        surface_class: (float(red), float(green), float(blue))
        for surface_class, color in CLASS_COLORS.items()
        for red, green, blue in [linear_from_srgb(np.array(color))]
    }


def class_color_table(colors: dict[SurfaceClass, tuple[float, float, float]]) -> Colors:
    """Return colors by class number + 1, (5, 4) float32 with an alpha of 1."""
    table = np.ones((len(SurfaceClass), 4), dtype=np.float32)
    for surface_class, color in colors.items():
        table[surface_class + 1, :3] = color
    return table


def region_colors(face_region: Indices) -> Colors:
    """Return a scene-linear color per face, the same for the same region number.

    Parameters
    ----------
    face_region : (m,) int64
        -1 where there is no region.

    Returns
    -------
    (m, 4) float32
    """
    count = int(face_region.max(initial=-1)) + 1
    table = np.ones((count + 1, 4))
    table[0, :3] = CLASS_COLORS[SurfaceClass.UNDEFINED]
    for region in range(count):
        table[region + 1, :3] = colorsys.hsv_to_rgb(
            (region * _GOLDEN) % 1.0, 0.45 + 0.2 * (region % 2), 0.92 - 0.12 * (region % 3)
        )
    table[:, :3] = linear_from_srgb(table[:, :3])
    return table.astype(np.float32)[face_region + 1]
