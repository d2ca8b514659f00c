# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The regions of a mesh as panels list them, with the names that users gave them."""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import Any

from bpy.types import Mesh

from ..geometry.classification import SurfaceClass
from ..geometry.segmentation import Segmentation

#: Regions beyond these are in the reports, but not at hand for panels and legends.
MOST_LISTED_REGIONS = 200


def write_regions(mesh: Mesh, segmentation: Segmentation, names: Sequence[str]) -> None:
    """List the largest regions of a segmentation with their measures and names."""
    regions, results = segmentation.regions, mesh.curvature
    results.region_count = regions.count
    write_names(mesh, names)
    for number, row in enumerate(results.regions):
        row.surface_class = SurfaceClass(int(regions.region_class[number])).name
        row.area = float(regions.area[number])
        row.faces = int(regions.face_count[number])
        row.min_radius = segmentation.region_min_radius[number] or 0.0
    results.active_region = min(results.active_region, max(len(results.regions) - 1, 0))


def write_names(mesh: Mesh, names: Sequence[str]) -> None:
    """List regions anew, with nothing but their names."""
    rows = mesh.curvature.regions
    rows.clear()
    for name in names[:MOST_LISTED_REGIONS]:
        rows.add().name = name


def region_names(mesh: Mesh) -> list[str]:
    """Return the name of every region: the largest as users changed them in the list."""
    results = mesh.curvature
    listed = [row.name.strip() or default_name(i) for i, row in enumerate(results.regions)]
    if results.region_count <= len(listed) or not results.report:
        return listed
    rows = json.loads(results.report).get("regions", ())
    return listed + [row.get("name") or default_name(row["id"]) for row in rows[len(listed) :]]


def with_names(rows: list[dict[str, Any]], found: list[str]) -> list[dict[str, Any]]:
    """Return the regions of a report with their names."""
    return [
        {"id": row["id"], "name": name, **{k: v for k, v in row.items() if k != "name"}}
        for row, name in zip(rows, found, strict=True)
    ]


def default_name(number: int) -> str:
    """Return the name of a region that has none, by its number."""
    return f"Region {number + 1}"
