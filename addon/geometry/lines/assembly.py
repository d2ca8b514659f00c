# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines put together from their arms: trimmed, closed where the arms met, in one direction."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..types import Flags, Floats, Indices
from .endings import Arms, Rules, far_along
from .field import DirectionField
from .lines import CurvatureLines, LineEnd
from .samples import Samples, close_pairs
from .steps import cross, go_straight, start_walkers, unfold
from .vectors import cross as product
from .vectors import dot, unit

#: A line closes if its arms miss each other by no more than this share of its length, more where
#: directions are uncertain, or of a side of a triangle, and of the spacing. Of its length: what
#: turns it by half a degree.
_MISS_LENGTH, _MISS_EDGE, _MISS_SPACING = float(np.tan(np.radians(0.5))), 0.5, 0.4
#: Ends at which a line has crossed the whole of its piece: there even a short one is wanted.
_OUTLINE = (LineEnd.RIM, LineEnd.CREASE, LineEnd.AREA)
#: Shortest such line over the shortest of others.
_ACROSS = 0.1
#: Shortest closed line over the shortest side of the triangles that it runs through.
_RING = 2.0
#: Points closer than this share of a side of a triangle to the one before are left out.
_DOUBLE = 1e-4
#: The same of closed lines, for points that lie less far onward than this.
_CURL = 1e-2

#: Sides crossed in succession, with less way between them than this share of a side, after which a
#: place that is moved stays where it is.
_CROSSINGS, _PROGRESS = 100, 1e-6


@dataclass
class _Meetings:
    """Where the two arms of m lines meet: line, ways of the arms, miss to the left of the line."""

    line: Indices
    forward: Floats
    backward: Floats
    miss: Floats


def assemble(
    field: DirectionField, state: Arms, samples: Samples, rules: Rules, shortest: float
) -> CurvatureLines:
    """Return the lines that traced arms form.

    Parameters
    ----------
    field : DirectionField
    state : Arms
    samples : Samples
        As traced.
    rules : Rules
    shortest : float
        Lines below this length in meters are left out, and below a tenth of it from rim to rim,
        but none that go around a pipe.

    Returns
    -------
    CurvatureLines
        In the order of their seeds.
    """
    meetings = _meetings(field, state, samples, rules)
    samples = samples.chosen(
        (samples.arc <= state.cut[samples.arm])
        & ~state.is_removed[samples.line]
        & ((samples.arm % 2 == 0) | (samples.arc > 0.0))
    )
    triangle, barycentric = _closed(field, samples, meetings)
    order = np.lexsort((samples.signed_arc, samples.line))
    line = samples.line[order]
    position = field.mesh.points(triangle[order], barycentric[order])
    move = np.diff(position, axis=0, prepend=position[:1])
    move[np.diff(line, prepend=-1) != 0] = 0.0
    step = np.sqrt(dot(move, move))
    # Points of closed lines, which were moved each for itself, may have changed places.
    is_ring = np.zeros(len(state.is_removed), dtype=np.bool_)
    is_ring[meetings.line] = True
    onward = np.where(samples.arm[order] % 2 == 0, 1.0, -1.0) * dot(move, samples.heading[order])
    is_double = (step < _DOUBLE * field.mesh.edge_length) | (
        is_ring[line] & (onward < _CURL * field.mesh.edge_length)
    )
    is_double &= np.diff(line, prepend=-1) == 0
    length = np.bincount(line, step, len(state.is_removed))
    corner = np.arange(len(length))[:, None] * 2 + [1, 0]
    spans = np.isin(state.end[corner], _OUTLINE).all(axis=1)
    is_long = length >= np.where(spans, _ACROSS, 1.0) * shortest
    # Around a pipe there are three sides of triangles at least; less turns about one corner.
    is_long |= is_ring & (length > _RING * _sides(field, triangle[order], line, len(length)))
    is_kept = ~is_double & is_long[line]
    order, line = order[is_kept], line[is_kept]
    seed, count = np.unique(line, return_counts=True)
    return CurvatureLines(
        points=field.mesh.points(triangle[order], barycentric[order]),
        triangle=triangle[order],
        barycentric=barycentric[order],
        start=np.concatenate([[0], np.cumsum(count)]).astype(np.int64),
        family=_line_family(samples, len(state.is_removed))[seed],
        ends=state.end[np.stack([2 * seed + 1, 2 * seed], axis=1)],
    )


