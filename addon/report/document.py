# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The report as a whole: its JSON and CSV texts."""

from __future__ import annotations

import csv
import io
import json
from typing import Any

SCHEMA = 1
"""Version of the report's structure; it grows only when a reader has to change."""

LIMIT_UNITS = {
    "criterion": "",
    "criterion_words": "",
    "criterion_preset": "",
    "criterion_source": "",
    "panel_size": "m",
    "deviation": "m",
    "curvature_limit": "1/m",
    "smallest_radius": "m",
    "gaussian_limit": "1/m²",
    "mean_limit": "1/m",
    "min_area": "m²",
}
"""What objects say about the limits of their classes, and in which unit."""

_QUANTITIES = ("gaussian_curvature", "mean_curvature", "k1", "k2")
_STATISTICS = ("min", "max", "mean", "median", "p05", "p95")
_MEASURES = ("area", "share", "faces", "regions", "min_radius")


def build_document(
    extension: str, blender: str, settings: dict[str, Any], objects: list[dict[str, Any]]
) -> dict[str, Any]:
    """Return a report.

    Parameters
    ----------
    extension, blender : str
        Versions.
    settings : dict
        What the user asked for; 0 stands for a default, and each object states the value used.
    objects : list of dict
        One block per object.

    Returns
    -------
    dict
        Ready for JSON.
    """
    return {
        "schema": SCHEMA,
        "extension": extension,
        "blender": blender,
        "unit": "m",
        "settings": settings,
        "objects": objects,
    }


def json_text(document: dict[str, Any]) -> str:
    """Return a report as JSON; refuses NaN and infinity, which JSON does not know."""
    return json.dumps(document, indent=2, ensure_ascii=False, allow_nan=False) + "\n"


def csv_text(document: dict[str, Any]) -> str:
    """Return a report as one long table: object, group, name, measure, value, unit.

    Spreadsheets filter and pivot such a table; columns do not depend on what was measured.
    """
    buffer = io.StringIO()
    writer = csv.writer(buffer, lineterminator="\r\n")
    writer.writerow(("object", "group", "name", "measure", "value", "unit"))
    for block in document["objects"]:
        writer.writerows((block["name"], *row) for row in _object_rows(block))
    return buffer.getvalue()


def _object_rows(block: dict[str, Any]) -> list[tuple[Any, ...]]:
    rows: list[tuple[Any, ...]] = [
        ("object", "", "source", block["source"], ""),
        ("object", "", "vertices", block["vertices"], ""),
        ("object", "", "faces", block["faces"], ""),
        ("object", "", "area", block["area"], "m²"),
    ]
    rows += [
        ("setting", "", key, block[key], unit) for key, unit in LIMIT_UNITS.items() if key in block
    ]
    for quantity in _QUANTITIES:
        unit = "1/m²" if quantity == "gaussian_curvature" else "1/m"
        statistics = block.get(quantity) or {}
        rows += [
            ("statistic", quantity, name, statistics[name], unit)
            for name in _STATISTICS
            if name in statistics
        ]
    for key, measures in block.get("classes", {}).items():
        rows += [("class", key, name, measures[name], _unit(name)) for name in _MEASURES]
    for region in block.get("regions", ()):
        rows += [
            ("region", region["id"], name, region[name], _unit(name))
            for name in ("name", "class", "area", "faces", "min_radius", "boundary_length")
            if name in region
        ]
    for key in ("borders", "parabolic_curves"):
        rows += [
            ("curves", key, name, value, _unit(name)) for name, value in block.get(key, {}).items()
        ]
    rows += _finding_rows(block)
    rows += [("warning", "", "", sentence, "") for sentence in block["warnings"]]
    return rows


def _finding_rows(block: dict[str, Any]) -> list[tuple[Any, ...]]:
    """Return the rows of curvature lines and umbilics."""
    rows: list[tuple[Any, ...]] = []
    for key in ("curvature_lines", "asymptotic_lines"):
        for name, found in block.get(key, {}).items():
            if isinstance(found, dict):
                rows += [
                    (key, name, each, found[each], _unit(each)) for each in ("count", "length")
                ]
            else:
                rows.append((key, "", name, found, "m"))
    for number, umbilic in enumerate(block.get("umbilics", ())):
        place = zip("xyz", umbilic["position"], strict=True)
        rows += [("umbilic", number, axis, value, "m") for axis, value in place]
        rows += [("umbilic", number, name, umbilic[name], "") for name in ("index", "kind")]
    for number, area in enumerate(block.get("umbilic_areas", ())):
        rows += [
            ("umbilic area", number, name, area[name], _unit(name)) for name in ("area", "index")
        ]
    return rows


def _unit(measure: str) -> str:
    return {"area": "m²", "min_radius": "m", "boundary_length": "m", "length": "m"}.get(measure, "")
