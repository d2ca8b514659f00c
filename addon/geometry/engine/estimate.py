# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the engine returns, and how its values are put in."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..types import AnyArray
from .smoothing import Choice
from .tensors import to_principal

#: Values of `Estimate.quality`: a point without a tangent plane (an apex), no faces of any area,
#: a fit of few points, the nearest ring of an exact
#: developable, a fit as it should be, patches over noise.
SINGULAR, UNDEFINED, FALLBACK, EXACT, TRUSTED, SMOOTHED = -2, -1, 0, 1, 2, 3
#: Curvatures that differ by less than this share of their size have no directions.
UMBILIC = 1e-6


@dataclass
class Estimate:
    """Curvature at s sectors.

    Attributes
    ----------
    k1, k2 : (s,) float64
        Principal curvatures in 1/m, k1 >= k2. Positive where the surface bends away from the
        normal: 1/R on a sphere with outward normals. 0 where
        undefined.
    direction_1, direction_2 : (s, 3) float64
        Unit principal directions; direction_2 = normal x direction_1; zero where undefined: no
        faces, apex, exact umbilic or flat point.
    normals : (s, 3) float64
        Unit normals of the fitted surface; zero where there is no face with area.
    quality : (s,) int8
        `SINGULAR` … `SMOOTHED`; below 0 there is no curvature.
    error : (s,) float64
        Standard uncertainty of k1 and k2 in 1/m, as far as noise and misfit show it.
    noise : (s,) float64
        Standard deviation of the heights that was taken for noise (m).
    roughness : float
        Standard deviation of the heights (m) that narrow fits leave at most vertices: at seams,
        where no fit is good, `noise` is misfit as well.
    """

    k1: AnyArray
    k2: AnyArray
    direction_1: AnyArray
    direction_2: AnyArray
    normals: AnyArray
    quality: AnyArray
    error: AnyArray
    noise: AnyArray
    roughness: float = 0.0


def adopt(result: Estimate, choice: Choice, changed: AnyArray) -> None:
    """Take the smoothed curvature of chosen vertices."""
    if not changed.any():
        return
    k1, k2, direction_1, direction_2 = to_principal(
        choice.tensor[:, changed], choice.normals[changed]
    )
    result.k1[changed], result.k2[changed] = k1, k2
    result.direction_1[changed], result.direction_2[changed], result.normals[changed] = (
        direction_1,
        direction_2,
        choice.normals[changed],
    )
    result.error[changed], result.noise[changed] = (
        np.sqrt(choice.error[changed]),
        np.sqrt(choice.noise[changed]),
    )
    result.quality[changed] = SMOOTHED


def blank(result: Estimate, extent: float) -> None:
    """Clear what is undefined.

    Values of vertices without a tangent plane, directions of exact umbilics.
    """
    none = result.quality < 0
    for values in (result.k1, result.k2, result.error, result.direction_1, result.direction_2):
        values[none] = 0
    size = np.maximum(np.abs(result.k1), np.abs(result.k2))
    umbilic = result.k1 - result.k2 <= UMBILIC * size + 1e-10 / max(extent, 1e-60)
    result.direction_1[umbilic] = 0
    result.direction_2[umbilic] = 0
