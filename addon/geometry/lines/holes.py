# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Holes: places far from all lines, wherever they are in their triangles."""

from __future__ import annotations

import numpy as np

from ..types import Floats, Indices
from .field import Family
from .samples import Samples, Trail, distances, take_samples
from .seeding import apart
from .seeds import Seeds, make_seeds
from .tracer import LineField, is_usable
from .triangulation import Triangulation

#: Places that are looked at lie about this share of the spacing from each other.
_GRID = 0.25
#: Most parts that a side of a triangle is cut into for that.
_PARTS = 24


def hole_seeds(
    lines: LineField, samples: Samples, families: tuple[Family, ...], spacing: float
) -> Seeds:
    """Return seeds at places that are farther than a spacing from any line, farthest first.

    Parameters
    ----------
    lines : LineField
    samples : Samples
        Of the lines that are there.
    families : tuple of Family
        Families to look for.
    spacing : float
        In meters.

    Returns
    -------
    Seeds
    """
    field = lines.field
    inside = np.flatnonzero((lines.umbilics.triangle_area < 0) & (field.mesh.double_area > 0.0))
    triangle, barycentric = _places(field.mesh, inside, _GRID * spacing)
    family = np.repeat(np.array([int(each) for each in families], dtype=np.int64), len(triangle))
    triangle = np.tile(triangle, len(families))
    barycentric = np.tile(barycentric, (len(families), 1))
    count = len(triangle)
    none = np.zeros((count, 3))
    place = Trail(2 * np.arange(count), np.zeros(count), triangle, barycentric, none, family)
    all_of_them = take_samples(field, place)
    distance = distances(all_of_them, samples, spacing, 4.0 * spacing)
    far = np.flatnonzero(distance > spacing)
    far = far[is_usable(lines, triangle[far], barycentric[far], family[far])]
    far = far[np.argsort(-np.minimum(distance[far], 1e30), kind="stable")]
    far = far[apart(all_of_them.chosen(far), spacing)]
    chosen = all_of_them.chosen(far)
    return make_seeds(chosen.triangle, chosen.barycentric, chosen.family)


def _places(mesh: Triangulation, inside: Indices, size: float) -> tuple[Indices, Floats]:
    """Return places in triangles in about every cell of a size, on every side of a thin part."""
    corner = mesh.position[mesh.triangles[inside]]
    side = np.linalg.norm(corner - np.roll(corner, 1, axis=1), axis=2).max(axis=1)
    parts = np.clip(np.ceil(side / size), 1, _PARTS).astype(np.int64)
    triangles: list[Indices] = [np.zeros(0, dtype=np.int64)]
    barycentrics: list[Floats] = [np.zeros((0, 3))]
    for number in np.unique(parts):
        chosen = inside[parts == number]
        middle = _middles(int(number))
        triangles.append(np.repeat(chosen, len(middle)))
        barycentrics.append(np.tile(middle, (len(chosen), 1)))
    triangle, barycentric = np.concatenate(triangles), np.concatenate(barycentrics)
    position = np.einsum("nc,ncx->nx", barycentric, mesh.position[mesh.triangles[triangle]])
    normal: Floats = mesh.frame[triangle, 2]
    cell = np.concatenate([np.floor(position / size), np.round(normal)], axis=1)
    first = np.unique(cell.astype(np.int64), axis=0, return_index=True)[1]
    return triangle[first], barycentric[first]


def _middles(parts: int) -> Floats:
    """Return the middles of the equal triangles that a triangle is cut into, barycentric."""
    i, j = (index.ravel() for index in np.indices((parts, parts)))
    upward = np.stack([i, j], axis=1)[i + j < parts] + 1.0 / 3.0
    downward = np.stack([i, j], axis=1)[i + j < parts - 1] + 2.0 / 3.0
    two = np.concatenate([upward, downward]) / parts
    return np.column_stack([two, 1.0 - two.sum(axis=1)])