def _sides(field: DirectionField, triangle: Indices, line: Indices, count: int) -> Floats:
    """Return the mean of the shortest sides of each line's triangles, (n,) in meters."""
    corner = field.mesh.position[field.mesh.triangles[triangle]]
    side = np.roll(corner, -1, axis=1) - corner
    shortest = np.sqrt((side**2).sum(axis=2).min(axis=1))
    total = np.bincount(line, shortest, count)
    return total / np.maximum(np.bincount(line, minlength=count), 1)


def _line_family(samples: Samples, count: int) -> Indices:
    family = np.zeros(count, dtype=np.int64)
    family[samples.line] = samples.family
    return family


def _meetings(field: DirectionField, state: Arms, samples: Samples, rules: Rules) -> _Meetings:
    """Return where lines close, cut their arms there; arms that miss each other end instead."""
    inside = state.closing[samples.line] & ~state.is_removed[samples.line]
    inside &= samples.arc <= state.cut[samples.arm]
    forward = samples.chosen(inside & (samples.arm % 2 == 0))
    backward = samples.chosen(inside & (samples.arm % 2 == 1))
    one, two = _own_pairs(forward, backward, rules)
    apart = forward.position[one] - backward.position[two]
    ahead = np.einsum("nx,nx->n", apart, backward.heading[two])
    far = far_along(forward.chosen(one), backward.chosen(two), rules.spacing)
    # The first place of the forward arm that lies beside the backward one, not beyond its end.
    last = np.zeros(len(state.closing))
    np.maximum.at(last, backward.line, backward.arc)
    is_beside = (ahead <= 0.0) | (backward.arc[two] < last[backward.line[two]])
    behind = np.flatnonzero(far & is_beside)
    order = behind[np.lexsort((forward.arc[one[behind]], forward.arm[one[behind]]))]
    first = order[np.flatnonzero(np.diff(forward.line[one[order]], prepend=-1))]
    left = product(forward.normal[one[first]], forward.heading[one[first]])
    left = unit(left)
    found = _Meetings(
        line=forward.line[one[first]],
        forward=forward.arc[one[first]],
        backward=backward.arc[two[first]] + ahead[first],
        miss=-np.einsum("nx,nx->n", left, apart[first]),
    )
    length = found.forward + found.backward
    astray = _MISS_LENGTH + _doubts(field, samples, len(state.closing))[found.line]
    allowed = np.maximum(astray * length, _MISS_EDGE * field.mesh.edge_length)
    is_closed = np.abs(found.miss) <= np.minimum(allowed, _MISS_SPACING * rules.spacing)
    missed = 2 * found.line[~is_closed] + 1
    state.cut[missed] = np.minimum(state.cut[missed], found.backward[~is_closed])
    is_open = state.closing & ~state.is_removed
    is_open[found.line[is_closed]] = False
    _end_open(state, forward, one, far, np.flatnonzero(is_open))
    # Who reached an umbilic or a neighbor in the step in which it closed is closed all the same.
    state.end[2 * found.line[is_closed]] = LineEnd.CLOSED
    state.end[2 * found.line[is_closed] + 1] = LineEnd.CLOSED
    state.cut[2 * found.line[is_closed]] = found.forward[is_closed]
    state.cut[2 * found.line[is_closed] + 1] = (
        found.backward[is_closed] - 0.1 * field.mesh.edge_length
    )
    return _Meetings(
        *(getattr(found, name)[is_closed] for name in ("line", "forward", "backward", "miss"))
    )


