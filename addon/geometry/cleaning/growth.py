# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Growth: a primitive fitted to a seed, then to all that lies on it, until it rests."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ..groups import ranges
from ..primitives.fits import first_guesses, refine
from ..primitives.residuals import correlates, has_shape
from ..primitives.shapes import Kind, Primitive
from ..types import Flags, Floats, Indices

#: Fewest points that a primitive is fitted to, for each of its degrees of freedom, and at all.
_PER_FREEDOM = 4
FEWEST = _PER_FREEDOM * Kind.PLANE.value
#: Points that a fit takes.
_SAMPLE = 800
#: Rounds of growth.
_ROUNDS = 16
#: A piece that keeps less of its seed is none; one that grows by no more than a share rests.
_HELD, _RESTS = 0.8, 0.01
#: Of a seed on an exact mesh half is enough: no chance puts a dozen points on a surface.
_HELD_EXACTLY = 0.5
#: Most of a seed on an exact mesh that may lie off by more than rounding, but hardly.
_BETWEEN = 0.02
#: Standard deviations of the heights within which a point lies on a piece.
_INLIER = 3.5


@dataclass(frozen=True)
class Piece:
    """A part of the surface on one primitive.

    Parameters
    ----------
    primitive : Primitive
    members : (c,) int64
        Places that lie on it.
    scatter : float
        Standard deviation in meters of their heights.
    """

    primitive: Primitive
    members: Indices
    scatter: float


@dataclass(frozen=True)
class Places:
    """Points of a surface, their neighbors, and what is noise there.

    Parameters
    ----------
    position, normal : (s, 3) float64
    start : (s + 1,) int64
        Where the neighbors of every place start.
    neighbor : (p,) int64
    is_rim : (s,) bool
        Places on creases and rims.
    exact : float
        Heights in meters that are rounding.
    least, most : float
        Noise in meters that no piece has less of, and that none may have more of.
    """

    position: Floats
    normal: Floats
    start: Indices
    neighbor: Indices
    is_rim: Flags
    exact: float
    least: float
    most: float

    def around(self, places: Indices) -> tuple[Indices, Indices]:
        """Return all neighbors of places, and the number of the place each belongs to."""
        many = self.start[places + 1] - self.start[places]
        owner = np.repeat(np.arange(len(places)), many)
        return self.neighbor[ranges(self.start, places)], owner

    def flags(self, chosen: Indices) -> Flags:
        """Return which places are chosen, (s,) bool."""
        flags = np.zeros(len(self.position), dtype=np.bool_)
        flags[chosen] = True
        return flags

    def inner(self, chosen: Indices) -> Indices:
        """Return the chosen places whose neighbors are all chosen."""
        neighbor, owner = self.around(chosen)
        return chosen[np.bincount(owner, ~self.flags(chosen)[neighbor], len(chosen)) == 0]

    def spread(self, seed: Indices, accepts: Callable[[Indices], Flags], most: int) -> Indices:
        """Return accepted places connected to a seed, ring by ring until there are enough."""
        front = seed[accepts(seed)]
        seen = self.flags(front)
        rings, many = [front], len(front)
        number = np.empty(len(seen), dtype=np.int64)
        while len(front) and many < most:
            neighbor, _ = self.around(front)
            neighbor = neighbor[~seen[neighbor]]
            # Each once: the last of equal ones is the one whose number stays.
            number[neighbor] = np.arange(len(neighbor))
            neighbor = neighbor[number[neighbor] == np.arange(len(neighbor))]
            seen[neighbor] = True
            front = neighbor[accepts(neighbor)]
            rings.append(front)
            many += len(front)
        return np.concatenate(rings)


def grow_piece(places: Places, seed: Indices) -> Piece | None:
    """Return the piece of the simplest kind that fits a seed and all that it grows over.

    Parameters
    ----------
    places : Places
    seed : (n,) int64
        Places on one smooth surface.

    Returns
    -------
    Piece or None
        None where every primitive leaves more than noise.
    """
    for kind in Kind:
        piece = _grown(places, seed, kind)
        if piece is not None:
            return piece
    return None


def _grown(places: Places, seed: Indices, kind: Kind) -> Piece | None:
    fewest = _PER_FREEDOM * kind.value
    if len(seed) < fewest:
        return None
    is_seed = places.flags(seed)
    fitted, members, largest = seed, seed, 0
    primitive: Primitive | None = None
    for _ in range(_ROUNDS):
        found = _fitted(places, fitted, kind, primitive)
        if found is None:
            return None
        primitive, scatter = found
        members = _lying_on(places, primitive, scatter, members)
        # What lies beyond the rim of a piece has grown into it; small ones are little but rim.
        inner = places.inner(members)
        fitted = inner if len(inner) >= fewest else members
        held = _HELD if scatter > places.exact else _HELD_EXACTLY
        if is_seed[members].sum() < held * len(seed) or len(fitted) < fewest:
            return None
        if len(members) <= (1.0 + _RESTS) * largest:
            # Places on a curve, or on the two of a strip, lie on many surfaces.
            if places.is_rim[places.inner(fitted)].all() or _is_gradual(places, fitted, primitive):
                return None
            return Piece(primitive, members, max(scatter, places.least))
        largest = len(members)
    return None


def _fitted(
    places: Places, members: Indices, kind: Kind, guess: Primitive | None
) -> tuple[Primitive, float] | None:
    """Return the primitive of a kind that leaves nothing but noise of its members, and how much."""
    sample = _some(members)
    points = places.position[sample]
    guesses = [guess] if guess is not None else first_guesses(kind, points, places.normal[sample])
    for each in guesses:
        primitive = refine(each, points, places.exact, places.most)
        scatter = _noise_left(places, members, primitive)
        if scatter is not None:
            return primitive, scatter
    return None


def _noise_left(places: Places, members: Indices, primitive: Primitive) -> float | None:
    """Return the standard deviation of the members' heights, None if they are not mere noise."""
    height = primitive.heights(places.position[members])
    is_exact = np.abs(height) <= _INLIER * places.exact
    is_between = ~is_exact & (np.abs(height) <= places.least)
    if is_exact.mean() >= _HELD_EXACTLY and is_between.mean() <= _BETWEEN:
        # What lies beyond a seam leaves by more than rounding at once.
        return places.exact
    freedom = max(len(members) - primitive.kind.value, 1)
    scatter = float(np.sqrt((height * height).sum() / freedom))
    if scatter > places.most:
        return None
    number = np.full(len(places.position), -1, dtype=np.int64)
    number[members] = np.arange(len(members))
    neighbor, owner = places.around(members)
    other = number[neighbor]
    if correlates(height, (owner[other >= 0], other[other >= 0])):
        return None
    return max(scatter, places.least)


def _is_gradual(places: Places, members: Indices, primitive: Primitive) -> bool:
    points = places.position[_some(members)]
    height = primitive.heights(points)
    if np.sqrt((height * height).mean()) <= places.exact:
        return False
    return has_shape(height, points - height[:, None] * primitive.normals(points))


def _some(members: Indices) -> Indices:
    return members[:: max(1, len(members) // _SAMPLE)]


def _lying_on(places: Places, primitive: Primitive, scatter: float, members: Indices) -> Indices:
    """Return what is connected to members by places on a primitive, but for threads of places."""

    def lies_on(chosen: Indices) -> Flags:
        return np.abs(primitive.heights(places.position[chosen])) <= _INLIER * scatter

    members = places.spread(members, lies_on, len(places.position))
    inner = places.inner(members)
    is_beside = places.flags(inner)
    is_beside[places.around(inner)[0]] = True
    return members[is_beside[members]]
