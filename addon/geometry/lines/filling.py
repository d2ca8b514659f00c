# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Directions found anew on a part of a surface, as even as those around it allow."""

from __future__ import annotations

import numpy as np

from ..types import Complexes, Flags, Floats, Graph, Indices
from .areas import Areas
from .field import DirectionField
from .transport import Transport


def filled(
    field: DirectionField, transport: Transport, is_open: Flags, areas: Areas
) -> DirectionField:
    """Return the field with some sectors' deviators interpolated from around them.

    Directions and strengths are interpolated each for itself: if they were not, those of strong
    surroundings would decide alone, and they may differ in strength by orders of magnitude.

    Parameters
    ----------
    field : DirectionField
    transport : Transport
        Of its mesh and normals.
    is_open : (s,) bool
        Sectors to fill.
    areas : Areas
        Across which nothing is interpolated.

    Returns
    -------
    DirectionField
    """
    chosen = np.flatnonzero(is_open & ~areas.is_void)
    if not len(chosen):
        return field
    corner = field.mesh.triangles
    beside = is_open[corner].any(axis=1) & (areas.triangle_area < 0)
    rows = transport.laplacian(np.flatnonzero(beside))[chosen]
    even = rows.tocoo()
    even.data = np.where(chosen[even.row] == even.col, even.data, -np.abs(even.data))
    given = np.where(is_open, 0.0, 1.0)
    strength = field.strength.astype(np.complex128)
    direction = field.deviator / np.maximum(field.strength, 1e-300)
    deviator = field.deviator.copy()
    deviator[chosen] = _interpolated(rows, chosen, given * direction, direction)
    deviator[chosen] *= _interpolated(even.tocsr(), chosen, given * strength, strength).real
    return field.with_deviator(deviator)


def _interpolated(rows: Graph, chosen: Indices, given: Complexes, guess: Complexes) -> Complexes:
    """Return values at chosen sectors that are the mean of those around, given the others."""
    # A trace of the old values decides where nothing around does.
    weight = np.full(len(chosen), 1e-6)
    return solve(rows[:, chosen], weight, weight * guess[chosen] - rows @ given, guess[chosen])


def solve(matrix: Graph, weight: Floats, target: Complexes, guess: Complexes) -> Complexes:
    """Solve (matrix + diagonal of weights) x = target by conjugate gradients."""
    from scipy.sparse.linalg import cg

    # Scaled so that the diagonal is one, which makes large and small triangles converge alike.
    scale = 1.0 / np.sqrt(np.maximum(matrix.diagonal().real + weight, 1e-300))
    system = matrix.multiply(scale[:, None]).multiply(scale[None, :]).tocsr()
    system.setdiag(1.0)
    found: Graph = cg(system, scale * target, x0=guess / scale, rtol=1e-5, maxiter=1000)
    return np.asarray(scale * found[0], dtype=np.complex128)
