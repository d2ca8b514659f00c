# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Borders of regions and parabolic curves of many objects."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from bpy.types import Context, Object

from .bridge import names, outlines, results
from .bridge.attributes import read_attribute
from .bridge.mode import object_mode
from .bridge.subject import Subject, carrier_of, read_object
from .geometry.errors import CurvatureError
from .geometry.outlines.borders import trace_borders
from .geometry.outlines.level_curves import parabolic_curves
from .geometry.outlines.polylines import Polylines
from .steps import Steps, Work


@dataclass(frozen=True)
class OutlineSettings:
    """Which curves to trace.

    Parameters
    ----------
    kinds : tuple of str
        BORDERS, PARABOLIC or both.
    tolerance : float
        How far borders may be moved to straighten them, in meters.
    is_straight : bool
        Whether borders are straightened at all; a tolerance of 0 is the deviation of the panels.
    include_rims : bool
        Whether the surface's own edges count as borders.
    """

    kinds: tuple[str, ...]
    tolerance: float
    is_straight: bool
    include_rims: bool


@dataclass
class Outlined:
    """What became of the objects: curves and meters per kind, and why others were refused."""

    models: int = 0
    counts: dict[str, int] = field(default_factory=dict)
    lengths: dict[str, float] = field(default_factory=dict)
    refused: list[str] = field(default_factory=list)


def outline_objects(
    context: Context, objects: list[Object], settings: OutlineSettings
) -> Steps[Outlined]:
    """Make curve objects of the borders and parabolic curves of segmented objects."""
    outcome = Outlined()
    with object_mode(context):
        for source in objects:
            try:
                traced = yield from _outline(context, source, settings)
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
    context: Context, source: Object, settings: OutlineSettings
) -> Steps[dict[str, Polylines]]:
    carrier = carrier_of(source)
    found = carrier.data.curvature
    if not found.is_segmented:
        raise CurvatureError("there are no regions: press Segment first")
    reading = read_object(
        source,
        context.scene,
        context.evaluated_depsgraph_get(),
        results.settings_of(carrier.data),
    )
    if reading.fingerprint != found.fingerprint:
        raise CurvatureError("the model has changed: press Segment first")
    subject = yield Work(reading.analyzed, 0.0, 0.8)
    traced = {kind: _trace(subject, carrier, kind, settings) for kind in settings.kinds}
    for kind, curves in traced.items():
        outlines.write_outline(subject, carrier, curves, kind, context.scene)
        outlines.write_measures(carrier.data, kind, curves.count, float(curves.lengths.sum()))
    return traced


def _trace(subject: Subject, carrier: Object, kind: str, settings: OutlineSettings) -> Polylines:
    analysis, found = subject.analysis, carrier.data.curvature
    if kind == "PARABOLIC":
        return parabolic_curves(
            analysis.surface, analysis.curvature, found.curvature_limit, found.panel_size
        )
    regions = read_attribute(carrier.data, names.REGION)
    if regions is None or len(regions) != analysis.surface.mesh.polygon_count:
        raise CurvatureError("the regions are missing: press Segment first")
    tolerance = (settings.tolerance or found.deviation) if settings.is_straight else 0.0
    return trace_borders(
        analysis.surface, regions.astype(np.int64), settings.include_rims, tolerance
    ).curves
