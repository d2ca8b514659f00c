# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The report as one HTML page that opens offline: pictures, figures and styles are inside."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from html import escape
from typing import Any

from ..geometry.classification import SurfaceClass
from ..geometry.display.palette import CLASS_COLORS, CLASS_NAMES
from ..geometry.settings import CriterionKind
from .html_findings import findings_section
from .html_parts import HISTOGRAM_NOTE, STYLE, histogram_svg, table
from .measures import CLASS_KEYS

_NAMES = {CLASS_KEYS[surface_class]: name for surface_class, name in CLASS_NAMES.items()}
_COLORS = {
    CLASS_KEYS[surface_class]: "#" + "".join(f"{round(255 * part):02x}" for part in color)
    for surface_class, color in CLASS_COLORS.items()
}
_CRITERIA = {kind.name: kind.value for kind in CriterionKind}
#: Rows of the region table; the reports for programs have all.
_MOST_REGIONS = 200


@dataclass(frozen=True)
class Picture:
    """A PNG picture and what it shows."""

    caption: str
    png: bytes


def html_text(
    document: dict[str, Any],
    pictures: Sequence[Picture] = (),
    colors: Mapping[str, str] | None = None,
) -> str:
    """Return a report as an HTML page.

    Parameters
    ----------
    document : dict
        The report; see `build_document`.
    pictures : sequence of Picture
        Shown above the figures, in their order.
    colors : mapping, optional
        CSS colors of the classes by their keys in reports, where the user changed them.

    Returns
    -------
    str
        UTF-8; refers to nothing outside itself.
    """
    palette = {**_COLORS, **(colors or {})}
    names = ", ".join(block["name"] for block in document["objects"])
    body = [
        f"<h1>Curvature of {escape(names)}</h1>",
        f"<p class='faint'>Architectural Curvature {escape(document['extension'])}, "
        f"Blender {escape(document['blender'])}</p>",
        _figures(pictures),
        *(_object_section(block, palette) for block in document["objects"]),
        _settings(document["settings"]),
    ]
    return (
        "<!DOCTYPE html>\n<html lang='en'><head><meta charset='utf-8'>"
        "<meta name='viewport' content='width=device-width, initial-scale=1'>"
        f"<title>Curvature of {escape(names)}</title><style>{STYLE}</style></head>\n"
        f"<body><main>\n{chr(10).join(part for part in body if part)}\n</main></body></html>\n"
    )


def _figures(pictures: Sequence[Picture]) -> str:
    if not pictures:
        return ""
    items = "".join(
        f"<figure><img alt='{escape(picture.caption)}' "
        f"src='data:image/png;base64,{b64encode(picture.png).decode('ascii')}'>"
        f"<figcaption>{escape(picture.caption)}</figcaption></figure>"
        for picture in pictures
    )
    return f"<section class='pictures'>{items}</section>"


def _estimates(counts: dict[str, int]) -> str:
    """Return in a line how many points were not measured as well as the others."""
    words = {
        "smoothed": "had noise smoothed away",
        "low_order": "allowed only a fit of low order",
        "undefined": "are undefined",
    }
    told = [f"{counts[key]:,} points {text}" for key, text in words.items() if counts.get(key)]
    return f"<p class='faint'>{'; '.join(told)}</p>" if told else ""


def _object_section(block: dict[str, Any], palette: Mapping[str, str]) -> str:
    parts = [
        f"<h2>{escape(block['name'])}</h2>",
        f"<p>{block['area']:.4g} m², {block['faces']:,} faces, {block['vertices']:,} vertices"
        f"{'; from ' + escape(block['source']) if block['source'] else ''}</p>",
    ]
    parts += [f"<p class='warning'>{escape(sentence)}</p>" for sentence in block["warnings"]]
    parts.append(_estimates(block.get("estimates", {})))
    if "classes" in block:
        parts += [
            f"<p>{_limit_sentences(block)}</p>",
            _class_bar(block["classes"], palette),
            _class_table(block["classes"], palette),
        ]
    if "histograms" in block:
        limit = block["curvature_limit"]
        parts += [
            "<div class='row'>",
            histogram_svg("Larger curvature", block["histograms"]["larger"], limit),
            histogram_svg("Smaller curvature", block["histograms"]["smaller"], limit),
            "</div>",
            f"<p class='faint'>{HISTOGRAM_NOTE}</p>",
        ]
    if block.get("comparison"):
        parts.append(_comparison(block, palette))
    parts += [_statistics(block), findings_section(block)]
    if block.get("regions"):
        parts.append(_regions(block["regions"], palette))
    return "<section>" + "\n".join(part for part in parts if part) + "</section>"


def _limit_sentences(block: dict[str, Any]) -> str:
    """Return the criterion in words, with its preset and where that has its limits from."""
    sentences = [_criterion_sentence(block)]
    preset, source = (block.get(key, "") for key in ("criterion_preset", "criterion_source"))
    if preset:
        sentences.append(f"Preset {preset}{': ' + source if source else ''}.")
    sentences.append(
        f"Regions of less than {block['min_area']:.3g} m² have joined a neighbor "
        "if they add nothing to the shape."
    )
    return escape(" ".join(sentences))


