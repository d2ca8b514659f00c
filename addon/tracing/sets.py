# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Traced lines made ready to be written: fitted, measured, one set per family."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from bpy.types import Context, Object

from ..bridge.companions import FAMILY_ROLES, picked
from ..bridge.curves import LineSet, write_curves
from ..geometry.fitting import BezierCurve, fit_bezier
from ..geometry.lines.field import Family
from ..geometry.lines.lines import CurvatureLines
from ..geometry.lines.simplification import simplified
from ..geometry.types import Floats
from .fields import Field
from .settings import LineSettings


@dataclass(frozen=True)
class Traced:
    """Lines on an analyzed object.

    Parameters
    ----------
    field : Field
    lines : CurvatureLines
    along : (p,) float64
        At every point the curvature of the surface along the line in 1/m; along asymptotic lines,
        where that is zero, the Gaussian curvature in 1/m².
    sets : dict of Family to LineSet
        What to write, for families that have lines.
    deviation : float
        Largest distance of what is written from the surface, in meters.
    """

    field: Field
    lines: CurvatureLines
    along: Floats
    sets: dict[Family, LineSet]
    deviation: float


def make_sets(field: Field, lines: CurvatureLines, settings: LineSettings) -> Traced:
    """Return lines ready to be written; does not touch Blender."""
    if not settings.is_fitted:
        # Traced lines have a point at every side of a triangle: many more than show.
        lines = simplified(lines, field.sizes.tolerance)
    along = _along(field, lines)
    curves = [_curve(field, lines, number, settings) for number in range(lines.count)]
    samples = [each.samples() if isinstance(each, BezierCurve) else each for each in curves]
    off = field.finder.deviation(np.concatenate(samples)) if samples else 0.0
    sets = {}
    for family in settings.families:
        chosen = np.flatnonzero(lines.family == family)
        if len(chosen):
            made = _line_set(lines, chosen.tolist(), curves, along)
            # Points of polylines lie on the surface: what they are off by is rounding.
            sets[family] = replace(made, deviation=off if settings.is_fitted else 0.0)
    return Traced(field, lines, along, sets, off)


def write_sets(
    context: Context, traced: Traced, carrier: Object, *, is_picked: bool = False
) -> None:
    """Make curve objects of lines, or add the lines to those that there are."""
    spacing = 0.0 if is_picked else traced.field.sizes.spacing
    for family, lines in traced.sets.items():
        role = FAMILY_ROLES[family]
        write_curves(
            traced.field.subject,
            carrier,
            replace(lines, spacing=spacing),
            picked(role) if is_picked else role,
            traced.field.sizes.thickness,
            context.scene,
        )


def _curve(
    field: Field, lines: CurvatureLines, number: int, settings: LineSettings
) -> Floats | BezierCurve:
    points = lines.line_points(number)
    if not settings.is_fitted or len(points) < 2:
        return points
    return fit_bezier(points, bool(lines.is_closed[number]), field.sizes.tolerance)


def _line_set(
    lines: CurvatureLines, chosen: list[int], curves: list[Floats | BezierCurve], along: Floats
) -> LineSet:
    values = []
    for number in chosen:
        curve = curves[number]
        each = along[lines.start[number] : lines.start[number + 1]]
        values.append(each[curve.point] if isinstance(curve, BezierCurve) else each)
    return LineSet(
        lines=[curves[number] for number in chosen],
        is_closed=lines.is_closed[chosen].tolist(),
        lengths=lines.length[chosen],
        ends=lines.ends[chosen],
        along=values,
    )


def _along(field: Field, lines: CurvatureLines) -> Floats:
    curvature, mesh = field.subject.analysis.curvature, field.lines.field.mesh
    family = lines.family[lines.point_line]
    values = lines.interpolated(mesh, np.stack([curvature.k1, curvature.k2, curvature.gaussian], 1))
    return np.choose(np.minimum(family, 3) - 1, values.T) if len(family) else np.zeros(0)
