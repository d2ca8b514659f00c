# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Borders of regions and parabolic curves: objects beside a model, and measures in its report."""

from __future__ import annotations

from typing import Any

import numpy as np
from bpy.types import Mesh, Object, Scene

from ..geometry.outlines.outline import OutlineSettings
from ..geometry.outlines.polylines import Polylines
from .companions import companions, discard_companions
from .curves import LineSet, write_curves
from .numbers import as_typed
from .subject import Subject

_KEYS = {"BORDERS": "borders", "PARABOLIC": "parabolic_curves"}

#: Thickness of the lines as a share of the model's diagonal.
_THICKNESS = {"BORDERS": 0.0024, "PARABOLIC": 0.004}


def write_outline(
    subject: Subject, carrier: Object, curves: Polylines, settings: OutlineSettings, scene: Scene
) -> Object:
    """Make an object of curves on a model, in place of the one of an earlier run.

    Parameters
    ----------
    subject : Subject
        The analysis that the curves were traced on.
    carrier : Object
        Shows the surface that the curves lie on, and keeps how many there are.
    curves : Polylines
        In meters, as the analysis has them.
    settings : OutlineSettings
        How they were traced, to be traced again with another segmentation.
    scene : Scene

    Returns
    -------
    Object
    """
    kind = settings.kind
    discard_companions(subject.source, (kind,))
    lines = LineSet(
        np.split(curves.points, curves.start[1:-1]) if curves.count else [],
        curves.is_closed.tolist(),
        curves.lengths,
        np.zeros((0, 2), dtype=np.int64),
        [],
    )
    rows = carrier.data.curvature.outlines
    row = next((row for row in rows if row.kind == kind), None) or rows.add()
    row.kind, row.curves, row.length = kind, curves.count, float(curves.lengths.sum())
    thickness = _THICKNESS[kind] * subject.analysis.surface.mesh.diagonal
    obj = write_curves(subject, carrier, lines, kind, thickness, scene)
    kept = obj.curvature
    kept.tolerance, kept.straighten = settings.tolerance, settings.is_straight
    kept.include_rims = settings.include_rims
    return obj


def shown_outlines(source: Object) -> list[OutlineSettings]:
    """Return how the curves were traced that a model is shown with."""
    found = [each.curvature for each in companions(source, _KEYS)]
    return [
        OutlineSettings(kept.role, as_typed(kept.tolerance), kept.straighten, kept.include_rims)
        for kept in found
    ]


def outline_blocks(mesh: Mesh) -> dict[str, Any]:
    """Return the measures of the curves made of a mesh's results, as reports have them."""
    return {
        _KEYS[row.kind]: {"count": row.curves, "length": as_typed(row.length)}
        for row in mesh.curvature.outlines
    }
