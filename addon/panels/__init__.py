# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Panels of the sidebar tab "Curvature", one per file."""

from __future__ import annotations

import bpy

from .analysis import CURVATURE_PT_analysis
from .changes import CURVATURE_PT_changes
from .delivery import CURVATURE_PT_delivery
from .hatching import CURVATURE_PT_hatching
from .lines import CURVATURE_PT_lines
from .outlines import CURVATURE_PT_outlines
from .picking import CURVATURE_PT_picking
from .preset_menu import CURVATURE_MT_presets
from .regions import CURVATURE_PT_regions, CURVATURE_UL_regions
from .results import CURVATURE_PT_results
from .segmentation import CURVATURE_PT_segmentation
from .warnings import CURVATURE_PT_warnings

register, unregister = bpy.utils.register_classes_factory(
    (
        CURVATURE_MT_presets,
        CURVATURE_PT_segmentation,
        CURVATURE_PT_results,
        CURVATURE_PT_changes,
        CURVATURE_UL_regions,
        CURVATURE_PT_regions,
        CURVATURE_PT_outlines,
        CURVATURE_PT_delivery,
        CURVATURE_PT_analysis,
        CURVATURE_PT_warnings,
        CURVATURE_PT_lines,
        CURVATURE_PT_picking,
        CURVATURE_PT_hatching,
    )
)
