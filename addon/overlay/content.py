# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the legend says about a scene."""

from __future__ import annotations

import numpy as np
from bpy.types import Object, Scene

from ..bridge import names, units
from ..bridge.companions import ROLES, companions
from ..bridge.criteria import criterion_lines, criterion_of
from ..bridge.display import CURVATURES, analyzed_objects, class_colors
from ..bridge.drawings import DRAWN_ROLES
from ..bridge.markers import SIGN_COLORS, umbilic_signs
from ..bridge.results import read_report
from ..bridge.subject import carrier_of, source_of
from ..geometry.classification import SurfaceClass
from ..geometry.display.colormap import ColorMap, srgb_from_linear
from ..geometry.display.legend import ClassKey, ColorBar, Legend
from ..geometry.display.palette import CLASS_NAMES, region_colors
from ..report.findings import ASYMPTOTIC_LINES, LINES

_MOST_REGIONS = 8
_UNITS = {"GAUSSIAN": "1/m²", "MEAN": "1/m", "K1": "1/m", "K2": "1/m"}


def legend_of(scene: Scene, active: Object | None) -> Legend | None:
    """Return the key of the colors that a scene's models show.

    Parameters
    ----------
    scene : Scene
    active : Object, optional
        The shares are those of this object where it has results, else of all models.

    Returns
    -------
    ColorBar, ClassKey or None
        None where nothing is shown.
    """
    settings = scene.curvature
    objects = _described_objects(scene, active)
    if settings.quantity == "NONE" or not objects:
        return None
    if settings.quantity in CURVATURES:
        return _color_bar(scene)
    objects = [obj for obj in objects if obj.data.curvature.is_segmented]
    if not objects:
        return None
    return _class_key(scene, objects) if settings.quantity == "CLASS" else _region_key(objects[0])


def class_legend(scene: Scene, objects: list[Object]) -> Legend | None:
    """Return the key of the classes of some objects, whatever is shown; None without classes."""
    segmented = [obj for obj in objects if obj.data.curvature.is_segmented]
    return _class_key(scene, segmented) if segmented else None


def tolerance_notes(scene: Scene, objects: list[Object]) -> tuple[str, ...]:
    """Return the criterion of objects' classes in words, nothing where they differ in it."""
    notes = {
        (
            *criterion_lines(scene, criterion_of(obj.data)),
            *(filter(None, [obj.data.curvature.criterion_preset])),
        )
        for obj in objects
    }
    return notes.pop() if len(notes) == 1 else ()


def line_legend(scene: Scene, objects: list[Object]) -> Legend | None:
    """Return the key of the curves on some objects; None without curves."""
    rows = []
    for role in DRAWN_ROLES:
        found = [each for obj in objects for each in companions(source_of(obj), (role,))]
        count = sum(len(each.data.splines) for each in found)
        if count:
            rows.append((_display_color(ROLES[role].color), ROLES[role].ending, f"{count:,}"))
    if not rows:
        return None
    rows += _umbilic_rows(objects)
    blocks = [read_report(obj) or {} for obj in objects]
    spacings = {b[key]["spacing"] for b in blocks for key in (LINES, ASYMPTOTIC_LINES) if key in b}
    notes = tuple(f"{units.length_text(scene, spacing)} apart" for spacing in sorted(spacings))
    return ClassKey("Curvature Lines", tuple(rows), notes)


def _umbilic_rows(objects: list[Object]) -> list[tuple[tuple[float, float, float], str, str]]:
    """Return the rows of a key for umbilics of either sign, where there are some."""
    marks = [each for obj in objects for each in companions(source_of(obj), ("UMBILICS",))]
    signs = [umbilic_signs(each) for each in marks]
    counts = {sign: sum(each[sign] for each in signs) for sign in SIGN_COLORS}
    return [
        (_display_color(color), f"Umbilics, Index {sign}", f"{counts[sign]:,}")
        for sign, color in SIGN_COLORS.items()
        if counts[sign]
    ]


def _described_objects(scene: Scene, active: Object | None) -> list[Object]:
    if active is not None and active.type == "MESH":
        carrier = carrier_of(active)
        if carrier.data.curvature.fingerprint:
            return [carrier]
    return analyzed_objects(scene)


def _color_bar(scene: Scene) -> ColorBar | None:
    settings = scene.curvature
    if settings.shown_limit <= 0.0:
        return None
    title = names.COLORS[settings.quantity]
    clipped = 100.0 * settings.shown_clipped
    notes = (f"{clipped:.1f} % of the area lies beyond",) if clipped >= 0.05 else ()
    return ColorBar(
        title,
        _UNITS[settings.quantity],
        ColorMap[settings.color_map],
        settings.shown_limit,
        notes,
    )


def _class_key(scene: Scene, objects: list[Object]) -> ClassKey:
    areas = dict.fromkeys(SurfaceClass, 0.0)
    for obj in objects:
        for row in obj.data.curvature.classes:
            areas[SurfaceClass[row.surface_class]] += row.area
    total = sum(areas.values()) or 1.0
    colors = class_colors(scene.curvature)
    rows = tuple(
        (
            _display_color(colors[surface_class]),
            name,
            f"{100.0 * areas[surface_class] / total:.1f} %",
        )
        for surface_class, name in CLASS_NAMES.items()
        if surface_class != SurfaceClass.UNDEFINED or areas[surface_class] > 0.0
    )
    return ClassKey("Curvature Class", rows, tolerance_notes(scene, objects))


def _region_key(obj: Object) -> ClassKey:
    results = obj.data.curvature
    listed = list(results.regions[:_MOST_REGIONS])
    colors = region_colors(np.arange(len(listed)))[:, :3].tolist()
    rows = tuple(
        (_display_color(color), row.name, CLASS_NAMES[SurfaceClass[row.surface_class]])
        for color, row in zip(colors, listed, strict=True)
    )
    count = results.region_count
    more = (f"and {count - len(listed)} smaller ones",) if count > len(listed) else ()
    return ClassKey("Curvature Regions", rows, more)


def _display_color(linear: tuple[float, float, float]) -> tuple[float, float, float]:
    red, green, blue = srgb_from_linear(np.array(linear, dtype=np.float64))
    return (float(red), float(green), float(blue))
