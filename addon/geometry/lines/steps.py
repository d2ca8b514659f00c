# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""One step of many walkers over triangles at once: straight on, or along a direction field."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..types import Flags, Floats, Indices
from .field import DirectionField
from .triangulation import Triangulation
from .vectors import cross as product
from .vectors import dot, unit

#: Most turn of a line from one step to the next, in radians; more is taken in shorter steps, but
#: not in shorter ones than this share.
TURN, LEAST = 0.2, 0.1
STRAIGHT = float(np.cos(TURN))
#: A middle direction that leaves the triangle in less than this share of the expected way grazes a
#: side; there the first direction leads into the triangle.
GRAZING = 0.2
#: After so many steps without progress a walker is stuck, and moves by this share towards the
#: middle of its triangle.
STUCK, NUDGE = 12, 1e-3

#: Sine of the angle to a side up to which one goes along it.
_ALONG = 1e-9


@dataclass
class Walkers:
    """Points that move over triangles, n at a time.

    Parameters
    ----------
    triangle : (n,) int64
    barycentric : (n, 3) float64
    heading : (n, 3) float64
        Unit vectors into which they moved last; decides between a line's two directions.
    family : (n,) int64
        Values of `Family`.
    idle : (n,) int64
        Steps in succession without progress.
    """

    triangle: Indices
    barycentric: Floats
    heading: Floats
    family: Indices
    idle: Indices

    def chosen(self, items: Indices | Flags) -> Walkers:
        """Return some of the walkers, copied."""
        return Walkers(
            self.triangle[items],
            self.barycentric[items],
            self.heading[items],
            self.family[items],
            self.idle[items],
        )

    def put(self, items: Indices, others: Walkers) -> None:
        """Replace some of the walkers."""
        self.triangle[items] = others.triangle
        self.barycentric[items] = others.barycentric
        self.heading[items] = others.heading
        self.idle[items] = others.idle


def start_walkers(
    triangle: Indices, barycentric: Floats, heading: Floats, family: Indices
) -> Walkers:
    """Return walkers that have not moved yet."""
    return Walkers(
        triangle.copy(),
        barycentric.copy(),
        heading.copy(),
        family.copy(),
        np.zeros(len(triangle), dtype=np.int64),
    )


def follow(field: DirectionField, walkers: Walkers, reach: Floats) -> tuple[Floats, Indices]:
    """Move walkers along the field: to the side of their triangle, or less far.

    The step is straight, in the direction of the field in its middle, which is found by going on as
    before; that errs by the third power of its length. Where the field turns much the step is
    shorter.

    Parameters
    ----------
    field : DirectionField
    walkers : Walkers
        Changed: they stand where the step ended, still in the same triangle.
    reach : (n,) float64
        Most way to go, in meters.

    Returns
    -------
    way : (n,) float64
        In meters.
    side : (n,) int64
        Side of the triangle that was reached, -1 for none.
    """
    triangle, start = walkers.triangle, walkers.barycentric
    gradient = field.mesh.gradient[triangle]
    # The gradients lie in the triangle, so that this goes along the heading as seen from above.
    guess = np.einsum("ncx,nx->nc", gradient, walkers.heading)
    free = _exit(start, guess)[0]
    length = np.minimum(free, reach)
    middle = start + (0.5 * length)[:, None] * guess
    tangent, course, _ = field.evaluate(triangle, middle, walkers.family)
    tangent, course = _aligned(tangent, course, walkers.heading)
    cosine = dot(tangent, walkers.heading)
    bent = np.flatnonzero((cosine < STRAIGHT) & (length > 0.0))
    if len(bent):
        turn = np.arccos(np.clip(cosine[bent], -1.0, 1.0))
        length[bent] *= np.maximum(TURN / turn, LEAST)
        middle = start[bent] + (0.5 * length[bent])[:, None] * guess[bent]
        again = field.evaluate(triangle[bent], middle, walkers.family[bent])
        tangent[bent], course[bent] = _aligned(again[0], again[1], walkers.heading[bent])
    rate = np.einsum("ncx,nx->nc", gradient, course)
    way, side = _exit(start, rate)
    is_short = reach < free
    is_short[bent] = True
    # Along a side both directions may point out, each into the other triangle: go by the first.
    grazes = (way < GRAZING * length) & (length > 0.0)
    stops = grazes | (is_short & (length < way))
    way = np.where(stops, np.where(grazes, 0.5 * length, length), way)
    side = np.where(stops, -1, side)
    rate = np.where(grazes[:, None], guess, rate)
    walkers.barycentric = _on_side(start + way[:, None] * rate, side)
    walkers.heading = tangent
    _unstick(walkers, way, field.mesh.edge_length)
    return way, side


