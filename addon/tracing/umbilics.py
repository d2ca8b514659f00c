# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Umbilics of many objects."""

from __future__ import annotations

from bpy.types import Context, Object

from ..bridge import results, units
from ..bridge.companions import world_points
from ..bridge.markers import write_umbilics
from ..bridge.mode import object_mode
from ..bridge.subject import Reading
from ..geometry.types import Progress
from ..report.findings import measure_umbilics
from ..steps import Steps
from ..tasks import Outcome, criterion_of, for_each, write_analysis
from .fields import Field, find_field
from .settings import Plan

#: Radius of the balls that mark umbilics, in thicknesses of lines.
_BALL = 2.5


def mark_umbilics(context: Context, objects: list[Object], plan: Plan) -> Steps[Outcome]:
    """Find the umbilics of objects, and make markers of them.

    Parameters
    ----------
    context : Context
    objects : list of Object
        Mesh objects; modes are left for the time of the work.
    plan : Plan
        Its lengths decide how large the markers are.

    Returns
    -------
    Steps of Outcome
    """
    points, areas, totals = [0], [0], [0.0]

    def compute(reading: Reading, on_progress: Progress) -> Field:
        return find_field(reading, plan, on_progress)

    def write(field: Field) -> Object:
        subject, umbilics = field.subject, field.lines.umbilics
        criterion = criterion_of(subject, plan.panel)
        carrier = write_analysis(context, subject, plan.analysis, criterion)
        write_umbilics(subject, carrier, umbilics, _BALL * field.sizes.thickness, context.scene)
        place = world_points(subject, umbilics.position) * units.meters_per_unit(context.scene)
        results.add_findings(carrier.data, measure_umbilics(umbilics, place))
        points.append(umbilics.count)
        areas.append(len(umbilics.area_size))
        totals.append(umbilics.total_index)
        return carrier

    with object_mode(context):
        outcome = yield from for_each(context, objects, plan.analysis, compute, write)
    parts = [_counted(sum(points), "umbilic point")]
    if sum(areas):
        parts.append(_counted(sum(areas), "umbilic area"))
    outcome.note = f"{' and '.join(parts)}, of index {sum(totals):g} in all"
    return outcome


def _counted(number: int, noun: str) -> str:
    return f"{number:,} {noun}{'' if number == 1 else 's'}"
