# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which point of a parametrized surface is nearest to a point close to it."""

from __future__ import annotations

import numpy as np
from scipy.spatial import cKDTree

from .catalogue import Patch
from .taylor import Array

_GRID = 200
"""Points along each parameter among which the search starts."""
_STEPS = 8
"""Steps by Gauss and Newton, each of which doubles the number of right digits."""


def nearest_parameters(patch: Patch, points: Array) -> tuple[Array, Array]:
    """Return u and v of the feet of points, two (n,) float64.

    Parameters
    ----------
    patch : Patch
    points : (n, 3) float64
        Much closer to the surface than its features are large.
    """
    u, v = (
        axis.ravel()
        for axis in np.meshgrid(
            np.linspace(*patch.u, _GRID), np.linspace(*patch.v, _GRID), indexing="ij"
        )
    )
    nearest = cKDTree(patch.derivatives(u, v)[0]).query(points)[1]
    u, v = u[nearest], v[nearest]
    for _ in range(_STEPS):
        position, by_u, by_v = patch.derivatives(u, v)[:3]
        rest = points - position
        uu, uv, vv = (
            np.einsum("ij,ij->i", a, b) for a, b in ((by_u, by_u), (by_u, by_v), (by_v, by_v))
        )
        along_u, along_v = (np.einsum("ij,ij->i", rest, a) for a in (by_u, by_v))
        determinant = uu * vv - uv**2
        u = u + (vv * along_u - uv * along_v) / determinant
        v = v + (uu * along_v - uv * along_u) / determinant
    return u, v
