# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The curvature below which a panel of a given size counts as straight."""

from __future__ import annotations

import math
from dataclasses import dataclass

from .errors import InvalidSettingError

_PANELS_PER_DIAGONAL = 20.0
_SIZES_PER_DEVIATION = 200.0


@dataclass(frozen=True)
class Tolerance:
    """A panel and the deviation from its ideal shape that its maker accepts.

    Parameters
    ----------
    panel_size : float
        Edge length of a panel in meters.
    deviation : float
        Largest distance in meters between the panel and the surface.
    """

    panel_size: float
    deviation: float

    def __post_init__(self) -> None:
        """Refuse sizes that give no limit."""
        for name, value in (("panel size", self.panel_size), ("deviation", self.deviation)):
            if not (math.isfinite(value) and value > 0.0):
                raise InvalidSettingError(f"the {name} must be greater than zero, not {value:g} m")

    @property
    def curvature_limit(self) -> float:
        """Curvature in 1/m that a panel's chord turns into the allowed deviation.

        A chord of length s on a circle of curvature k has the sagitta k s²/8.
        """
        return 8.0 * self.deviation / self.panel_size**2

    @property
    def radius_limit(self) -> float:
        """Radius in meters beyond which a panel counts as straight."""
        return 1.0 / self.curvature_limit


def resolve_tolerance(panel_size: float, deviation: float, diagonal: float) -> Tolerance:
    """Return the tolerance, with defaults where the user gave none.

    Parameters
    ----------
    panel_size : float
        In meters; 0 means a twentieth of the diagonal.
    deviation : float
        In meters; 0 means a two-hundredth of the panel size.
    diagonal : float
        Diagonal of the model's bounding box in meters.

    Returns
    -------
    Tolerance

    Raises
    ------
    InvalidSettingError
        If a value is negative, or no size is given for a model without extent.
    """
    size = panel_size or diagonal / _PANELS_PER_DIAGONAL
    return Tolerance(size, deviation or size / _SIZES_PER_DEVIATION)
