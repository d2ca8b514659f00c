# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces continued beyond their border: where a place would lie if it belonged to them.

A polynomial of degree 2 or 3 is fitted to points of one side. What a cylinder or sphere has beyond
that degree is taken away first, so that fillets of few edges fit.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..engine.cholesky import backward, factorize, forward
from ..engine.monomials import moments
from ..types import Flags, Floats

#: Terms of a polynomial of degree 3; those of degree 2 come first, so that one factor serves both.
_TERMS = [(0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2), (3, 0), (2, 1), (1, 2), (0, 3)]
_QUADRATIC = 6
#: Points that a fit has more than unknowns, at least.
_SPARE = 3
#: Fewest points that any surface is fitted to.
FEWEST = _QUADRATIC + _SPARE
#: A height predicted with more than this many times the variance of one point is a guess.
_LARGEST_VARIANCE = 16.0
#: Against singular systems, as a share of the trace.
_RIDGE, _LEAST_RIDGE = 1e-9, 1e-12


@dataclass(frozen=True)
class Continuation:
    """Surfaces fitted to points of one side of p places.

    Parameters
    ----------
    height : (p,) float64
        Height of the surface above the place, in meters.
    deviation : (p,) float64
        Standard deviation of that height, the place's own noise included.
    bend : (3, p) float64
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


@dataclass(frozen=True)
class _Points:
    """Points of a side, (c, p) each, in units of their extent, and the p places."""

    x: Floats
    y: Floats
    z: Floats
    weight: Floats
    count: Floats
    height: Floats
    noise: Floats


def continue_surface(
    local: tuple[Floats, Floats, Floats], is_used: Flags, noise: float
) -> Continuation:
    """Fit surfaces to points and tell how far the origins lie off them.

    Parameters
    ----------
    local : three (c, p) float64
        x, y and z of c points per place, in meters from the place, in a frame along their mean
        normal.
    is_used : (c, p) bool
        Which of the points belong to the side.
    noise : float
        Standard deviation in meters that no fit undercuts.

    Returns
    -------
    Continuation
    """
    count = np.maximum(is_used.sum(axis=0), 1).astype(np.float64)
    weight = is_used / count
    middle = [np.einsum("cp,cp->p", weight, values) for values in local]
    x, y, z = (values - mean for values, mean in zip(local, middle, strict=True))
    scale = np.sqrt(np.where(is_used, x * x + y * y, 0.0).max(axis=0, initial=0.0))
    scale = np.where(scale > 0.0, scale, 1.0)
    x, y, z = x / scale, y / scale, z / scale
    a, b, c = (-mean / scale for mean in middle)
    gram, right, _ = moments(x, y, z, weight, _TERMS)
    many = np.arange(len(_TERMS))
    gram[many, many] += _RIDGE * gram[many, many].sum(axis=0) + _LEAST_RIDGE
    factor = factorize(gram)
    first = _solved(factor, right[:_QUADRATIC])
    z = z - _beyond(first, x, y)
    c = c - _beyond(first, a, b)
    points = _Points(x, y, z, weight, count, c, noise / scale)
    right = _right(points)
    wanted = np.stack([a**i * b**j for i, j in _TERMS])
    low, high = (_fit(factor, right[:n], wanted[:n], points) for n in (_QUADRATIC, len(_TERMS)))
    is_cubic = high.deviation < low.deviation

    def pick(name: str) -> Floats:
        return np.where(is_cubic, getattr(high, name), getattr(low, name))

    return Continuation(
        height=pick("height") * scale,
        deviation=pick("deviation") * scale,
        bend=pick("bend") / scale,
        bend_deviation=pick("bend_deviation") / scale,
        change=pick("change") / scale,
        is_sound=low.is_sound | (is_cubic & high.is_sound),
    )


def _fit(factor: Floats, right: Floats, wanted: Floats, points: _Points) -> Continuation:
    """Fit the polynomial that has the first terms, as many as there are rows of `right`."""
    many = len(right)
    coefficient = _solved(factor, right)
    off = points.z - _value(coefficient, points.x, points.y)
    off *= off
    freedom = np.maximum(points.count - many, 1.0)
    spread = np.sqrt(points.count / freedom * np.einsum("cp,cp->p", points.weight, off))
    reach = (forward(factor, wanted) ** 2).sum(axis=0) / points.count
    is_sound = (points.count >= many + _SPARE) & (reach < _LARGEST_VARIANCE)
    spread = np.where(is_sound, np.maximum(spread, points.noise), np.inf)
    bend_variance = np.zeros(len(spread))
    # The block of the factor from the second derivatives on is all that their covariance takes.
    for term, square in ((3, 4.0), (4, 2.0), (5, 4.0)):
        unit = np.zeros((many - 3, len(spread)))
        unit[term - 3] = 1.0
        bend_variance += square * (forward(factor[3:many, 3:many], unit) ** 2).sum(axis=0)
    bend = _bend(coefficient, wanted)
    return Continuation(
        height=np.einsum("ap,ap->p", wanted, coefficient) - points.height,
        deviation=spread * np.sqrt(1.0 + reach),
        bend=bend,
        bend_deviation=spread * np.sqrt(bend_variance / points.count),
        change=size_of_bend(bend - coefficient[3:6] * [[2.0], [1.0], [2.0]]),
        is_sound=is_sound,
    )


def size_of_bend(bend: Floats) -> Floats:
    """Return the Frobenius norm of second derivatives xx, xy, yy, (3, p) to (p,) float64."""
    return np.sqrt(bend[0] ** 2 + 2.0 * bend[1] ** 2 + bend[2] ** 2)


def _bend(coefficient: Floats, wanted: Floats) -> Floats:
    """Return the second derivatives xx, xy, yy of the polynomial where it is wanted."""
    bend = coefficient[3:6] * [[2.0], [1.0], [2.0]]
    if len(coefficient) > _QUADRATIC:
        a, b = wanted[1], wanted[2]
        xxx, xxy, xyy, yyy = coefficient[_QUADRATIC:]
        bend[0] += 6.0 * xxx * a + 2.0 * xxy * b
        bend[1] += 2.0 * xxy * a + 2.0 * xyy * b
        bend[2] += 2.0 * xyy * a + 6.0 * yyy * b
    return bend


def _solved(factor: Floats, right: Floats) -> Floats:
    """Return the coefficients of least squares of the first terms."""
    return backward(factor[: len(right), : len(right)], forward(factor, right), len(right))


def _right(points: _Points) -> Floats:
    """Return the right side of the normal equations."""
    x, y = points.x, points.y
    height = points.weight * points.z
    along_y = [height, height * y]
    along_y += [along_y[1] * y]
    along_y += [along_y[2] * y]
    along_x = {1: x, 2: x * x}
    along_x[3] = along_x[2] * x
    return np.stack(
        [
            np.einsum("cp,cp->p", along_x[i], along_y[j]) if i else along_y[j].sum(axis=0)
            for i, j in _TERMS
        ]
    )


def _value(coefficient: Floats, x: Floats, y: Floats) -> Floats:
    """Return the value of a polynomial of degree 2 or 3."""
    none, one_x, one_y, xx, xy, yy = coefficient[:_QUADRATIC]
    by_x, by_y = one_x + xx * x + xy * y, one_y + yy * y
    if len(coefficient) > _QUADRATIC:
        xxx, xxy, xyy, yyy = coefficient[_QUADRATIC:]
        by_x += x * (xxx * x + xxy * y)
        by_y += y * (xyy * x + yyy * y)
    by_x *= x
    by_y *= y
    by_x += by_y
    by_x += none
    return by_x


def _beyond(coefficient: Floats, x: Floats, y: Floats) -> Floats:
    """Return the height of degree 4 of the cylinder or sphere with these second derivatives."""
    xx, xy, yy = 2.0 * coefficient[3], coefficient[4], 2.0 * coefficient[5]
    u = xx * x + xy * y
    v = xy * x + yy * y
    return 0.125 * (u * x + v * y) * (u * u + v * v)
