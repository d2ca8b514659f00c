# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators, one per file: read, compute, write, report."""

from __future__ import annotations

import bpy

from .analyze import CURVATURE_OT_analyze
from .assign_class import CURVATURE_OT_assign_class
from .clear import CURVATURE_OT_clear
from .deliver import CURVATURE_OT_deliver
from .export_lines import CURVATURE_OT_export_lines
from .export_report import CURVATURE_OT_export_report
from .find_umbilics import CURVATURE_OT_find_umbilics
from .hatch import CURVATURE_OT_hatch
from .merge_regions import CURVATURE_OT_merge_regions
from .outline import CURVATURE_OT_outline
from .pick_lines import CURVATURE_OT_pick_lines
from .preset_add import CURVATURE_OT_preset_add
from .segment import CURVATURE_OT_segment
from .select_class import CURVATURE_OT_select_class
from .select_region import CURVATURE_OT_select_region
from .separate import CURVATURE_OT_separate
from .show import CURVATURE_OT_show
from .split_region import CURVATURE_OT_split_region
from .trace_lines import CURVATURE_OT_trace_lines
from .trace_through import CURVATURE_OT_trace_through

register, unregister = bpy.utils.register_classes_factory(
    (
        CURVATURE_OT_analyze,
        CURVATURE_OT_segment,
        CURVATURE_OT_show,
        CURVATURE_OT_select_class,
        CURVATURE_OT_select_region,
        CURVATURE_OT_assign_class,
        CURVATURE_OT_merge_regions,
        CURVATURE_OT_split_region,
        CURVATURE_OT_export_report,
        CURVATURE_OT_deliver,
        CURVATURE_OT_separate,
        CURVATURE_OT_outline,
        CURVATURE_OT_trace_lines,
        CURVATURE_OT_trace_through,
        CURVATURE_OT_pick_lines,
        CURVATURE_OT_find_umbilics,
        CURVATURE_OT_hatch,
        CURVATURE_OT_export_lines,
        CURVATURE_OT_clear,
        CURVATURE_OT_preset_add,
    )
)
