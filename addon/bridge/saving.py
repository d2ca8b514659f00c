# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Blender files that are written whole or not at all."""

from __future__ import annotations

from pathlib import Path

import bpy

from ..report.files import FileRefusedError, written_whole


def save_blend(path: Path) -> None:
    """Write the open file to a path, without making it the open file's path.

    Raises
    ------
    FileRefusedError
        If the folder is missing, cannot be written to, or Blender fails to write.
    """
    with written_whole(path) as temporary:
        # Blender would keep the empty placeholder as a backup of the "earlier version".
        temporary.unlink()
        try:
            bpy.ops.wm.save_as_mainfile(filepath=str(temporary), copy=True, compress=True)
        except RuntimeError as error:
            raise FileRefusedError(f"{path}: Blender cannot write it ({error})") from error
