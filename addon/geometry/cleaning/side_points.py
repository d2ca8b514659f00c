# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Points of one side of a border, and the surface through them continued to places beyond."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..engine.normals import tangent_frame
from ..nearest import PointFinder
from ..threads import in_parallel, joined
from ..types import AnyArray, Coordinates, Flags, Floats, Indices
from .continuation import FEWEST, Continuation, continue_surface

#: Points that a side is continued from, and how near the nearest of them must be, as a share of how
#: far they may be.
_POINTS = 48
_NEAREST = 0.5
#: Cosine between normals beyond which a point belongs to another sheet.
_FACING = 0.3
#: Half a disc of points scatters twice to almost three times as far along the border as across it;
#: a strip that scatters more tells nothing about what lies across it.
_SLENDER = 3.0
#: Places at a time: what is computed of them stays in the processor's cache.
_CHUNK = 512


@dataclass(frozen=True)
class Field:
    """Positions and normals of all places, x, y and z apart, and the noise in meters."""

    position: Coordinates
    normal: Coordinates
    noise: float

    @staticmethod
    def of(position: Floats, normal: Floats, noise: float) -> Field:
        """Return the field of (s, 3) positions and normals."""
        return Field(_columns(position), _columns(normal), noise)


@dataclass(frozen=True)
class Side:
    """Places that are known to lie on one side of borders.

    Parameters
    ----------
    source : (n,) int64
    piece : (s,) int64
        Connected part that each place of the surface lies in.
    finder : PointFinder
        Of the positions of `source`.
    """

    source: Indices
    piece: Indices
    finder: PointFinder

    @staticmethod
    def of(position: Floats, source: Indices, piece: Indices) -> Side:
        """Return the side of the places `source`, given (s, 3) positions of all places."""
        return Side(source, piece, PointFinder(position[source]))

    def is_near(self, position: Floats, reach: Floats) -> Flags:
        """Return whether the side comes near enough to (p, 3) positions to be continued there."""
        if not len(position):
            return np.zeros(0, dtype=np.bool_)
        distance, _ = self.finder.nearest(position, 1, _NEAREST * float(reach.max()))
        return distance[:, 0] < _NEAREST * reach

    def continued(
        self, field: Field, places: Indices, reach: Floats
    ) -> tuple[Indices, Continuation]:
        """Return which of the places the side can be continued to, and how it continues there.

        Parameters
        ----------
        field : Field
        places : (p,) int64
            Places that the side is near.
        reach : (p,) float64
            How far points may be, in meters.

        Returns
        -------
        (q,) int64
            Numbers of those of the p places that have enough points.
        Continuation
            At these.
        """

        def work(start: int) -> tuple[Indices, Continuation]:
            part = slice(start, start + _CHUNK)
            found, continuation = self._continued(field, places[part], reach[part])
            return start + found, continuation

        found, parts = zip(*in_parallel(work, range(0, max(len(places), 1), _CHUNK)), strict=True)
        return np.concatenate(found), joined(parts)

    def _continued(
        self, field: Field, places: Indices, reach: Floats
    ) -> tuple[Indices, Continuation]:
        at = np.stack([values[places] for values in field.position], axis=1)
        distance, near = self.finder.nearest(at, _POINTS, float(reach.max(initial=0.0)))
        # Points by places: every operation runs over contiguous places.
        points = self.source[np.ascontiguousarray(near.T)]
        is_used: Flags = np.ascontiguousarray(distance.T) < reach
        facing = sum(values[points] * values[places] for values in field.normal)
        is_used &= (self.piece[points] == self.piece[points[0]]) & (facing > _FACING)
        found = np.flatnonzero(is_used.sum(axis=0) >= FEWEST)
        local = _local(field, places[found], points[:, found], is_used[:, found])
        is_used = is_used[:, found] & (_slenderness(*local[:2], is_used[:, found]) < _SLENDER)
        return found, continue_surface(local, is_used, field.noise)


def _columns(values: Floats) -> Coordinates:
    x, y, z = (np.ascontiguousarray(column) for column in values.T)
    return x, y, z


def _local(field: Field, places: Indices, points: Indices, is_used: Flags) -> Coordinates:
    """Return points (c, p) as seen from their places, in frames along the points' mean normal."""
    normal = np.stack([(values[points] * is_used).sum(axis=0) for values in field.normal])
    normal /= np.maximum(np.linalg.norm(normal, axis=0), 1e-300)
    # Axes that turn along with the normal, so that second derivatives can be compared.
    axis = tangent_frame(np.stack([values[places] for values in field.normal], axis=1))[0].T
    first = axis - np.einsum("jp,jp->p", axis, normal) * normal
    first /= np.maximum(np.linalg.norm(first, axis=0), 1e-300)
    second = np.cross(normal, first, axis=0)
    arm = [values[points] - values[places] for values in field.position]

    def along(side: AnyArray) -> Floats:
        result = arm[0] * side[0]
        result += arm[1] * side[1]
        result += arm[2] * side[2]
        return result

    return along(first), along(second), along(normal)


def _slenderness(x: Floats, y: Floats, is_used: Flags) -> Floats:
    """Return how many times farther points scatter along their strip than across it."""
    weight = is_used / np.maximum(is_used.sum(axis=0), 1)
    x = x - np.einsum("cp,cp->p", weight, x)
    y = y - np.einsum("cp,cp->p", weight, y)
    wx = weight * x
    xx, xy = np.einsum("cp,cp->p", wx, x), np.einsum("cp,cp->p", wx, y)
    yy = np.einsum("cp,cp->p", weight * y, y)
    mean, gap = 0.5 * (xx + yy), np.hypot(0.5 * (xx - yy), xy)
    result = np.full(len(mean), np.inf)
    np.divide(mean + gap, mean - gap, out=result, where=mean > gap)
    return np.sqrt(result)
