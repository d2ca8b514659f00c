# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Strokes for illustrations: curvature lines, as many of them as a tone asks for.

Lines are ranked so that those of the first ranks are evenly spaced by themselves; darker tones add
further ranks, and then the lines of the other family across them.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .lines.field import DirectionField, Family
from .lines.lines import CurvatureLines
from .types import Flags, Floats, Indices

#: Tones at which the ranks of the first and the second family appear.
_TONES = {Family.FIRST: (0.08, 0.3, 0.5), Family.SECOND: (0.62, 0.76, 0.9)}
LIGHTEST = _TONES[Family.FIRST][0]
"""Tone up to which there are no strokes."""

#: Distances over the spacing within which lines are neighbors, per rank that is added.
_REACH = (3.2, 1.6)
#: Share of a line's points that have to be near another line for it to be a neighbor.
_BESIDE = 0.3
#: Lengths of strokes, of the gaps between them and of their tapers, in spacings.
_STROKE, _GAP, _TAPER = (9.0, 20.0), 0.7, 2.0
#: Shorter strokes than this many spacings are left out.
_SHORTEST = 1.5
_THINNEST = 0.25


@dataclass(frozen=True)
class Strokes:
    """Short lines of changing width.

    Parameters
    ----------
    lines : list of (p, 3) float64
        Points in the mesh's coordinates, in meters.
    widths : list of (p,) float64
        Share of the full width at every point, 0 to 1.
    lengths : (n,) float64
        In meters.
    """

    lines: list[Floats]
    widths: list[Floats]
    lengths: Floats


def shade_tone(field: DirectionField, light: Floats) -> Floats:
    """Return how dark the sectors are in a light from far away, (s,) from 0 to 1.

    Parameters
    ----------
    field : DirectionField
    light : (3,) float64
        Where the light comes from, in the mesh's coordinates.
    """
    length = float(np.linalg.norm(light))
    towards = light / length if length > 0.0 else np.array([0.0, 0.0, 1.0])
    tone: Floats = 1.0 - np.clip(0.1 + field.normal @ towards, 0.0, 1.0)
    return tone


def curvature_tone(k1: Floats, k2: Floats) -> Floats:
    """Return how much the sectors are bent, from 0 to 1 for the 95th percentile and beyond."""
    size = np.maximum(np.abs(k1), np.abs(k2))
    most = float(np.percentile(size, 95.0)) if size.size else 0.0
    tone: Floats = np.clip(size / most, 0.0, 1.0) if most > 0.0 else np.zeros_like(size)
    return tone


def hatch(lines: CurvatureLines, tone: Floats, spacing: float, seed: int = 0) -> Strokes:
    """Return the strokes that give a surface its tone.

    Parameters
    ----------
    lines : CurvatureLines
        Evenly spaced principal curvature lines.
    tone : (p,) float64
        At the points of the lines: 0 for none, 1 for all strokes.
    spacing : float
        Of the lines, in meters.
    seed : int
        Of the lengths of strokes.

    Returns
    -------
    Strokes
    """
    random = np.random.default_rng(seed)
    rank: list[int] = _ranks(lines, spacing).tolist()
    found: list[tuple[Floats, Floats, float]] = []
    for number in range(lines.count):
        threshold = _TONES[Family(int(lines.family[number]))][rank[number]]
        rows: Indices = np.arange(lines.start[number], lines.start[number + 1], dtype=np.int64)
        if lines.is_closed[number]:
            rows = np.append(rows, rows[0])
        found += _strokes(lines.points[rows], tone[rows], threshold, spacing, random)
    return Strokes(
        [each[0] for each in found],
        [each[1] for each in found],
        np.array([each[2] for each in found], dtype=np.float64),
    )


