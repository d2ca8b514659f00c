# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Where evenly spaced lines start: at umbilics, and beside lines."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ..types import Floats, Indices
from .assembly import shifted
from .field import DirectionField, Family
from .lines import CurvatureLines
from .samples import Samples, Trail, close_pairs, distances, take_samples
from .seeds import Seeds, joined_seeds, make_seeds
from .tracer import LineField
from .vectors import cross, unit

#: A gap up to this many spacings wide takes one line, in its middle.
_ONE = 2.5
#: A place beside a line, not yet put on the surface, is free this share of the spacing from lines.
_GUESS = 0.6


def course(lines: CurvatureLines) -> tuple[Floats, Floats]:
    """Return the way from the first point of its line, and the direction, of every point."""
    line = lines.point_line
    move = np.diff(lines.points, axis=0, prepend=lines.points[:1])
    move[lines.start[:-1][np.diff(lines.start) > 0]] = 0.0
    total = np.cumsum(np.linalg.norm(move, axis=1))
    arc = total - total[lines.start[:-1]][line]
    ahead = np.roll(move, -1, axis=0)
    last = lines.start[1:] - 1
    ahead[last] = move[last]
    return arc, unit(ahead)


def samples_along(
    field: DirectionField, lines: CurvatureLines, step: float, first_line: int
) -> Samples:
    """Return points of lines no closer than a step along each, and the ends.

    Parameters
    ----------
    field : DirectionField
    lines : CurvatureLines
    step : float
        In meters.
    first_line : int
        Number that the first line gets.

    Returns
    -------
    Samples
    """
    line = lines.point_line
    arc, ahead = course(lines)
    number = np.floor(arc / step)
    is_new = (np.diff(number, prepend=-1.0) != 0.0) | (np.diff(line, prepend=-1) != 0)
    is_new[lines.start[1:] - 1] = True
    return take_samples(
        field,
        Trail(
            2 * (first_line + line[is_new]),
            arc[is_new],
            lines.triangle[is_new],
            lines.barycentric[is_new],
            ahead[is_new],
            lines.family[line][is_new],
        ),
    )


def ray_seeds(lines: LineField, families: tuple[Family, ...], spacing: float) -> Seeds:
    """Return seeds beside the umbilics, where lines run straight out of them."""
    umbilics, mesh = lines.umbilics, lines.field.mesh
    has_ray = (umbilics.rays != 0.0).any(axis=2) & (np.abs(umbilics.index) == 0.5)[:, None]
    umbilic, number = np.nonzero(has_ray)
    ray = umbilics.rays[umbilic, number]
    none = np.zeros(0, dtype=np.int64)
    parts = [make_seeds(none, np.zeros((0, 3)), none)]
    for family, sign in ((Family.FIRST, 1.0), (Family.SECOND, -1.0)):
        if family not in families:
            continue
        way = np.full(len(ray), min(0.25 * spacing, 1.5 * mesh.edge_length))
        triangle, barycentric = shifted(
            lines.field,
            umbilics.triangle[umbilic],
            umbilics.barycentric[umbilic],
            sign * ray,
            way,
        )
        parts.append(
            Seeds(
                triangle,
                barycentric,
                np.full(len(ray), int(family), dtype=np.int64),
                umbilic.astype(np.int64),
                sign * ray,
            )
        )
    return joined_seeds(parts)


def gap_seeds(lines: LineField, placed: CurvatureLines, samples: Samples, spacing: float) -> Seeds:
    """Return seeds beside lines, where the next line is missing.

    One for every run of points along a side of a line that have no neighbor: the middle of the
    run, longest runs first.
    """
    field = lines.field
    step = samples_along(field, placed, 0.5 * spacing, 0)
    side = np.repeat([1.0, -1.0], len(step))
    both = step.chosen(np.tile(np.arange(len(step)), 2))
    left = side[:, None] * cross(both.normal, both.heading)
    left = unit(left)
    # Most have a neighbor already: that shows without walking there.
    guess = replace(both, position=both.position + spacing * left)
    is_open = distances(guess, samples, spacing, _GUESS * spacing) == np.inf
    run_end = np.diff(both.line, prepend=-1) != 0
    both, left = both.chosen(is_open), left[is_open]
    found, gone = _moved(field, both, left, np.full(len(both), spacing))
    gap = _gaps(found, samples, gone, spacing)
    is_narrow = gap < _ONE * spacing
    way = np.where(is_narrow, 0.5 * gap, spacing)
    found, gone = _moved(field, both, left, way)
    is_there = np.linalg.norm(found.position - both.position, axis=1) > 0.7 * way
    is_free = distances(found, samples, spacing, 0.85 * spacing) == np.inf
    is_free &= is_there & (lines.umbilics.triangle_area[found.triangle] < 0)
    number = np.cumsum(run_end | ~is_open)[is_open]
    run = np.cumsum(np.diff(is_free, prepend=False) | (np.diff(number, prepend=-1) != 0))
    rows = np.flatnonzero(is_free)
    names, first, size = np.unique(run[rows], return_index=True, return_counts=True)
    middle = rows[first + size // 2]
    middle = middle[np.argsort(-size, kind="stable")]
    del names
    middle = middle[apart(found.chosen(middle), spacing)]
    chosen = found.chosen(middle)
    return make_seeds(chosen.triangle, chosen.barycentric, chosen.family)


def _moved(
    field: DirectionField, samples: Samples, heading: Floats, way: Floats
) -> tuple[Samples, Floats]:
    """Return samples moved straight over the surface, and the direction they went."""
    triangle, barycentric = shifted(field, samples.triangle, samples.barycentric, heading, way)
    found = take_samples(
        field, Trail(samples.arm, samples.arc, triangle, barycentric, heading, samples.family)
    )
    gone = found.position - samples.position
    return found, unit(gone)


def _gaps(found: Samples, samples: Samples, gone: Floats, spacing: float) -> Floats:
    """Return the width of the gap in which each sample is, inf where it is wide, in meters."""
    sample, other = close_pairs(found, samples, spacing, (_ONE - 1.0) * spacing, 24)
    apart = samples.position[other] - found.position[sample]
    distance = np.linalg.norm(apart, axis=1)
    is_ahead = np.einsum("nx,nx->n", apart, gone[sample]) > 0.7 * distance
    gap = np.full(len(found), np.inf)
    np.minimum.at(gap, sample[is_ahead], spacing + distance[is_ahead])
    return gap


def apart(samples: Samples, spacing: float) -> Indices:
    """Return the samples that have no more important one of their family close by.

    Parameters
    ----------
    samples : Samples
        The most important first.
    spacing : float
        In meters.
    """
    sample, other = close_pairs(samples, samples, spacing, 0.85 * spacing, 12)
    is_kept = np.ones(len(samples), dtype=np.bool_)
    is_kept[sample[other < sample]] = False
    return np.flatnonzero(is_kept)
