# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Borders of regions and parabolic curves of many objects."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from bpy.types import Context, Object

from .bridge import names, results
from .bridge.attributes import read_attribute
from .bridge.criteria import criterion_of
from .bridge.mode import object_mode
from .bridge.outlines import write_outline
from .bridge.subject import carrier_of, read_object
from .geometry.errors import CurvatureError
from .geometry.outlines.outline import OutlineSettings, trace_outline
from .geometry.outlines.polylines import Polylines
from .steps import Steps, Work


@dataclass
class Outlined:
    """What became of the objects: curves and meters per kind, and why others were refused."""

    models: int = 0
    counts: dict[str, int] = field(default_factory=dict)
    lengths: dict[str, float] = field(default_factory=dict)
    refused: list[str] = field(default_factory=list)


def outline_objects(
    context: Context, objects: list[Object], wanted: list[OutlineSettings]
) -> Steps[Outlined]:
    """Make curve objects of the borders and parabolic curves of segmented objects."""
    outcome = Outlined()
    with object_mode(context):
        for source in objects:
            try:
                traced = yield from _outline(context, source, wanted)
            except CurvatureError as error:
                outcome.refused.append(f"{source.name}: {error}")
                continue
            outcome.models += 1
            for kind, curves in traced.items():
                outcome.counts[kind] = outcome.counts.get(kind, 0) + curves.count
                length = float(curves.lengths.sum())
                outcome.lengths[kind] = outcome.lengths.get(kind, 0.0) + length
    return outcome


def _outline(
    context: Context, source: Object, wanted: list[OutlineSettings]
) -> Steps[dict[str, Polylines]]:
    carrier = carrier_of(source)
    mesh = carrier.data
    if not mesh.curvature.is_segmented:
        raise CurvatureError("there are no regions: press Segment first")
    reading = read_object(
        source, context.scene, context.evaluated_depsgraph_get(), results.settings_of(mesh)
    )
    if reading.fingerprint != mesh.curvature.fingerprint:
        raise CurvatureError("the model has changed: press Segment first")
    regions = read_attribute(mesh, names.REGION)
    if regions is None or len(regions) != reading.mesh.polygon_count:
        raise CurvatureError("the regions are missing: press Segment first")
    subject = yield Work(reading.analyzed, 0.0, 0.6)
    criterion, face_region = criterion_of(mesh), regions.astype(np.int64)
    traced = yield Work(
        lambda _: [trace_outline(subject.analysis, face_region, criterion, s) for s in wanted],
        0.6,
        0.9,
    )
    for settings, curves in zip(wanted, traced, strict=True):
        write_outline(subject, carrier, curves, settings, context.scene)
    return {settings.kind: curves for settings, curves in zip(wanted, traced, strict=True)}