def _ranks(lines: CurvatureLines, spacing: float) -> Indices:
    """Return 0 for every fourth line, 1 for those between, 2 for the others, (n,)."""
    rank = np.full(lines.count, len(_REACH), dtype=np.int64)
    for family in (Family.FIRST, Family.SECOND):
        chosen = np.flatnonzero(lines.family == family)
        for level in range(len(_REACH) - 1, -1, -1):
            apart = _spread(lines, chosen, _REACH[level] * spacing, spacing)
            rank[chosen[apart]] = level
            chosen = chosen[apart]
    return rank


def _spread(lines: CurvatureLines, chosen: Indices, reach: float, spacing: float) -> Flags:
    """Return which of some lines to take so that none has a neighbor, long ones first."""
    from scipy.spatial import cKDTree

    some = lines.chosen(chosen)
    is_taken = np.zeros(some.count, dtype=np.bool_)
    if not some.count:
        return is_taken
    points, line = _thinned(some, 0.5 * spacing)
    pairs = cKDTree(points).query_pairs(reach, output_type="ndarray")
    one, other = np.concatenate([pairs, pairs[:, ::-1]]).T if len(pairs) else np.zeros((2, 0), int)
    is_between = line[one] != line[other]
    touched = np.unique(np.stack([one[is_between], line[other[is_between]]], axis=1), axis=0)
    edges, beside = np.unique(
        np.stack([line[touched[:, 0]], touched[:, 1]], axis=1), axis=0, return_counts=True
    )
    sizes = np.bincount(line, minlength=some.count)
    edges = edges[beside > _BESIDE * sizes[edges[:, 0]]]
    is_blocked = np.zeros(some.count, dtype=np.bool_)
    for number in np.argsort(-some.length, kind="stable").tolist():
        if is_blocked[number]:
            continue
        is_taken[number] = True
        is_blocked[edges[edges[:, 0] == number, 1]] = True
        is_blocked[edges[edges[:, 1] == number, 0]] = True
    return is_taken


def _thinned(lines: CurvatureLines, step: float) -> tuple[Floats, Indices]:
    """Return points of lines about a step apart, and the line of each."""
    line = lines.point_line
    move = np.linalg.norm(np.diff(lines.points, axis=0, prepend=lines.points[:1]), axis=1)
    is_first = np.diff(line, prepend=-1) > 0
    arc = np.cumsum(np.where(is_first, 0.0, move))
    cell = np.floor(arc / step)
    is_kept = is_first | (np.diff(cell, prepend=-1.0) > 0.0)
    return lines.points[is_kept], line[is_kept]


def _strokes(
    points: Floats, tone: Floats, threshold: float, spacing: float, random: np.random.Generator
) -> list[tuple[Floats, Floats, float]]:
    """Return points, widths and length of the strokes along one line."""
    step = np.linalg.norm(np.diff(points, axis=0), axis=1)
    arc = np.concatenate([[0.0], np.cumsum(step)])
    found: list[tuple[Floats, Floats, float]] = []
    begin = 0.0
    while begin < arc[-1]:
        end = begin + spacing * float(random.uniform(*_STROKE))
        inside = (arc >= begin) & (arc <= end) & (tone > threshold)
        for run in _runs(inside):
            length = float(arc[run[-1]] - arc[run[0]])
            if length >= _SHORTEST * spacing and len(run) > 2:
                strength = np.sqrt((tone[run] - threshold) / (1.0 - threshold))
                found.append((points[run], _tapered(arc[run], strength, spacing), length))
        begin = end + _GAP * spacing
    return found


def _runs(inside: Flags) -> list[Indices]:
    """Return the numbers of neighbors that are inside, run by run."""
    rows = np.flatnonzero(inside)
    if not len(rows):
        return []
    return np.split(rows, np.flatnonzero(np.diff(rows) > 1) + 1)


def _tapered(arc: Floats, strength: Floats, spacing: float) -> Floats:
    """Return widths that fall towards both ends."""
    taper = min(_TAPER * spacing, 0.5 * float(arc[-1] - arc[0]))
    near = np.minimum(arc - arc[0], arc[-1] - arc) / max(taper, 1e-300)
    width: Floats = (0.45 + 0.55 * strength) * np.clip(near, _THINNEST, 1.0)
    return width
