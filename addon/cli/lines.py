# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The subcommand `lines`: curvature lines of a model, as curves or drawings."""

from __future__ import annotations

from argparse import Namespace
from pathlib import Path
from typing import Any

import bpy
from bpy.types import Context, Object

from ..bridge import picture, results, saving, viewport
from ..bridge.drawings import drawing_of
from ..bridge.subject import source_of
from ..choices import line_plan
from ..export.formats import write_drawing
from ..geometry.errors import CurvatureError
from ..overlay.content import line_legend
from ..report.findings import ASYMPTOTIC_LINES, LINES, UMBILICS
from ..report.html import Picture
from ..reporting import report_pictures, scene_document
from ..steps import complete
from ..tracing.lines import trace_objects
from ..tracing.umbilics import mark_umbilics
from .inputs import load
from .outputs import Outputs
from .streams import Console


def trace_model(
    model: Path, files: Outputs, options: Namespace, screen: Console
) -> tuple[dict[str, Any], list[Picture], list[str]]:
    """Trace the lines of one model and write its files; return report, pictures and refusals."""
    objects = load(model, options)
    context = bpy.context
    _apply_line_settings(context, options)
    plan = line_plan(context)
    outcome = complete(trace_objects(context, objects, plan), screen.percentages())
    if not outcome.carriers:
        raise CurvatureError("; ".join(outcome.refused))
    sources = [source_of(carrier) for carrier in outcome.carriers]
    complete(mark_umbilics(context, sources, plan))
    for sentence in [*outcome.warnings, *outcome.remarks]:
        screen.progress(f"  warning: {sentence}")
    document = scene_document(context, outcome.carriers, str(model))
    viewport.frame(context, outcome.carriers)
    _write(context, files, outcome.carriers, options, screen)
    if not options.json:
        for carrier in outcome.carriers:
            screen.result(_result_line(model, carrier))
    pictures = []
    if options.report:
        key = line_legend(context.scene, outcome.carriers)
        pictures = report_pictures(context, outcome.carriers, key, options.report)
    return document, pictures, outcome.refused


def _apply_line_settings(context: Context, options: Namespace) -> None:
    settings = context.scene.curvature
    settings.line_kind = "ASYMPTOTIC" if options.asymptotic else "PRINCIPAL"
    settings.families = options.families
    settings.spacing = options.spacing
    settings.thickness = options.thickness
    settings.fit_curves = options.fit is not None
    settings.fit_tolerance = options.fit or 0.0


def _write(
    context: Context, files: Outputs, carriers: list[Object], options: Namespace, screen: Console
) -> None:
    if files.output:
        if files.output.suffix.lower() == ".blend":
            saving.save_blend(files.output)
        else:
            drawing = drawing_of([source_of(carrier) for carrier in carriers], context.scene)
            write_drawing(files.output, drawing)
        screen.progress(f"  wrote {files.output}")
    if files.image:
        legend = line_legend(context.scene, carriers)
        picture.render(carriers, legend, options.image_size, files.image, is_plain=True)
        screen.progress(f"  wrote {files.image}")


def _result_line(model: Path, carrier: Object) -> str:
    block = results.read_report(carrier) or {}
    key = ASYMPTOTIC_LINES if ASYMPTOTIC_LINES in block else LINES
    parts = [
        f"{each['count']} lines of {family.replace('_', ' ')}, {each['length']:.4g} m"
        for family, each in block[key].items()
        if family.startswith("family_")
    ]
    count = len(block[UMBILICS])
    parts.append(f"{count} {'umbilic' if count == 1 else 'umbilics'}")
    return f"{model.name}: {block['name']}: {'; '.join(parts)}"
