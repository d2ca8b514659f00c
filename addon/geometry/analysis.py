# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""One call from a mesh to its curvature."""

from __future__ import annotations

from dataclasses import dataclass

from .curvature import Curvature, estimate_curvature
from .diagnosis import diagnose
from .mesh import PolygonMesh
from .settings import AnalysisSettings
from .surface import Surface, build_surface
from .types import Progress


@dataclass(frozen=True)
class Analysis:
    """A surface, its curvature as the settings ask for it, and what is unsound about it."""

    surface: Surface
    curvature: Curvature
    warnings: tuple[str, ...]


def analyze(
    mesh: PolygonMesh, settings: AnalysisSettings, on_progress: Progress | None = None
) -> Analysis:
    """Cut a mesh along its creases and measure its curvature.

    Parameters
    ----------
    mesh : PolygonMesh
        Positions in meters.
    settings : AnalysisSettings
    on_progress : callable, optional
        Receives the share of the work that is done.

    Returns
    -------
    Analysis
    """
    surface = build_surface(mesh, settings.crease_angle)
    curvature = estimate_curvature(
        surface, settings.smoothing, settings.smoothing_length, on_progress
    )
    if settings.flip_normals:
        curvature = curvature.flipped()
    return Analysis(surface, curvature, diagnose(surface))
