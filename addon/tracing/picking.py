# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines picked one by one on a model: traced under the mouse, kept by a click."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from bpy.types import Context, Object

from ..bridge.companions import analyzed_points, world_points
from ..bridge.mode import object_mode
from ..bridge.subject import Reading, read_object
from ..geometry.lines.lines import CurvatureLines
from ..geometry.lines.point_lines import PointLines, PointTracer
from ..geometry.types import Floats, Progress
from ..steps import Steps, Work
from ..tasks import criterion_of, write_analysis
from .fields import Field, find_field
from .sets import make_sets, write_sets
from .settings import Plan


@dataclass(frozen=True)
class Picker:
    """A model whose lines can be traced through any point of it."""

    field: Field
    plan: Plan
    tracer: PointTracer

    @property
    def source(self) -> Object:
        """The model."""
        return self.field.subject.source

    def seen(self, origin: Floats, direction: Floats) -> PointLines | None:
        """Return the lines through the first place of the model that a ray meets, not traced yet.

        Parameters
        ----------
        origin, direction : (3,) float64
            In the world.

        Returns
        -------
        PointLines or None
            None where the ray meets nothing.
        """
        start, further = analyzed_points(self.field.subject, np.stack([origin, origin + direction]))
        place = self.field.finder.seen(start, further - start)
        return None if place is None else self.tracer.start(*place)

    def in_world(self, lines: CurvatureLines) -> list[Floats]:
        """Return the points of every line in world coordinates, in Blender units."""
        points = world_points(self.field.subject, lines.points)
        return np.split(points, lines.start[1:-1]) if lines.count else []

    def keep(self, context: Context, lines: CurvatureLines) -> None:
        """Add lines to the curves of the model."""
        subject = self.field.subject
        with object_mode(context):
            criterion = criterion_of(subject, self.plan.panel)
            carrier = write_analysis(context, subject, self.plan.analysis, criterion)
            traced = make_sets(self.field, lines, self.plan.lines)
            write_sets(context, traced, carrier, is_picked=True)


def prepare_picker(context: Context, source: Object, plan: Plan) -> Steps[Picker]:
    """Read and analyze a model, so that its lines can be picked; changes nothing.

    Parameters
    ----------
    context : Context
    source : Object
        A mesh object.
    plan : Plan

    Returns
    -------
    Steps of Picker
    """
    with object_mode(context):
        depsgraph = context.evaluated_depsgraph_get()
        reading: Reading = read_object(source, context.scene, depsgraph, plan.analysis)

    def compute(on_progress: Progress) -> Picker:
        field = find_field(reading, plan, on_progress)
        # Made here, beside the window, and not when the mouse first moves.
        _ = field.finder
        return Picker(field, plan, PointTracer(field.lines, plan.lines.families))

    return (yield Work(compute, 0.0, 1.0))
