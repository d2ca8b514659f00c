# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The line field of a surface's principal directions, between its vertices too.

What is interpolated is not directions, which have no sign, but the part of the shape operator
that has no trace: it turns twice as fast as the directions, is small where they are uncertain, and
vanishes at umbilics. It is kept as a matrix in space beside the normal, so that along an edge both
triangles see the same field and lines cross it without a jump.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from enum import IntEnum

import numpy as np

from ..curvature import Curvature
from ..engine.normals import tangent_frame
from ..groups import sum_by_group
from ..surface import Surface
from ..types import Complexes, Flags, Floats, Indices
from .triangulation import Triangulation, triangulate
from .vectors import cross, dot, unit

#: Cosine between a triangle and the interpolated normal that is taken where the mesh folds over.
STEEPEST = 0.1
#: The same between a fitted normal and the triangles around a sector where it is none of theirs.
ASTRAY = 0.5

#: Strength times the diagonal that counts as none by default: over a twentieth of the diagonal the
#: sagittas along both directions differ by less than 2e-5 of the diagonal.
_UMBILIC = 0.05
#: Standard error of half the difference of k1 and k2 over the uncertainty of either (measured
#: 0.05 to 0.4; less where the field is smoothed).
_CALIBRATION = 0.25
#: Confidence up to which there is no direction to speak of, and up to which a direction is weak.
DOUBTFUL, WEAK = 0.5, 0.96


class Family(IntEnum):
    """Which direction a line follows."""

    FIRST = 1
    """Along the direction of k1."""
    SECOND = 2
    """Along the direction of k2."""
    ASYMPTOTIC_LEFT = 3
    """Without normal curvature, turned left from the direction of k1, seen from outside."""
    ASYMPTOTIC_RIGHT = 4
    """Without normal curvature, turned right from the direction of k1."""


PRINCIPAL = (Family.FIRST, Family.SECOND)
"""The two families of principal curvature lines."""

ASYMPTOTIC = (Family.ASYMPTOTIC_LEFT, Family.ASYMPTOTIC_RIGHT)
"""The two families of asymptotic lines."""


@dataclass(frozen=True)
class DirectionField:
    """A field of pairs of crossing lines on the triangles of a surface.

    Parameters
    ----------
    surface : Surface
    mesh : Triangulation
        Its triangles.
    normal : (s, 3) float64
        Unit normals of the sectors; zero where undefined.
    deviator : (s,) complex128
        (k1 - k2) / 2 times exp(2i angle), the angle of direction 1 in `tangent_frame(normal)`, in
        1/m: twice the turn of the directions, and zero at umbilics.
    mean : (s,) float64
        Mean curvature in 1/m.
    uncertainty : (s,) float64
        Standard uncertainty of the deviator's size in 1/m.
    is_defined : (s,) bool
        Where there is a curvature.
    tolerance : float
        Strength in 1/m up to which a part counts as umbilic, however certain it is.
    packed : (s, 13) float64
        What is interpolated: deviators as matrices, normals, mean curvatures.
    """

    surface: Surface
    mesh: Triangulation
    normal: Floats
    deviator: Complexes
    mean: Floats
    uncertainty: Floats
    is_defined: Flags
    tolerance: float
    packed: Floats

    @property
    def strength(self) -> Floats:
        """(s,) half the difference of the principal curvatures, in 1/m."""
        return np.abs(self.deviator)

    @property
    def doubt(self) -> Floats:
        """(s,) strength in 1/m up to which there is no direction to speak of."""
        return np.maximum(self.uncertainty, self.tolerance)

    @property
    def confidence(self) -> Floats:
        """(s,) from 0 at umbilics and on flat parts to 1 where directions are beyond doubt."""
        square = self.strength**2
        total = square + self.doubt**2
        return np.divide(square, total, out=np.zeros_like(square), where=total > 0.0)

    @property
    def direction_1(self) -> Floats:
        """(s, 3) unit directions of k1, of either sign; zero where there is none."""
        first, second = tangent_frame(self.normal)
        half = 0.5 * np.angle(self.deviator)[:, None]
        direction = np.cos(half) * first + np.sin(half) * second
        return np.where((self.strength > 0.0)[:, None], direction, 0.0)

    def with_deviator(self, deviator: Complexes) -> DirectionField:
        """Return the field with other directions."""
        packed = _pack(self.normal, deviator, self.mean)
        return replace(self, deviator=deviator, packed=packed)

    def evaluate(
        self, triangle: Indices, barycentric: Floats, family: Indices
    ) -> tuple[Floats, Floats, Floats]:
        """Return the directions of lines at points in triangles.

        Parameters
        ----------
        triangle : (n,) int64
        barycentric : (n, 3) float64
        family : (n,) int64
            Values of `Family`.

        Returns
        -------
        tangent : (n, 3) float64
            Unit vectors at right angles to the interpolated normal, of either sign.
        course : (n, 3) float64
            The same in the plane of the triangle: seen along the interpolated normal, or along its
            own where the mesh folds over.
        strength : (n,) float64
            Half the difference of the principal curvatures in 1/m; for asymptotic lines the square
            root of -k1 k2, zero where there is no such direction.
        """
        at_corner = self.packed[self.mesh.triangles[triangle]]
        values = np.einsum("ncf,nc->nf", at_corner, barycentric)
        matrix = values[:, :9].reshape(-1, 3, 3)
        frame = self.mesh.frame[triangle]
        normal = unit(values[:, 9:12])
        first = unit(frame[:, 0] - dot(frame[:, 0], normal)[:, None] * normal)
        second = cross(normal, first)
        applied = np.einsum("nij,nj->ni", matrix, first)
        bend = 0.5 * (dot(first, applied) - np.einsum("ni,nij,nj->n", second, matrix, second))
        twist = dot(second, applied)
        angle = 0.5 * np.arctan2(twist, bend)
        strength = np.hypot(twist, bend)
        angle, strength = _turned(angle, strength, values[:, 12], family)
        tangent = np.cos(angle)[:, None] * first + np.sin(angle)[:, None] * second
        flat = frame[:, 2]
        cosine = dot(normal, flat)
        folds = cosine < STEEPEST
        along = np.where(folds[:, None], flat, normal)
        cosine = np.where(folds, 1.0, cosine)
        course = unit(tangent - (dot(tangent, flat) / cosine)[:, None] * along)
        return tangent, course, strength


