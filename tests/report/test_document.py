# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reports say everything that was measured, in JSON and as a table."""

from __future__ import annotations

import csv
import io
import json
import math
from typing import Any

import numpy as np
import pytest
from architectural_curvature.addon.geometry.analysis import analyze
from architectural_curvature.addon.geometry.mesh import mesh_from_polygons
from architectural_curvature.addon.geometry.segmentation import segment
from architectural_curvature.addon.geometry.settings import AnalysisSettings
from architectural_curvature.addon.geometry.tolerance import Tolerance
from architectural_curvature.addon.report.document import build_document, csv_text, json_text
from architectural_curvature.addon.report.measures import measure_object
from solids import capped_cylinder

RADIUS, HEIGHT, AROUND = 2.0, 3.0, 48
SETTINGS = {"panel_size": 1.0, "deviation": 0.01, "crease_angle": 0.5}
CLASSES = (
    "flat",
    "single_curved",
    "double_curved_elliptic",
    "double_curved_hyperbolic",
    "undefined",
)


def _block(*, segmented: bool = True) -> dict[str, Any]:
    vertices, faces = capped_cylinder(RADIUS, HEIGHT, AROUND, 12)
    mesh = mesh_from_polygons(np.concatenate([vertices, [[9.0, 9, 9]]]), faces)
    analysis = analyze(mesh, AnalysisSettings(0.5))
    result = segment(analysis.surface, analysis.curvature, Tolerance(1.0, 0.01))
    return {"name": "Tower", "source": "tower.obj"} | measure_object(
        analysis, result if segmented else None
    )


def _document(*blocks: dict[str, Any]) -> dict[str, Any]:
    return build_document("0.1.0", "4.5.3", SETTINGS, list(blocks))


def _rows(document: dict[str, Any]) -> list[dict[str, str]]:
    return list(csv.DictReader(io.StringIO(csv_text(document), newline="")))


def test_the_document_has_the_keys_of_schema_1() -> None:
    document = _document(_block())
    assert list(document) == ["schema", "extension", "blender", "unit", "settings", "objects"]
    assert (document["schema"], document["unit"]) == (1, "m")
    assert (document["extension"], document["blender"]) == ("0.1.0", "4.5.3")
    assert document["settings"] == SETTINGS


def test_an_object_is_measured_by_formula() -> None:
    block = _block()
    chord = 2.0 * RADIUS * np.sin(np.pi / AROUND)
    wall = AROUND * chord * HEIGHT
    caps = AROUND * RADIUS**2 * np.sin(2.0 * np.pi / AROUND)
    assert block["area"] == pytest.approx(wall + caps, rel=1e-12)
    assert tuple(block["classes"]) == CLASSES
    single, flat = block["classes"]["single_curved"], block["classes"]["flat"]
    assert single["area"] == pytest.approx(wall, rel=1e-12)
    assert flat["share"] == pytest.approx(caps / (wall + caps), rel=1e-12)
    assert flat["min_radius"] is None
    assert block["warnings"] == ["1 vertex has no faces and no curvature"]
    assert block["estimates"] == {"smoothed": 0, "low_order": 0, "undefined": 0}
    assert block["curvature_limit"] == 0.08
    assert block["criterion"] == "PANEL"
    assert block["criterion_words"].endswith("within 10 mm of a cylinder over a 1 m panel")


def test_regions_are_listed_by_falling_area_with_their_own_numbers() -> None:
    regions = _block()["regions"]
    assert [region["id"] for region in regions] == [0, 1, 2]
    assert [region["class"] for region in regions] == ["single_curved", "flat", "flat"]
    assert list(regions[0]) == ["id", "class", "area", "faces", "min_radius", "boundary_length"]


