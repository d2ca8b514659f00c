# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The curves that a segmentation is drawn with: region borders and parabolic curves."""

from __future__ import annotations

from dataclasses import dataclass

from ..analysis import Analysis
from ..criterion import Criterion
from ..types import Indices
from .borders import trace_borders
from .level_curves import parabolic_curves
from .polylines import Polylines

BORDERS, PARABOLIC = "BORDERS", "PARABOLIC"


@dataclass(frozen=True)
class OutlineSettings:
    """Which curves to trace, and how.

    Parameters
    ----------
    kind : str
        BORDERS or PARABOLIC.
    tolerance : float
        How far borders may be moved to straighten them, in meters; 0 takes the deviation of the
        panels.
    is_straight : bool
        Whether borders are straightened at all.
    include_rims : bool
        Whether the surface's own edges count as borders.
    """

    kind: str
    tolerance: float = 0.0
    is_straight: bool = True
    include_rims: bool = False


def trace_outline(
    analysis: Analysis, face_region: Indices, criterion: Criterion, settings: OutlineSettings
) -> Polylines:
    """Trace the curves of one kind.

    Parameters
    ----------
    analysis : Analysis
    face_region : (m,) int64
        -1 where undefined.
    criterion : Criterion
        What the regions were made by.
    settings : OutlineSettings

    Returns
    -------
    Polylines
    """
    panel = criterion.tolerance
    if settings.kind == PARABOLIC:
        return parabolic_curves(
            analysis.surface, analysis.curvature, criterion.curvature_limit, panel.panel_size
        )
    tolerance = (settings.tolerance or panel.deviation) if settings.is_straight else 0.0
    return trace_borders(analysis.surface, face_region, settings.include_rims, tolerance).curves
