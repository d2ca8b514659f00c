# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What an operator was told to use, and the scene's settings for what it was not."""

from __future__ import annotations

from dataclasses import replace

from bpy.types import Context, Operator

from .bridge.numbers import as_typed, as_typed_angle
from .geometry.criterion import resolve_criterion
from .geometry.errors import InvalidSettingError
from .geometry.settings import (
    AnalysisSettings,
    CriterionKind,
    SegmentationSettings,
    Smoothing,
)
from .preset_text import LIMITS
from .tracing.hatching import HatchSettings
from .tracing.settings import LineSettings, Plan, Sizes, families_of, resolve_sizes

CRITERION_OF = {
    name: CriterionKind[kind]
    for kind, names in LIMITS.items()
    for name in names
    if name != "panel_size"
}
"""Which criterion a limit is of; the panel size counts with all of them."""

LINE_NAMES = ("families", "thickness", "fit_curves", "fit_tolerance")
"""Properties of operators that trace lines, which scenes have under the same names."""

_HATCHING = ("tone", "spacing", "light")


def adopt_settings(operator: Operator, context: Context, names: tuple[str, ...]) -> None:
    """Fill properties that nobody has set from the scene, so that the redo panel shows them."""
    for name in names:
        if not operator.properties.is_property_set(name):
            setattr(operator, name, getattr(context.scene.curvature, name))


def adopt_criterion(operator: Operator) -> None:
    """Set the criterion of the limits that an operator was told, where they are of one."""
    kinds = {CRITERION_OF[name] for name in _told_limits(operator)}
    if len(kinds) == 1 and not operator.properties.is_property_set("criterion"):
        operator.criterion = kinds.pop().name


def analysis_settings(context: Context, operator: Operator | None = None) -> AnalysisSettings:
    """Return how to measure curvature.

    Raises
    ------
    InvalidSettingError
        If a value makes no sense.
    """
    return AnalysisSettings(
        crease_angle=as_typed_angle(float(_choose(context, operator, "crease_angle"))),
        flip_normals=bool(_choose(context, operator, "flip_normals")),
        smoothing=Smoothing[str(_choose(context, operator, "smoothing"))],
        smoothing_length=as_typed(float(_choose(context, operator, "smoothing_length"))),
    )


def implied_criterion(told: set[str]) -> CriterionKind | None:
    """Return the criterion that limits are of, by their names; None where there are none.

    Raises
    ------
    InvalidSettingError
        If limits of several criteria are given.
    """
    kinds = {
        CRITERION_OF[name]: name.replace("_", " ") for name in sorted(told & CRITERION_OF.keys())
    }
    if len(kinds) > 1:
        raise InvalidSettingError(
            f"{' and '.join(sorted(kinds.values()))} belong to different criteria: give one of them"
        )
    return next(iter(kinds), None)


def segmentation_settings(
    context: Context, operator: Operator | None = None
) -> SegmentationSettings:
    """Return how to segment; an operator's limit brings its criterion if none is told.

    Raises
    ------
    InvalidSettingError
        If a value makes no sense.
    """
    return SegmentationSettings(
        criterion=_choose_criterion(context, operator),
        smallest_radius=as_typed(float(_choose(context, operator, "smallest_radius"))),
        gaussian_limit=as_typed(float(_choose(context, operator, "gaussian_limit"))),
        mean_limit=as_typed(float(_choose(context, operator, "mean_limit"))),
        panel_size=as_typed(float(_choose(context, operator, "panel_size"))),
        deviation=as_typed(float(_choose(context, operator, "deviation"))),
        min_area=as_typed(float(_choose(context, operator, "min_area"))),
    )


def point_settings(context: Context) -> SegmentationSettings:
    """Return what tells flat points from curved ones: measuring need not wait for limits.

    Raises
    ------
    InvalidSettingError
        If a value makes no sense.
    """
    settings = segmentation_settings(context)
    limits = {
        CriterionKind.PANEL: True,
        CriterionKind.RADIUS: settings.smallest_radius > 0.0,
        CriterionKind.RAW: settings.gaussian_limit > 0.0 and settings.mean_limit > 0.0,
    }
    return (
        settings if limits[settings.criterion] else replace(settings, criterion=CriterionKind.PANEL)
    )


def adopt_kind(operator: Operator, context: Context) -> None:
    """Fill the kind of lines from the scene where nobody has set it."""
    if not operator.properties.is_property_set("kind"):
        operator.kind = context.scene.curvature.line_kind


def line_plan(context: Context, operator: Operator | None = None) -> Plan:
    """Return how to trace lines.

    Raises
    ------
    InvalidSettingError
        If a value makes no sense.
    """
    kind = context.scene.curvature.line_kind
    if operator is not None and operator.properties.is_property_set("kind"):
        kind = operator.kind
    smoothing_length = getattr(operator, "smoothing_length", 0.0)
    return Plan(
        # The smoothing length of lines is that of their directions, not of the curvature.
        analysis_settings(context),
        point_settings(context),
        LineSettings(
            families=families_of(kind, str(_choose(context, operator, "families"))),
            spacing=as_typed(float(_choose(context, operator, "spacing"))),
            smoothing_length=as_typed(float(smoothing_length)),
            is_fitted=bool(_choose(context, operator, "fit_curves")),
            tolerance=as_typed(float(_choose(context, operator, "fit_tolerance"))),
            thickness=as_typed(float(_choose(context, operator, "thickness"))),
        ),
    )


def line_sizes(context: Context, diagonal: float) -> Sizes:
    """Return the lengths of lines on a model of this size in meters, with defaults for zeros.

    Raises
    ------
    InvalidSettingError
        If a value makes no sense.
    """
    plan = line_plan(context)
    panel_size = resolve_criterion(plan.panel, diagonal).tolerance.panel_size
    return resolve_sizes(plan.lines, panel_size, diagonal)


def adopt_hatching(operator: Operator, context: Context) -> None:
    """Fill properties of a hatching that nobody has set from the scene."""
    for name in _HATCHING:
        if not operator.properties.is_property_set(name):
            setattr(operator, name, getattr(context.scene.curvature, f"hatch_{name}"))


def hatch_settings(context: Context, operator: Operator) -> HatchSettings:
    """Return how to hatch: what an operator was told, else the scene's settings."""
    told = {name for name in _HATCHING if operator.properties.is_property_set(name)}
    scene = context.scene.curvature
    x, y, z = operator.light if "light" in told else scene.hatch_light
    spacing = operator.spacing if "spacing" in told else 0.0
    return HatchSettings(
        tone=str(operator.tone if "tone" in told else scene.hatch_tone),
        spacing=as_typed(float(spacing or scene.hatch_spacing)),
        light=(float(x), float(y), float(z)),
    )


def _choose_criterion(context: Context, operator: Operator | None) -> CriterionKind:
    if operator is not None and not operator.properties.is_property_set("criterion"):
        implied = implied_criterion(_told_limits(operator))
        if implied is not None:
            return implied
    return CriterionKind[str(_choose(context, operator, "criterion"))]


def _told_limits(operator: Operator) -> set[str]:
    return {name for name in CRITERION_OF if getattr(operator, name) > 0.0}


def _choose(context: Context, operator: Operator | None, name: str) -> str | float:
    """Return what an operator was told, else the scene's setting; a number of 0 tells nothing."""
    value = getattr(context.scene.curvature, name)
    if operator is not None and name in operator.properties.bl_rna.properties:
        told = getattr(operator, name)
        is_told = operator.properties.is_property_set(name)
        if is_told and (told or isinstance(told, bool)):
            value = told
    return value
