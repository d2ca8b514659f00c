# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Edges of a polygon mesh: which are smooth, which are creases, which are rims."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .mesh import PolygonMesh
from .types import Flags, Floats, Indices

DEFAULT_CREASE_ANGLE = float(np.radians(30.0))
"""Dihedral angle in radians above which an edge is a crease."""

#: Rounding of the cosine of a fold, with plenty to spare.
_SLACK = 1e-9
#: Polygons that meet at less than this (radians) may lie in one plane.
_BENT = 1e-3


@dataclass(frozen=True)
class Edges:
    """The edges of a mesh, sorted by what they mean for curvature.

    Parameters
    ----------
    inner : (p, 2) int64
        The two half-edges (named by their first corner) of every edge that two polygons share in
        opposite directions.
    is_crease : (p,) bool
        Inner edges that are marked sharp or folded by more than the crease angle.
    is_bent : (p,) bool
        Inner edges whose polygons have area and clearly do not lie in one plane.
    rim : (r,) int64
        Half-edges that belong to one polygon only.
    nonmanifold_count : int
        Number of edges with more than two polygons; always creases.
    flipped_count : int
        Number of edges that their two polygons run through in the same direction; always creases.
    marked_count : int
        Number of inner edges that are creases only because they are marked sharp.
    """

    inner: Indices
    is_crease: Flags
    is_bent: Flags
    rim: Indices
    nonmanifold_count: int
    flipped_count: int
    marked_count: int

    @property
    def smooth(self) -> Indices:
        """(q, 2) the inner edges that are not creases."""
        return self.inner[~self.is_crease] if self.is_crease.any() else self.inner


def find_edges(
    mesh: PolygonMesh, area_vectors: Floats, is_degenerate: Flags, crease_angle: float
) -> Edges:
    """Sort the edges of a mesh into smooth ones, creases and rims.

    Parameters
    ----------
    mesh : PolygonMesh
        Positions in meters.
    area_vectors : (m, 3) float64
        Vector areas of the polygons.
    is_degenerate : (m,) bool
        Polygons without a usable normal: no angle is measured at them, so that a sliver between
        two good faces does not tear the surface.
    crease_angle : float
        Largest dihedral angle in radians of a smooth edge; 0 for two coplanar faces.

    Returns
    -------
    Edges
    """
    half_edges = np.arange(len(mesh.corner_edge))
    edge_count = len(mesh.edge_is_sharp)
    uses = np.bincount(mesh.corner_edge, minlength=edge_count)
    # With duplicate indices numpy keeps the last value written, so the two passes find both users.
    last = np.zeros(edge_count, dtype=np.int64)
    first = np.zeros(edge_count, dtype=np.int64)
    last[mesh.corner_edge] = half_edges
    first[mesh.corner_edge[::-1]] = half_edges[::-1]

    paired = np.flatnonzero(uses == 2)
    pairs = np.stack([first[paired], last[paired]], axis=1)
    starts = mesh.corner_vertex[pairs]
    is_flipped = starts[:, 0] == starts[:, 1]
    if is_flipped.any():
        pairs, paired = pairs[~is_flipped], paired[~is_flipped]
    inner, sharp = pairs, mesh.edge_is_sharp[paired]

    polygon = mesh.corner_polygon[inner]
    is_measured = ~(is_degenerate[polygon[:, 0]] | is_degenerate[polygon[:, 1]])
    is_folded, is_bent = _folds(area_vectors, polygon, crease_angle)
    is_folded &= is_measured
    return Edges(
        inner=inner,
        is_crease=sharp | is_folded,
        is_bent=is_measured & is_bent,
        rim=first[uses == 1],
        nonmanifold_count=int((uses > 2).sum()),
        flipped_count=int(is_flipped.sum()),
        marked_count=int((sharp & ~is_folded).sum()),
    )


def _folds(area_vectors: Floats, polygon: Indices, crease_angle: float) -> tuple[Flags, Flags]:
    """Return which pairs of polygons fold by more than the crease angle, and which fold at all."""
    length = np.sqrt(np.einsum("ij,ij->i", area_vectors, area_vectors))
    unit = area_vectors / np.where(length > 0.0, length, 1.0)[:, None]
    one, other = (np.ascontiguousarray(polygon[:, side]) for side in (0, 1))
    cosine = np.zeros(len(polygon))
    for axis in range(3):
        values = np.ascontiguousarray(unit[:, axis])
        cosine += values[one] * values[other]
    # A cosine tells small angles apart badly: those that may be creases are measured as angles.
    is_folded = cosine < np.cos(crease_angle) + _SLACK
    close = np.flatnonzero(is_folded)
    angles = dihedral_angles(unit[polygon[close, 0]], unit[polygon[close, 1]])
    is_folded[close] = angles > crease_angle
    return is_folded, cosine < 1.0 - 0.5 * _BENT**2


def dihedral_angles(normals_1: Floats, normals_2: Floats) -> Floats:
    """Return the angle between pairs of normals of any length.

    Parameters
    ----------
    normals_1, normals_2 : (p, 3) float64

    Returns
    -------
    (p,) float64
        Radians, 0 to pi; exact also for small angles.
    """
    return np.arctan2(
        np.linalg.norm(np.cross(normals_1, normals_2), axis=1),
        np.einsum("ij,ij->i", normals_1, normals_2),
    )
