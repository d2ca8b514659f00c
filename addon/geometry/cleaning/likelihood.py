# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""How probable each class is, given an uncertain curvature."""

from __future__ import annotations

import numpy as np

from ..criterion import Criterion
from ..types import Floats

#: A cost that no border is worth: what is certain stays, however small.
CERTAIN = 100.0

#: Share of the limit that a class border is uncertain by: nobody knows a tolerance to a percent.
_SHARPNESS = 0.02


def class_costs(k1: Floats, k2: Floats, uncertainty: Floats, criterion: Criterion) -> Floats:
    """Return the negative logarithm of the probability of every class.

    The two curvatures are taken as independent and normally distributed, and so are K and H.

    Parameters
    ----------
    k1, k2 : (m,) float64
        Principal curvatures in 1/m.
    uncertainty : (m,) float64
        Their standard deviation in 1/m.
    criterion : Criterion

    Returns
    -------
    (m, 4) float64
        Flat, single-curved, elliptic, hyperbolic; the least is 0, none is above `CERTAIN`.
    """
    limit = criterion.curvature_limit
    # Where an estimate says that it knows nothing, it is still the best guess there is.
    uncertainty = np.minimum(uncertainty, limit)
    if criterion.gaussian_limit is None:
        logarithm = _by_principal(k1, k2, np.hypot(uncertainty, _SHARPNESS * limit), limit)
    else:
        logarithm = _by_gaussian_and_mean(k1, k2, uncertainty, limit, criterion.gaussian_limit)
    cost = np.minimum(-logarithm, CERTAIN)
    return np.maximum(cost - cost.min(axis=1, keepdims=True), 0.0)


def _by_principal(k1: Floats, k2: Floats, deviation: Floats, limit: float) -> Floats:
    above_1, below_1, within_1 = _tails(k1, deviation, limit)
    above_2, below_2, within_2 = _tails(k2, deviation, limit)
    return np.stack(
        [
            within_1 + within_2,
            np.logaddexp(
                within_1 + np.logaddexp(above_2, below_2),
                within_2 + np.logaddexp(above_1, below_1),
            ),
            np.logaddexp(above_1 + above_2, below_1 + below_2),
            np.logaddexp(above_1 + below_2, below_1 + above_2),
        ],
        axis=1,
    )


def _by_gaussian_and_mean(
    k1: Floats, k2: Floats, uncertainty: Floats, mean_limit: float, gaussian_limit: float
) -> Floats:
    mean_deviation = np.hypot(np.sqrt(0.5) * uncertainty, _SHARPNESS * mean_limit)
    above, below, within = _tails(0.5 * (k1 + k2), mean_deviation, mean_limit)
    gaussian_deviation = np.hypot(uncertainty * np.hypot(k1, k2), _SHARPNESS * gaussian_limit)
    dome, saddle, straight = _tails(k1 * k2, gaussian_deviation, gaussian_limit)
    return np.stack(
        [straight + within, straight + np.logaddexp(above, below), dome, saddle], axis=1
    )


def _tails(value: Floats, deviation: Floats, limit: float) -> tuple[Floats, Floats, Floats]:
    """Return log P(v > limit), log P(v < -limit) and log P(|v| < limit)."""
    # scipy takes a noticeable part of a second to load, which Blender's start must not pay for.
    from scipy.special import log_ndtr

    above, below = log_ndtr((value - limit) / deviation), log_ndtr((-limit - value) / deviation)
    not_above, not_below = (
        log_ndtr((limit - value) / deviation),
        log_ndtr((value + limit) / deviation),
    )
    # P(-l < v < l) = P(v < l) P(v > -l), but for the product of the two tails
    return above, below, not_above + not_below
