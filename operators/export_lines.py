# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Write curves as a drawing."""

from __future__ import annotations

from bpy.types import Context, Operator

from ..addon import polls
from ..addon.bridge.drawings import drawing_of
from ..addon.bridge.subject import selected_subjects
from ..addon.export.formats import TEXTS, write_drawing
from ..addon.exporting import ExportOperator, file_filter, file_path
from ..addon.report.files import FileRefusedError


class CURVATURE_OT_export_lines(ExportOperator, Operator):
    """Write the curves on the selected meshes to a drawing."""

    bl_idname = "curvature.export_lines"
    bl_label = "Export Lines"
    bl_description = (
        "Write the curvature lines, region borders and parabolic curves of the selected meshes "
        "to a DXF, OBJ or SVG file, a layer per kind"
    )
    # No UNDO: the operator changes a file, nothing in Blender.
    bl_options = {"REGISTER"}

    ending = "-lines.dxf"

    filepath: file_path(TEXTS)
    filter_glob: file_filter(TEXTS)

    @classmethod
    def poll(cls, context: Context) -> bool:
        """Ask for a mesh with curves."""
        return polls.has_lines(cls, context)

    def execute(self, context: Context) -> set[str]:
        """Collect the lines and write the file."""
        drawing = drawing_of(selected_subjects(context), context.scene)
        if not drawing.layers:
            self.report({"ERROR"}, "The selected meshes have no curves: trace curvature lines")
            return {"CANCELLED"}
        path = self.path
        try:
            write_drawing(path, drawing)
        except FileRefusedError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        count = sum(len(layer.lines) for layer in drawing.layers)
        self.report({"INFO"}, f"Wrote {count:,} lines to {path.name}")
        return {"FINISHED"}
