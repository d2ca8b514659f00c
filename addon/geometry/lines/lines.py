# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Traced lines as arrays: where they run, and why they end."""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum

import numpy as np

from ..types import Flags, Floats, Indices
from .triangulation import Triangulation


class LineEnd(IntEnum):
    """Why a line ends where it does."""

    CLOSED = 0
    """It does not: it closes on itself."""
    RIM = 1
    """The surface ends."""
    CREASE = 2
    """The smooth piece of the surface ends."""
    UMBILIC = 3
    """At an umbilic point."""
    AREA = 4
    """Where the principal curvatures do not differ: a flat or spherical part."""
    NEIGHBOR = 5
    """It came too close to another line of its family, or to itself."""
    PARABOLIC = 6
    """An asymptotic line at a parabolic curve, beyond which there is none."""
    FOLD = 7
    """Where the mesh folds over or its directions turn sharply: it does not show the way on."""


@dataclass(frozen=True)
class CurvatureLines:
    """Polylines on the triangles of a surface.

    A closed line does not repeat its first point.

    Parameters
    ----------
    points : (p, 3) float64
        In the mesh's coordinates, in meters, line by line.
    triangle : (p,) int64
        Triangle that holds each point, a row of `Surface.sector_triangles`.
    barycentric : (p, 3) float64
        Place in it.
    start : (n + 1,) int64
        First point of every line, and the number of points at the end.
    family : (n,) int64
        Values of `Family`.
    ends : (n, 2) int64
        `LineEnd` at the first and the last point.
    """

    points: Floats
    triangle: Indices
    barycentric: Floats
    start: Indices
    family: Indices
    ends: Indices

    @property
    def count(self) -> int:
        """Number of lines."""
        return len(self.family)

    @property
    def is_closed(self) -> Flags:
        """(n,) lines that close on themselves."""
        return self.ends[:, 0] == LineEnd.CLOSED

    @property
    def point_line(self) -> Indices:
        """(p,) line of every point."""
        return np.repeat(np.arange(self.count), np.diff(self.start))

    @property
    def length(self) -> Floats:
        """(n,) length of every line in meters, that of closed lines all around."""
        line = self.point_line
        following = np.arange(1, len(self.points) + 1)
        last = self.start[1:] - 1
        following[last] = np.where(self.is_closed, self.start[:-1], last)
        steps = np.linalg.norm(self.points[following] - self.points, axis=1)
        return np.bincount(line, steps, self.count).astype(np.float64)

    def interpolated(self, mesh: Triangulation, values: Floats) -> Floats:
        """Return values of the sectors at the points of the lines.

        Parameters
        ----------
        mesh : Triangulation
            Of the surface that the lines lie on.
        values : (s,) or (s, k) float64

        Returns
        -------
        (p,) or (p, k) float64
        """
        at_corner = values[mesh.triangles[self.triangle]]
        return np.einsum("pc...,pc->p...", at_corner, self.barycentric)

    def line_points(self, line: int) -> Floats:
        """Return the points of one line, (k, 3) in meters."""
        return self.points[self.start[line] : self.start[line + 1]]

    def chosen(self, lines: Indices) -> CurvatureLines:
        """Return some of the lines, in the given order."""
        counts = np.diff(self.start)[lines]
        start = np.concatenate([[0], np.cumsum(counts)]).astype(np.int64)
        shift = np.repeat(self.start[:-1][lines] - start[:-1], counts)
        rows = np.arange(int(start[-1])) + shift
        return CurvatureLines(
            self.points[rows],
            self.triangle[rows],
            self.barycentric[rows],
            start,
            self.family[lines],
            self.ends[lines],
        )


def no_lines() -> CurvatureLines:
    """Return an empty set of lines."""
    return CurvatureLines(
        np.zeros((0, 3)),
        np.zeros(0, dtype=np.int64),
        np.zeros((0, 3)),
        np.zeros(1, dtype=np.int64),
        np.zeros(0, dtype=np.int64),
        np.zeros((0, 2), dtype=np.int64),
    )


def joined_lines(one: CurvatureLines, other: CurvatureLines) -> CurvatureLines:
    """Return the lines of two sets in one."""
    return CurvatureLines(
        np.concatenate([one.points, other.points]),
        np.concatenate([one.triangle, other.triangle]),
        np.concatenate([one.barycentric, other.barycentric]),
        np.concatenate([one.start, one.start[-1] + other.start[1:]]),
        np.concatenate([one.family, other.family]),
        np.concatenate([one.ends, other.ends]),
    )