def go_straight(mesh: Triangulation, walkers: Walkers, reach: Floats) -> tuple[Floats, Indices]:
    """Move walkers straight on in the plane of their triangle; see `follow`."""
    frame = mesh.frame[walkers.triangle]
    along = np.einsum("nix,nx->ni", frame[:, :2], walkers.heading)
    course = np.einsum("nix,ni->nx", frame[:, :2], along)
    course = unit(course)
    gradient = mesh.gradient[walkers.triangle]
    rate = np.einsum("ncx,nx->nc", gradient, course)
    # Who goes along a side may seem to leave both of its triangles by a rounding error, for ever.
    is_along = np.abs(rate) < _ALONG * np.sqrt((gradient**2).sum(axis=2))
    rate[is_along & (walkers.barycentric <= 0.0)] = 0.0
    way, side = _exit(walkers.barycentric, rate)
    side = np.where(reach < way, -1, side)
    way = np.minimum(way, reach)
    walkers.barycentric = _on_side(walkers.barycentric + way[:, None] * rate, side)
    walkers.heading = course
    _unstick(walkers, way, mesh.edge_length)
    return way, side


def cross(mesh: Triangulation, walkers: Walkers, side: Indices) -> Flags:
    """Move walkers at a side into the triangle beyond it.

    Parameters
    ----------
    mesh : Triangulation
    walkers : Walkers
        Changed.
    side : (n,) int64
        Side at which each stands, -1 for none.

    Returns
    -------
    (n,) bool
        Walkers that stand at a side with nothing beyond; they stay.
    """
    here = np.flatnonzero(side >= 0)
    beyond = mesh.neighbor[walkers.triangle[here], side[here]]
    is_end = np.zeros(len(side), dtype=np.bool_)
    is_end[here[beyond < 0]] = True
    here, beyond = here[beyond >= 0], beyond[beyond >= 0]
    old = side[here]
    new = mesh.neighbor_side[walkers.triangle[here], old]
    rows = np.arange(len(here))
    before = walkers.barycentric[here]
    after = np.zeros_like(before)
    after[rows, (new + 1) % 3] = before[rows, (old + 2) % 3]
    after[rows, (new + 2) % 3] = before[rows, (old + 1) % 3]
    walkers.triangle[here] = beyond
    walkers.barycentric[here] = after
    return is_end


def unfold(mesh: Triangulation, walkers: Walkers, side: Indices) -> None:
    """Turn the headings of walkers that crossed a side as if it were flattened out.

    Parameters
    ----------
    mesh : Triangulation
    walkers : Walkers
        Changed; those that crossed stand at a side of their new triangle.
    side : (n,) int64
        Side that each has crossed in its old triangle, -1 for none.
    """
    here = np.flatnonzero(side >= 0)
    triangle = walkers.triangle[here]
    inward = mesh.gradient[triangle, np.argmin(walkers.barycentric[here], axis=1)]
    inward = unit(inward)
    along = product(mesh.frame[triangle, 2], inward)
    part = np.clip(dot(walkers.heading[here], along), -1.0, 1.0)
    walkers.heading[here] = part[:, None] * along + np.sqrt(1.0 - part * part)[:, None] * inward


def _exit(start: Floats, rate: Floats) -> tuple[Floats, Indices]:
    """Return how far it is to the triangle's side, and which side it is."""
    falling = rate < 0.0
    distance = np.where(falling, start / np.where(falling, -rate, 1.0), np.inf)
    side = np.argmin(distance, axis=1)
    return distance[np.arange(len(side)), side], side


def _on_side(barycentric: Floats, side: Indices) -> Floats:
    """Return barycentric coordinates without rounding: inside, and zero for the side reached."""
    inside = np.maximum(barycentric, 0.0)
    at = np.flatnonzero(side >= 0)
    inside[at, side[at]] = 0.0
    return inside / inside.sum(axis=1)[:, None]


def _aligned(tangent: Floats, course: Floats, heading: Floats) -> tuple[Floats, Floats]:
    """Return directions with the sign that goes on as before."""
    backward = dot(tangent, heading) < 0.0
    sign = np.where(backward, -1.0, 1.0)[:, None]
    return sign * tangent, sign * course


def _unstick(walkers: Walkers, way: Floats, edge_length: float) -> None:
    """Move walkers that turn around a corner without end a little into their triangle."""
    walkers.idle = np.where(way > 1e-9 * edge_length, 0, walkers.idle + 1)
    stuck = np.flatnonzero(walkers.idle > STUCK)
    if len(stuck):
        moved = (1.0 - NUDGE) * walkers.barycentric[stuck] + NUDGE / 3.0
        walkers.barycentric[stuck] = moved
        walkers.idle[stuck] = STUCK // 2
