# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Seams: where two surfaces of unlike curvature meet smoothly, every estimate blurs the two.

A fillet runs into a wall without a crease, and curvature jumps from 1/r to 0. An estimate has a
reach: a few edges on clean meshes, many on noisy ones, and within it the jump becomes a ramp, so
that a limit far below 1/r is crossed well inside the wall. What tells the truth there is not
curvature but position: vertices of the wall still lie on the plane that the calm part of the wall
continues into, and leave it exactly at the seam.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..curvature import Curvature
from ..links import typical_length
from ..nearest import PointFinder
from ..threads import in_parallel, joined
from ..types import Flags, Floats, Indices

#: A neighborhood is calm where curvature differs by less than this share of itself …
_CALM = 0.05

#: … or of the limit that matters.
_CALM_LIMIT = 0.5

#: What a calm model may err by, as a share of where the place's own curvature, reached along a
#: ramp, would have put it.
_MODEL = 0.03

#: A place off the model by more than this share of the same distance is not explained by it.
_EXPLAINED = 0.3

#: The ramp must differ from the model by this many standard deviations of what is measured.
_SIGNIFICANT = 4.0

#: Calm places that are asked, per class of calm places, and how far away they may lie, in edges.
_ASKED = 6
_REACH = 14.0

#: Cost of a class without a calm surface nearby; misfit beyond which a surface is refuted.
NO_MODEL = 3.0
_REFUTED = 10.0

_CLASSES = 4
#: Places at a time: what is computed of them stays in the processor's cache.
_CHUNK = 2048


@dataclass(frozen=True)
class Seams:
    """What positions tell about places whose curvature is blurred.

    Parameters
    ----------
    k1, k2 : (s,) float64
        Principal curvatures in 1/m that jump at seams instead of ramping.
    cost : (s, 4) float64
        How badly the place fits the calm surfaces of each class beside it: half the squared
        distance from them in standard deviations; meaningless where there is no evidence.
    is_doubtful : (s,) bool
        Places that are not calm.
    has_evidence : (s,) bool
        Places that lie on a calm surface beside them although their own curvature denies it.
    """

    k1: Floats
    k2: Floats
    cost: Floats
    is_doubtful: Flags
    has_evidence: Flags


def find_seams(
    position: Floats, links: Indices, curvature: Curvature, place_class: Indices, limit: float
) -> Seams:
    """Ask the calm surfaces around every blurred place whether it lies on them.

    A place on a ramp takes over the curvature of the calm surface that it demonstrably lies on.
    Where curvature changes gradually nothing lies on the extrapolation of anything else, and
    nothing changes.

    Parameters
    ----------
    position : (s, 3) float64
        Of the sectors, in meters.
    links : (p, 2) int64
        Sectors that an edge joins.
    curvature : Curvature
        At the sectors; with `noise`.
    place_class : (s,) int64
        Class of every sector by its own curvature: the calm places of each class are asked apart.
    limit : float
        Curvature in 1/m that matters: variation far below it is calm.

    Returns
    -------
    Seams
    """
    k1, k2 = curvature.k1.copy(), curvature.k2.copy()
    cost = np.full((len(k1), _CLASSES), NO_MODEL)
    evidence = np.zeros(len(k1), dtype=np.bool_)
    size = np.maximum(np.abs(k1), np.abs(k2))
    variation = np.maximum(range_around(links, k1), range_around(links, k2))
    is_calm = curvature.is_defined & (variation <= np.maximum(_CALM_LIMIT * limit, _CALM * size))
    is_calm = erode(links, is_calm)
    is_doubtful = curvature.is_defined & ~is_calm
    seams = Seams(k1, k2, cost, is_doubtful, evidence)
    doubtful = np.flatnonzero(is_doubtful)
    if not len(doubtful) or not is_calm.any():
        return seams
    edge = typical_length(position, links)
    best = np.full(len(doubtful), np.inf)
    for surface_class in np.unique(place_class[is_calm & (place_class >= 0)]):
        calm = np.flatnonzero(is_calm & (place_class == surface_class))
        fit = _continue_all(position, curvature, doubtful, calm, _REACH * edge)
        cost[doubtful, surface_class] = np.where(
            fit.is_found, 0.5 * np.minimum(fit.misfit, _REFUTED) ** 2, NO_MODEL
        )
        evidence[doubtful] |= fit.is_explained
        is_better = fit.is_explained & (fit.misfit < best)
        best[is_better] = fit.misfit[is_better]
        k1[doubtful[is_better]], k2[doubtful[is_better]] = fit.k1[is_better], fit.k2[is_better]
    return seams


@dataclass(frozen=True)
class _Continuation:
    """How d places fit the calm surfaces that continue towards them."""

    misfit: Floats
    is_found: Flags
    is_explained: Flags
    k1: Floats
    k2: Floats


