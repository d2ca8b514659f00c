# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines with fewer points: what is left out lies within a tolerance of what is kept."""

from __future__ import annotations

import numpy as np

from ..types import Flags, Floats, Indices
from .lines import CurvatureLines
from .vectors import dot


def simplified(lines: CurvatureLines, tolerance: float) -> CurvatureLines:
    """Return lines without the points that they can do without.

    Parameters
    ----------
    lines : CurvatureLines
    tolerance : float
        Largest distance in meters of a point that is left out from the line that remains.

    Returns
    -------
    CurvatureLines
        The same lines with the first and last points of open ones, and at least three points of
        closed ones.

    Notes
    -----
    All spans of all lines are split at once, at the point that is farthest from the chord, as many
    times as the deepest one needs.

    References
    ----------
    .. [1] Douglas, Peucker (1973). Algorithms for the reduction of the number of points required to
           represent a digitized line or its caricature. Cartographica 10(2).
    """
    is_kept = _outset(lines)
    while True:
        kept = np.flatnonzero(is_kept)
        span = np.cumsum(is_kept) - 1
        end = np.append(kept[1:], len(lines.points))[span]
        # The last span of a closed line leads back to its first point.
        line = lines.point_line
        is_last = end >= lines.start[1:][line]
        end[is_last] = lines.start[:-1][line][is_last]
        away = _distances(lines.points, lines.points[kept[span]], lines.points[end])
        away[is_kept] = 0.0
        order = np.lexsort((-away, span))
        farthest = order[np.flatnonzero(np.diff(span[order], prepend=-1))]
        split = farthest[away[farthest] > tolerance]
        if not len(split):
            return _with_points(lines, kept)
        is_kept[split] = True


def _outset(lines: CurvatureLines) -> Flags:
    """Return the points that stay in any case, (p,) bool."""
    is_kept = np.zeros(len(lines.points), dtype=np.bool_)
    first, last = lines.start[:-1], lines.start[1:] - 1
    is_kept[first] = True
    is_kept[last[~lines.is_closed]] = True
    third = (last - first) // 3
    is_kept[(first + third)[lines.is_closed]] = True
    is_kept[(last - third)[lines.is_closed]] = True
    return is_kept


def _distances(points: Floats, start: Floats, end: Floats) -> Floats:
    """Return the distances of points from segments, (p,) in meters."""
    chord, apart = end - start, points - start
    share = np.clip(dot(apart, chord) / np.maximum(dot(chord, chord), 1e-300), 0.0, 1.0)
    away = apart - share[:, None] * chord
    return np.sqrt(dot(away, away))


def _with_points(lines: CurvatureLines, kept: Indices) -> CurvatureLines:
    counts = np.bincount(lines.point_line[kept], minlength=lines.count)
    return CurvatureLines(
        lines.points[kept],
        lines.triangle[kept],
        lines.barycentric[kept],
        np.concatenate([[0], np.cumsum(counts)]).astype(np.int64),
        lines.family,
        lines.ends,
    )