def build_direction_field(
    surface: Surface, curvature: Curvature, tolerance: float = 0.0
) -> DirectionField:
    """Return the line field of the principal directions.

    Parameters
    ----------
    surface : Surface
    curvature : Curvature
        Of this surface.
    tolerance : float
        Half the difference of k1 and k2 in 1/m up to which a part counts as umbilic; 0 for what
        turns a panel of a twentieth of the diagonal by less than can be built.

    Returns
    -------
    DirectionField
    """
    mesh = triangulate(surface)
    normal, is_astray = _normals(mesh, curvature.normal)
    first, second = tangent_frame(normal)
    along = np.einsum("ij,ij->i", curvature.direction_1, first)
    across = np.einsum("ij,ij->i", curvature.direction_1, second)
    deviator = 0.5 * (curvature.k1 - curvature.k2) * (along + 1j * across) ** 2
    deviator[is_astray] = 0.0
    mean = np.where(is_astray, 0.0, curvature.mean)
    return DirectionField(
        surface=surface,
        mesh=mesh,
        normal=normal,
        deviator=deviator,
        mean=mean,
        uncertainty=_CALIBRATION * curvature.uncertainty,
        is_defined=curvature.is_defined & ~is_astray,
        tolerance=tolerance or _UMBILIC / max(surface.mesh.diagonal, 1e-300),
        packed=_pack(normal, deviator, mean),
    )


def _normals(mesh: Triangulation, fitted: Floats) -> tuple[Floats, Flags]:
    """Return the normals of sectors, and where the fitted ones say nothing about them, (s,) bool.

    Between folds as narrow as a triangle a fit takes in what is beyond them: it may see the
    triangles around a sector from their edge, or from behind.
    """
    parts = np.repeat(mesh.frame[:, 2] * mesh.double_area[:, None], 3, axis=0)
    own = unit(
        np.stack(
            [sum_by_group(mesh.triangles.ravel(), part, mesh.sector_count) for part in parts.T],
            axis=1,
        )
    )
    is_astray = (dot(fitted, own) < ASTRAY) & fitted.any(axis=1) & own.any(axis=1)
    return np.where(is_astray[:, None], own, fitted), is_astray


def _pack(normal: Floats, deviator: Complexes, mean: Floats) -> Floats:
    """Return what is interpolated, side by side: matrix, normal, mean, (s, 13)."""
    a, b = tangent_frame(normal)
    real, imaginary = deviator.real[:, None], deviator.imag[:, None]
    # The real part times aa - bb, the imaginary one times ab + ba.
    one = real * a + imaginary * b
    other = imaginary * a - real * b
    matrix = a[:, :, None] * one[:, None, :] + b[:, :, None] * other[:, None, :]
    return np.concatenate([matrix.reshape(-1, 9), normal, mean[:, None]], axis=1)


def _turned(
    angle: Floats, strength: Floats, mean: Floats, family: Indices
) -> tuple[Floats, Floats]:
    """Return angle and strength of each family, given those of the first."""
    angle = angle + 0.5 * np.pi * (family == Family.SECOND)
    is_asymptotic = family >= Family.ASYMPTOTIC_LEFT
    if is_asymptotic.any():
        cosine = np.clip(-mean / np.maximum(strength, 1e-300), -1.0, 1.0)
        turn = 0.5 * np.arccos(cosine)
        turn = np.where(family == Family.ASYMPTOTIC_RIGHT, -turn, turn)
        angle = np.where(is_asymptotic, angle + turn, angle)
        saddle = np.sqrt(np.maximum(strength**2 - mean**2, 0.0))
        strength = np.where(is_asymptotic, saddle, strength)
    return angle, strength
