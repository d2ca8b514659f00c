# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Part faces from their region."""

from __future__ import annotations

from bpy.types import Context, Operator

from ..addon import editing, polls
from ..addon.bridge.subject import selected_subjects
from ..addon.reporting import conclude
from ..addon.running import RunningOperator
from ..addon.steps import Steps


class CURVATURE_OT_split_region(RunningOperator, Operator):
    """Part the selected faces from the rest of their region."""

    bl_idname = "curvature.split_region"
    bl_label = "Split Region"
    bl_description = "Make a region of its own of the selected faces, which later runs keep apart"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context: Context) -> bool:
        """Ask for a segmented mesh."""
        return polls.has_classes(cls, context)

    def steps(self, context: Context) -> Steps[editing.Edited]:
        """Cut around the selected faces, and segment again."""
        return editing.edit_objects(context, selected_subjects(context), editing.split_regions)

    def finish(self, _context: Context, outcome: editing.Edited) -> set[str]:
        """Tell what was changed."""
        faces = f"{outcome.faces:,} {'face' if outcome.faces == 1 else 'faces'}"
        return conclude(self, outcome, f"Split {faces} off regions of")
