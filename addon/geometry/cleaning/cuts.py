# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Minimum cuts: which items change where each gains or loses by it, and unlike neighbors cost."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..groups import sum_by_group
from ..types import AnyArray, Flags, Floats, Graph, Indices

#: Capacities of scipy's maximum flow are 32-bit whole numbers; sums of a few must fit too.
LARGEST = 2**27

#: Items are decided one by one as long as that settles this share of them at once.
_WORTHWHILE = 0.1

#: Links around those who gain within which a cut is looked for first, if they are no more than this
#: share of all.
_NEAR, _FEW = 6, 0.01


@dataclass
class CutProblem:
    """Items that may change; all values are whole numbers.

    Parameters
    ----------
    surplus : (n,) float64
        What each item gains by changing.
    a, b : (p,) int64
        Items that arcs join.
    forth, back : (p,) float64
        What it costs if a changes and b does not, and the other way round; not negative, and those
        of an item together at most `LARGEST`.
    """

    surplus: Floats
    a: Indices
    b: Indices
    forth: Floats
    back: Floats

    def sent(self, flow: Floats) -> CutProblem:
        """Return the problem with the same solutions after a flow from a to b along every arc.

        It is as if the flow were already found to be part of the largest one: the better the guess,
        the less is left to find.
        """
        many = len(self.surplus)
        lost = sum_by_group(self.a, flow, many) - sum_by_group(self.b, flow, many)
        return CutProblem(self.surplus - lost, self.a, self.b, self.forth - flow, self.back + flow)

    def part(self, items: Flags) -> tuple[CutProblem, Indices]:
        """Return the problem of some items as if they had no arcs to others, and its arcs."""
        number = np.cumsum(items) - 1
        arcs = np.flatnonzero(items[self.a] & items[self.b])
        return CutProblem(
            self.surplus[items],
            number[self.a[arcs]],
            number[self.b[arcs]],
            self.forth[arcs],
            self.back[arcs],
        ), arcs

    def around(self) -> tuple[Floats, Floats]:
        """Return the capacities of all arcs out of and into every item."""
        count = len(self.surplus)
        return (
            sum_by_group(self.a, self.forth, count) + sum_by_group(self.b, self.back, count),
            sum_by_group(self.a, self.back, count) + sum_by_group(self.b, self.forth, count),
        )


def minimum_cut(problem: CutProblem) -> tuple[Flags, Floats]:
    """Return which items change in the minimum cut that changes fewest, and the flow along arcs.

    What is gained flows along arcs to where it is lost. If those who gain are few, all may be lost
    near them, or what changes may end there: then nobody farther off needs to be asked.

    Parameters
    ----------
    problem : CutProblem

    Returns
    -------
    (n,) bool
    (p,) float64
        From a to b.
    """
    a, b = problem.a, problem.b
    changes, flow = np.zeros(len(problem.surplus), dtype=np.bool_), np.zeros(len(a))
    is_inside = problem.surplus > 0.0
    is_inside[:] |= is_inside.sum() > _FEW * len(is_inside)
    rings = _NEAR
    while is_inside.any():
        for _ in range(0 if is_inside.all() else rings):
            near = is_inside.copy()
            near[b[is_inside[a]]] = True
            near[a[is_inside[b]]] = True
            is_inside = near
        is_inside[:] |= 2 * is_inside.sum() > len(is_inside)
        part, arcs = problem.part(is_inside)
        changes[is_inside], flow[arcs] = _solved(part)
        leaks = (changes[a] & ~is_inside[b] & (problem.forth > 0.0)) | (
            changes[b] & ~is_inside[a] & (problem.back > 0.0)
        )
        if not leaks.any():
            break
        rings *= 2
    return changes, flow


def _solved(problem: CutProblem) -> tuple[Flags, Floats]:
    """Return which items change, and the flow along arcs."""
    flow = np.zeros(len(problem.a))
    changes, is_open = np.zeros((2, len(problem.surplus)), dtype=np.bool_)
    is_open[:] = True
    rest, arcs = problem, np.arange(len(flow))
    while (rest.surplus > 0.0).any():
        out, into = rest.around()
        # Who gains more than all its arcs cost changes in any case, lonely items among them; whom
        # no neighbor can talk into it never does. Flow fills the arcs between them and others.
        is_changing, is_staying = rest.surplus > out, rest.surplus <= -into
        sent = np.where(is_changing[rest.a] | is_staying[rest.b], rest.forth, 0.0)
        sent = np.where(is_changing[rest.b] | is_staying[rest.a], -rest.back, sent)
        is_decided = is_changing | is_staying
        sent[is_decided[rest.a] & is_decided[rest.b]] = 0.0
        flow[arcs] = sent
        items = np.flatnonzero(is_open)
        changes[items[is_changing]] = True
        is_open[items[is_decided]] = False
        rest, kept = rest.sent(sent).part(~is_decided)
        arcs = arcs[kept]
        if is_decided.sum() <= _WORTHWHILE * len(is_decided):
            if (rest.surplus > 0.0).any():
                changes[is_open], flow[arcs] = _by_maximum_flow(rest)
            break
    return changes, flow


def _by_maximum_flow(problem: CutProblem) -> tuple[Flags, Floats]:
    """Return which items change, and the flow along arcs.

    An item on the source's side changes; it then pays its loss, one on the sink's side its gain.
    """
    a, b, count = problem.a, problem.b, len(problem.surplus)
    out, into = problem.around()
    # Larger capacities than all arcs of an item together decide nothing more.
    surplus = np.clip(problem.surplus, -1.0 - into, 1.0 + out).astype(np.int32)
    source, sink = count, count + 1
    gains, losses = np.flatnonzero(surplus > 0), np.flatnonzero(surplus < 0)
    row = np.concatenate([a, b, np.full(len(gains), source), losses])
    column = np.concatenate([b, a, gains, np.full(len(losses), sink)])
    arcs = (each.astype(np.int32) for each in (problem.forth, problem.back))
    capacity = np.concatenate([*arcs, surplus[gains], -surplus[losses]])
    reached, sent = _source_side(row, column, capacity, count)
    changes = np.zeros(count + 2, dtype=np.bool_)
    changes[reached] = True
    return changes[:count], np.asarray(sent[a, b], dtype=np.float64).reshape(-1)


def _source_side(
    row: Indices, column: Indices, capacity: AnyArray, count: int
) -> tuple[AnyArray, Graph]:
    """Return what the source `count` reaches beside a maximum flow to the sink `count + 1`."""
    # scipy takes a noticeable part of a second to load, which Blender's start must not pay for.
    from scipy.sparse import csr_matrix
    from scipy.sparse.csgraph import breadth_first_order, maximum_flow

    graph: Graph = csr_matrix((capacity, (row, column)), shape=(count + 2, count + 2))
    graph.indices, graph.indptr = graph.indices.astype(np.int32), graph.indptr.astype(np.int32)
    flow: Graph = maximum_flow(graph, count, count + 1).flow
    residual: Graph = graph - flow
    residual.data = np.maximum(residual.data, 0)
    residual.eliminate_zeros()
    return breadth_first_order(residual, count, return_predecessors=False), flow
