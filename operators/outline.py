# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Make curves of borders and of where domes turn into saddles."""

from __future__ import annotations

from bpy.props import BoolProperty, EnumProperty, FloatProperty
from bpy.types import Context, Operator

from ..addon import polls
from ..addon.bridge import units
from ..addon.bridge.subject import selected_subjects
from ..addon.geometry.outlines.outline import OutlineSettings
from ..addon.outlining import Outlined, outline_objects
from ..addon.properties.items import OUTLINE_ITEMS
from ..addon.running import RunningOperator
from ..addon.steps import Steps

_NOUNS = {"BORDERS": ("border", "borders"), "PARABOLIC": ("parabolic curve", "parabolic curves")}


class CURVATURE_OT_outline(RunningOperator, Operator):
    """Make curve objects of the region borders and parabolic curves of the selected meshes."""

    bl_idname = "curvature.outline"
    bl_label = "Outline Regions"
    bl_description = (
        "Make curves of the borders between regions, and of where domes turn into saddles, "
        "in a collection of their own"
    )
    bl_options = {"REGISTER", "UNDO"}

    kind: EnumProperty(
        name="Kind",
        description="Which curves to make",
        items=(*OUTLINE_ITEMS, ("BOTH", "Both", "Region borders and parabolic curves", 2)),
        default="BORDERS",
        options={"SKIP_SAVE"},
    )
    straighten: BoolProperty(
        name="Straighten",
        description="Take the zigzag of the mesh out of borders, within the tolerance",
        default=True,
    )
    tolerance: FloatProperty(
        name="Tolerance (m)",
        description="How far borders may be moved to straighten them, in meters; "
        "0 takes the deviation of the panels",
        default=0.0,
        min=0.0,
        precision=4,
        options={"SKIP_SAVE"},
    )
    include_rims: BoolProperty(
        name="Include Rims",
        description="Take the edges where the surface ends for borders as well",
        default=False,
    )

    @classmethod
    def poll(cls, context: Context) -> bool:
        """Ask for a segmented mesh."""
        return polls.has_classes(cls, context)

    def steps(self, context: Context) -> Steps[Outlined]:
        """Trace, and make curves."""
        kinds = ("BORDERS", "PARABOLIC") if self.kind == "BOTH" else (self.kind,)
        wanted = [
            OutlineSettings(kind, self.tolerance, self.straighten, self.include_rims)
            for kind in kinds
        ]
        return outline_objects(context, selected_subjects(context), wanted)

    def finish(self, context: Context, outcome: Outlined) -> set[str]:
        """Tell how many curves there are, and how long they are."""
        if not outcome.models:
            self.report({"ERROR"}, "; ".join(outcome.refused))
            return {"CANCELLED"}
        text = "; ".join([_sentence(context, outcome), *outcome.refused])
        self.report({"WARNING"} if outcome.refused else {"INFO"}, text)
        return {"FINISHED"}


def _sentence(context: Context, outcome: Outlined) -> str:
    parts = [
        f"{count:,} {_NOUNS[kind][count != 1]}, "
        f"{units.length_text(context.scene, outcome.lengths[kind])} long"
        for kind, count in outcome.counts.items()
    ]
    return f"Made {' and '.join(parts)}"
