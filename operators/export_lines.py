# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Write curvature lines as a drawing."""

from __future__ import annotations

from pathlib import Path

import bpy
from bpy.props import BoolProperty, StringProperty
from bpy.types import Context, Event, Operator

from ..addon import polls
from ..addon.bridge.drawings import drawing_of
from ..addon.bridge.subject import selected_subjects
from ..addon.export.formats import TEXTS, write_drawing
from ..addon.report.files import FileRefusedError


class CURVATURE_OT_export_lines(Operator):
    """Write the curvature lines of the selected meshes to a drawing."""

    bl_idname = "curvature.export_lines"
    bl_label = "Export Lines"
    bl_description = (
        "Write the curvature lines of the selected meshes to a DXF, OBJ or SVG file, "
        "a layer per family"
    )
    # No UNDO: the operator changes a file, nothing in Blender.
    bl_options = {"REGISTER"}

    filepath: StringProperty(
        name="File Path",
        description="File to write; its ending decides the format: .dxf, .svg or .obj",
        subtype="FILE_PATH",
        options={"SKIP_SAVE"},
    )
    check_existing: BoolProperty(
        name="Check Existing",
        description="Warn before a file is replaced",
        default=True,
        options={"HIDDEN"},
    )
    filter_glob: StringProperty(
        name="Filter",
        description="Endings of the files to list",
        default=";".join(f"*{ending}" for ending in TEXTS),
        options={"HIDDEN"},
    )

    @classmethod
    def poll(cls, context: Context) -> bool:
        """Ask for a mesh with lines."""
        return polls.has_lines(cls, context)

    def invoke(self, context: Context, _event: Event) -> set[str]:
        """Ask for the file, beside the open one by default."""
        if not self.filepath:
            stem = Path(bpy.data.filepath).stem or "untitled"
            self.filepath = str(Path(bpy.data.filepath).with_name(f"{stem}-lines.dxf"))
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    def execute(self, context: Context) -> set[str]:
        """Collect the lines and write the file."""
        drawing = drawing_of(selected_subjects(context), context.scene)
        if not drawing.layers:
            self.report({"ERROR"}, "The selected meshes have no curvature lines: trace some")
            return {"CANCELLED"}
        path = Path(bpy.path.abspath(self.filepath))
        try:
            write_drawing(path, drawing)
        except FileRefusedError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        count = sum(len(layer.lines) for layer in drawing.layers)
        self.report({"INFO"}, f"Wrote {count:,} lines to {path.name}")
        return {"FINISHED"}
