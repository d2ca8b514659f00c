# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a report says about one object."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

import numpy as np

from ..geometry.analysis import Analysis
from ..geometry.classification import SurfaceClass
from ..geometry.criterion import Criterion
from ..geometry.segmentation import Segmentation
from ..geometry.settings import CriterionKind
from ..geometry.statistics import area_histogram, summarize

_HISTOGRAM_BARS = 40
#: Histograms end at this many curvature limits.
_HISTOGRAM_LIMITS = 10.0

CLASS_KEYS = {
    SurfaceClass.FLAT: "flat",
    SurfaceClass.SINGLE: "single_curved",
    SurfaceClass.ELLIPTIC: "double_curved_elliptic",
    SurfaceClass.HYPERBOLIC: "double_curved_hyperbolic",
    SurfaceClass.UNDEFINED: "undefined",
}
"""Names of the classes in reports, in their order there."""


def measure_object(analysis: Analysis, segmentation: Segmentation | None = None) -> dict[str, Any]:
    """Return an object's block of the report, without its name and source.

    Parameters
    ----------
    analysis : Analysis
    segmentation : Segmentation, optional
        Its keys are absent where nothing was segmented.

    Returns
    -------
    dict
        Ready for JSON. Lengths in m, areas in m², curvatures in 1/m and 1/m²; statistics are
        weighted by area.
    """
    surface, curvature = analysis.surface, analysis.curvature
    areas = surface.sector_area * curvature.is_defined
    block: dict[str, Any] = {
        "vertices": surface.mesh.vertex_count,
        "faces": surface.mesh.polygon_count,
        "area": float(surface.polygon_area.sum()),
        "warnings": list(analysis.warnings),
        "estimates": {
            "smoothed": int(curvature.is_smoothed.sum()),
            "low_order": int(curvature.is_doubtful.sum()),
            "undefined": int((~curvature.is_defined).sum()),
        },
    }
    for key, values in (
        ("gaussian_curvature", curvature.gaussian),
        ("mean_curvature", curvature.mean),
        ("k1", curvature.k1),
        ("k2", curvature.k2),
    ):
        summary = summarize(values, areas)
        block[key] = asdict(summary) if summary else None
    if segmentation is not None:
        block |= _segmentation_block(segmentation)
        block["histograms"] = _histograms(analysis, segmentation.criterion.curvature_limit)
    return block


def _histograms(analysis: Analysis, limit: float) -> dict[str, Any]:
    """Return the area by absolute curvature of the faces, up to several times the limit."""
    curvature = analysis.curvature
    areas = analysis.surface.polygon_area * curvature.is_face_defined
    sizes = np.abs([curvature.face_k1, curvature.face_k2])
    larger, smaller = (
        area_histogram(size, areas, _HISTOGRAM_LIMITS * limit, _HISTOGRAM_BARS)
        for size in (sizes.max(axis=0), sizes.min(axis=0))
    )
    return {
        "larger": {"edges": larger[0], "areas": larger[1]},
        "smaller": {"edges": smaller[0], "areas": smaller[1]},
    }


def _criterion_block(criterion: Criterion) -> dict[str, Any]:
    """Return the limits; those of other criteria are absent."""
    block: dict[str, Any] = {
        "criterion": criterion.kind.name,
        "criterion_words": criterion.words,
        "panel_size": criterion.tolerance.panel_size,
        "deviation": criterion.tolerance.deviation,
        "curvature_limit": criterion.curvature_limit,
    }
    if criterion.kind is CriterionKind.RADIUS:
        # The criterion keeps the deviation that follows from the radius: undo the rounding.
        block["smallest_radius"] = float(f"{criterion.tolerance.radius_limit:.12g}")
    if criterion.gaussian_limit is not None:
        block["gaussian_limit"] = criterion.gaussian_limit
        block["mean_limit"] = float(f"{criterion.curvature_limit:.12g}")
    return block


def _segmentation_block(segmentation: Segmentation) -> dict[str, Any]:
    regions = segmentation.regions
    return {
        **_criterion_block(segmentation.criterion),
        "min_area": segmentation.min_area,
        "classes": {
            key: asdict(segmentation.classes[surface_class])
            for surface_class, key in CLASS_KEYS.items()
        },
        "regions": [
            {
                "id": number,
                "class": CLASS_KEYS[SurfaceClass(int(regions.region_class[number]))],
                "area": float(regions.area[number]),
                "faces": int(regions.face_count[number]),
                "min_radius": segmentation.region_min_radius[number],
                "boundary_length": float(regions.boundary_length[number]),
            }
            for number in range(regions.count)
        ],
    }
