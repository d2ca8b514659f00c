# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Give faces a class by hand."""

from __future__ import annotations

from bpy.props import EnumProperty
from bpy.types import Context, Operator

from ..addon import editing, polls
from ..addon.bridge.subject import selected_subjects
from ..addon.geometry.classification import SurfaceClass
from ..addon.geometry.display.palette import CLASS_NAMES
from ..addon.properties.items import CLASS_ITEMS
from ..addon.reporting import conclude
from ..addon.running import RunningOperator
from ..addon.steps import Steps

_ITEMS = (
    *(item for item in CLASS_ITEMS if item[0] != SurfaceClass.UNDEFINED.name),
    (SurfaceClass.UNDEFINED.name, "Free", "What the segmentation finds by itself", 0),
)


class CURVATURE_OT_assign_class(RunningOperator, Operator):
    """Give the selected faces a class that later runs keep."""

    bl_idname = "curvature.assign_class"
    bl_label = "Assign Class"
    bl_description = "Give the selected faces a class by hand, which they keep in later runs"
    bl_options = {"REGISTER", "UNDO"}

    surface_class: EnumProperty(
        name="Class",
        description="Class to give, or whether faces are free again",
        items=_ITEMS,
        default=SurfaceClass.FLAT.name,
        options={"SKIP_SAVE"},
    )

    @classmethod
    def poll(cls, context: Context) -> bool:
        """Ask for a segmented mesh."""
        return polls.has_classes(cls, context)

    def steps(self, context: Context) -> Steps[editing.Edited]:
        """Lock the selected faces, and segment again."""
        kind = SurfaceClass[self.surface_class]
        return editing.edit_objects(context, selected_subjects(context), editing.assign_class(kind))

    def finish(self, _context: Context, outcome: editing.Edited) -> set[str]:
        """Tell what was changed."""
        kind = SurfaceClass[self.surface_class]
        faces = f"{outcome.faces:,} {'face' if outcome.faces == 1 else 'faces'}"
        is_free = kind == SurfaceClass.UNDEFINED
        verb = f"Freed {faces} of" if is_free else f"Assigned {CLASS_NAMES[kind]} to {faces} of"
        return conclude(self, outcome, verb)
