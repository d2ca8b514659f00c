# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a scenario says to the windowed Blender in which it runs.

A scenario is a generator function `scenario(*arguments)` in a file of its own. It calls bpy, and
yields whenever the screen has to catch up or something has to happen outside Blender::

    import bpy
    from buttons import press
    from session import record, shot, show_sidebar, wait


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

from collections.abc import Callable, Generator, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field

import bpy


@dataclass(frozen=True)
class Step:
    """Something to wait for before the scenario goes on."""

    seconds: float = 0.0
    condition: Callable[[], object] | None = None
    outside: dict[str, object] = field(default_factory=dict)


Steps = Generator[Step, None, None]
recorded: dict[str, object] = {}


def record(**values: object) -> None:
    """Keep values for the judging tests, in result.json."""
    recorded.update(values)


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


def key(name: str) -> Step:
    """Press a key, in X's names: "Return", "ctrl+z"."""
    return _mouse("key", name)


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


def leave() -> Steps:
    """Move the mouse to where it highlights nothing."""
    yield move(window().width / 2, 2)
    yield wait(0.2)
