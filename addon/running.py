# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators whose work takes time: the window stays alive, Esc cancels."""

from __future__ import annotations

from bpy.types import Context, Event

from .geometry.errors import CurvatureError
from .progress import progress
from .reporting import conclude
from .steps import Run, Steps, complete
from .tasks import Outcome

#: Seconds that a user does not notice: short work ends before the window is shown again.
_PATIENCE = 0.3
#: Seconds between two looks at the work.
_TICK = 0.1


class RunningOperator:
    """An operator that runs a task: at once from a script, beside the window from a button."""

    verb = "Done"

    def steps(self, context: Context) -> Steps[Outcome]:
        """Return the task; may raise what is wrong with the settings."""
        raise NotImplementedError

    def execute(self, context: Context) -> set[str]:
        """Run the task to its end."""
        steps = self._checked_steps(context)
        if steps is None:
            return {"CANCELLED"}
        with progress(context.window_manager) as advance:
            outcome = complete(steps, advance)
        return self.finish(context, outcome)

    def finish(self, _context: Context, outcome: Outcome) -> set[str]:
        """Tell what became of the objects."""
        return conclude(self, outcome, self.verb)

    def invoke(self, context: Context, _event: Event) -> set[str]:
        """Run the task beside the window."""
        return self.start(context)

    def start(self, context: Context) -> set[str]:
        """Run the task beside the window."""
        steps = self._checked_steps(context)
        if steps is None:
            return {"CANCELLED"}
        self._run = Run(steps)
        if self._run.advance(_PATIENCE):
            return self.finish(context, self._run.result)
        manager = context.window_manager
        self._timer = manager.event_timer_add(_TICK, window=context.window)
        manager.progress_begin(0, 100)
        manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context: Context, event: Event) -> set[str]:
        """Look whether the work is done; everything but Esc waits for it."""
        if event.type == "ESC":
            self._run.cancel()
            self._leave(context)
            self.report({"INFO"}, f"{self.bl_label} was cancelled: nothing has changed")
            return {"CANCELLED"}
        if event.type != "TIMER":
            return {"RUNNING_MODAL"}
        if not self._has_ended(context):
            share = round(100.0 * self._run.share)
            context.window_manager.progress_update(share)
            context.workspace.status_text_set(f"{self.bl_label}: {share} %    Esc: Cancel")
            return {"RUNNING_MODAL"}
        return self.finish(context, self._run.result)

    def cancel(self, context: Context) -> None:
        """Stop with Blender, or with the file that is closed."""
        self._run.cancel()
        self._leave(context)

    def _checked_steps(self, context: Context) -> Steps[Outcome] | None:
        """Return the task, or None after telling what is wrong with the settings."""
        try:
            return self.steps(context)
        except CurvatureError as error:
            self.report({"ERROR"}, str(error))
            return None

    def _has_ended(self, context: Context) -> bool:
        """Go on; leave the window as it was where the task has ended, also by an error."""
        has_ended = True
        try:
            has_ended = self._run.advance(0.0)
        finally:
            if has_ended:
                self._leave(context)
        return has_ended

    def _leave(self, context: Context) -> None:
        manager = context.window_manager
        manager.event_timer_remove(self._timer)
        manager.progress_end()
        context.workspace.status_text_set(None)
