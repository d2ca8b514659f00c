# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Symmetric curvature tensors in space: from principal values and back."""

from __future__ import annotations

import numpy as np

from ..types import AnyArray
from .normals import tangent_frame


def from_principal(
    k1: AnyArray, k2: AnyArray, direction_1: AnyArray, direction_2: AnyArray
) -> AnyArray:
    """Return k1 d1 d1ᵀ + k2 d2 d2ᵀ as (6, n)."""
    a, b = direction_1.T, direction_2.T
    ka, kb = k1 * a, k2 * b
    return np.stack(
        [
            ka[0] * a[0] + kb[0] * b[0],
            ka[1] * a[1] + kb[1] * b[1],
            ka[2] * a[2] + kb[2] * b[2],
            ka[0] * a[1] + kb[0] * b[1],
            ka[0] * a[2] + kb[0] * b[2],
            ka[1] * a[2] + kb[1] * b[2],
        ]
    )


def eigenvalues_in_plane(tensor: AnyArray) -> tuple[AnyArray, AnyArray]:
    """Return the larger and the smaller eigenvalue of (6, n) tensors whose third one vanishes."""
    xx, yy, zz, xy, xz, yz = tensor
    mean = 0.5 * (xx + yy + zz)
    minors = xx * yy + xx * zz + yy * zz - xy * xy - xz * xz - yz * yz
    gap = np.sqrt(np.maximum(mean * mean - minors, 0.0))
    return mean + gap, mean - gap


def _apply(tensor: AnyArray, vector: AnyArray) -> AnyArray:
    xx, yy, zz, xy, xz, yz = tensor
    x, y, z = vector.T
    return np.stack(
        [xx * x + xy * y + xz * z, xy * x + yy * y + yz * z, xz * x + yz * y + zz * z], axis=1
    )


def to_principal(
    tensor: AnyArray, normals: AnyArray
) -> tuple[AnyArray, AnyArray, AnyArray, AnyArray]:
    """Return k1 >= k2 and their unit directions of tensors in the planes of unit normals."""
    e, f = tangent_frame(normals)
    te, tf = _apply(tensor, e), _apply(tensor, f)
    a, b, c = (np.einsum("ij,ij->i", p, q) for p, q in ((e, te), (e, tf), (f, tf)))
    mean, half = (a + c) / 2, (a - c) / 2
    gap = np.hypot(half, b)
    angle = 0.5 * np.arctan2(b, half)
    direction_1 = np.cos(angle)[:, None] * e + np.sin(angle)[:, None] * f
    return mean + gap, mean - gap, direction_1, np.cross(normals, direction_1)
