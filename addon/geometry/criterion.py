# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What counts as curved: limits in the terms that a designer thinks in."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from .classification import SurfaceClass, classify
from .errors import InvalidSettingError
from .settings import CriterionKind, SegmentationSettings
from .tolerance import Tolerance, resolve_tolerance
from .types import Flags, Floats, Indices


@dataclass(frozen=True)
class Criterion:
    """Limits that decide between flat, single-curved and double-curved.

    With a panel or a radius both principal curvatures have one limit. With raw limits a face is
    flat if |K| and |H| are within theirs, single-curved if only |K| is, double-curved otherwise.

    Parameters
    ----------
    kind : CriterionKind
    tolerance : Tolerance
        The panel, which is the scale of what matters, and the deviation that follows from the
        limits over it.
    gaussian_limit : float or None
        Limit of |K| in 1/m² with raw limits; None with the others.
    """

    kind: CriterionKind
    tolerance: Tolerance
    gaussian_limit: float | None = None

    def __post_init__(self) -> None:
        """Refuse limits that separate nothing."""
        limit = self.gaussian_limit
        if (self.kind is CriterionKind.RAW) != (limit is not None):
            raise InvalidSettingError("raw limits, and only they, need a limit of |K|")
        if limit is not None and not (math.isfinite(limit) and limit > 0.0):
            raise InvalidSettingError(
                f"the limit of |K| must be greater than zero, not {limit:g} 1/m²"
            )

    @property
    def curvature_limit(self) -> float:
        """Limit in 1/m of the principal curvatures; of |H| with raw limits."""
        return self.tolerance.curvature_limit

    @property
    def words(self) -> str:
        """The criterion in a sentence for legends and reports."""
        if self.gaussian_limit is not None:
            return (
                f"single-curved: |K| at most {self.gaussian_limit:g} 1/m²; "
                f"flat: also |H| at most {self.curvature_limit:g} 1/m"
            )
        if self.kind is CriterionKind.RADIUS:
            return f"straight: radius of at least {self.tolerance.radius_limit:g} m"
        return (
            f"single-curved: within {1000.0 * self.tolerance.deviation:g} mm of a cylinder "
            f"over a {self.tolerance.panel_size:g} m panel"
        )


def panel_criterion(tolerance: Tolerance) -> Criterion:
    """Return the limit at which a panel's chord deviates by what its maker accepts."""
    return Criterion(CriterionKind.PANEL, tolerance)


def radius_criterion(smallest_radius: float, panel_size: float) -> Criterion:
    """Return the limit of a radius beyond which a panel counts as straight.

    Parameters
    ----------
    smallest_radius, panel_size : float
        In meters.
    """
    _refuse_zero("smallest radius", smallest_radius, "m")
    deviation = panel_size**2 / (8.0 * smallest_radius)
    return Criterion(CriterionKind.RADIUS, Tolerance(panel_size, deviation))


def raw_criterion(gaussian_limit: float, mean_limit: float, panel_size: float) -> Criterion:
    """Return raw limits of |K| in 1/m² and |H| in 1/m, for panels of a size in meters."""
    _refuse_zero("limit of |H|", mean_limit, "1/m")
    tolerance = Tolerance(panel_size, mean_limit * panel_size**2 / 8.0)
    return Criterion(CriterionKind.RAW, tolerance, gaussian_limit)


def resolve_criterion(settings: SegmentationSettings, diagonal: float) -> Criterion:
    """Return the criterion of settings, with defaults where they say nothing.

    Parameters
    ----------
    settings : SegmentationSettings
    diagonal : float
        Diagonal of the model's bounding box in meters.

    Returns
    -------
    Criterion

    Raises
    ------
    InvalidSettingError
        If a value makes no sense, or no size is given for a model without extent.
    """
    tolerance = resolve_tolerance(settings.panel_size, settings.deviation, diagonal)
    if settings.criterion is CriterionKind.RADIUS:
        return radius_criterion(settings.smallest_radius, tolerance.panel_size)
    if settings.criterion is CriterionKind.RAW:
        return raw_criterion(settings.gaussian_limit, settings.mean_limit, tolerance.panel_size)
    return panel_criterion(tolerance)


def _refuse_zero(name: str, value: float, unit: str) -> None:
    if not (math.isfinite(value) and value > 0.0):
        raise InvalidSettingError(f"the {name} must be greater than zero, not {value:g} {unit}")


def classify_by(k1: Floats, k2: Floats, criterion: Criterion, is_defined: Flags) -> Indices:
    """Return the class of every face or point by whichever limits the criterion has.

    Parameters
    ----------
    k1, k2 : (m,) float64
        Principal curvatures in 1/m.
    criterion : Criterion
    is_defined : (m,) bool

    Returns
    -------
    (m,) int64
        Values of `SurfaceClass`.
    """
    if criterion.gaussian_limit is None:
        return classify(k1, k2, criterion.curvature_limit, is_defined)
    gaussian, mean = k1 * k2, 0.5 * (k1 + k2)
    double = np.where(gaussian > 0.0, SurfaceClass.ELLIPTIC, SurfaceClass.HYPERBOLIC)
    straight = np.where(
        np.abs(mean) <= criterion.curvature_limit, SurfaceClass.FLAT, SurfaceClass.SINGLE
    )
    labels = np.where(np.abs(gaussian) <= criterion.gaussian_limit, straight, double)
    return np.where(is_defined, labels, SurfaceClass.UNDEFINED).astype(np.int64)
