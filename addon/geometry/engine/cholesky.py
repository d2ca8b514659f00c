# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Cholesky factorization of many small matrices at once.

Loops over the matrix, vectorized over the stack.
"""

from __future__ import annotations

import numpy as np

from ..types import AnyArray


def factorize(matrix: AnyArray) -> AnyArray:
    """Overwrite the lower triangles of (p, p, m) positive definite matrices by their factors.

    The diagonal holds 1/L_ii.
    """
    size = matrix.shape[0]
    for j in range(size):
        column = matrix[j:, j]
        if j:
            column -= np.einsum("ikm,km->im", matrix[j:, :j], matrix[j, :j])
        # rounding may leave a tiny negative pivot: the ridge added by the caller is the scale of
        # what is lost
        inverse = 1.0 / np.sqrt(np.maximum(column[0], 1e-14))
        column[1:] *= inverse
        column[0] = inverse
    return matrix


def forward(factor: AnyArray, right: AnyArray) -> AnyArray:
    """Return L^-1 right, (p, m)."""
    result = right.copy()
    for i in range(len(right)):
        if i:
            result[i] -= np.einsum("km,km->m", factor[i, :i], result[:i])
        result[i] *= factor[i, i]
    return result


def backward(factor: AnyArray, reduced: AnyArray, wanted: int) -> AnyArray:
    """Return the last `wanted` unknowns of L^T c = reduced, (wanted, m)."""
    size = len(reduced)
    result = reduced[size - wanted :].copy()
    for i in range(wanted - 1, -1, -1):
        row = size - wanted + i
        if i + 1 < wanted:
            result[i] -= np.einsum("km,km->m", factor[row + 1 :, row], result[i + 1 :])
        result[i] *= factor[row, row]
    return result
