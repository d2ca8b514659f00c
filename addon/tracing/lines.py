# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Evenly spaced lines on many objects, and lines through given points."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import numpy as np
from bpy.types import Context, Object

from ..bridge import results, units
from ..bridge.companions import FAMILY_ROLES, analyzed_points, discard_companions, world_points
from ..bridge.mode import object_mode
from ..bridge.selection import selected_vertices
from ..bridge.subject import Reading
from ..geometry.errors import CurvatureError
from ..geometry.lines.field import ASYMPTOTIC, PRINCIPAL, Family
from ..geometry.lines.lines import CurvatureLines
from ..geometry.lines.tracer import trace_from
from ..geometry.places import vertex_places
from ..geometry.progress import part_of
from ..geometry.types import AnyArray, Floats, Indices, Progress
from ..report.findings import (
    ASYMPTOTIC_LINES,
    LINES,
    UMBILIC_AREAS,
    UMBILICS,
    measure_lines,
    measure_umbilics,
)
from ..steps import Steps
from ..tasks import Outcome, criterion_of, for_each, write_analysis
from .absence import absence
from .fields import Field, cover, find_field
from .sets import Traced, make_sets, write_sets
from .settings import Plan

Places = tuple[Indices, Floats]

#: Share of the time that the direction field takes, analysis included.
_FIELD = 0.5


def trace_objects(context: Context, objects: list[Object], plan: Plan) -> Steps[Outcome]:
    """Trace evenly spaced lines on objects and make curves of them.

    What is missing or stale of the analysis is measured first.

    Parameters
    ----------
    context : Context
    objects : list of Object
        Mesh objects; modes are left for the time of the work.
    plan : Plan

    Returns
    -------
    Steps of Outcome
    """

    def find(field: Field, on_progress: Progress) -> CurvatureLines:
        return cover(field, plan.lines.families, on_progress)

    def write(traced: Traced, carrier: Object) -> None:
        pair = ASYMPTOTIC if plan.lines.is_asymptotic else PRINCIPAL
        discard_companions(traced.field.subject.source, [FAMILY_ROLES[each] for each in pair])
        write_sets(context, traced, carrier)
        _report(context, traced, carrier, plan)

    return (yield from _trace(context, objects, plan, find, write))


def trace_seeds(context: Context, objects: list[Object], plan: Plan, seeds: str) -> Steps[Outcome]:
    """Trace lines through given points, and add them to those that were picked before.

    Parameters
    ----------
    context : Context
    objects : list of Object
    plan : Plan
    seeds : str
        CURSOR: the points nearest to the 3D cursor; VERTICES: the selected vertices.

    Returns
    -------
    Steps of Outcome
    """
    cursor = np.array([context.scene.cursor.location], dtype=np.float64)
    with object_mode(context):
        selected = {obj.name_full: selected_vertices(obj.data) for obj in objects}

    def find(field: Field, _on_progress: Progress) -> CurvatureLines:
        if seeds == "CURSOR":
            at = analyzed_points(field.subject, cursor)
            triangle, place = field.finder.nearest(at)[:2]
        else:
            triangle, place = _vertex_seeds(field, *selected[field.subject.source.name_full])
        lines = trace_from(field.lines, triangle, place, plan.lines.families)
        if not lines.count:
            where = (
                "saddles only" if plan.lines.is_asymptotic else "curved parts only, not spherical"
            )
            raise CurvatureError(f"no lines run through these points: there are some in {where}")
        return lines

    write = partial(write_sets, context, is_picked=True)
    return (yield from _trace(context, objects, plan, find, write))


def describe(context: Context, counts: dict[Family, int], length: float) -> str:
    """Return in words how many lines there are and how long they are together."""
    if not any(counts.values()):
        return "no lines"
    parts = [
        f"{count:,} {'line' if count == 1 else 'lines'} of family {2 - family % 2}"
        for family, count in counts.items()
    ]
    return f"{' and '.join(parts)}, {units.length_text(context.scene, length)} long"


def _trace(
    context: Context,
    objects: list[Object],
    plan: Plan,
    find: Callable[[Field, Progress], CurvatureLines],
    write: Callable[[Traced, Object], None],
) -> Steps[Outcome]:
    counts = dict.fromkeys(plan.lines.families, 0)
    lengths, absent = [], []

    def compute(reading: Reading, on_progress: Progress) -> Traced:
        field = find_field(reading, plan, part_of(on_progress, 0.0, _FIELD))
        lines = find(field, part_of(on_progress, _FIELD, 1.0))
        return make_sets(field, lines, plan.lines)

    def write_all(traced: Traced) -> Object:
        subject = traced.field.subject
        criterion = criterion_of(subject, plan.panel)
        carrier = write_analysis(context, subject, plan.analysis, criterion)
        write(traced, carrier)
        for family, lines in traced.sets.items():
            counts[family] += len(lines.lines)
            lengths.append(lines.lengths.sum())
        if not traced.sets:
            is_asymptotic = plan.lines.is_asymptotic
            absent.append(absence(traced.field, context.scene, is_asymptotic=is_asymptotic))
        return carrier

    with object_mode(context):
        outcome = yield from for_each(context, objects, plan.analysis, compute, write_all)
    outcome.note = describe(context, counts, float(np.sum(lengths)))
    outcome.remarks += absent
    return outcome


def _report(context: Context, traced: Traced, carrier: Object, plan: Plan) -> None:
    subject = traced.field.subject
    key = ASYMPTOTIC_LINES if plan.lines.is_asymptotic else LINES
    umbilics = traced.field.lines.umbilics
    place = world_points(subject, umbilics.position) * units.meters_per_unit(context.scene)
    found = {
        key: {
            "spacing": traced.field.sizes.spacing,
            "deviation": traced.deviation,
            **measure_lines(traced.lines, plan.lines.families, traced.along),
        },
        **measure_umbilics(umbilics, place),
    }
    results.add_findings(carrier.data, found, (UMBILICS, UMBILIC_AREAS))


def _vertex_seeds(field: Field, vertices: AnyArray, position: AnyArray) -> Places:
    """Return the places of selected vertices, given their numbers and coordinates."""
    if not len(vertices):
        raise CurvatureError("no vertices are selected: select some in Edit Mode")
    subject = field.subject
    if subject.has_base_topology:
        return vertex_places(subject.analysis.surface, vertices)
    in_meters = (position - subject.center) @ subject.meters_from_object
    return field.finder.nearest(in_meters)[:2]