def _doubts(field: DirectionField, samples: Samples, count: int) -> Floats:
    """Return the mean uncertainty of the directions along each line, (n,) float64 in radians."""
    doubt = 0.5 * field.uncertainty / np.maximum(field.strength, field.doubt)
    corner = field.mesh.triangles[samples.triangle]
    total = np.bincount(samples.line, doubt[corner].mean(axis=1), count)
    return total / np.maximum(np.bincount(samples.line, minlength=count), 1)


def _own_pairs(forward: Samples, backward: Samples, rules: Rules) -> tuple[Indices, Indices]:
    """Return pairs of samples on the two arms of a line that are close, nearest first."""
    one, two = forward.by_line(), backward.by_line()
    return close_pairs(one, two, rules.spacing, rules.nearest, 1)


def _end_open(state: Arms, forward: Samples, one: Indices, far: Flags, lines: Indices) -> None:
    """End the forward arms of lines where they first come close to their own backward arms."""
    is_missed = np.isin(forward.line, lines)[one] & far
    arm, arc = forward.arm[one[is_missed]], forward.arc[one[is_missed]]
    np.minimum.at(state.cut, arm, arc)
    both = np.concatenate([2 * lines, 2 * lines + 1])
    state.end[both] = LineEnd.NEIGHBOR
    state.cut[both] = np.minimum(state.cut[both], state.turned[both])


def _closed(field: DirectionField, samples: Samples, meetings: _Meetings) -> tuple[Indices, Floats]:
    """Return the samples' places, those of closed lines moved so that the arms meet.

    What the arms miss each other by is spread over the whole line, which turns it by no more than
    the miss over the length.
    """
    rate = np.zeros(int(samples.line.max(initial=-1)) + 1)
    whole = np.maximum(meetings.forward + meetings.backward, 1e-300)
    rate[meetings.line] = meetings.miss / whole
    way = rate[samples.line] * samples.signed_arc
    is_backward = samples.arm % 2
    moving = np.flatnonzero(np.abs(way) > 1e-6 * field.mesh.edge_length)
    left = product(samples.normal[moving], samples.heading[moving])
    # Headings of the backward arm run against the line.
    left *= np.where((is_backward[moving] == 1) != (way[moving] < 0.0), -1.0, 1.0)[:, None]
    left = unit(left)
    triangle, barycentric = samples.triangle.copy(), samples.barycentric.copy()
    triangle[moving], barycentric[moving] = shifted(
        field, triangle[moving], barycentric[moving], left, np.abs(way[moving])
    )
    return triangle, barycentric


def shifted(
    field: DirectionField, triangle: Indices, barycentric: Floats, heading: Floats, way: Floats
) -> tuple[Indices, Floats]:
    """Return places moved straight over the surface, as far as it goes.

    Parameters
    ----------
    field : DirectionField
    triangle : (n,) int64
    barycentric : (n, 3) float64
    heading : (n, 3) float64
        Tangents of any length.
    way : (n,) float64
        In meters.

    Returns
    -------
    triangle : (n,) int64
    barycentric : (n, 3) float64
    """
    walkers = start_walkers(triangle, barycentric, heading, np.ones(len(triangle), dtype=np.int64))
    left, idle = way.copy(), np.zeros(len(way), dtype=np.int64)
    active = np.arange(len(left))
    while len(active):
        moving = walkers.chosen(active)
        done, side = go_straight(field.mesh, moving, left[active])
        is_out = cross(field.mesh, moving, side)
        unfold(field.mesh, moving, np.where(is_out, -1, side))
        walkers.put(active, moving)
        left[active] -= done
        # Who turns about a corner without getting on has gone as far as it goes.
        idle[active] = np.where(done > _PROGRESS * field.mesh.edge_length, 0, idle[active] + 1)
        active = active[~is_out & (side >= 0) & (idle[active] <= _CROSSINGS)]
    return walkers.triangle, walkers.barycentric
