# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a mesh was segmented with, kept to segment it in the same way after an edit."""

from __future__ import annotations

import json
from dataclasses import asdict

from bpy.types import Mesh

from ..geometry.settings import CriterionKind, SegmentationSettings


def write_segmentation_settings(mesh: Mesh, settings: SegmentationSettings) -> None:
    """Keep the settings of a segmentation with its results."""
    values = asdict(settings) | {"criterion": settings.criterion.name}
    mesh.curvature.segmentation = json.dumps(values)


def segmentation_settings_of(mesh: Mesh) -> SegmentationSettings:
    """Return the settings that a mesh was segmented with."""
    values = json.loads(mesh.curvature.segmentation or "{}")
    if "criterion" in values:
        values["criterion"] = CriterionKind[values["criterion"]]
    return SegmentationSettings(**values)
