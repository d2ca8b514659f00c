# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Finding buttons of the sidebar and pressing them by mouse, for scenarios.

Blender tells no button's place. But it says what lies under the mouse, so the mouse is moved down
over the sidebar until it lies on what is wanted: nothing is counted in pixels or rows.
"""

from __future__ import annotations

import re
from collections.abc import Generator

import bpy
from session import Step, Steps, click, in_view3d, leave, move, region, wait


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
    # Rows may hold several buttons: they are crossed at three places.
    for share in (0.7, 0.35, 0.82):
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
