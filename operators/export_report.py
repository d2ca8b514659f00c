# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Write a report."""

from __future__ import annotations

import bpy
from bpy.types import Context, Operator

from ..addon import polls
from ..addon.bridge.subject import carrier_of, selected_subjects
from ..addon.exporting import ExportOperator, file_filter, file_path
from ..addon.overlay.content import class_legend
from ..addon.report.files import FORMATS, FileRefusedError, check_format, write_report
from ..addon.reporting import css_colors, report_pictures, scene_document


class CURVATURE_OT_export_report(ExportOperator, Operator):
    """Write what was measured on the selected meshes to a file."""

    bl_idname = "curvature.export_report"
    bl_label = "Export Report"
    bl_description = (
        "Write areas, shares, radii and statistics of the selected meshes "
        "to an HTML, JSON or CSV file"
    )
    # No UNDO: the operator changes a file, nothing in Blender.
    bl_options = {"REGISTER"}

    ending = "-curvature.html"

    filepath: file_path(FORMATS)
    filter_glob: file_filter(FORMATS)

    @classmethod
    def poll(cls, context: Context) -> bool:
        """Ask for an analyzed mesh."""
        return polls.has_results(cls, context)

    def execute(self, context: Context) -> set[str]:
        """Collect the measures and write the file."""
        carriers = [carrier_of(source) for source in selected_subjects(context)]
        carriers = [carrier for carrier in carriers if carrier.data.curvature.report]
        if not carriers:
            self.report({"ERROR"}, "The selected meshes have no curvature results: analyze them")
            return {"CANCELLED"}
        path = self.path
        try:
            check_format(path)
            pictures = report_pictures(
                context, carriers, class_legend(context.scene, carriers), path
            )
            document = scene_document(context, carriers, bpy.data.filepath)
            write_report(path, document, pictures, css_colors(context))
        except FileRefusedError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        self.report({"INFO"}, f"Wrote {path.name}")
        return {"FINISHED"}
