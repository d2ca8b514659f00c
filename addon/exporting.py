# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Operators that write a file: they ask for it, and warn before one is replaced."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

import bpy
from bpy.props import BoolProperty, StringProperty
from bpy.types import Context, Event


def file_path(endings: Iterable[str]) -> object:
    """Return the property of a file to write in one of several formats."""
    *others, last = endings
    return StringProperty(
        name="File Path",
        description=f"File to write; its ending decides the format: {', '.join(others)} or {last}",
        subtype="FILE_PATH",
        options={"SKIP_SAVE"},
    )


def file_filter(endings: Iterable[str]) -> object:
    """Return the property that tells the file browser which files to list."""
    return StringProperty(
        name="Filter",
        description="Endings of the files to list",
        default=";".join(f"*{ending}" for ending in endings),
        options={"HIDDEN"},
    )


class ExportOperator:
    """An operator that writes to its `filepath`."""

    ending = ""
    """What the name of the file ends with if the user does not give another."""

    check_existing: BoolProperty(
        name="Check Existing",
        description="Warn before a file is replaced",
        default=True,
        options={"HIDDEN"},
    )

    def invoke(self, context: Context, _event: Event) -> set[str]:
        """Ask for the file, beside the open one by default."""
        if not self.filepath:
            stem = Path(bpy.data.filepath).stem or "untitled"
            self.filepath = str(Path(bpy.data.filepath).with_name(f"{stem}{self.ending}"))
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    @property
    def path(self) -> Path:
        """The file to write; a name that begins with // lies beside the open file."""
        return Path(bpy.path.abspath(self.filepath))
