# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Settings of an analysis, as values."""

from __future__ import annotations

import math
from dataclasses import dataclass

from .errors import InvalidSettingError


@dataclass(frozen=True)
class AnalysisSettings:
    """How curvature is measured.

    Parameters
    ----------
    crease_angle : float
        Dihedral angle in radians above which an edge is a crease, 0 to pi.
    flip_normals : bool
        Whether the surface is seen from the other side: k1, k2 and H change sign.
    """

    crease_angle: float
    flip_normals: bool = False

    def __post_init__(self) -> None:
        """Refuse angles that no fold can have."""
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
        Edge length of a panel in meters.
    deviation : float
        Allowed distance between panel and surface in meters.
    min_area : float
        Regions below this area in m² join a neighbor; 0 keeps all.
    """

    panel_size: float = 0.0
    deviation: float = 0.0
    min_area: float = 0.0

    def __post_init__(self) -> None:
        """Refuse negative sizes."""
        for name in ("panel_size", "deviation", "min_area"):
            value = getattr(self, name)
            if not (math.isfinite(value) and value >= 0.0):
                raise InvalidSettingError(
                    f"the {name.replace('_', ' ')} must not be negative: {value:g}"
                )
