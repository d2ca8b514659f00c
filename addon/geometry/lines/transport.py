# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""How a direction turns from vertex to vertex, and how much the surface turns it by itself.

Angles are measured from the side between two vertices, as seen in the tangent plane of each. What
is left over around a triangle is the triangle's share of the surface's total curvature; on a closed
surface these add up to 2 pi times the Euler characteristic, exactly.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..engine.normals import tangent_frame
from ..groups import sum_by_group
from ..types import Complexes, Flags, Floats, Graph, Indices
from .triangulation import Triangulation

#: Least and largest cotangent weight of a side: slivers must not tear or dominate the smoothing.
_WEIGHTS = (0.05, 10.0)


@dataclass(frozen=True)
class Transport:
    """Angles in the tangent planes of a triangulation.

    Parameters
    ----------
    mesh : Triangulation
    next_angle : (t, 3) float64
        At each corner the angle of the side to the next corner in `tangent_frame(normal)`, radians.
    previous_angle : (t, 3) float64
        The same of the side to the previous corner.
    """

    mesh: Triangulation
    next_angle: Floats
    previous_angle: Floats

    @cached_property
    def excess(self) -> Floats:
        """(t,) sum of each triangle's angles less pi, in radians.

        Around every sector that has no rim or crease the angles add up to 2 pi, whatever the
        normals are.
        """
        mesh = self.mesh
        angle = self.previous_angle - self.next_angle
        flat = _corner_angles(mesh, mesh.triangles)
        total = sum_by_group(mesh.triangles.ravel(), flat.ravel(), mesh.sector_count)
        scaled = flat * (2.0 * np.pi / np.maximum(total, 1e-9))[mesh.triangles]
        is_inner = ~self._on_outline()
        expected = np.where(is_inner[mesh.triangles], scaled, flat)
        angle += 2.0 * np.pi * np.round((expected - angle) / (2.0 * np.pi))
        found = sum_by_group(mesh.triangles.ravel(), angle.ravel(), mesh.sector_count)
        missing = np.where(is_inner, 2.0 * np.pi - found, 0.0)
        owner = np.zeros(mesh.sector_count, dtype=np.int64)
        owner[mesh.triangles.ravel()] = np.arange(mesh.triangles.size)
        np.add.at(angle.reshape(-1), owner[is_inner], missing[is_inner])
        return angle.sum(axis=1) - np.pi

    def turn(self, deviator: Complexes) -> Floats:
        """Return by how much a deviator turns along each side, (t, 3) float64 in radians, ±pi.

        Entry c belongs to the side from corner c to the next. The two triangles of a side see
        opposite turns.
        """
        angle = np.angle(deviator)[self.mesh.triangles]
        at_start = angle - 2.0 * self.next_angle
        at_end = np.roll(angle - 2.0 * self.previous_angle, -1, axis=1)
        # Rounding is symmetric: the two triangles agree even where the turn is half a circle.
        turn = at_end - at_start
        turn -= 2.0 * np.pi * np.round(turn / (2.0 * np.pi))
        return turn

    def laplacian(self, triangle: Indices | None = None) -> Graph:
        """Return the matrix of the squared difference of neighbors' deviators, (s, s) complex.

        Hermitian and positive; weighted by cotangents, so that it has no unit.

        Parameters
        ----------
        triangle : (n,) int64, optional
            Triangles whose corners have anything to do with each other; by default all.
        """
        from scipy.sparse import csr_matrix

        mesh = self.mesh
        chosen = slice(None) if triangle is None else triangle
        start = mesh.triangles[chosen]
        end = np.roll(start, -1, axis=1)
        opposite = np.roll(_corner_angles(mesh, start), 1, axis=1)
        weight = 0.5 * np.clip(1.0 / np.tan(np.maximum(opposite, 1e-3)), *_WEIGHTS).ravel()
        at_start, at_end = self.next_angle[chosen], np.roll(self.previous_angle[chosen], -1, axis=1)
        carried = np.exp(2j * (at_end - at_start)).ravel()
        i, j = start.ravel(), end.ravel()
        entries = np.concatenate([weight, weight, -weight * carried.conj(), -weight * carried])
        rows, columns = np.concatenate([i, j, i, j]), np.concatenate([i, j, j, i])
        return csr_matrix((entries, (rows, columns)), shape=(mesh.sector_count, mesh.sector_count))

    def _on_outline(self) -> Flags:
        """Return the sectors on rims and creases, (s,) bool."""
        mesh = self.mesh
        is_open = mesh.neighbor < 0
        flags = np.zeros(mesh.sector_count, dtype=np.bool_)
        flags[np.roll(mesh.triangles, -1, axis=1)[is_open]] = True
        flags[np.roll(mesh.triangles, -2, axis=1)[is_open]] = True
        return flags


def build_transport(mesh: Triangulation, normal: Floats) -> Transport:
    """Return the angles of the sides in the tangent planes.

    Parameters
    ----------
    mesh : Triangulation
    normal : (s, 3) float64
        Unit normals; where one is zero any plane is taken, which leaves all sums exact.

    Returns
    -------
    Transport
    """
    first, second = tangent_frame(normal)
    corner = mesh.triangles
    position = mesh.position[corner]

    def angles(step: int) -> Floats:
        side = np.roll(position, step, axis=1) - position
        return np.arctan2(
            np.einsum("tcx,tcx->tc", side, second[corner]),
            np.einsum("tcx,tcx->tc", side, first[corner]),
        )

    return Transport(mesh, angles(-1), angles(1))


def _corner_angles(mesh: Triangulation, triangles: Indices) -> Floats:
    """Return the interior angles of triangles given by their corners, (t, 3) in radians."""
    position = mesh.position[triangles]
    ahead = np.roll(position, -1, axis=1) - position
    behind = np.roll(position, 1, axis=1) - position
    return np.arctan2(
        np.linalg.norm(np.cross(ahead, behind), axis=2), np.einsum("tcx,tcx->tc", ahead, behind)
    )