def _continue_all(
    position: Floats, curvature: Curvature, doubtful: Indices, calm: Indices, reach: float
) -> _Continuation:
    finder = PointFinder(position[calm])

    def work(start: int) -> _Continuation:
        part = doubtful[start : start + _CHUNK]
        distance, near = finder.nearest(position[part], _ASKED, reach)
        return _continue(position, curvature, part, calm, distance, near)

    return joined(in_parallel(work, range(0, len(doubtful), _CHUNK)))


def _continue(
    position: Floats,
    curvature: Curvature,
    doubtful: Indices,
    calm: Indices,
    distance: Floats,
    near: Indices,
) -> _Continuation:
    is_found = np.isfinite(distance)
    source = calm[np.where(is_found, near, 0)]
    is_found &= np.einsum("ij,ikj->ik", curvature.normal[doubtful], curvature.normal[source]) > 0.5
    found = np.maximum(is_found.sum(axis=1), 1)

    def mean(values: Floats) -> Floats:
        return np.where(is_found, values, 0.0).sum(axis=1) / found

    arm = position[doubtful][:, None] - position[source]
    off = osculating_height(
        arm,
        curvature.normal[source],
        curvature.direction_1[source],
        curvature.k1[source],
        curvature.k2[source],
    )
    noise = curvature.noise
    # The mean forgets the noise of the calm places; the spread does not forget a gradual change of
    # curvature, whose effects on opposite sides cancel in the mean.
    spread = np.sqrt(np.maximum(mean(off * off) - 2.0 * noise**2, 0.0))
    off_mean = np.maximum(np.abs(mean(off)), spread)
    # Only curvature along the way counts: what changes across it moves nothing.
    own = bend_along(
        arm,
        curvature.normal[doubtful][:, None],
        curvature.direction_1[doubtful][:, None],
        curvature.k1[doubtful][:, None],
        curvature.k2[doubtful][:, None],
    )
    calm_bend = bend_along(
        arm,
        curvature.normal[source],
        curvature.direction_1[source],
        curvature.k1[source],
        curvature.k2[source],
    )
    square = np.where(is_found, distance, 0.0) ** 2
    ramp = mean(np.abs(own - calm_bend)) / 6.0
    doubt = mean(curvature.uncertainty[source] * square) / 2.0
    measured = np.hypot(noise, doubt)
    deviation = np.hypot(measured, _MODEL * ramp) + np.finfo(float).tiny
    is_any = is_found.any(axis=1)
    return _Continuation(
        misfit=off_mean / deviation,
        is_found=is_any,
        is_explained=is_any
        & (off_mean <= np.minimum(3.0 * deviation, _EXPLAINED * ramp))
        & (ramp > _SIGNIFICANT * measured),
        k1=mean(curvature.k1[source]),
        k2=mean(curvature.k2[source]),
    )


def osculating_height(
    arm: Floats, normal: Floats, direction_1: Floats, k1: Floats, k2: Floats
) -> Floats:
    """Return the height of points above the surface that continues with constant curvature.

    Exact for planes, cylinders and spheres; of third order in the distance for other surfaces.

    Parameters
    ----------
    arm : (..., 3) float64
        From the place whose surface is continued to the points, in meters.
    normal, direction_1 : (..., 3) float64
        At the place; a zero direction where it does not matter.
    k1, k2 : (...) float64
        In 1/m.

    Returns
    -------
    (...) float64
        In meters.
    """
    z = np.einsum("...j,...j->...", arm, normal)
    x = np.einsum("...j,...j->...", arm, direction_1)
    flat = np.maximum(np.einsum("...j,...j->...", arm, arm) - z * z, 0.0)
    square_1 = np.minimum(x * x, flat)
    square_2 = flat - square_1
    bend = k1 * square_1 + k2 * square_2
    inside = np.maximum(1.0 - k1 * k1 * square_1 - k2 * k2 * square_2, 0.0)
    return z + bend / (1.0 + np.sqrt(inside))


def bend_along(arm: Floats, normal: Floats, direction_1: Floats, k1: Floats, k2: Floats) -> Floats:
    """Return the second fundamental form II(arm, arm) in m, of what lies in the tangent plane.

    Parameters are those of `osculating_height`.
    """
    z = np.einsum("...j,...j->...", arm, normal)
    x = np.einsum("...j,...j->...", arm, direction_1)
    flat = np.maximum(np.einsum("...j,...j->...", arm, arm) - z * z, 0.0)
    square_1 = np.minimum(x * x, flat)
    return k1 * square_1 + k2 * (flat - square_1)


def range_around(links: Indices, values: Floats) -> Floats:
    """Return largest minus smallest value among every place and its neighbors, (s,) float64."""
    low, high = values.copy(), values.copy()
    for own, other in ((links[:, 0], links[:, 1]), (links[:, 1], links[:, 0])):
        np.minimum.at(low, own, values[other])
        np.maximum.at(high, own, values[other])
    return high - low


def erode(links: Indices, chosen: Flags) -> Flags:
    """Return the chosen places whose neighbors are all chosen."""
    result = chosen.copy()
    is_out = ~(chosen[links[:, 0]] & chosen[links[:, 1]])
    result[links[is_out].reshape(-1)] = False
    return result
