# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pick curvature lines with the mouse."""

from __future__ import annotations

import numpy as np
from bpy.types import Context, Event, Operator

from ..addon import polls
from ..addon.bridge import viewport
from ..addon.bridge.companions import FAMILY_ROLES, ROLES
from ..addon.bridge.pointing import pointed_at
from ..addon.bridge.subject import source_of
from ..addon.choices import LINE_NAMES, adopt_kind, adopt_settings, line_plan
from ..addon.geometry.display.colormap import srgb_from_linear
from ..addon.geometry.errors import CurvatureError
from ..addon.geometry.lines.field import Family
from ..addon.geometry.lines.lines import CurvatureLines
from ..addon.geometry.types import Floats
from ..addon.overlay import preview
from ..addon.properties.lines import LineChoices
from ..addon.steps import Run, Steps, Work
from ..addon.tracing.picking import Picker, prepare_picker

#: Seconds between two looks at the work.
_TICK = 0.05
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
        self._lines: CurvatureLines | None = None
        self._run: Run | None = None
        self._wanted: Floats | None = None
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
        if event.value == "PRESS" and self._picker is not None and self._lines is not None:
            self._picker.keep(context, self._lines)
            self._kept += self._lines.count
            self._write_status(context)
        return {"RUNNING_MODAL"}

    def _advance(self, context: Context) -> set[str]:
        if self._picker is None:
            return self._prepare(context)
        if self._run is not None and self._run.advance(0.0):
            lines = self._run.result
            self._run = None
            if self._wanted is not None or self._lines is None:
                self._show(context, lines)
        if self._run is None and self._wanted is not None:
            # The newest place only: what the mouse passed meanwhile is of no interest.
            self._run = Run(_once(self._picker, self._wanted))
            self._run.advance(0.0)
            self._wanted = None
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
        """Want the lines through what the mouse is on; nothing where it is beside the model."""
        if self._picker is None:
            return
        self._wanted = pointed_at(context, self._mouse, self._picker.source)
        if self._wanted is None:
            self._show(context, None)

    def _show(self, context: Context, lines: CurvatureLines | None) -> None:
        self._lines = lines if lines is not None and lines.count else None
        shown = []
        if self._lines is not None and self._picker is not None:
            rows = zip(
                self._picker.in_world(self._lines),
                self._lines.is_closed.tolist(),
                self._lines.family.tolist(),
                strict=True,
            )
            shown = [preview.PreviewLine(points, closed, _color(f)) for points, closed, f in rows]
        preview.show(shown)
        viewport.redraw(context)

    def _write_status(self, context: Context) -> None:
        if self._picker is None:
            text = f"Analyzing: {round(100.0 * self._preparing.share)} %    Esc: Cancel"
        else:
            text = f"{self._kept} lines kept    Click: Keep the Lines    Esc, Right Click: End"
        context.workspace.status_text_set(f"{self.bl_label}: {text}")

    def _end(self, context: Context) -> set[str]:
        self._leave(context)
        if not self._kept:
            return {"CANCELLED"}
        self.report({"INFO"}, f"Kept {self._kept} lines")
        return {"FINISHED"}

    def _leave(self, context: Context) -> None:
        for run in (self._preparing, self._run):
            if run is not None and not run.is_finished:
                run.cancel()
        preview.hide()
        context.window_manager.event_timer_remove(self._timer)
        context.workspace.status_text_set(None)
        viewport.redraw(context)


def _once(picker: Picker, place: Floats) -> Steps[CurvatureLines]:
    return (yield Work(picker.tracing(place), 0.0, 1.0))


def _color(family: int) -> tuple[float, float, float, float]:
    linear = np.array(ROLES[FAMILY_ROLES[Family(family)]].color)
    # Brighter than the curves, which they are not yet.
    red, green, blue = srgb_from_linear(np.minimum(2.5 * linear + 0.02, 1.0)).tolist()
    return (red, green, blue, 1.0)
