# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Polylines as few cubic Bézier arcs that stay within a tolerance.

References
----------
.. [1] Schneider (1990). An algorithm for automatically fitting digitized curves. Graphics Gems.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .types import Floats, Indices

#: Rounds in which the parameters of the points are improved before an arc is halved.
_ROUNDS = 3
#: Points per arc at which a deviation is looked for.
_SAMPLES = 9


@dataclass(frozen=True)
class BezierCurve:
    """Cubic arcs from knot to knot, smooth in the knots.

    Parameters
    ----------
    knots : (k, 3) float64
    before, after : (k, 3) float64
        Control points on either side of every knot.
    point : (k,) int64
        Point of the polyline that each knot lies on.
    is_closed : bool
        Whether an arc leads from the last knot to the first.
    """

    knots: Floats
    before: Floats
    after: Floats
    point: Indices
    is_closed: bool

    def samples(self) -> Floats:
        """Return points along all arcs, (n, 3)."""
        last = len(self.knots) if self.is_closed else len(self.knots) - 1
        start = np.arange(last)
        end = (start + 1) % len(self.knots)
        weights = _bernstein(np.linspace(0.0, 1.0, _SAMPLES))
        controls = np.stack(
            [self.knots[start], self.after[start], self.before[end], self.knots[end]], axis=1
        )
        return np.einsum("sw,awx->asx", weights, controls).reshape(-1, 3)


def fit_bezier(points: Floats, is_closed: bool, tolerance: float) -> BezierCurve:
    """Return a curve of few arcs through the ends of a polyline and some of its points.

    Parameters
    ----------
    points : (p, 3) float64
        At least two; a closed line does not repeat its first point.
    is_closed : bool
    tolerance : float
        Largest distance of the polyline's points from the curve.

    Returns
    -------
    BezierCurve
    """
    row = np.concatenate([points, points[:1]]) if is_closed else points
    tangent = _tangents(points, is_closed)
    if is_closed:
        tangent = np.concatenate([tangent, tangent[:1]])
    arcs = _arcs(row, tangent, tolerance)
    start = np.array([arc[0] for arc in arcs], dtype=np.int64)
    knot = start if is_closed else np.append(start, len(row) - 1)
    after, before = row[knot].copy(), row[knot].copy()
    for number, (_, _, first, second) in enumerate(arcs):
        after[number] = first
        before[(number + 1) % len(knot)] = second
    return BezierCurve(row[knot], before, after, knot, is_closed)


def _arcs(row: Floats, tangent: Floats, tolerance: float) -> list[tuple[int, int, Floats, Floats]]:
    """Return first and last point and inner controls of arcs, halved until they fit."""
    done: list[tuple[int, int, Floats, Floats]] = []
    open_arcs = [(0, len(row) - 1)]
    while open_arcs:
        low, high = open_arcs.pop()
        first, second, miss = _fit(row[low : high + 1], tangent[low], tangent[high])
        if miss <= tolerance or high - low < 2:
            done.append((low, high, first, second))
        else:
            middle = (low + high) // 2
            open_arcs += [(middle, high), (low, middle)]
    return done


def _fit(row: Floats, tangent_0: Floats, tangent_1: Floats) -> tuple[Floats, Floats, float]:
    """Return the inner controls of the best arc through the ends of points, and its miss."""
    step = np.linalg.norm(np.diff(row, axis=0), axis=1)
    length = float(step.sum())
    chord = float(np.linalg.norm(row[-1] - row[0]))
    if length <= 0.0 or chord <= 0.05 * length:
        # A loop is no arc: a miss beyond any tolerance has it halved.
        miss = np.inf if len(row) > 2 else 0.0
        return row[0] + tangent_0 * length / 3.0, row[-1] - tangent_1 * length / 3.0, miss
    share = np.concatenate([[0.0], np.cumsum(step)]) / length
    first, second = row[0], row[-1]
    miss = np.inf
    for _ in range(_ROUNDS):
        sizes = _handle_sizes(row, share, tangent_0, tangent_1, length)
        first, second = row[0] + sizes[0] * tangent_0, row[-1] - sizes[1] * tangent_1
        controls = np.stack([row[0], first, second, row[-1]])
        off = _bernstein(share) @ controls - row
        miss = float(np.linalg.norm(off, axis=1).max())
        share = _improved(share, controls, off)
    return first, second, miss


def _handle_sizes(
    row: Floats, share: Floats, tangent_0: Floats, tangent_1: Floats, length: float
) -> tuple[float, float]:
    """Return the lengths of the handles that fit best in the least-squares sense."""
    weights = _bernstein(share)
    one, two = weights[:, 1, None] * tangent_0, -weights[:, 2, None] * tangent_1
    ends = (weights[:, :1] + weights[:, 1:2]) * row[0] + (weights[:, 2:3] + weights[:, 3:]) * row[
        -1
    ]
    rest = row - ends
    a, b, c = (one * one).sum(), (one * two).sum(), (two * two).sum()
    x, y = (one * rest).sum(), (two * rest).sum()
    size = a * c - b * b
    third = length / 3.0
    if size <= 1e-12 * max(a * c, 1e-300):
        return third, third
    sizes = ((c * x - b * y) / size, (a * y - b * x) / size)
    # Handles that are very short, long or reversed make loops and cusps.
    first, second = (float(np.clip(each, 0.3 * third, 3.0 * third)) for each in sizes)
    return first, second


def _improved(share: Floats, controls: Floats, off: Floats) -> Floats:
    """Return parameters after a step of Newton's towards the nearest points of the arc."""
    t = share[:, None]
    side = np.diff(controls, axis=0) * 3.0
    speed = (1 - t) ** 2 * side[0] + 2 * t * (1 - t) * side[1] + t**2 * side[2]
    square = np.maximum((speed * speed).sum(axis=1), 1e-300)
    moved = np.clip(share - (off * speed).sum(axis=1) / square, 0.0, 1.0)
    moved[0], moved[-1] = 0.0, 1.0
    return np.maximum.accumulate(moved)


def _bernstein(t: Floats) -> Floats:
    """Return the weights of the four controls, (n, 4)."""
    s = 1.0 - t
    return np.stack([s**3, 3 * s * s * t, 3 * s * t * t, t**3], axis=1)


def _tangents(points: Floats, is_closed: bool) -> Floats:
    """Return unit tangents at the points of a polyline, (p, 3)."""
    ahead = np.roll(points, -1, axis=0) - points
    if not is_closed:
        ahead[-1] = ahead[-2]
    behind = np.roll(ahead, 1, axis=0)
    if not is_closed:
        behind[0] = ahead[0]
    # The shorter side says more about the tangent: of the circle through three points.
    tangent = _by_own_square(ahead) + _by_own_square(behind)
    if not is_closed and len(points) > 2:
        # Of the same circle: its tangent at the end is that beside it, mirrored in the chord.
        for end, beside in ((0, 1), (-1, -2)):
            chord = ahead[0] if end == 0 else ahead[-1]
            unit = chord / (np.linalg.norm(chord) + 1e-300)
            inner = tangent[beside] / (np.linalg.norm(tangent[beside]) + 1e-300)
            tangent[end] = 2.0 * (inner @ unit) * unit - inner
    return tangent / (np.linalg.norm(tangent, axis=1, keepdims=True) + 1e-300)


def _by_own_square(vectors: Floats) -> Floats:
    """Return vectors over the squares of their lengths; zero stays zero."""
    square = np.einsum("px,px->p", vectors, vectors)[:, None]
    return np.divide(vectors, square, out=np.zeros_like(vectors), where=square > 0.0)
