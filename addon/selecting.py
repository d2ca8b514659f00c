# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators that select faces of segmented meshes."""

from __future__ import annotations

from bpy.props import BoolProperty
from bpy.types import Context, Event

from .bridge.mode import enter_face_select


class SelectOperator:
    """An operator that selects faces, in place of those that are selected or beside them."""

    extend: BoolProperty(
        name="Extend",
        description="Keep the faces that are selected already",
        default=False,
        options={"SKIP_SAVE"},
    )

    def invoke(self, context: Context, event: Event) -> set[str]:
        """Select and enter Edit Mode, where selected faces can be seen; Shift extends."""
        self.extend = self.extend or event.shift
        result = self.execute(context)
        if result == {"FINISHED"} and context.mode == "OBJECT":
            enter_face_select(context)
        return result
