# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""How far to look, and what to fit, where: one set of constants for all meshes."""

from __future__ import annotations

from .jet_fit import JetOptions

#: Small meshes are given three rings: they cost no quarter of a second, and halve the error.
#: Large ones are fine enough for two.
LARGE = 15_000
THREE_RINGS = (3, JetOptions(falloff=6.0, softening=0.1))
TWO_RINGS = (2, JetOptions(falloff=3.0, softening=0.1))
#: Where rounding is all the noise there is, a constant term and even weights suffice against it.
ROUNDED = (3, JetOptions(constant=True, falloff=0.0))
#: Where the mesh is so fine that rounding outweighs what a cubic leaves out, fewer unknowns help
#: more than more points, and take a third of the time.
VERY_ROUNDED = (2, JetOptions(degree=3, constant=True, falloff=0.0))
#: Shares of the inverse extent from which on rounding shows, and outweighs.
SHOWING, OUTWEIGHED = 6e-4, 6e-3
#: Beside a rim a vertex has neighbors on one side only, on it still fewer: reach further, but look
#: closer.
NEAR_RIM = (3, JetOptions(falloff=5.0, softening=0.1))
RIM = (4, JetOptions(falloff=6.0, softening=0.1))
#: The last resorts inside coarse meshes, and on their rims.
NEAREST = (1, JetOptions(degree=2, falloff=0.0))
PARABOLOID = (2, JetOptions(degree=2, falloff=3.0, softening=0.1))


def ordinary(count: int, rounding: float) -> tuple[int, JetOptions]:
    """Return how to fit inside a mesh.

    Parameters
    ----------
    count : int
        Number of vertices.
    rounding : float
        Error of the curvature that rounding makes in a fit of degree 4 over two rings, as a share
        of the inverse of the mesh's extent.
    """
    if rounding > OUTWEIGHED:
        return VERY_ROUNDED
    if rounding > SHOWING:
        return ROUNDED
    return THREE_RINGS if count < LARGE else TWO_RINGS
