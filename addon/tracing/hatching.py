# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Hatching of many objects."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from bpy.types import Context, Object, Scene

from ..bridge.companions import discard_companions
from ..bridge.curves import LineSet, write_curves
from ..bridge.mode import object_mode
from ..bridge.subject import Reading, Subject
from ..geometry.hatching import LIGHTEST, Strokes, curvature_tone, hatch, shade_tone
from ..geometry.lines.field import PRINCIPAL
from ..geometry.lines.lines import LineEnd
from ..geometry.progress import part_of
from ..geometry.types import Floats, Progress
from ..steps import Steps
from ..tasks import Outcome, criterion_of, for_each, write_analysis
from .absence import absence
from .fields import Field, cover, find_field
from .settings import LineSettings, Plan

#: Spacing of the densest strokes as a share of the model's diagonal, where the user gives none.
_SPACING = 1.0 / 120.0
#: Full width of a stroke as a share of the spacing.
_WIDTH = 0.3
#: Share of the time that the direction field takes, analysis included.
_FIELD = 0.3


@dataclass(frozen=True)
class HatchSettings:
    """How strokes are laid.

    Parameters
    ----------
    tone : str
        SHADE or CURVATURE.
    spacing : float
        Where strokes are densest, in meters; 0 for a share of the model.
    light : (float, float, float)
        Where the light comes from, in the world.
    """

    tone: str
    spacing: float
    light: tuple[float, float, float]


@dataclass(frozen=True)
class _Hatched:
    field: Field
    strokes: Strokes
    is_light: bool


def hatch_objects(
    context: Context, objects: list[Object], plan: Plan, settings: HatchSettings
) -> Steps[Outcome]:
    """Lay strokes along the principal directions of objects.

    Parameters
    ----------
    context : Context
    objects : list of Object
        Mesh objects; modes are left for the time of the work.
    plan : Plan
        How they are analyzed.
    settings : HatchSettings

    Returns
    -------
    Steps of Outcome
    """
    total, absent = [0], []

    def compute(reading: Reading, on_progress: Progress) -> _Hatched:
        diagonal = reading.mesh.diagonal
        spacing = settings.spacing or _SPACING * diagonal
        fine = replace(plan, lines=LineSettings(PRINCIPAL, spacing))
        field = find_field(reading, fine, part_of(on_progress, 0.0, _FIELD))
        lines = cover(field, PRINCIPAL, part_of(on_progress, _FIELD, 1.0))
        direction, curvature = field.lines.field, field.subject.analysis.curvature
        if settings.tone == "SHADE":
            tone = shade_tone(direction, _light(field.subject, settings.light))
        else:
            tone = curvature_tone(curvature.k1, curvature.k2)
        at_points = lines.interpolated(direction.mesh, tone)
        is_light = lines.count > 0 and bool(np.median(at_points) <= LIGHTEST)
        return _Hatched(field, hatch(lines, at_points, spacing), is_light)

    def write(found: _Hatched) -> Object:
        subject, strokes = found.field.subject, found.strokes
        criterion = criterion_of(subject, plan.panel)
        carrier = write_analysis(context, subject, plan.analysis, criterion)
        discard_companions(subject.source, ("HATCHING",))
        count = len(strokes.lines)
        total.append(count)
        if not count:
            absent.append(_no_strokes(found, context.scene))
            return carrier
        lines = LineSet(
            lines=list(strokes.lines),
            is_closed=[False] * count,
            lengths=strokes.lengths,
            ends=np.full((count, 2), LineEnd.NEIGHBOR, dtype=np.int64),
            along=[],
            radii=strokes.widths,
        )
        width = _WIDTH * found.field.sizes.spacing
        write_curves(subject, carrier, lines, "HATCHING", width, context.scene)
        return carrier

    with object_mode(context):
        outcome = yield from for_each(context, objects, plan.analysis, compute, write)
    outcome.note = f"{sum(total):,} strokes"
    outcome.remarks += absent
    return outcome


def _no_strokes(found: _Hatched, scene: Scene) -> str:
    """Return why an object has no strokes, in words."""
    if found.is_light:
        return f"{found.field.subject.source.name} lies in the light: turn the light"
    return absence(found.field, scene)


def _light(subject: Subject, light: tuple[float, float, float]) -> Floats:
    """Return the direction of the light in the coordinates of the analyzed mesh."""
    world = np.array(subject.source.matrix_world, dtype=np.float64)[:3, :3]
    turn = world @ np.linalg.inv(subject.meters_from_object)
    return np.array(light, dtype=np.float64) @ turn
