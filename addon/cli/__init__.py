# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The command `blender --command curvature`."""

from __future__ import annotations

import bpy

from .arguments import PROGRAM
from .run import main

_commands: list[object] = []


def register() -> None:
    """Make the command known to Blender."""
    _commands.append(bpy.utils.register_cli_command(PROGRAM, main))


def unregister() -> None:
    """Take the command away."""
    while _commands:
        bpy.utils.unregister_cli_command(_commands.pop())
