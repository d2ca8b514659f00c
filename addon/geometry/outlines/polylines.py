# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Polylines: segments that share end points, chained into open and closed curves."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..groups import connected_groups
from ..types import Flags, Floats, Indices


@dataclass(frozen=True)
class Polylines:
    """Curves as rows of points.

    Parameters
    ----------
    points : (p, 3) float64
        In meters, curve by curve; a closed curve does not repeat its first point.
    start : (c + 1,) int64
        First point of every curve, and the number of points at the end.
    is_closed : (c,) bool
        Whether the last point of a curve is joined to its first.
    source : (p,) int64
        The node that each point came from.
    """

    points: Floats
    start: Indices
    is_closed: Flags
    source: Indices

    @property
    def count(self) -> int:
        """Number of curves."""
        return len(self.is_closed)

    @property
    def lengths(self) -> Floats:
        """(c,) lengths in meters, the closing segments included."""
        if not self.count:
            return np.zeros(0)
        following = np.arange(1, len(self.points) + 1)
        last = self.start[1:] - 1
        following[last] = np.where(self.is_closed, self.start[:-1], last)
        step = np.linalg.norm(self.points[following] - self.points, axis=1)
        return np.asarray(np.add.reduceat(step, self.start[:-1]), dtype=np.float64)


def chain_segments(segments: Indices, points: Floats) -> Polylines:
    """Join segments into curves that are as long as possible.

    Curves run on through nodes with two segments, and end where one, three or more meet: there
    several borders meet, and each is a curve of its own.

    Parameters
    ----------
    segments : (s, 2) int64
        Nodes at the ends of every segment; each segment once.
    points : (n, 3) float64
        Positions of the nodes in meters.

    Returns
    -------
    Polylines
        Longest first.
    """
    degree = np.bincount(segments.reshape(-1), minlength=len(points))
    # Nodes where curves end are split into one node per segment; what is left are paths and loops.
    ends = segments.reshape(-1)
    is_junction = degree[ends] != 2
    split = ends.copy()
    split[is_junction] = len(points) + np.flatnonzero(is_junction)
    names, compact = np.unique(split, return_inverse=True)
    original = np.empty(len(names), dtype=np.int64)
    original[compact.reshape(-1)] = ends
    order, curve, is_closed = _walk(compact.reshape(-1, 2), len(names))
    result = _sorted_by_length(points[original[order]], curve, is_closed, original[order])
    return result


def _walk(segments: Indices, count: int) -> tuple[Indices, Indices, Flags]:
    """Return the nodes in order along their curves, the curve of each, and which are closed.

    Positions along a curve come from pointer doubling: log(n) passes over all nodes at once.
    """
    group = connected_groups(segments, count)
    curve_count = int(group.max(initial=-1)) + 1
    edges = np.bincount(group[segments[:, 0]], minlength=curve_count)
    nodes = np.bincount(group, minlength=curve_count)
    is_closed = edges == nodes
    # Directed edges: each segment both ways; the successor of a->b is the b->c with c != a.
    tail = np.concatenate([segments[:, 0], segments[:, 1]])
    head = np.concatenate([segments[:, 1], segments[:, 0]])
    half = len(segments)
    twin = (np.arange(2 * half) + half) % (2 * half)
    by_tail = np.argsort(tail, kind="stable")
    first = np.searchsorted(tail[by_tail], np.arange(count))
    out_1 = by_tail[first]
    second = np.minimum(first + 1, len(by_tail) - 1)
    has_two = (first + 1 < len(by_tail)) & (tail[by_tail[second]] == np.arange(count))
    out_2 = np.where(has_two, by_tail[second], -1)
    onward = np.where(out_1[head] == twin, out_2[head], out_1[head])
    # One direction of each curve: from its start, the smallest end node or, if closed, any node.
    is_end = ~has_two
    start_node = np.full(curve_count, count, dtype=np.int64)
    candidates = np.flatnonzero(is_end | is_closed[group])
    np.minimum.at(start_node, group[candidates], candidates)
    begin = out_1[start_node]
    # Cut loops open where they start, then rank by doubling towards the end.
    following = onward.copy()
    cut = np.concatenate([begin[is_closed], twin[begin[is_closed]]])
    following[np.isin(onward, cut)] = -1
    distance = np.where(following >= 0, 1, 0).astype(np.int64)
    jump = following.copy()
    while (jump >= 0).any():
        live = jump >= 0
        step = jump[live]
        distance[live] += distance[step]
        jump[live] = jump[step]
    is_ours = np.zeros(2 * half, dtype=np.bool_)
    remaining = distance[begin][group[tail]] - distance
    # An edge belongs to the chosen direction if it ends where the chosen first edge ends.
    last_of = _final(following)
    is_ours = last_of == last_of[begin][group[tail]]
    chosen = np.flatnonzero(is_ours)
    key = np.lexsort((remaining[chosen], group[tail[chosen]]))
    chosen = chosen[key]
    order, curve = tail[chosen], group[tail[chosen]]
    # Open curves have one node more than edges.
    open_end = np.flatnonzero(np.append(curve[1:] != curve[:-1], True) & ~is_closed[curve])
    order = np.insert(order, open_end + 1, head[chosen[open_end]])
    curve = np.insert(curve, open_end + 1, curve[open_end])
    return order, curve, is_closed


def _final(following: Indices) -> Indices:
    """Return the last element of every element's chain."""
    last = np.where(following >= 0, following, np.arange(len(following)))
    while True:
        further = last[last]
        if np.array_equal(further, last):
            return last
        last = further


def _sorted_by_length(
    points: Floats, curve: Indices, is_closed: Flags, source: Indices
) -> Polylines:
    count = len(is_closed)
    size = np.bincount(curve, minlength=count)
    start = np.concatenate([[0], np.cumsum(size)]).astype(np.int64)
    raw = Polylines(points, start, is_closed, source)
    order = np.argsort(-np.round(raw.lengths, 9), kind="stable")
    rank = np.empty(count, dtype=np.int64)
    rank[order] = np.arange(count)
    moved = np.argsort(rank[curve], kind="stable")
    new_start = np.concatenate([[0], np.cumsum(size[order])]).astype(np.int64)
    return Polylines(points[moved], new_start, is_closed[order], source[moved])
