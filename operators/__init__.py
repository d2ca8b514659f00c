# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators, one per file: read, compute, write, report."""

from __future__ import annotations

import bpy

from .analyze import CURVATURE_OT_analyze
from .clear import CURVATURE_OT_clear
from .deliver import CURVATURE_OT_deliver
from .export_report import CURVATURE_OT_export_report
from .preset_add import CURVATURE_OT_preset_add
from .segment import CURVATURE_OT_segment
from .select_class import CURVATURE_OT_select_class
from .separate import CURVATURE_OT_separate
from .show import CURVATURE_OT_show

register, unregister = bpy.utils.register_classes_factory(
    (
        CURVATURE_OT_analyze,
        CURVATURE_OT_segment,
        CURVATURE_OT_show,
        CURVATURE_OT_select_class,
        CURVATURE_OT_export_report,
        CURVATURE_OT_deliver,
        CURVATURE_OT_separate,
        CURVATURE_OT_clear,
        CURVATURE_OT_preset_add,
    )
)