def test_statistics_are_weighted_by_area() -> None:
    block = _block()
    share = block["classes"]["single_curved"]["share"]
    # On the wall k1 is 1/2 up to the fit's k³ r² / 4, with r two cells; on the caps it is 0.
    reach = 2.0 * np.hypot(2.0 * RADIUS * np.sin(np.pi / AROUND), 0.25)
    k1 = block["k1"]
    assert list(k1) == ["min", "max", "mean", "median", "p05", "p95"]
    assert k1["mean"] == pytest.approx(0.5 * share, rel=0.25 * (0.5 * reach) ** 2)
    assert k1["p05"] == 0.0
    assert k1["median"] == pytest.approx(0.5, rel=0.25 * (0.5 * reach) ** 2)


def test_what_was_not_segmented_is_absent() -> None:
    block = _block(segmented=False)
    assert not {"classes", "regions", "panel_size"} & set(block)
    assert {row["group"] for row in _rows(_document(block))} == {"object", "statistic", "warning"}


def test_without_area_statistics_are_null() -> None:
    mesh = mesh_from_polygons(np.array([[0.0, 0, 0], [1, 0, 0], [2, 0, 0]]), [[0, 1, 2]])
    analysis = analyze(mesh, AnalysisSettings(0.5))
    block = {"name": "a", "source": "b"} | measure_object(analysis)
    assert block["k1"] is None
    document = _document(block)
    assert json.loads(json_text(document))["objects"][0]["gaussian_curvature"] is None
    assert not [row for row in _rows(document) if row["group"] == "statistic"]


def test_json_reads_back_as_it_was_and_keeps_letters() -> None:
    document = _document(_block() | {"name": "Dächle α"})
    text = json_text(document)
    assert json.loads(text) == document
    assert "Dächle α" in text
    assert text.endswith("}\n")


@pytest.mark.parametrize("number", [math.nan, math.inf])
def test_json_refuses_numbers_that_it_does_not_know(number: float) -> None:
    with pytest.raises(ValueError, match="JSON compliant"):
        json_text(_document({"area": number}))


def test_the_table_has_a_unit_for_every_measure_that_needs_one() -> None:
    rows = _rows(_document(_block()))
    assert list(rows[0]) == ["object", "group", "name", "measure", "value", "unit"]
    units = {(row["group"], row["measure"]): row["unit"] for row in rows}
    assert units["object", "area"] == "m²"
    assert units["setting", "panel_size"] == "m"
    assert units["setting", "min_area"] == "m²"
    assert units["setting", "criterion_words"] == ""
    assert units["class", "area"] == "m²"
    assert units["class", "min_radius"] == "m"
    assert units["class", "share"] == ""
    assert units["region", "boundary_length"] == "m"
    of_statistics = {row["name"]: row["unit"] for row in rows if row["group"] == "statistic"}
    assert of_statistics == {
        "gaussian_curvature": "1/m²",
        "mean_curvature": "1/m",
        "k1": "1/m",
        "k2": "1/m",
    }


def test_the_table_says_the_same_as_the_json() -> None:
    block = _block()
    rows = _rows(_document(block))
    values = {(r["group"], r["name"], r["measure"]): r["value"] for r in rows}
    assert len(values) == len(rows)
    for key, measures in block["classes"].items():
        for measure, value in measures.items():
            assert values["class", key, measure] == ("" if value is None else str(value))
    for region in block["regions"]:
        assert float(values["region", str(region["id"]), "area"]) == region["area"]
    assert float(values["statistic", "k1", "p95"]) == block["k1"]["p95"]
    assert values["warning", "", ""] == block["warnings"][0]


def test_names_with_commas_quotes_and_line_breaks_stay_in_their_cell() -> None:
    name = 'Roof, "north"\nlower'
    rows = _rows(_document(_block() | {"name": name}))
    assert {row["object"] for row in rows} == {name}


def test_every_object_has_its_own_rows() -> None:
    one, other = _block() | {"name": "A"}, _block() | {"name": "B"}
    rows = _rows(_document(one, other))
    assert [row["object"] for row in rows] == ["A"] * (len(rows) // 2) + ["B"] * (len(rows) // 2)


def test_a_report_on_nothing_is_a_table_with_a_heading() -> None:
    assert csv_text(_document()) == "object,group,name,measure,value,unit\r\n"
