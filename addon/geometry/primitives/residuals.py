# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a fit leaves: noise, or a shape that it cannot follow."""

from __future__ import annotations

import itertools

import numpy as np

from ..types import Floats, Indices

#: Standard deviations beyond what chance allows at which a residual is no noise.
_SIGNIFICANT = 3.5
#: Pairs of neighbors that are heard: more tell how a fit errs that was made to a sample.
_MOST_PAIRS = 2500
#: Degree of the polynomials that find a shape; those of a few points fit whatever there is.
_DEGREE, _POINTS_PER_TERM = 4, 3

#: Terms with a smaller singular value differ on the points by noise only, as all powers of a
#: coordinate do beyond the number of its values.
_DISTINCT = 1e-2


def correlates(height: Floats, pairs: tuple[Indices, Indices]) -> bool:
    """Return whether the heights of neighbors are alike, which those of noise are not.

    Parameters
    ----------
    height : (n,) float64
        What a fit leaves at points.
    pairs : two (p,) int64
        Neighbors, each pair in both orders.

    Returns
    -------
    bool

    References
    ----------
    .. [1] Moran (1950). Notes on continuous stochastic phenomena. Biometrika 37.
    """
    square = float((height * height).mean())
    if not len(pairs[0]) or not square > 0.0:
        return False
    correlation = float((height[pairs[0]] * height[pairs[1]]).mean()) / square
    return correlation > _SIGNIFICANT / np.sqrt(min(0.5 * len(pairs[0]), _MOST_PAIRS))


def has_shape(height: Floats, points: Floats) -> bool:
    """Return whether heights follow a polynomial of the place better than chance allows.

    Where curvature changes gradually, a primitive fits up to some distance, and what is left there
    is less than the noise; but it has a shape, which many points show together.

    Parameters
    ----------
    height : (n,) float64
        What a fit leaves at points.
    points : (n, 3) float64
        On the fitted surface.

    Returns
    -------
    bool
    """
    many = len(height)
    square = float((height * height).sum())
    if not square > 0.0:
        return False
    local = points - points.mean(axis=0)
    values, axes = np.linalg.eigh(local.T @ local / many)
    # An axis without extent is none: on a plane there are two.
    width = np.sqrt(np.maximum(values, 0.0))
    is_wide = width > 1e-6 * width.max()
    local = local @ (axes[:, is_wide] / width[is_wide])
    # Few terms tell a simple shape from fewer points, many terms a rich one.
    for degree in range(2, _DEGREE + 1):
        left, sizes, _ = np.linalg.svd(_terms(local, degree), full_matrices=False)
        basis = left[:, sizes > _DISTINCT * sizes[0]]
        count = basis.shape[1]
        if count * _POINTS_PER_TERM > many:
            return False
        explained = float(((basis.T @ height) ** 2).sum())
        noise = max(square - explained, 0.0) / (many - count)
        if explained > noise * _chance(count):
            return True
    return False


def _chance(terms: int) -> float:
    """Return what chi-squared of so many terms does not exceed by chance (Cornish and Fisher)."""
    more = _SIGNIFICANT * np.sqrt(2.0 * terms) + (_SIGNIFICANT**2 - 1.0) * 2.0 / 3.0
    return float(terms + more)


def _terms(local: Floats, degree: int) -> Floats:
    columns = [np.ones(len(local))]
    for order in range(1, degree + 1):
        for axes in itertools.combinations_with_replacement(range(local.shape[1]), order):
            columns.append(np.prod(local[:, axes], axis=1))
    return np.stack(columns, axis=1)
