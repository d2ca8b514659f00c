# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A direction field freed from noise: smoothed where it is noisy.

The principal curvatures of a noisy mesh are smoothed by the engine as far as their values ask for.
Their difference needs more: where k1 is close to k2 a small error turns the directions a lot.
"""

from __future__ import annotations

import numpy as np

from ..types import Floats
from .field import DirectionField
from .filling import solve
from .transport import Transport

#: Smoothing length over the diagonal where uncertainty and strength are equal (measured on tori,
#: catenoids, ellipsoids, paraboloids with noise of 0.5 % of the diagonal).
_LENGTH = 0.08
#: Balance of a bias that grows with the square of the length and noise that falls with the length.
_POWER = 1.0 / 3.0
#: Relative uncertainty below which nothing is smoothed.
_CLEAN = 0.02


def smoothed(
    field: DirectionField, transport: Transport, length: float | None = None
) -> DirectionField:
    """Return the field averaged over a length.

    Parameters
    ----------
    field : DirectionField
    transport : Transport
        Of its mesh and normals.
    length : float, optional
        In meters; 0 changes nothing. By default as long as the uncertainty asks for, at every
        sector.

    Returns
    -------
    DirectionField
    """
    lengths = np.full(field.mesh.sector_count, length) if length is not None else _lengths(field)
    if not lengths.any():
        return field
    area = np.maximum(field.surface.sector_area, 1e-300)
    # As if every sector were measured with a precision, and differences to its neighbors with one.
    weight = area / np.maximum(lengths, 0.1 * field.mesh.edge_length) ** 2
    weight = np.where(field.is_defined, weight, 1e-3 * weight)
    deviator = solve(transport.laplacian(), weight, weight * field.deviator, field.deviator)
    return field.with_deviator(deviator)


def _lengths(field: DirectionField) -> Floats:
    """Return the length to smooth over at every sector, (s,) float64 in meters."""
    strength = field.strength[field.is_defined]
    typical = float(np.quantile(strength, 0.75)) if len(strength) else 0.0
    if typical <= field.tolerance:
        return np.zeros(field.mesh.sector_count)
    share = np.minimum(field.uncertainty / typical, 1.0)
    share = np.where(share > _CLEAN, share, 0.0)
    return _LENGTH * field.surface.mesh.diagonal * share**_POWER
