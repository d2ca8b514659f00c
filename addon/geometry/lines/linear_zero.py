# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Where a direction field vanishes in a triangle, and how lines run around that point."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..types import Complexes, Floats, Indices
from .field import DirectionField

#: Barycentric coordinates of a zero that lies outside of its triangle by rounding.
_INSIDE = 1e-3


@dataclass(frozen=True)
class Zeros:
    """Zeros of a field, see `umbilics.Umbilics`."""

    triangle: Indices
    barycentric: Floats
    index: Floats
    rays: Floats

    def chosen(self, items: Indices, index: Floats) -> Zeros:
        """Return some of the zeros, with an index of their own."""
        return Zeros(self.triangle[items], self.barycentric[items], index, self.rays[items])


def find_zeros(field: DirectionField, triangle: Indices) -> Zeros:
    """Return the zeros of the field in triangles that have an index.

    Parameters
    ----------
    field : DirectionField
    triangle : (u,) int64

    Returns
    -------
    Zeros
        Their index is left open (0).
    """
    values = _in_plane(field, triangle)
    barycentric = _linear_zero(values)
    a, b = _derivatives(field, triangle, values)
    angle = _ray_angles(a, b)
    frame = field.mesh.frame[triangle]
    rays = (
        np.cos(angle)[..., None] * frame[:, None, 0] + np.sin(angle)[..., None] * frame[:, None, 1]
    )
    return Zeros(
        triangle, barycentric, np.zeros(len(triangle)), np.where(np.isnan(rays), 0.0, rays)
    )


def _in_plane(field: DirectionField, triangle: Indices) -> Complexes:
    """Return the deviators at the corners as seen in the frames of the triangles, (u, 3)."""
    corners = np.eye(3)
    columns: list[Complexes] = []
    for corner in corners:
        family = np.ones(len(triangle), dtype=np.int64)
        place = np.broadcast_to(corner, (len(triangle), 3))
        _, course, strength = field.evaluate(triangle, place, family)
        frame = field.mesh.frame[triangle]
        turn = np.einsum("ux,ux->u", course, frame[:, 0]) + 1j * np.einsum(
            "ux,ux->u", course, frame[:, 1]
        )
        columns.append(strength * turn**2)
    return np.stack(columns, axis=1)


def _linear_zero(values: Complexes) -> Floats:
    """Return the barycentric coordinates where linear fields vanish, (u, 3)."""
    rows = np.stack([values.real, values.imag, np.ones(values.shape)], axis=1)
    scale = np.maximum(np.abs(values).max(axis=1, initial=0.0), 1e-300)
    rows[:, :2] /= scale[:, None, None]
    is_solvable = np.abs(np.linalg.det(rows)) > 1e-12
    rows[~is_solvable] = np.eye(3)
    right = np.where(is_solvable[:, None], (0.0, 0.0, 1.0), 1.0 / 3.0)
    found = np.linalg.solve(rows, right[..., None])[..., 0]
    inside = np.clip(found, _INSIDE, 1.0)
    return inside / inside.sum(axis=1)[:, None]


def _derivatives(
    field: DirectionField, triangle: Indices, values: Complexes
) -> tuple[Complexes, Complexes]:
    """Return a and b of the field a z + b z* around its zero, z in the triangle's frame."""
    frame, gradient = field.mesh.frame[triangle], field.mesh.gradient[triangle]
    by_x = np.einsum("uc,ucx,ux->u", values, gradient, frame[:, 0])
    by_y = np.einsum("uc,ucx,ux->u", values, gradient, frame[:, 1])
    return 0.5 * (by_x - 1j * by_y), 0.5 * (by_x + 1j * by_y)


def _ray_angles(a: Complexes, b: Complexes) -> Floats:
    """Return the angles in which lines of the first family leave the zeros, (u, 3), NaN for none.

    A line leaves straight at the angle t where the field's angle is 2t: where a exp(-it) +
    b exp(-3it) is real, positive for the first family. That is
    a cubic equation for tan t, so there are one or three such angles in a half turn.

    References
    ----------
    .. [1] Berry, Hannay (1977). Umbilic points on Gaussian random surfaces. J. Phys. A 10.
    """
    sample = np.linspace(-np.pi / 2, np.pi / 2, 720, endpoint=False)
    value = _radial(a, b, sample).imag
    following = np.concatenate([value[:, 1:], -value[:, :1]], axis=1)
    is_root = (value <= 0.0) != (following <= 0.0)
    rank = np.cumsum(is_root, axis=1)
    angles = np.full((len(a), 3), np.nan)
    zero, place = np.nonzero(is_root & (rank <= 3))
    fraction = value[zero, place] / (value[zero, place] - following[zero, place])
    root = sample[place] + fraction * (sample[1] - sample[0])
    along = (a[zero] * np.exp(-1j * root) + b[zero] * np.exp(-3j * root)).real
    angles[zero, rank[zero, place] - 1] = np.where(along > 0.0, root, root + np.pi)
    return angles


def _radial(a: Complexes, b: Complexes, angle: Floats) -> Complexes:
    """Return the field on a circle as seen from its center, (u, n)."""
    return a[:, None] * np.exp(-1j * angle) + b[:, None] * np.exp(-3j * angle)
