# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Make one region of several."""

from __future__ import annotations

from bpy.types import Context, Operator

from ..addon import editing, polls
from ..addon.bridge.subject import selected_subjects
from ..addon.progress import progress
from ..addon.reporting import conclude


class CURVATURE_OT_merge_regions(Operator):
    """Make one region of those that faces are selected of."""

    bl_idname = "curvature.merge_regions"
    bl_label = "Merge Regions"
    bl_description = (
        "Make one region of those that faces are selected of, of the class that covers most; "
        "later runs keep it"
    )
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context: Context) -> bool:
        """Ask for a segmented mesh."""
        return polls.has_classes(cls, context)

    def execute(self, context: Context) -> set[str]:
        """Lock the faces of the regions to one class, and segment again."""
        with progress(context.window_manager) as advance:
            outcome = editing.edit_objects(
                context, selected_subjects(context), editing.merge_regions, advance
            )
        apart = outcome.regions_left - len(outcome.carriers)
        if apart > 0:
            outcome.refused.append("regions that do not touch, or meet at a crease, stay apart")
        return conclude(self, outcome, f"Merged {outcome.regions:,} regions of")
