# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What changed since the segmentation before."""

from __future__ import annotations

import math
from typing import Any

from bpy.types import Mesh, bpy_prop_collection

from ..geometry.classification import SurfaceClass
from ..report.measures import CLASS_KEYS
from .criteria import criterion_of


def class_changes(mesh: Mesh) -> list[tuple[SurfaceClass, float, float]]:
    """Return class, area before and area now in m², of the classes that changed.

    Empty where there was no segmentation before, or nothing has changed since.
    """
    before, now = _areas(mesh.curvature.previous), _areas(mesh.curvature.classes)
    if not before or not now:
        return []
    return [
        (kind, before.get(kind, 0.0), area)
        for kind, area in now.items()
        if not math.isclose(area, before.get(kind, 0.0), rel_tol=1e-6, abs_tol=1e-12)
    ]


def previous_criterion(mesh: Mesh) -> str:
    """Return the criterion of the classes before in words, empty if it is the one at hand."""
    previous = mesh.curvature.previous_criterion
    return "" if previous == criterion_of(mesh).words else previous


def comparison_of(mesh: Mesh) -> dict[str, Any]:
    """Return the changes since the segmentation before as reports have them."""
    changes = class_changes(mesh)
    if not changes:
        return {}
    previous = previous_criterion(mesh)
    return {
        "comparison": {
            CLASS_KEYS[kind]: {"before": before, "after": after} for kind, before, after in changes
        },
        **({"previous_criterion": previous} if previous else {}),
    }


def keep_previous(mesh: Mesh, areas: dict[SurfaceClass, float]) -> None:
    """Keep the classes at hand for comparison, unless the new ones are the same."""
    results = mesh.curvature
    at_hand = _areas(results.classes)
    if not at_hand or (
        areas
        and all(
            math.isclose(at_hand.get(kind, 0.0), area, rel_tol=1e-6, abs_tol=1e-12)
            for kind, area in areas.items()
        )
    ):
        return
    results.previous_criterion = criterion_of(mesh).words
    results.previous.clear()
    for kind, area in at_hand.items():
        row = results.previous.add()
        row.surface_class, row.area = kind.name, area


def _areas(rows: bpy_prop_collection) -> dict[SurfaceClass, float]:
    return {SurfaceClass[row.surface_class]: row.area for row in rows}
