# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which values a color map spans: symmetric on zero, so that its middle means zero."""

from __future__ import annotations

import math

import numpy as np

from ..statistics import weighted_percentiles
from ..types import Floats

#: Values below this share of the surface's own scale are shown as zero.
_SMALLEST_SHARE = 0.01


def percentile_limit(values: Floats, areas: Floats, percent: float, scale: float) -> float:
    """Return the value that bounds a given share of the area, rounded up to two digits.

    Parameters
    ----------
    values : (n,) float64
    areas : (n,) float64
        In m².
    percent : float
        Share of the area whose values lie within the limit, 0 to 100.
    scale : float
        Size of the quantity that the surface's larger curvature would give. A cylinder's Gaussian
        curvature is zero but for rounding, which must not be blown up to full colors: the limit
        is at least a hundredth of this.

    Returns
    -------
    float
        Greater than zero; 1 for a plane.
    """
    size = 0.0
    if areas.sum() > 0.0:
        size = float(weighted_percentiles(np.abs(values), areas, np.array([percent]))[0])
    size = max(size, _SMALLEST_SHARE * scale)
    return round_up(size) if size > 1e-9 else 1.0


def round_up(value: float) -> float:
    """Return the next number with two significant digits, for values greater than zero."""
    digit = 10.0 ** (math.floor(math.log10(value)) - 1)
    return float(f"{math.ceil(round(value / digit, 6)) * digit:.2g}")


def clipped_share(values: Floats, areas: Floats, limit: float) -> float:
    """Return the share of the area, 0 to 1, whose values lie beyond the limit."""
    total = float(areas.sum())
    return float(areas[np.abs(values) > limit].sum()) / total if total > 0.0 else 0.0
