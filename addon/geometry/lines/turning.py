# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines that turn: sharply, where they end, or around to where they started, where they close."""

from __future__ import annotations

import numpy as np

from ..types import Floats, Indices
from .endings import Arms, Rules, close_lines
from .field import DirectionField
from .lines import LineEnd
from .samples import Samples, Trail
from .vectors import cross, dot

#: Most turn of a line within about this share of the spacing, in radians. Around an umbilic that it
#: passes at the distance above it turns by 0.6.
_LATELY, _SHARP = 0.15, 0.75
#: An arm comes around to its start if it goes the same way there but for this cosine, misses it by
#: less than this share of its way, and was behind it by more than this share.
STRAIGHT_ON, AROUND, BEHIND = 0.5, 0.1, 0.01
#: A move shorter than this share of that way has no direction to speak of.
_SHORT = 1e-6


class Turns:
    """Ends lines before they turn sharply: there the mesh does not show how they go on.

    What counts is the way that they take on the surface. Where a mesh is folded its directions,
    seen along normals that are hardly those of its triangles, may go straight on where the way does
    not.

    Parameters
    ----------
    field : DirectionField
    spacing : float
        In meters.
    triangle : (2n,) int64
        In which each arm starts.
    heading : (2n, 3) float64
        In which it comes to its start.
    """

    def __init__(
        self, field: DirectionField, spacing: float, triangle: Indices, heading: Floats
    ) -> None:
        self._mesh, self._lately = field.mesh, _LATELY * spacing
        # Where each arm went last, in which plane, how far, and how much it turned left and right.
        self._move, self._flat = heading.copy(), field.mesh.frame[triangle, 2]
        self._way, self._bend = np.zeros(len(triangle)), np.zeros((len(triangle), 2))

    def look(self, start: Floats, way: Floats, new: Trail, state: Arms) -> None:
        """End arms that have turned sharply.

        Parameters
        ----------
        start : (n, 3) float64
            Barycentric place at which the arms entered their triangles, or were before.
        way : (n,) float64
            How far they moved in meters.
        new : Trail
            Where they are now.
        state : Arms
            Changed.
        """
        arm = new.arm
        flat = self._mesh.frame[new.triangle, 2]
        corner = self._mesh.position[self._mesh.triangles[new.triangle]]
        move = np.einsum("nc,ncx->nx", new.barycentric - start, corner)
        before, level = self._move[arm], self._flat[arm]
        ahead = _laid(move, flat, level)
        turn = np.arctan2(dot(cross(before, ahead), level), dot(before, ahead))
        is_short = way < _SHORT * self._lately
        turn[is_short] = 0.0
        moved = arm[~is_short]
        self._move[moved], self._flat[moved] = move[~is_short], flat[~is_short]
        # The last turn was before the last move, this one is before the new one.
        lately = np.exp(-self._way[arm] / self._lately)
        self._way[arm] = way
        # A turn to one side is not made good by one to the other side before it.
        bend = lately[:, None] * self._bend[arm] + np.stack([turn, -turn], axis=1)
        self._bend[arm] = bend = np.maximum(bend, 0.0)
        # Close to where both arms started, what the other one has turned belongs to the same turn.
        is_near = new.arc < 2.0 * self._lately
        bend = bend + np.where(is_near[:, None], self._bend[arm ^ 1][:, ::-1], 0.0)
        is_sharp = bend.max(axis=1) > _SHARP
        arm = arm[is_sharp]
        state.end[arm] = LineEnd.FOLD
        state.cut[arm] = np.minimum(state.cut[arm], (new.arc - way)[is_sharp])


def _laid(vectors: Floats, normal: Floats, level: Floats) -> Floats:
    """Return vectors in planes turned with them into other planes, as paper folds, (n, 3)."""
    cosine = dot(normal, level)
    axis = cross(normal, level)
    along = dot(axis, vectors) / np.maximum(1.0 + cosine, 1e-9)
    return cosine[:, None] * vectors + cross(axis, vectors) + along[:, None] * axis


def end_at_seeds(
    field: DirectionField, first: Samples, lowest: Floats, new: Trail, state: Arms, rules: Rules
) -> None:
    """Close lines of which an arm has come around to where it started.

    A ring around a thin pipe is passed many times between two looks at other lines.

    Parameters
    ----------
    field : DirectionField
    first : Samples
        Where the arms started.
    lowest : (2n,) float64
        How far behind its start each arm has been, seen in the direction it started in, as a
        negative number in meters. Changed.
    new : Trail
        Where the arms are now.
    state : Arms
        Changed.
    rules : Rules
    """
    position, heading = first.position[new.arm], first.heading[new.arm]
    corner = field.mesh.position[field.mesh.triangles[new.triangle]]
    apart = np.einsum("nc,ncx->nx", new.barycentric, corner) - position
    ahead = dot(apart, heading)
    lowest[new.arm] = np.minimum(lowest[new.arm], ahead)
    is_past = (ahead >= 0.0) & (ahead < 0.5 * rules.spacing) & (ahead < 0.5 * new.arc)
    is_past &= lowest[new.arm] < -BEHIND * new.arc
    passed = np.flatnonzero(is_past)
    if not len(passed):
        return
    passed = passed[dot(new.heading[passed], heading[passed]) > STRAIGHT_ON]
    aside = apart[passed] - ahead[passed, None] * heading[passed]
    near = np.minimum(rules.nearest, AROUND * new.arc[passed])
    passed = passed[dot(aside, aside) < near**2]
    close_lines(state, np.unique(new.arm[passed] // 2))
