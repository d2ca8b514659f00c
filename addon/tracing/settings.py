# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""How lines are traced and written, as values."""

from __future__ import annotations

import math
from dataclasses import dataclass

from ..geometry.errors import InvalidSettingError
from ..geometry.lines.field import ASYMPTOTIC, PRINCIPAL, Family
from ..geometry.settings import AnalysisSettings, SegmentationSettings

#: A finer spacing than this share of the model's diagonal would take hours.
_FINEST = 1.0 / 3000.0
#: A finer spacing than this share of a side of a triangle shows nothing that the model knows.
_FINEST_IN_EDGE = 0.01
#: Thickness of lines as a share of their spacing, where the user gives none.
_THICKNESS = 0.04
#: Distance of written curves from the traced lines as a share of the spacing, where the user gives
#: none.
_TOLERANCE = 0.002


@dataclass(frozen=True)
class LineSettings:
    """How lines are traced and written; lengths of 0 mean defaults that depend on the model.

    Parameters
    ----------
    families : tuple of Family
    spacing : float
        Between neighboring lines in meters; 0 for the panel size.
    smoothing_length : float
        Over which directions are averaged, in meters; 0 for what the noise asks for.
    is_fitted : bool
        Whether lines become Bézier curves.
    tolerance : float
        How far what is written may be from the traced lines, in meters.
    thickness : float
        Diameter in meters.
    """

    families: tuple[Family, ...]
    spacing: float = 0.0
    smoothing_length: float = 0.0
    is_fitted: bool = False
    tolerance: float = 0.0
    thickness: float = 0.0

    def __post_init__(self) -> None:
        """Refuse negative lengths."""
        for name in ("spacing", "smoothing_length", "tolerance", "thickness"):
            value = getattr(self, name)
            if not (math.isfinite(value) and value >= 0.0):
                text = name.replace("_", " ")
                raise InvalidSettingError(f"the {text} must not be negative: {value:g} m")

    @property
    def is_asymptotic(self) -> bool:
        """Whether the lines are asymptotic ones."""
        return Family.ASYMPTOTIC_LEFT in self.families or Family.ASYMPTOTIC_RIGHT in self.families


@dataclass(frozen=True)
class Plan:
    """All settings of a task that traces."""

    analysis: AnalysisSettings
    panel: SegmentationSettings
    lines: LineSettings


@dataclass(frozen=True)
class Sizes:
    """Lengths for one model, in meters, with defaults where the user gave none."""

    spacing: float
    thickness: float
    tolerance: float


def families_of(kind: str, families: str) -> tuple[Family, ...]:
    """Return the families of a kind (PRINCIPAL, ASYMPTOTIC): BOTH, the FIRST or the SECOND."""
    pair = ASYMPTOTIC if kind == "ASYMPTOTIC" else PRINCIPAL
    return {"BOTH": pair, "FIRST": pair[:1], "SECOND": pair[1:]}[families]


def resolve_sizes(settings: LineSettings, panel_size: float, diagonal: float) -> Sizes:
    """Return the lengths for a model.

    Parameters
    ----------
    settings : LineSettings
    panel_size, diagonal : float
        In meters.

    Returns
    -------
    Sizes

    Raises
    ------
    InvalidSettingError
        If the spacing is too fine for the model.
    """
    spacing = settings.spacing or panel_size
    if spacing < _FINEST * diagonal:
        raise InvalidSettingError(
            f"a spacing of {spacing:g} m is too fine for a model of {diagonal:.3g} m: "
            f"take {2.0 * _FINEST * diagonal:.2g} m or more"
        )
    return Sizes(
        spacing,
        settings.thickness or _THICKNESS * spacing,
        settings.tolerance or _TOLERANCE * spacing,
    )


def check_resolution(spacing: float, edge_length: float) -> None:
    """Refuse a spacing that is far finer than a model.

    Parameters
    ----------
    spacing, edge_length : float
        Between lines, and of a typical side of the model's triangles, in meters.

    Raises
    ------
    InvalidSettingError
        If it is too fine.
    """
    if spacing < _FINEST_IN_EDGE * edge_length:
        raise InvalidSettingError(
            f"a spacing of {spacing:.3g} m is too fine for faces of {edge_length:.3g} m: "
            f"take {2.0 * _FINEST_IN_EDGE * edge_length:.2g} m or more, or subdivide the model"
        )
