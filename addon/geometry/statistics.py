# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Area-weighted statistics of curvature."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .types import Floats, Indices

#: Share of the area that a smallest radius leaves out, against single bad faces.
RADIUS_PERCENTILE = 99.0

#: Shares that differ by no more than this are equal: sums of areas carry rounding.
_TIE = 1e-12


@dataclass(frozen=True)
class Summary:
    """Distribution of a quantity over the surface, weighted by area; in the quantity's unit."""

    min: float
    max: float
    mean: float
    median: float
    p05: float
    p95: float


def weighted_percentiles(values: Floats, weights: Floats, percents: Floats) -> Floats:
    """Return the values below which given shares of the weight lie.

    A value of weight 3 counts as three values of weight 1 do. Nothing is interpolated: between a
    large face and a tiny one there are no faces whose curvature would lie between theirs.

    Parameters
    ----------
    values, weights : (n,) float64
        Weights are not negative and do not all vanish; n >= 1.
    percents : (p,) float64
        0 to 100.

    Returns
    -------
    (p,) float64
        Values that occur; the mean of two where the share ends just between them.
    """
    used = weights > 0.0
    values = values[used]
    order = np.argsort(values)
    total = np.cumsum(weights[used][order])
    wanted = percents / 100.0 * total[-1]
    slack = _TIE * total[-1]
    found: list[Indices] = [
        np.searchsorted(total, wanted - slack, side="left"),
        np.searchsorted(total, wanted + slack, side="right"),
    ]
    lower, upper = (values[order[np.minimum(index, len(order) - 1)]] for index in found)
    return 0.5 * (lower + upper)


def summarize(values: Floats, weights: Floats) -> Summary | None:
    """Return the distribution of values that stand for areas.

    Parameters
    ----------
    values : (n,) float64
    weights : (n,) float64
        Areas in m².

    Returns
    -------
    Summary or None
        None where no area has a value.
    """
    if not weights.sum() > 0.0:
        return None
    used = weights > 0.0
    values, weights = values[used], weights[used]
    p05, median, p95 = weighted_percentiles(values, weights, np.array([5.0, 50.0, 95.0]))
    return Summary(
        min=float(values.min()),
        max=float(values.max()),
        mean=float(np.average(values, weights=weights)),
        median=float(median),
        p05=float(p05),
        p95=float(p95),
    )


def area_histogram(
    values: Floats, areas: Floats, last: float, bars: int
) -> tuple[list[float], list[float]]:
    """Return how much area has which value, from 0 to a last value.

    Parameters
    ----------
    values, areas : (n,) float64
        Values are not negative.
    last : float
        Upper end of the last bar, which holds all values beyond it as well.
    bars : int

    Returns
    -------
    edges : list of bars + 1 float
    areas : list of float
    """
    edges = np.linspace(0.0, last, bars + 1)
    counts, _ = np.histogram(np.minimum(values, last), edges, weights=areas)
    return edges.tolist(), counts.tolist()


def smallest_radius(curvature_size: Floats, areas: Floats) -> float | None:
    """Return the radius that 99 % of the area does not fall below.

    Parameters
    ----------
    curvature_size : (n,) float64
        Larger absolute principal curvature in 1/m.
    areas : (n,) float64
        In m².

    Returns
    -------
    float or None
        In meters; None where there is no area or no curvature.
    """
    if not areas.sum() > 0.0:
        return None
    size = weighted_percentiles(curvature_size, areas, np.array([RADIUS_PERCENTILE]))[0]
    return float(1.0 / size) if size > 0.0 else None
