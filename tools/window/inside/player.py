# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Plays a scenario inside Blender: `blender --python player.py -- SCENARIO RESULTS [ARGUMENT …]`.

The scenario's steps are carried out from a timer, so that Blender works and draws between them.
"""

from __future__ import annotations

import importlib.util
import json
import os
import sys
import time
import traceback
from collections.abc import Iterator
from pathlib import Path
from typing import NoReturn

import bpy

sys.path.append(str(Path(__file__).parent))

import session  # it lies beside this file

_POLL_SECONDS = 0.03
_ANSWER_LIMIT = 30.0
_START_SECONDS = 1.5


class _Player:
    """Carries out a scenario's steps, one at a time, from a timer of Blender's."""

    def __init__(self, steps: session.Steps, results: Path) -> None:
        self._steps = steps
        self._results = results
        self._waiting: Iterator[float] = iter(())
        self._start = time.monotonic()

    def tick(self) -> float:
        """Go on; return after how many seconds Blender shall call again."""
        try:
            return self._next_pause()
        except StopIteration:
            self._finish(error=None)
        except BaseException:  # noqa: BLE001 - Blender would go on for ever without a scenario
            self._finish(error=traceback.format_exc())

    def _next_pause(self) -> float:
        pause = next(self._waiting, None)
        while pause is None:
            self._waiting = self._carry_out(next(self._steps))
            pause = next(self._waiting, None)
        return pause

    def _carry_out(self, step: session.Step) -> Iterator[float]:
        if step.outside:
            yield from self._ask(step.outside)
        elif step.condition is None:
            yield step.seconds
        else:
            end = time.monotonic() + step.seconds
            while not step.condition():
                if time.monotonic() > end:
                    message = f"a condition did not come true in {step.seconds} s"
                    raise TimeoutError(message)
                yield _POLL_SECONDS

    def _ask(self, outside: dict[str, object]) -> Iterator[float]:
        if "shot" in outside:
            yield 0.4  # until what was tagged has been drawn
        # Into blender.log, between what Blender and the extension say.
        print(f"session: {time.monotonic() - self._start:6.2f} s: {outside}", flush=True)
        request = self._results / "request.json"
        partial = request.with_suffix(".partial")
        partial.write_text(json.dumps(outside), encoding="utf-8")
        partial.rename(request)
        end = time.monotonic() + _ANSWER_LIMIT
        while request.exists():
            if time.monotonic() > end:
                message = f"the driver did not answer {outside}"
                raise TimeoutError(message)
            yield _POLL_SECONDS

    def _finish(self, error: str | None) -> NoReturn:
        result = {
            "error": error,
            "blender": bpy.app.version_string,
            "window": [session.window().width, session.window().height],
            **session.recorded,
        }
        path = self._results / "result.json"
        path.write_text(json.dumps(result, indent=1), encoding="utf-8")
        sys.stdout.flush()
        sys.stderr.flush()
        # A timer cannot end Blender with a status in another way.
        os._exit(1 if error else 0)


def _start() -> None:
    scenario_file, results, *arguments = sys.argv[sys.argv.index("--") + 1 :]
    preferences = bpy.context.preferences
    # What is set here would be written to the user's preferences on quitting.
    preferences.use_preferences_save = False
    preferences.view.show_splash = False
    spec = importlib.util.spec_from_file_location("played_scenario", scenario_file)
    assert spec is not None  # noqa: S101 - for the type checker
    assert spec.loader is not None  # noqa: S101
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    player = _Player(module.scenario(*arguments), Path(results))
    bpy.app.timers.register(player.tick, first_interval=_START_SECONDS, persistent=True)


if __name__ == "__main__":
    _start()
