# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Planes, spheres, cylinders, cones and tori: how far points lie off them, how they bend."""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import Enum

import numpy as np

from ..types import Floats

#: Lengths that nothing is divided by, in meters.
_TINY = 1e-300


class Kind(Enum):
    """Kinds of surfaces, in the order of their degrees of freedom."""

    PLANE = 3
    SPHERE = 4
    CYLINDER = 5
    CONE = 6
    TORUS = 7


@dataclass(frozen=True)
class Primitive:
    """A surface without borders.

    Parameters
    ----------
    kind : Kind
    origin : (3,) float64
        A point of the plane, the center of sphere or torus, a point of the axis; in meters.
    frame : (3, 3) float64
        Rows x, y, z: right-handed and orthonormal; z is the normal of the plane or the axis.
    sizes : tuple of float
        Sphere and cylinder: radius. Cone: radius at the origin in m, and the angle in radians by
        which it opens along the axis. Torus: radius of the spine and of the pipe.
    """

    kind: Kind
    origin: Floats
    frame: Floats
    sizes: tuple[float, ...]

    def heights(self, points: Floats) -> Floats:
        """Return the signed distances of (n, 3) points from the surface, in meters."""
        return self._measured(points)[0]

    def normals(self, points: Floats) -> Floats:
        """Return the unit normals of the surface beside (n, 3) points: where heights rise."""
        return self._measured(points)[2] @ self.frame

    def derivatives(self, points: Floats) -> tuple[Floats, Floats]:
        """Return heights and how they change with the surface.

        Parameters
        ----------
        points : (n, 3) float64

        Returns
        -------
        (n,) float64
            Signed distances in meters.
        (n, d) float64
            By shifts along x, y and z, turns about x and y, and sizes, as far as the kind has them.
        """
        height, local, normal = self._measured(points)
        x, y, z = local.T
        nx, ny, nz = normal.T
        # A turn by w moves the surface at q by w x q: the height falls by n . (w x q).
        turns = [ny * z - nz * y, nz * x - nx * z]
        rho = np.hypot(x, y)
        one = np.ones(len(x))
        if self.kind is Kind.PLANE:
            columns = [-nz, *turns]
        elif self.kind is Kind.SPHERE:
            columns = [-nx, -ny, -nz, -one]
        elif self.kind is Kind.CYLINDER:
            columns = [-nx, -ny, *turns, -one]
        elif self.kind is Kind.CONE:
            radius, angle = self.sizes
            c, s = np.cos(angle), np.sin(angle)
            columns = [-nx, -ny, *turns, -c * one, -(rho - radius) * s - z * c]
        else:
            off = rho - self.sizes[0]
            columns = [-nx, -ny, -nz, *turns, -off / np.maximum(np.hypot(off, z), _TINY), -one]
        # Each column in one stretch of memory.
        return height, np.stack(columns).T

    def changed(self, change: Floats) -> Primitive:
        """Return the surface after a change of the quantities that `derivatives` derives by."""
        values: list[float] = change.tolist()
        shift, turn = np.zeros(3), np.zeros(2)
        if self.kind is Kind.PLANE:
            shift[2], turn[:] = values[0], values[1:3]
            values = []
        elif self.kind in (Kind.CYLINDER, Kind.CONE):
            shift[:2], turn[:] = values[:2], values[2:4]
            values = values[4:]
        else:
            shift[:] = values[:3]
            values = values[3:]
            if self.kind is Kind.TORUS:
                turn[:] = values[:2]
                values = values[2:]
        axis = self.frame[2] + turn[1] * self.frame[0] - turn[0] * self.frame[1]
        sizes = tuple(old + new for old, new in zip(self.sizes, values, strict=True))
        return Primitive(self.kind, self.origin + shift @ self.frame, frame_of(axis), sizes)

    def bends(self, points: Floats) -> tuple[Floats, Floats]:
        """Return the principal curvatures beside (n, 3) points in 1/m, with one sign in common."""
        local = (points - self.origin) @ self.frame.T
        rho = np.maximum(np.hypot(local[:, 0], local[:, 1]), _TINY)
        zero = np.zeros(len(points))
        if self.kind is Kind.PLANE:
            return zero, zero
        if self.kind is Kind.CONE:
            return np.cos(self.sizes[1]) / rho, zero
        own = np.full(len(points), 1.0 / max(abs(self.sizes[-1]), _TINY))
        if self.kind is Kind.SPHERE:
            return own, own
        if self.kind is Kind.CYLINDER:
            return own, zero
        off = rho - self.sizes[0]
        cosine = off / np.maximum(np.hypot(off, local[:, 2]), _TINY)
        # On the surface, not where noise has moved the point to.
        around = self.sizes[0] + self.sizes[1] * cosine
        return own, cosine / np.where(np.abs(around) > _TINY, around, _TINY)

    def _measured(self, points: Floats) -> tuple[Floats, Floats, Floats]:
        """Return heights, points and normals in the own frame."""
        local = (self.frame @ (points - self.origin).T).T
        x, y, z = local.T
        if self.kind is Kind.PLANE:
            return z, local, np.broadcast_to([0.0, 0.0, 1.0], local.shape)
        if self.kind is Kind.SPHERE:
            size = np.sqrt(x * x + y * y + z * z)
            return size - self.sizes[0], local, local / np.maximum(size, _TINY)[:, None]
        rho = np.hypot(x, y)
        radial, along = np.ones(len(x)), np.zeros(len(x))
        if self.kind is Kind.CYLINDER:
            height = rho - self.sizes[0]
        elif self.kind is Kind.CONE:
            radius, angle = self.sizes
            height = (rho - radius) * np.cos(angle) - z * np.sin(angle)
            radial, along = radial * np.cos(angle), along - np.sin(angle)
        else:
            off = rho - self.sizes[0]
            size = np.hypot(off, z)
            height = size - self.sizes[1]
            radial, along = off / np.maximum(size, _TINY), z / np.maximum(size, _TINY)
        radial = radial / np.maximum(rho, _TINY)
        return height, local, np.stack([radial * x, radial * y, along]).T


def frame_of(axis: Floats) -> Floats:
    """Return an orthonormal right-handed frame, rows x, y, z, whose z is along an axis."""
    # In plain numbers: numpy takes twenty times as long for three, and fits need many frames.
    a, b, c = _unit(*axis.tolist())
    least = min(abs(a), abs(b), abs(c))
    if abs(a) == least:
        d, e, f = _unit(0.0, -c, b)
    elif abs(b) == least:
        d, e, f = _unit(c, 0.0, -a)
    else:
        d, e, f = _unit(-b, a, 0.0)
    return np.array([[d, e, f], [b * f - c * e, c * d - a * f, a * e - b * d], [a, b, c]])


def _unit(x: float, y: float, z: float) -> tuple[float, float, float]:
    size = max(math.sqrt(x * x + y * y + z * z), _TINY)
    return x / size, y / size, z / size
