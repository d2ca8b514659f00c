# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What users are told: messages of operators, documents of reports."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import bpy
import numpy as np
from bpy.types import Context, Object, Operator

from .bridge import results
from .bridge.display import class_colors
from .bridge.mode import object_mode
from .bridge.numbers import as_typed
from .bridge.report_pictures import four_sides
from .geometry.classification import SurfaceClass
from .geometry.display.colormap import srgb_from_linear
from .geometry.display.legend import Legend
from .geometry.display.palette import CLASS_NAMES
from .report.document import LIMIT_UNITS, build_document
from .report.html import Picture
from .report.measures import CLASS_KEYS
from .tasks import Outcome
from .version import extension_version


def conclude(operator: Operator, outcome: Outcome, verb: str) -> set[str]:
    """Report what became of the objects, and return the operator's result."""
    if not outcome.carriers:
        operator.report({"ERROR"}, "; ".join(outcome.refused) or "Select a mesh object")
        return {"CANCELLED"}
    count = len(outcome.carriers)
    parts = [f"{verb} {outcome.carriers[0].name if count == 1 else f'{count} models'}"]
    parts += outcome.refused
    if outcome.warnings:
        count = len(outcome.warnings)
        parts.append(
            f"{count} {'warning is' if count == 1 else 'warnings are'} listed under Results"
        )
    if outcome.note:
        parts[0] += f": {outcome.note}"
    elif len(outcome.carriers) == 1 and outcome.carriers[0].data.curvature.is_segmented:
        parts[0] += f": {shares_text(outcome.carriers[0])}"
    parts += outcome.remarks
    is_sound = not (outcome.refused or outcome.warnings or outcome.remarks)
    operator.report({"INFO"} if is_sound else {"WARNING"}, "; ".join(parts))
    return {"FINISHED"}


def shares_text(carrier: Object) -> str:
    """Return the shares of the classes that an object has, in one line."""
    return ", ".join(
        f"{CLASS_NAMES[SurfaceClass[row.surface_class]].lower().replace(',', '')} "
        f"{100.0 * row.share:.1f} %"
        for row in carrier.data.curvature.classes
        if row.faces
    )


def scene_document(context: Context, carriers: list[Object], source: str) -> dict[str, Any]:
    """Return the report of analyzed objects, made by the settings of the scene.

    Parameters
    ----------
    context : Context
    carriers : list of Object
        Objects with results.
    source : str
        File that the objects come from, empty where it was not saved.
    """
    blocks = [results.read_report(carrier) for carrier in carriers]
    objects = [{**block, "source": source} for block in blocks if block]
    return document_of(objects, used_settings(context, carriers, objects))


def report_pictures(
    context: Context, carriers: list[Object], legend: Legend | None, path: Path
) -> list[Picture]:
    """Return the pictures that a report of this name shows: none but in HTML.

    Parameters
    ----------
    context : Context
    carriers : list of Object
        Objects with results.
    legend : Legend, optional
        Key of the colors, for the first picture.
    path : Path
        Where the report goes.

    Returns
    -------
    list of Picture

    Raises
    ------
    FileRefusedError
        If the machine lacks what renders.
    """
    if path.suffix.lower() != ".html":
        return []
    with object_mode(context):
        return four_sides(carriers, legend)


def css_colors(context: Context) -> dict[str, str]:
    """Return the colors that the user gave to the classes, as HTML reports take them."""
    return {
        CLASS_KEYS[surface_class]: "#"
        + "".join(f"{round(255 * part):02x}" for part in srgb_from_linear(np.array(color)).tolist())
        for surface_class, color in class_colors(context.scene.curvature).items()
    }


def document_of(objects: list[dict[str, Any]], settings: dict[str, Any]) -> dict[str, Any]:
    """Return the report of blocks that were measured already."""
    return build_document(extension_version(), bpy.app.version_string, settings, objects)


def used_settings(
    context: Context, carriers: list[Object], objects: list[dict[str, Any]]
) -> dict[str, Any]:
    """Return the settings that were used; None where the objects differ in one."""
    per_object = [
        {
            **{key: block[key] for key in LIMIT_UNITS if key in block},
            "crease_angle": as_typed(carrier.data.curvature.crease_angle),
            "flip_normals": carrier.data.curvature.flip_normals,
            "smoothing": carrier.data.curvature.smoothing,
            "smoothing_length": as_typed(carrier.data.curvature.smoothing_length),
        }
        for carrier, block in zip(carriers, objects, strict=True)
    ]
    merged = merge_settings(per_object)
    return {**merged, "scale_length": as_typed(context.scene.unit_settings.scale_length)}


def merge_settings(settings: list[dict[str, Any]]) -> dict[str, Any]:
    """Return settings that all share; None for those in which they differ."""
    keys = {key: None for each in settings for key in each}
    return {
        key: settings[0].get(key) if len({repr(each.get(key)) for each in settings}) == 1 else None
        for key in keys
    }
