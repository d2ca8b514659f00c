# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The only door to libigl: its functions under our names, types and conventions."""

from __future__ import annotations

import numpy as np

from .types import Floats, Indices


def principal_curvature(
    positions: Floats, triangles: Indices, radius: int
) -> tuple[Floats, Floats, Floats, Floats, Indices]:
    """Return principal curvatures and directions by quadric fitting.

    Parameters
    ----------
    positions : (s, 3) float64
        Every position must be used by a triangle.
    triangles : (t, 3) int64
        Counter-clockwise seen from outside.
    radius : int
        Size of the neighborhood in rings, at least 2.

    Returns
    -------
    k1, k2 : (s,) float64
        k1 >= k2, positive where the surface is convex seen from outside.
    direction_1, direction_2 : (s, 3) float64
        Unit principal directions.
    failed : (b,) int64
        Positions where the fit failed; their values are zero.

    References
    ----------
    .. [1] Panozzo, Puppo, Rocca (2010). Efficient multi-scale curvature and crease estimation.
    """
    # Together with scipy, libigl takes long to load; Blender's start must not pay for it.
    import igl  # pyright: ignore[reportMissingTypeStubs] – it does not declare its types

    direction_1, direction_2, k1, k2, failed = igl.principal_curvature(
        np.ascontiguousarray(positions), np.ascontiguousarray(triangles, dtype=np.int64), radius
    )
    return (
        np.asarray(k1, dtype=np.float64),
        np.asarray(k2, dtype=np.float64),
        np.asarray(direction_1, dtype=np.float64),
        np.asarray(direction_2, dtype=np.float64),
        np.array(failed, dtype=np.int64),
    )
