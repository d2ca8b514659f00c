# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Products of vectors row by row; for few rows faster than numpy's own."""

from __future__ import annotations

import numpy as np

from ..types import Floats

#: The axes after and before each axis.
_AFTER, _BEFORE = np.array([1, 2, 0]), np.array([2, 0, 1])


def dot(a: Floats, b: Floats) -> Floats:
    """Return the scalar products of rows, (n,)."""
    return np.einsum("ni,ni->n", a, b)


def cross(a: Floats, b: Floats) -> Floats:
    """Return the vector products of the last axes, (..., 3)."""
    return a[..., _AFTER] * b[..., _BEFORE] - a[..., _BEFORE] * b[..., _AFTER]


def unit(vectors: Floats) -> Floats:
    """Return rows of length one; zero stays zero."""
    return vectors / np.sqrt(dot(vectors, vectors) + 1e-300)[:, None]
