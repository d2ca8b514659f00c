# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The polynomial basis of the fits and its moments, for many neighborhoods at once.

Arrays are laid out structure-of-arrays: (neighbors, vertices), so that every numpy operation runs
over contiguous vertices.
"""

from __future__ import annotations

import numpy as np

from ..types import AnyArray


def exponents(degree: int, constant: bool) -> list[tuple[int, int]]:
    """Return exponents (a, b) of x^a y^b.

    Highest degree first, then x, y, then xx, xy, yy, last the constant's place is the front.

    The Hessian stands last so that back-substitution can stop after it, and so that its covariance
    is the inverse of the last block of the
    factor.
    """
    high = [(total - b, b) for total in range(degree, 2, -1) for b in range(total + 1)]
    return ([(0, 0)] if constant else []) + high + [(1, 0), (0, 1), (2, 0), (1, 1), (0, 2)]


def moments(
    x: AnyArray, y: AnyArray, z: AnyArray, weight: AnyArray, basis: list[tuple[int, int]]
) -> tuple[AnyArray, AnyArray, AnyArray]:
    """Return normal equations of the weighted fit z = sum c_i basis_i(x, y).

    Parameters
    ----------
    x, y, z, weight : (k, m) float64
        Neighbors in each vertex's frame; weight 0 (or x = y = z = 0 without a constant) for
        padding.

    Returns
    -------
    gram : (p, p, m) float64, lower triangle filled
    right : (p, m) float64
    square : (m,) float64
        Weighted sum of z².
    """
    degree = max(a + b for a, b in basis)
    powers_x = [weight]
    powers_y = [np.ones(0), y]  # the power 0 is never multiplied by
    for _ in range(2 * degree):
        powers_x.append(powers_x[-1] * x)
    for _ in range(2 * degree - 1):
        powers_y.append(powers_y[-1] * y)
    height_y = [z, *(powers_y[b] * z for b in range(1, degree + 1))]
    table: dict[tuple[int, int], AnyArray] = {}

    def moment(a: int, b: int) -> AnyArray:
        if (a, b) not in table:
            table[a, b] = (
                powers_x[a].sum(axis=0)
                if b == 0
                else np.einsum("km,km->m", powers_x[a], powers_y[b])
            )
        return table[a, b]

    p = len(basis)
    gram = np.zeros((p, p, x.shape[1]))
    right = np.empty((p, x.shape[1]))
    for i, (a, b) in enumerate(basis):
        right[i] = np.einsum("km,km->m", powers_x[a], height_y[b])
        for j, (c, d) in enumerate(basis[: i + 1]):
            gram[i, j] = moment(a + c, b + d)
    square = np.einsum("km,km,km->m", weight, z, z)
    return gram, right, square
