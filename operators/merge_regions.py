# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Make one region of several."""

from __future__ import annotations

from bpy.types import Context, Operator

from ..addon import editing, polls
from ..addon.bridge.subject import selected_subjects
from ..addon.reporting import conclude
from ..addon.running import RunningOperator
from ..addon.steps import Steps


class CURVATURE_OT_merge_regions(RunningOperator, Operator):
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

    def steps(self, context: Context) -> Steps[editing.Edited]:
        """Lock the faces of the regions to one class, and segment again."""
        return editing.edit_objects(context, selected_subjects(context), editing.merge_regions)

    def finish(self, _context: Context, outcome: editing.Edited) -> set[str]:
        """Tell what was changed."""
        apart = outcome.regions_left - len(outcome.carriers)
        if apart > 0:
            outcome.refused.append("regions that do not touch, or meet at a crease, stay apart")
        return conclude(self, outcome, f"Merged {outcome.regions:,} regions of")
