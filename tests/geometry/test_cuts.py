# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Minimum cuts are the smallest there are, from whatever flow they take up, and near or far."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from architectural_curvature.addon.geometry.cleaning.cuts import CutProblem, minimum_cut
from architectural_curvature.addon.geometry.cleaning.potts import (
    Flows,
    PottsProblem,
    minimize_potts,
)
from numpy.typing import NDArray

SEEDS = pytest.mark.parametrize("seed", range(10))


def _random(seed: int, items: int = 10) -> CutProblem:
    rng = np.random.default_rng(seed)
    pairs = np.array(
        [pair for pair in itertools.combinations(range(items), 2) if rng.random() < 0.4]
    )
    forth, back = rng.integers(0, 20, (2, len(pairs))).astype(np.float64)
    surplus = rng.integers(-40, 40, items).astype(np.float64)
    return CutProblem(surplus, pairs[:, 0], pairs[:, 1], forth, back)


def _grid(seed: int, size: int) -> CutProblem:
    """Return items in rows and columns of which very few gain, some of them much."""
    rng = np.random.default_rng(seed)
    number = np.arange(size * size).reshape(size, size)
    a = np.concatenate([number[1:].ravel(), number[:, 1:].ravel()])
    b = np.concatenate([number[:-1].ravel(), number[:, :-1].ravel()])
    surplus = -rng.integers(0, 12, size * size).astype(np.float64)
    gaining = rng.choice(size * size, 5, replace=False)
    surplus[gaining] = [5.0, 60.0, 200.0, 1000.0, 20_000.0]
    capacity = rng.integers(5, 60, (2, len(a))).astype(np.float64)
    return CutProblem(surplus, a, b, *capacity)


def _cost(problem: CutProblem, changes: NDArray[np.bool_]) -> float:
    one, other = changes[problem.a], changes[problem.b]
    arcs = problem.forth[one & ~other].sum() + problem.back[other & ~one].sum()
    return float(arcs - problem.surplus[changes].sum())


@SEEDS
def test_the_cut_is_the_smallest_and_of_these_changes_fewest(seed: int) -> None:
    problem = _random(seed)
    found, flow = minimum_cut(problem)
    every = [np.array(flags) for flags in itertools.product([False, True], repeat=10)]
    costs = np.array([_cost(problem, flags) for flags in every])
    least = [flags for flags, cost in zip(every, costs, strict=True) if cost == costs.min()]
    assert found.tolist() == min(least, key=lambda flags: flags.sum()).tolist()
    assert (flow <= problem.forth).all()
    assert (-flow <= problem.back).all()


@SEEDS
def test_any_flow_sent_before_leaves_the_same_cut(seed: int) -> None:
    problem = _random(seed)
    share = np.random.default_rng(seed + 100).random(len(problem.a))
    flow = np.round(share * (problem.forth + problem.back) - problem.back)
    assert (minimum_cut(problem.sent(flow))[0] == minimum_cut(problem)[0]).all()


@SEEDS
def test_a_cut_found_near_those_who_gain_is_that_of_all(seed: int) -> None:
    problem = _grid(seed, 40)
    near, _ = minimum_cut(problem)
    assert 0 < near.sum() < len(near)
    # With as much gained and lost at every second item, all must be asked.
    flow = np.round(0.5 * np.minimum(problem.forth, problem.back)) * (-1.0) ** problem.a
    everywhere = problem.sent(flow)
    assert (everywhere.surplus > 0.0).mean() > 0.1
    assert (minimum_cut(everywhere)[0] == near).all()


@SEEDS
def test_after_the_flow_that_was_found_nothing_is_left_to_gain(seed: int) -> None:
    problem = _grid(seed, 40)
    changes, flow = minimum_cut(problem)
    rest = problem.sent(flow)
    assert not (rest.surplus[~changes] > 0.0).any()
    again, more = minimum_cut(rest)
    assert (again == changes).all()
    assert not more[~changes[rest.a] & ~changes[rest.b]].any()


@SEEDS
def test_labels_do_not_depend_on_the_flows_they_take_up(seed: int) -> None:
    rng = np.random.default_rng(seed)
    number = np.arange(400).reshape(20, 20)
    links = np.concatenate(
        [
            np.stack([number[1:].ravel(), number[:-1].ravel()], axis=1),
            np.stack([number[:, 1:].ravel(), number[:, :-1].ravel()], axis=1),
        ]
    )
    weight, cost = rng.random(len(links)), rng.random((400, 4))
    flows: Flows = []
    minimize_potts(PottsProblem(cost, links, weight), flows=flows)
    cost[rng.choice(400, 20)] = rng.random((20, 4))
    changed = PottsProblem(cost, links, weight)
    assert (minimize_potts(changed, flows=flows) == minimize_potts(changed)).all()
