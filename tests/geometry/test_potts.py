# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Minimum cuts: exact for two labels, close to it for more, whatever the order."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from architectural_curvature.addon.geometry.cleaning.potts import PottsProblem, minimize_potts

SEEDS = pytest.mark.parametrize("seed", range(20))


def _random(seed: int, items: int, labels: int) -> PottsProblem:
    rng = np.random.default_rng(seed)
    links = [(i, j) for i in range(items) for j in range(i) if rng.random() < 0.4]
    return PottsProblem(
        2.0 * rng.random((items, labels)),
        np.array(links, dtype=np.int64).reshape(-1, 2),
        rng.random(len(links)),
    )


def _least(problem: PottsProblem) -> float:
    items, count = problem.cost.shape
    return min(
        problem.energy(np.array(labels)) for labels in itertools.product(range(count), repeat=items)
    )


@SEEDS
def test_two_labels_reach_the_least_energy(seed: int) -> None:
    problem = _random(seed, 9, 2)
    assert problem.energy(minimize_potts(problem)) == pytest.approx(_least(problem), abs=1e-6)


@SEEDS
def test_more_labels_stay_within_the_proven_factor(seed: int) -> None:
    problem = _random(seed, 7, 3)
    assert problem.energy(minimize_potts(problem)) <= 2.0 * _least(problem)


@SEEDS
def test_the_order_of_items_does_not_matter(seed: int) -> None:
    problem = _random(seed, 12, 4)
    order = np.random.default_rng(seed).permutation(12)
    shuffled = PottsProblem(problem.cost[order], np.argsort(order)[problem.links], problem.weight)
    assert (minimize_potts(shuffled) == minimize_potts(problem)[order]).all()


def test_lonely_items_take_their_cheapest_label() -> None:
    """An item whose neighbors are all settled has no arcs in the cut."""
    cost = np.array([[5.0, 0.0], [0.2, 0.0]])
    problem = PottsProblem(cost, np.array([[0, 1]]), np.array([0.1]))
    assert minimize_potts(problem).tolist() == [1, 1]


def test_fixed_labels_stay_and_win_over_neighbors_that_border_on_them() -> None:
    cost = np.array([[0.0, 9.0], [0.0, 9.0]])
    weak = PottsProblem(cost, np.array([[0, 1]]), np.array([1.0]))
    assert minimize_potts(weak, np.array([1, -1])).tolist() == [1, 0]
    strong = PottsProblem(cost, np.array([[0, 1]]), np.array([20.0]))
    assert minimize_potts(strong, np.array([1, -1])).tolist() == [1, 1]


def test_progress_rises_and_may_stop_the_work() -> None:
    shares: list[float] = []
    minimize_potts(_random(0, 12, 4), on_progress=shares.append)
    assert shares == sorted(shares)
    assert 0.0 < shares[0] <= shares[-1] <= 1.0

    def stop(share: float) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        minimize_potts(_random(0, 12, 4), on_progress=stop)
