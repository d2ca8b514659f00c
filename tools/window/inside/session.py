# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a scenario says to the windowed Blender in which it runs.

A scenario is a generator function `scenario(*arguments)` in a file of its own. It calls bpy, and
yields whenever the screen has to catch up or something has to happen outside Blender::

    import bpy
    from session import click, press, record, show_sidebar, shot, wait


    def scenario(model):
        bpy.ops.wm.obj_import(filepath=model)
        yield wait(0.5)
        yield from show_sidebar("Curvature")
        yield from press("curvature.segment")
        yield shot("segmented")
        record(faces=len(bpy.context.object.data.polygons))

Places on the screen are in Blender's own pixels, which count from the lower left corner. A scenario
that fails leaves its traceback in result.json.
"""

from __future__ import annotations

import importlib.util
import json
import os
import re
import sys
import time
import traceback
from collections.abc import Callable, Generator, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import NoReturn

import bpy

_POLL_SECONDS = 0.03
_ANSWER_LIMIT = 30.0
_START_SECONDS = 1.5


@dataclass(frozen=True)
class Step:
    """Something to wait for before the scenario goes on."""

    seconds: float = 0.0
    condition: Callable[[], object] | None = None
    outside: dict[str, object] = field(default_factory=dict)


Steps = Generator[Step, None, None]
_recorded: dict[str, object] = {}


def record(**values: object) -> None:
    """Keep values for the judging tests, in result.json."""
    _recorded.update(values)


def wait(seconds: float) -> Step:
    """Let Blender work and draw for a while."""
    return Step(seconds=seconds)


def until(condition: Callable[[], object], seconds: float = 20.0) -> Step:
    """Let Blender work until a condition is true; the scenario fails if it never is."""
    return Step(seconds=seconds, condition=condition)


def shot(name: str) -> Step:
    """Take a picture of the whole screen, `name`.png."""
    redraw()
    return Step(outside={"shot": name})


def move(x: float, y: float) -> Step:
    """Move the mouse."""
    return _mouse("mousemove", *_on_screen(x, y))


def click(x: float, y: float, button: int = 1) -> Step:
    """Move the mouse and click."""
    # Blender acts on the button under the mouse only after it has seen the mouse come to rest.
    return _mouse("mousemove", *_on_screen(x, y), "sleep", "0.3", "click", str(button))


def drag(*places: tuple[float, float], button: int = 1) -> Step:
    """Press at the first place, pass through the others and let go at the last."""
    (x, y), *others = places
    words = ["mousemove", *_on_screen(x, y), "sleep", "0.3", "mousedown", str(button)]
    for place in others:
        words += ["sleep", "0.1", "mousemove", *_on_screen(*place)]
    return _mouse(*words, "sleep", "0.2", "mouseup", str(button))


def key(name: str) -> Step:
    """Press a key, in X's names: "Return", "ctrl+z"."""
    return _mouse("key", name)


def type_text(text: str) -> Step:
    """Type a text into the field that is being edited."""
    return _mouse("type", "--delay", "30", text)


def _mouse(*words: str) -> Step:
    return Step(outside={"xdotool": list(words)})


def _on_screen(x: float, y: float) -> tuple[str, str]:
    """Turn Blender's place into X's, which counts from the top."""
    return str(round(x)), str(round(window().height - 1 - y))


def window() -> bpy.types.Window:
    """Return Blender's only window."""
    return bpy.context.window_manager.windows[0]


def view3d() -> bpy.types.Area:
    """Return the largest 3D Viewport."""
    areas = [area for area in window().screen.areas if area.type == "VIEW_3D"]
    return max(areas, key=lambda area: area.width * area.height)


def region(kind: str = "WINDOW") -> bpy.types.Region:
    """Return a region of the 3D Viewport; "UI" is the sidebar."""
    return next(one for one in view3d().regions if one.type == kind)


@contextmanager
def in_view3d(kind: str = "WINDOW") -> Iterator[None]:
    """Call operators as if the mouse were in the 3D Viewport."""
    with bpy.context.temp_override(window=window(), area=view3d(), region=region(kind)):
        yield


def redraw() -> None:
    """Draw everything anew as soon as Blender is back at work."""
    for area in window().screen.areas:
        area.tag_redraw()


def show_sidebar(tab: str) -> Steps:
    """Open the 3D Viewport's sidebar at a tab."""
    view3d().spaces.active.show_region_ui = True
    redraw()
    # The tabs are known once the region has been drawn.
    yield until(lambda: region("UI").width > 1)
    yield wait(0.5)
    region("UI").active_panel_category = tab
    redraw()
    yield wait(0.5)


def find(target: str) -> Generator[Step, None, tuple[float, float]]:
    """Find a button of the sidebar by moving the mouse down over it.

    Parameters
    ----------
    target : str
        An operator ("curvature.segment") or the end of a property's path ("curvature.panel_size").

    Returns
    -------
    tuple of float
        The place of the button.

    Raises
    ------
    LookupError
        If no such button can be seen; it names those that were.
    """
    sidebar = region("UI")
    seen: list[str] = []
    row = 20 * bpy.context.preferences.system.ui_scale
    # Rows may hold several buttons: they are crossed at two places.
    for share in (0.7, 0.35):
        x = sidebar.x + sidebar.width * share
        y = sidebar.y + sidebar.height - row / 4
        while y > sidebar.y:
            yield move(x, y)
            yield wait(0.06)
            under = _button_under_mouse()
            if re.search(rf"(^|\.){re.escape(target)}(\(|$)", under):
                return x, y
            seen.append(under)
            y -= row / 2
    known = sorted(set(seen) - {""})
    message = f"no button for {target} in the sidebar; there are {', '.join(known) or 'none'}"
    raise LookupError(message)


def press(target: str) -> Steps:
    """Find a button of the sidebar and click it, see `find`."""
    x, y = yield from find(target)
    yield click(x, y)
    yield wait(0.3)
    yield from leave()


def leave() -> Steps:
    """Move the mouse to where it highlights nothing."""
    yield move(window().width / 2, 2)
    yield wait(0.2)


def _button_under_mouse() -> str:
    """Ask Blender what the button under the mouse is: a command, a property's path, or nothing."""
    manager = bpy.context.window_manager
    manager.clipboard = ""
    with in_view3d("UI"):
        for ask in (bpy.ops.ui.copy_python_command_button, bpy.ops.ui.copy_data_path_button):
            if ask.poll():
                ask()
                break
    return manager.clipboard.removeprefix("bpy.ops.")


class _Player:
    """Carries out a scenario's steps, one at a time, from a timer of Blender's."""

    def __init__(self, steps: Steps, results: Path) -> None:
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

    def _carry_out(self, step: Step) -> Iterator[float]:
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
            "window": [window().width, window().height],
            **_recorded,
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
    # The scenario imports from this very module.
    sys.modules["session"] = sys.modules[__name__]
    spec = importlib.util.spec_from_file_location("played_scenario", scenario_file)
    assert spec is not None  # noqa: S101 - for the type checker
    assert spec.loader is not None  # noqa: S101
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    player = _Player(module.scenario(*arguments), Path(results))
    bpy.app.timers.register(player.tick, first_interval=_START_SECONDS, persistent=True)


if __name__ == "__main__":
    _start()
