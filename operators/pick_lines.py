# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pick curvature lines with the mouse."""

from __future__ import annotations

from math import inf

import numpy as np
from bpy.types import Context, Event, Operator

from ..addon import polls
from ..addon.bridge import viewport
from ..addon.bridge.companions import FAMILY_ROLES, ROLES
from ..addon.bridge.pointing import ray_through
from ..addon.bridge.subject import source_of
from ..addon.choices import LINE_NAMES, adopt_kind, adopt_settings, line_plan
from ..addon.geometry.display.colormap import srgb_from_linear
from ..addon.geometry.errors import CurvatureError
from ..addon.geometry.lines.field import Family
from ..addon.geometry.lines.point_lines import PointLines
from ..addon.overlay import preview
from ..addon.properties.lines import LineChoices
from ..addon.steps import Run
from ..addon.tracing.picking import Picker, prepare_picker

#: Seconds between two looks at the work, and those that may pass before the window is shown again:
#: longer lines grow while one looks.
_TICK, _PATIENCE = 0.02, 0.03
_PASSED = {"MIDDLEMOUSE", "WHEELUPMOUSE", "WHEELDOWNMOUSE", "TRACKPADPAN", "TRACKPADZOOM"}
_NAVIGATION = {f"NUMPAD_{digit}" for digit in range(10)} | {"NUMPAD_PERIOD", "HOME", "NDOF_MOTION"}


class CURVATURE_OT_pick_lines(LineChoices, Operator):
    """Trace the curvature lines under the mouse, and keep those that are clicked."""

    bl_idname = "curvature.pick_lines"
    bl_label = "Pick Lines"
    bl_description = (
        "Show the lines through the point under the mouse; a click keeps them, "
        "Esc or the right mouse button ends"
    )
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context: Context) -> bool:
        """Ask for an active mesh and a mode in which it can be read."""
        return polls.has_active_mesh(cls, context)

    def execute(self, context: Context) -> set[str]:
        """Refuse: without a mouse there is nothing to pick."""
        del context
        self.report({"ERROR"}, "Picking needs a 3D viewport: use Trace Through Points in scripts")
        return {"CANCELLED"}

    def invoke(self, context: Context, event: Event) -> set[str]:
        """Analyze the active model, then follow the mouse."""
        if context.region_data is None:
            return self.execute(context)
        adopt_settings(self, context, LINE_NAMES)
        adopt_kind(self, context)
        self._picker: Picker | None = None
        self._pointed: PointLines | None = None
        self._mouse = (event.mouse_region_x, event.mouse_region_y)
        self._kept = 0
        try:
            plan = line_plan(context, self)
            self._preparing = Run(prepare_picker(context, source_of(context.object), plan))
            self._preparing.advance(_TICK)
        except CurvatureError as error:
            self.report({"ERROR"}, f"{context.object.name}: {error}")
            return {"CANCELLED"}
        manager = context.window_manager
        self._timer = manager.event_timer_add(_TICK, window=context.window)
        manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context: Context, event: Event) -> set[str]:
        """Trace where the mouse is, keep on a click, let the view be moved."""
        if event.type in {"ESC", "RIGHTMOUSE", "RET"} and event.value == "PRESS":
            return self._end(context)
        if event.type == "TIMER":
            return self._advance(context)
        if event.type in _PASSED | _NAVIGATION or event.alt:
            return {"PASS_THROUGH"}
        if event.type == "MOUSEMOVE":
            self._mouse = (event.mouse_region_x, event.mouse_region_y)
            self._follow(context)
        elif event.type == "LEFTMOUSE":
            return self._click(context, event)
        return {"RUNNING_MODAL"}

    def cancel(self, context: Context) -> None:
        """Stop with Blender, or with the file that is closed."""
        self._leave(context)

    def _click(self, context: Context, event: Event) -> set[str]:
        """Keep the lines shown; clicks beside the viewport belong to what they hit."""
        region = context.region
        is_inside = (
            0 <= event.mouse_region_x < region.width and 0 <= event.mouse_region_y < region.height
        )
        if not is_inside:
            return {"PASS_THROUGH"}
        if event.value == "PRESS" and self._picker is not None and self._pointed is not None:
            self._pointed.advance(inf)
            lines = self._pointed.lines()
            if lines.count:
                self._picker.keep(context, lines)
                self._kept += lines.count
                self._write_status(context)
        return {"RUNNING_MODAL"}

    def _advance(self, context: Context) -> set[str]:
        if self._picker is None:
            return self._prepare(context)
        if self._pointed is not None and not self._pointed.is_done:
            self._go_on(context)
        return {"RUNNING_MODAL"}

    def _prepare(self, context: Context) -> set[str]:
        try:
            is_done = self._preparing.advance(0.0)
        except CurvatureError as error:
            self._leave(context)
            self.report({"ERROR"}, f"{context.object.name}: {error}")
            return {"CANCELLED"}
        if is_done:
            self._picker = self._preparing.result
            # The mouse may have come to rest before the model was ready.
            self._follow(context)
        self._write_status(context)
        return {"RUNNING_MODAL"}

    def _follow(self, context: Context) -> None:
        """Trace the lines through what the mouse is on; none where it is beside the model."""
        if self._picker is None:
            return
        ray = ray_through(context, self._mouse)
        self._pointed = None if ray is None else self._picker.seen(*ray)
        self._go_on(context)

    def _go_on(self, context: Context) -> None:
        """Trace for a moment, and show the lines as far as they are."""
        shown = []
        if self._picker is not None and self._pointed is not None:
            self._pointed.advance(_PATIENCE)
            lines = self._pointed.lines()
            rows = zip(
                self._picker.in_world(lines),
                lines.is_closed.tolist(),
                lines.family.tolist(),
                strict=True,
            )
            shown = [preview.PreviewLine(points, closed, _color(f)) for points, closed, f in rows]
        preview.show(shown)
        self._write_status(context)
        viewport.redraw(context)

    def _write_status(self, context: Context) -> None:
        if self._picker is None:
            text = f"Analyzing: {round(100.0 * self._preparing.share)} %    Esc: Cancel"
        else:
            is_void = self._pointed is not None and not preview.shown()
            here = "No Lines Here" if is_void else "Click: Keep the Lines"
            text = f"{self._kept} lines kept    {here}    Esc, Right Click: End"
        context.workspace.status_text_set(f"{self.bl_label}: {text}")

    def _end(self, context: Context) -> set[str]:
        self._leave(context)
        if not self._kept:
            return {"CANCELLED"}
        self.report({"INFO"}, f"Kept {self._kept} lines")
        return {"FINISHED"}

    def _leave(self, context: Context) -> None:
        if not self._preparing.is_finished:
            self._preparing.cancel()
        preview.hide()
        context.window_manager.event_timer_remove(self._timer)
        context.workspace.status_text_set(None)
        viewport.redraw(context)


def _color(family: int) -> tuple[float, float, float, float]:
    linear = np.array(ROLES[FAMILY_ROLES[Family(family)]].color)
    # Brighter than the curves, which they are not yet.
    red, green, blue = srgb_from_linear(np.minimum(2.5 * linear + 0.02, 1.0)).tolist()
    return (red, green, blue, 1.0)