def _criterion_sentence(block: dict[str, Any]) -> str:
    if block["criterion"] == CriterionKind.RAW.name:
        return (
            f"Single-curved means |K| of at most {block['gaussian_limit']:.4g} 1/m²; "
            f"flat means also |H| of at most {block['mean_limit']:.4g} 1/m."
        )
    if block["criterion"] == CriterionKind.RADIUS.name:
        return f"Panels are straight at a radius of at least {block['smallest_radius']:.4g} m."
    radius = 1.0 / block["curvature_limit"]
    return (
        f"Panels of {block['panel_size']:.4g} m that may deviate by "
        f"{1000.0 * block['deviation']:.3g} mm are straight above a radius of {radius:.4g} m. "
        f"Single-curved means within {1000.0 * block['deviation']:.3g} mm of a cylinder "
        f"over a {block['panel_size']:.4g} m panel."
    )


def _swatch(key: str, palette: Mapping[str, str]) -> str:
    return f"<span class='swatch' style='background:{palette[key]}'></span>{escape(_NAMES[key])}"


def _class_bar(classes: dict[str, Any], palette: Mapping[str, str]) -> str:
    cells = "".join(
        f"<div title='{escape(_NAMES[key])} {100 * measure['share']:.1f} %' "
        f"style='width:{100 * measure['share']:.3f}%;background:{palette[key]}'></div>"
        for key, measure in classes.items()
        if measure["area"] > 0.0
    )
    return f"<div class='bar'>{cells}</div>"


def _class_table(classes: dict[str, Any], palette: Mapping[str, str]) -> str:
    rows = [
        (
            _swatch(key, palette),
            f"{measure['area']:.4g}",
            f"{100.0 * measure['share']:.1f} %",
            f"{measure['faces']:,}",
            f"{measure['regions']:,}",
            _radius(measure["min_radius"]),
        )
        for key, measure in classes.items()
        if measure["faces"] or key != CLASS_KEYS[SurfaceClass.UNDEFINED]
    ]
    heads = ("Class", "Area (m²)", "Share", "Faces", "Regions", "Smallest radius (m)")
    return table(heads, rows)


def _comparison(block: dict[str, Any], palette: Mapping[str, str]) -> str:
    rows = [
        (
            _swatch(key, palette),
            f"{change['before']:.4g}",
            f"{change['after']:.4g}",
            f"{change['after'] - change['before']:+.4g}",
        )
        for key, change in block["comparison"].items()
        if change["before"] or change["after"]
    ]
    heads = ("Class", "Before (m²)", "After (m²)", "Change (m²)")
    previous = block.get("previous_criterion", "")
    note = f"<p class='faint'>Criterion before: {escape(previous)}</p>" if previous else ""
    return "<h3>Changes since the segmentation before</h3>" + table(heads, rows) + note


def _statistics(block: dict[str, Any]) -> str:
    rows = []
    for key, name, unit in (
        ("gaussian_curvature", "Gaussian curvature", "1/m²"),
        ("mean_curvature", "Mean curvature", "1/m"),
        ("k1", "Principal curvature 1", "1/m"),
        ("k2", "Principal curvature 2", "1/m"),
    ):
        summary = block.get(key)
        if summary:
            values = (summary[each] for each in ("min", "p05", "median", "mean", "p95", "max"))
            rows.append((f"{name} ({unit})", *(f"{value:.4g}" for value in values)))
    heads = ("Curvature, weighted by area", "Minimum", "5 %", "Median", "Mean", "95 %", "Maximum")
    return "<h3>Statistics</h3>" + table(heads, rows) if rows else ""


def _regions(regions: Sequence[dict[str, Any]], palette: Mapping[str, str]) -> str:
    rows = [
        (
            escape(str(region.get("name") or region["id"] + 1)),
            _swatch(region["class"], palette),
            f"{region['area']:.4g}",
            f"{region['faces']:,}",
            _radius(region["min_radius"]),
            f"{region['boundary_length']:.4g}",
        )
        for region in regions[:_MOST_REGIONS]
    ]
    heads = ("Region", "Class", "Area (m²)", "Faces", "Smallest radius (m)", "Outline (m)")
    more = len(regions) - len(rows)
    note = f"<p class='faint'>and {more:,} smaller regions</p>" if more > 0 else ""
    return f"<h3>{len(regions):,} regions</h3>" + table(heads, rows) + note


def _settings(settings: dict[str, Any]) -> str:
    rows = [
        (escape(key.replace("_", " ").capitalize()), _setting(_CRITERIA.get(value, value)))
        for key, value in settings.items()
    ]
    return "<section><h2>Settings</h2>" + table(("Setting", "Value"), rows) + "</section>"


def _setting(value: object) -> str:
    if value is None:
        return "differs between the objects"
    return f"{value:.6g}" if isinstance(value, float) else escape(str(value))


def _radius(value: float | None) -> str:
    return f"{value:.3g}" if value else "–"
