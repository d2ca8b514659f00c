# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The criterion of a mesh's classes: stored with them, and told in the units of a scene."""

from __future__ import annotations

from bpy.types import Mesh, Scene

from ..geometry.criterion import Criterion
from ..geometry.segmentation import Segmentation
from ..geometry.settings import CriterionKind, SegmentationSettings
from ..geometry.tolerance import Tolerance
from ..preset_text import LIMITS
from . import units
from .numbers import as_typed


def write_criterion(mesh: Mesh, segmentation: Segmentation) -> None:
    """Write the limits that the classes of a mesh hold for."""
    results, criterion = mesh.curvature, segmentation.criterion
    results.criterion = criterion.kind.name
    results.panel_size = criterion.tolerance.panel_size
    results.deviation = criterion.tolerance.deviation
    results.curvature_limit = criterion.curvature_limit
    results.gaussian_limit = criterion.gaussian_limit or 0.0
    results.min_area = segmentation.min_area


def criterion_of(mesh: Mesh) -> Criterion:
    """Return the criterion of a segmented mesh."""
    results = mesh.curvature
    kind = CriterionKind[results.criterion]
    return Criterion(
        kind,
        Tolerance(as_typed(results.panel_size), as_typed(results.deviation)),
        as_typed(results.gaussian_limit) if kind is CriterionKind.RAW else None,
    )


def preset_of(scene: Scene, settings: SegmentationSettings) -> dict[str, str]:
    """Return name and source of the preset that settings are of, empty where they are of none."""
    shown = scene.curvature
    is_of_scene = shown.criterion == settings.criterion.name and all(
        as_typed(getattr(shown, name)) == getattr(settings, name)
        for name in LIMITS[settings.criterion.name]
    )
    return {
        name: getattr(shown, name) if is_of_scene else ""
        for name in ("criterion_preset", "criterion_source")
    }


def criterion_lines(scene: Scene, criterion: Criterion) -> tuple[str, ...]:
    """Return a criterion in words, in lines that fit a legend."""
    tolerance = criterion.tolerance
    if criterion.gaussian_limit is not None:
        return (
            f"Single-curved: |K| at most {criterion.gaussian_limit:.3g} 1/m²",
            f"Flat: also |H| at most {criterion.curvature_limit:.3g} 1/m",
        )
    radius = units.length_text(scene, tolerance.radius_limit)
    if criterion.kind is CriterionKind.RADIUS:
        return (f"Straight: radius of at least {radius}",)
    return (
        f"Single-curved: within {units.length_text(scene, tolerance.deviation)} of a cylinder",
        f"over a {units.length_text(scene, tolerance.panel_size)} panel,",
        f"straight above a radius of {radius}",
    )
