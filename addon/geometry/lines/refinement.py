# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A direction field freed from noise: smoothed where it is noisy, bridged where it is only noise.

The principal curvatures of a noisy mesh are smoothed by the engine as far as their values ask for.
Their difference needs more: where k1 is close to k2 a small error turns the directions a lot.
"""

from __future__ import annotations

import numpy as np

from ..groups import connected_groups, sum_by_group
from ..types import Complexes, Flags, Floats, Graph, Indices
from .field import DirectionField
from .transport import Transport

#: Smoothing length over the diagonal where uncertainty and strength are equal (measured on tori,
#: catenoids, ellipsoids, paraboloids with noise of 0.5 % of the diagonal).
_LENGTH = 0.08
#: Balance of a bias that grows with the square of the length and noise that falls with the length.
_POWER = 1.0 / 3.0
#: Relative uncertainty below which nothing is smoothed.
_CLEAN = 0.02
#: A doubtful zone no larger than this many edges or this share of the diagonal is a point.
_POINT_EDGES, _POINT_SHARE = 1.5, 0.07


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
    deviator = _solve(transport.laplacian(), weight, weight * field.deviator, field.deviator)
    return field.with_deviator(deviator)


def bridged(field: DirectionField, transport: Transport) -> tuple[DirectionField, Indices]:
    """Return the field with small doubtful zones filled from around them, and the zones.

    Parameters
    ----------
    field : DirectionField
    transport : Transport

    Returns
    -------
    field : DirectionField
    zone : (s,) int64
        Number of the doubtful zone of each sector: from 0 for umbilic areas, from -2 down for
        small zones, which hold an umbilic or nothing; -1 elsewhere.
    """
    diagonal = field.surface.mesh.diagonal
    limit = field.doubt
    is_doubtful = (field.strength <= limit) | ~field.is_defined
    zone = np.full(field.mesh.sector_count, -1, dtype=np.int64)
    if not is_doubtful.any():
        return field, zone
    names, number = _zones(field, is_doubtful)
    area = sum_by_group(number, field.surface.sector_area[is_doubtful], len(names))
    members = np.bincount(number, minlength=len(names))
    typical = sum_by_group(number, limit[is_doubtful], len(names)) / members
    share = np.minimum(typical * diagonal, _POINT_SHARE)
    radius = np.maximum(_POINT_EDGES * field.mesh.edge_length, share * diagonal)
    is_area = area > np.pi * radius**2
    name = np.where(is_area, np.cumsum(is_area) - 1, -1 - np.cumsum(~is_area))
    zone[is_doubtful] = name[number]
    if is_area.all():
        return field, zone
    return _filled(field, transport, zone <= -2), zone


def _lengths(field: DirectionField) -> Floats:
    """Return the length to smooth over at every sector, (s,) float64 in meters."""
    strength = field.strength[field.is_defined]
    typical = float(np.quantile(strength, 0.75)) if len(strength) else 0.0
    if typical <= field.tolerance:
        return np.zeros(field.mesh.sector_count)
    share = np.minimum(field.uncertainty / typical, 1.0)
    share = np.where(share > _CLEAN, share, 0.0)
    return _LENGTH * field.surface.mesh.diagonal * share**_POWER


def _zones(field: DirectionField, is_doubtful: Flags) -> tuple[Indices, Indices]:
    """Return the connected groups of doubtful sectors and the group of each of them."""
    edges = field.mesh.edges
    inside = edges[is_doubtful[edges].all(axis=1)]
    group = connected_groups(inside, field.mesh.sector_count)[is_doubtful]
    names, number = np.unique(group, return_inverse=True)
    return names, number.reshape(-1)


def _filled(field: DirectionField, transport: Transport, is_open: Flags) -> DirectionField:
    """Return the field with some sectors' deviators as even as those around them allow."""
    matrix = transport.laplacian()
    chosen = np.flatnonzero(is_open)
    given = np.where(is_open, 0.0, field.deviator)
    inner = matrix[chosen][:, chosen]
    target = -(matrix[chosen] @ given)
    # A trace of the old values decides where nothing around does.
    weight = np.full(len(chosen), 1e-6)
    deviator = field.deviator.copy()
    deviator[chosen] = _solve(inner, weight, target, field.deviator[chosen])
    return field.with_deviator(deviator)


def _solve(matrix: Graph, weight: Floats, target: Complexes, guess: Complexes) -> Complexes:
    """Solve (matrix + diagonal of weights) x = target by conjugate gradients."""
    from scipy.sparse.linalg import cg

    # Scaled so that the diagonal is one, which makes large and small triangles converge alike.
    scale = 1.0 / np.sqrt(np.maximum(matrix.diagonal().real + weight, 1e-300))
    system = matrix.multiply(scale[:, None]).multiply(scale[None, :]).tocsr()
    system.setdiag(1.0)
    found: Graph = cg(system, scale * target, x0=guess / scale, rtol=1e-5, maxiter=1000)
    return np.asarray(scale * found[0], dtype=np.complex128)
