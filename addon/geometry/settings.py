# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Settings of an analysis, as values."""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import Enum

from .errors import InvalidSettingError


class Smoothing(Enum):
    """What counts as noise; the value is the name that users read."""

    AUTO = "Auto"
    NONE = "None"
    LENGTH = "Length"


class CriterionKind(Enum):
    """How the limits are given; the value is the name that users read."""

    PANEL = "Panel and Deviation"
    RADIUS = "Smallest Radius"
    RAW = "Gaussian and Mean Curvature"


@dataclass(frozen=True)
class AnalysisSettings:
    """How curvature is measured.

    Parameters
    ----------
    crease_angle : float
        Dihedral angle in radians above which an edge is a crease, 0 to pi.
    flip_normals : bool
        Whether the surface is seen from the other side: k1, k2 and H change sign.
    smoothing : Smoothing
        AUTO measures the noise and smooths no more than it asks for; NONE never smooths; LENGTH
        takes all detail below a length for noise.
    smoothing_length : float
        That length in meters; used with LENGTH only.
    """

    crease_angle: float
    flip_normals: bool = False
    smoothing: Smoothing = Smoothing.AUTO
    smoothing_length: float = 0.0

    def __post_init__(self) -> None:
        """Refuse angles that no fold can have, and smoothing over no length."""
        if self.smoothing is Smoothing.LENGTH and not (
            math.isfinite(self.smoothing_length) and self.smoothing_length > 0.0
        ):
            raise InvalidSettingError(
                "the smoothing length must be greater than zero, "
                f"not {self.smoothing_length:g} m: set a length, or smooth by Auto"
            )
        if not 0.0 < self.crease_angle <= math.pi:
            raise InvalidSettingError(
                "the crease angle must be above 0 and at most 180 degrees, "
                f"not {math.degrees(self.crease_angle):g}"
            )


@dataclass(frozen=True)
class SegmentationSettings:
    """How a surface is segmented; zeros mean defaults that depend on the model.

    Parameters
    ----------
    panel_size : float
        Edge length of a panel in meters. With every criterion it is the scale of what matters.
    deviation : float
        Allowed distance between panel and surface in meters; counts with PANEL only.
    min_area : float
        Regions below this area in m² join a neighbor; 0 takes a panel's, but see
        `default_min_area`.
    criterion : CriterionKind
        Which of the limits count.
    smallest_radius : float
        Radius in meters beyond which a panel counts as straight; needed with RADIUS.
    gaussian_limit, mean_limit : float
        Limits of |K| in 1/m² and of |H| in 1/m; needed with RAW.
    """

    panel_size: float = 0.0
    deviation: float = 0.0
    min_area: float = 0.0
    criterion: CriterionKind = CriterionKind.PANEL
    smallest_radius: float = 0.0
    gaussian_limit: float = 0.0
    mean_limit: float = 0.0

    def __post_init__(self) -> None:
        """Refuse negative sizes."""
        for name in (
            *("panel_size", "deviation", "min_area"),
            *("smallest_radius", "gaussian_limit", "mean_limit"),
        ):
            value = getattr(self, name)
            if not (math.isfinite(value) and value >= 0.0):
                raise InvalidSettingError(
                    f"the {name.replace('_', ' ')} must not be negative: {value:g}"
                )
