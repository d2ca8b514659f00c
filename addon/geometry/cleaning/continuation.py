# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces continued beyond their border: where a place would lie if it belonged to them.

A polynomial of degree 2 or 3 is fitted to points of one side. What a cylinder or sphere has beyond
that degree is taken away first, so that fillets of few edges fit.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..types import Flags, Floats

#: Terms of a polynomial of degree 3, those of degree 2 first.
_QUADRATIC = 6
#: A height predicted with more than this many times the variance of one point is a guess.
_LARGEST_VARIANCE = 16.0
#: Against singular systems, as a share of the diagonal.
_RIDGE = 1e-9


@dataclass(frozen=True)
class Continuation:
    """Surfaces fitted to points of one side of p places.

    Parameters
    ----------
    height : (p,) float64
        Height of the surface above the place, in meters.
    deviation : (p,) float64
        Standard deviation of that height, the place's own noise included.
    bend : (p, 3) float64
        Second derivatives xx, xy, yy in 1/m at the place.
    bend_deviation : (p,) float64
        Standard deviation of the second derivatives.
    change : (p,) float64
        How much the second derivatives change from the middle of the points to the place.
    is_sound : (p,) bool
        Whether the points allow the fit.
    """

    height: Floats
    deviation: Floats
    bend: Floats
    bend_deviation: Floats
    change: Floats
    is_sound: Flags


def continue_surface(
    local: tuple[Floats, Floats, Floats],
    target: tuple[Floats, Floats, Floats],
    is_used: Flags,
    noise: float,
) -> Continuation:
    """Fit surfaces to points and tell how far places lie off them.

    Parameters
    ----------
    local : three (p, c) float64
        x, y and z of c points per place, in meters, in a frame along their mean normal.
    target : three (p,) float64
        The places in the same frames.
    is_used : (p, c) bool
        Which of the points belong to the side.
    noise : float
        Standard deviation in meters that no fit undercuts.

    Returns
    -------
    Continuation
    """
    weight = is_used.astype(np.float64)
    count = np.maximum(weight.sum(axis=1), 1.0)
    middle = [(weight * values).sum(axis=1) / count for values in local]
    x, y, z = (values - mean[:, None] for values, mean in zip(local, middle, strict=True))
    at = [values - mean for values, mean in zip(target, middle, strict=True)]
    scale = np.sqrt(np.where(is_used, x * x + y * y, 0.0).max(axis=1, initial=0.0))
    scale = np.where(scale > 0.0, scale, 1.0)
    x, y, z = x / scale[:, None], y / scale[:, None], z / scale[:, None]
    a, b, c = (values / scale for values in at)
    terms, wanted = _terms(x, y), _terms(a, b)
    weighted = terms * weight
    normal = np.einsum("apc,bpc->pab", weighted, terms)
    first, _ = _solved(normal[:, :_QUADRATIC, :_QUADRATIC], weighted[:_QUADRATIC], z)
    z = z - _beyond(first, x, y)
    c = c - _beyond(first, a[:, None], b[:, None])[:, 0]
    fits = [
        _fit(normal[:, :n, :n], (terms[:n], weighted[:n], wanted[:n]), (z, c), count, noise / scale)
        for n in (_QUADRATIC, len(terms))
    ]
    is_cubic = fits[1].deviation < fits[0].deviation

    def pick(name: str) -> Floats:
        low, high = getattr(fits[0], name), getattr(fits[1], name)
        return np.where(is_cubic.reshape(-1, *[1] * (low.ndim - 1)), high, low)

    return Continuation(
        height=pick("height") * scale,
        deviation=pick("deviation") * scale,
        bend=pick("bend") / scale[:, None],
        bend_deviation=pick("bend_deviation") / scale,
        change=pick("change") / scale,
        is_sound=fits[0].is_sound | (is_cubic & fits[1].is_sound),
    )


def _terms(x: Floats, y: Floats) -> Floats:
    xx, yy = x * x, y * y
    return np.stack([np.ones_like(x), x, y, xx, x * y, yy, x * xx, xx * y, x * yy, y * yy])


def _fit(
    normal: Floats,
    terms: tuple[Floats, Floats, Floats],
    heights: tuple[Floats, Floats],
    count: Floats,
    noise: Floats,
) -> Continuation:
    (own, weighted, wanted), (z, c) = terms, heights
    many = len(own)
    coefficient, inverse = _solved(normal, weighted, z)
    off = z - np.einsum("apc,pa->pc", own, coefficient)
    freedom = np.maximum(count - many, 1.0)
    spread = np.sqrt((weighted[0] * off * off).sum(axis=1) / freedom)
    reach = np.einsum("ap,pab,bp->p", wanted, inverse, wanted)
    is_sound = (count >= many + 3) & (reach >= 0.0) & (reach < _LARGEST_VARIANCE)
    spread = np.where(is_sound, np.maximum(spread, noise), np.inf)
    variance = np.maximum(np.diagonal(inverse, axis1=1, axis2=2), 0.0)
    bend_variance = 4.0 * variance[:, 3] + 4.0 * variance[:, 5] + 2.0 * variance[:, 4]
    bend = _bend(coefficient, wanted)
    return Continuation(
        height=np.einsum("ap,pa->p", wanted, coefficient) - c,
        deviation=spread * np.sqrt(1.0 + np.maximum(reach, 0.0)),
        bend=bend,
        bend_deviation=spread * np.sqrt(bend_variance),
        change=size_of_bend(bend - coefficient[:, 3:6] * [2.0, 1.0, 2.0]),
        is_sound=is_sound,
    )


def size_of_bend(bend: Floats) -> Floats:
    """Return the Frobenius norm of second derivatives xx, xy, yy, (p,) float64."""
    return np.sqrt(bend[:, 0] ** 2 + 2.0 * bend[:, 1] ** 2 + bend[:, 2] ** 2)


def _bend(coefficient: Floats, wanted: Floats) -> Floats:
    """Return the second derivatives xx, xy, yy of the polynomial where it is wanted."""
    bend = coefficient[:, 3:6] * [2.0, 1.0, 2.0]
    if coefficient.shape[1] > _QUADRATIC:
        a, b = wanted[1], wanted[2]
        xxx, xxy, xyy, yyy = coefficient[:, _QUADRATIC:].T
        bend[:, 0] += 6.0 * xxx * a + 2.0 * xxy * b
        bend[:, 1] += 2.0 * xxy * a + 2.0 * xyy * b
        bend[:, 2] += 2.0 * xyy * a + 6.0 * yyy * b
    return bend


def _solved(normal: Floats, weighted: Floats, z: Floats) -> tuple[Floats, Floats]:
    """Return the coefficients of least squares and the inverse of their normal equations."""
    size = normal.shape[1]
    ridge: Floats = _RIDGE * np.einsum("paa->p", normal) + 1e-12
    system: Floats = normal + ridge[:, None, None] * np.eye(size)
    inverse = np.asarray(np.linalg.inv(system), dtype=np.float64)
    right = np.einsum("apc,pc->pa", weighted, z)
    return np.einsum("pab,pb->pa", inverse, right), inverse


def _beyond(coefficient: Floats, x: Floats, y: Floats) -> Floats:
    """Return the height of degree 4 of the cylinder or sphere with these second derivatives."""
    xx, xy, yy = (2.0 * coefficient[:, 3], coefficient[:, 4], 2.0 * coefficient[:, 5])
    u = xx[:, None] * x + xy[:, None] * y
    v = xy[:, None] * x + yy[:, None] * y
    return 0.125 * (u * x + v * y) * (u * u + v * v)
