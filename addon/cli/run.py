# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A run of the command: every model is read, worked on and written, one after the other."""

from __future__ import annotations

from argparse import Namespace
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import bpy
from bpy.types import Object

from .. import tasks
from ..bridge import importing, picture, results, saving, viewport
from ..choices import analysis_settings, segmentation_settings
from ..geometry.errors import CurvatureError
from ..overlay.content import class_legend, legend_of
from ..report.document import json_text
from ..report.files import FileRefusedError, write_report
from ..report.html import Picture
from ..reporting import (
    css_colors,
    document_of,
    merge_settings,
    report_pictures,
    scene_document,
    shares_text,
)
from ..steps import complete
from .arguments import PROGRAM, parse_arguments
from .inputs import load
from .lines import trace_model
from .outputs import Outputs, plan_outputs
from .streams import Console, console


def main(arguments: Sequence[str]) -> int:
    """Run the command.

    Parameters
    ----------
    arguments : sequence of str
        What follows `blender --command curvature`.

    Returns
    -------
    int
        Exit status: 0 all done, 1 at least one model failed, 2 wrong usage.
    """
    try:
        options = parse_arguments(arguments)
    except SystemExit as stop:
        return int(stop.code or 0)
    with console(options.quiet) as screen:
        return _run(options, screen)


def _run(options: Namespace, screen: Console) -> int:
    try:
        outputs = plan_outputs(options)
    except FileRefusedError as error:
        screen.error(f"{PROGRAM}: {error}")
        return 1
    documents: list[dict[str, Any]] = []
    pictures: list[Picture] = []
    failures = 0
    work = trace_model if options.command == "lines" else _segment_model
    for number, (model, files) in enumerate(zip(options.models, outputs, strict=True), 1):
        screen.progress(f"[{number}/{len(options.models)}] {model}")
        try:
            document, shown, refused = work(model, files, options, screen)
        except (CurvatureError, FileRefusedError, importing.ImportRefusedError) as error:
            screen.error(f"{PROGRAM}: {model}: {error}")
            failures += 1
            continue
        documents.append(document)
        pictures += shown
        for sentence in refused:
            screen.error(f"{PROGRAM}: {model}: {sentence}")
        failures += bool(refused)
    if documents:
        failures += _deliver(_join(documents), pictures, options, screen)
    if len(options.models) > 1:
        done = len(options.models) - min(failures, len(options.models))
        screen.progress(f"{done} of {len(options.models)} models done")
    return 1 if failures else 0


def _segment_model(
    model: Path, files: Outputs, options: Namespace, screen: Console
) -> tuple[dict[str, Any], list[Picture], list[str]]:
    """Segment one model and write its files; return its report, its pictures and refusals."""
    objects = load(model, options)
    context = bpy.context
    outcome = complete(
        tasks.segment_objects(
            context, objects, analysis_settings(context), segmentation_settings(context)
        ),
        screen.percentages(),
    )
    if not outcome.carriers:
        raise CurvatureError("; ".join(outcome.refused))
    settings = context.scene.curvature
    settings.use_material = True
    settings.quantity = options.quantity
    for sentence in outcome.warnings:
        screen.progress(f"  warning: {sentence}")
    document = scene_document(context, outcome.carriers, str(model))
    viewport.frame(context, outcome.carriers)
    if files.output:
        saving.save_blend(files.output)
        screen.progress(f"  wrote {files.output}")
    if files.image:
        legend = legend_of(context.scene, outcome.carriers[0] if len(objects) == 1 else None)
        picture.render(outcome.carriers, legend, options.image_size, files.image)
        screen.progress(f"  wrote {files.image}")
    if not options.json:
        for carrier in outcome.carriers:
            screen.result(_result_line(model, carrier))
    pictures = []
    if options.report:
        key = class_legend(context.scene, outcome.carriers)
        pictures = report_pictures(context, outcome.carriers, key, options.report)
    return document, pictures, outcome.refused


def _result_line(model: Path, carrier: Object) -> str:
    block = results.read_report(carrier) or {}
    radii = [
        measure["min_radius"] for measure in block["classes"].values() if measure["min_radius"]
    ]
    count = len(block["regions"])
    radius = f", smallest radius {min(radii):.2f} m" if radii else ""
    return (
        f"{model.name}: {block['name']}: {block['area']:.4g} m²: {shares_text(carrier)}"
        f", {count} {'region' if count == 1 else 'regions'}{radius}"
    )


def _join(documents: list[dict[str, Any]]) -> dict[str, Any]:
    return document_of(
        [block for document in documents for block in document["objects"]],
        merge_settings([document["settings"] for document in documents]),
    )


def _deliver(
    document: dict[str, Any], pictures: list[Picture], options: Namespace, screen: Console
) -> int:
    """Write the report; return how many failures that brought."""
    if options.json:
        screen.result(json_text(document).rstrip())
    if options.report is None:
        return 0
    try:
        write_report(options.report, document, pictures, css_colors(bpy.context))
    except FileRefusedError as error:
        screen.error(f"{PROGRAM}: {error}")
        return 1
    screen.progress(f"wrote {options.report}")
    return 0
