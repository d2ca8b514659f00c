# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The report says what is stored on the meshes, completely and in valid JSON."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import bpy
import numpy as np
import pytest
from bpy.types import Object
from models import RADIUS, STRICT, add_surface, barrel, dome, plate, saddle, stored

TOP = {"schema", "extension", "blender", "unit", "settings", "objects"}
SETTINGS = {
    "panel_size",
    "deviation",
    "curvature_limit",
    "crease_angle",
    "flip_normals",
    "scale_length",
}
QUANTITIES = ("gaussian_curvature", "mean_curvature", "k1", "k2")
ANALYSIS = {
    *("name", "source", "vertices", "faces", "area", "warnings", "estimates"),
    *QUANTITIES,
}
SEGMENTATION = {"classes", "regions"}
STATISTICS = {"min", "max", "mean", "median", "p05", "p95"}
CLASSES = (
    "flat",
    "single_curved",
    "double_curved_elliptic",
    "double_curved_hyperbolic",
    "undefined",
)
MEASURES = {"area", "share", "faces", "regions", "min_radius"}
REGION = {"id", "name", "class", "area", "faces", "min_radius", "boundary_length"}


@pytest.fixture
def export(tmp_path: Path) -> Callable[..., Any]:
    """Export the selected models to JSON and return the document."""

    def call() -> dict:
        path = tmp_path / "report.json"
        assert bpy.ops.curvature.export_report(filepath=str(path)) == {"FINISHED"}
        return json.loads(path.read_text(encoding="utf-8"))

    return call


def _wavy(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    return 0.2 * np.sin(2.0 * x) * np.cos(1.5 * y)


def _face_areas(obj: Object) -> np.ndarray:
    return np.array([polygon.area for polygon in obj.data.polygons])


def _vertex_areas(obj: Object) -> np.ndarray:
    """Half of each of a vertex's triangles' sides: a third of every triangle around it."""
    obj.data.calc_loop_triangles()
    areas = np.zeros(len(obj.data.vertices))
    for triangle in obj.data.loop_triangles:
        areas[list(triangle.vertices)] += triangle.area / 3.0
    return areas


def _percentile(values: np.ndarray, weights: np.ndarray, percent: float) -> float:
    """Return the value that a share of the weight does not exceed."""
    order = np.argsort(values)
    share = np.cumsum(weights[order]) / weights.sum()
    return float(values[order][np.searchsorted(share, percent / 100.0)])


def test_document_has_the_documented_keys(export: Callable[..., Any]) -> None:
    add_surface(saddle)
    bpy.ops.curvature.segment(**STRICT)
    document = export()
    assert document.keys() == TOP
    assert document["settings"].keys() >= SETTINGS
    (block,) = document["objects"]
    assert block.keys() >= ANALYSIS | SEGMENTATION
    for quantity in QUANTITIES:
        assert block[quantity].keys() == STATISTICS
    assert tuple(block["classes"]) == CLASSES
    for measures in block["classes"].values():
        assert measures.keys() == MEASURES
    for region in block["regions"]:
        assert region.keys() == REGION


def test_analysis_alone_reports_no_classes(export: Callable[..., Any]) -> None:
    add_surface(saddle)
    bpy.ops.curvature.analyze()
    (block,) = export()["objects"]
    assert block.keys() >= ANALYSIS
    assert not SEGMENTATION & block.keys()


def test_header_names_schema_versions_and_unit(export: Callable[..., Any], extension: str) -> None:
    import tomllib
    from importlib import resources

    add_surface(dome)
    bpy.ops.curvature.analyze()
    document = export()
    manifest = tomllib.loads(
        resources.files(extension).joinpath("blender_manifest.toml").read_text(encoding="utf-8")
    )
    assert document["schema"] == 1
    assert document["extension"] == manifest["version"]
    assert document["blender"] == bpy.app.version_string
    assert document["unit"] == "m"


def test_settings_are_those_that_were_used(export: Callable[..., Any]) -> None:
    add_surface(dome)
    bpy.context.scene.unit_settings.scale_length = 0.5
    bpy.ops.curvature.segment(panel_size=1.2, deviation=0.003, crease_angle=math.radians(40.0))
    settings = export()["settings"]
    assert settings["panel_size"] == 1.2
    assert settings["deviation"] == 0.003
    assert settings["curvature_limit"] == pytest.approx(8.0 * 0.003 / 1.2**2, rel=1e-12)
    assert settings["crease_angle"] == pytest.approx(math.radians(40.0), rel=1e-6)
    assert settings["flip_normals"] is False
    assert settings["scale_length"] == 0.5


def test_counts_and_areas_are_those_of_the_mesh(export: Callable[..., Any]) -> None:
    obj = add_surface(_wavy)
    bpy.ops.curvature.segment(**STRICT)
    (block,) = export()["objects"]
    areas, classes = _face_areas(obj), stored(obj, "curvature_class")
    assert block["name"] == "Roof"
    assert block["vertices"] == 17 * 17
    assert block["faces"] == 256
    # Quads that are not flat: Blender's area is that of a fan of triangles, as ours within 1 %.
    assert block["area"] == pytest.approx(areas.sum(), rel=0.01)
    corners = np.array([tuple(face.vertices) for face in obj.data.polygons])
    at_vertex = np.zeros((len(obj.data.vertices), 4), dtype=bool)
    at_vertex[corners, classes[:, None]] = True
    is_beside = (at_vertex.sum(axis=1) > 1)[corners].any(axis=1)
    for number, key in enumerate(CLASSES[:4]):
        measures = block["classes"][key]
        assert measures["faces"] == (classes == number).sum()
        # Borders run through faces: of those beside a border a part counts for the other class.
        beside = areas[(classes == number) & is_beside].sum()
        whole = areas[classes == number].sum()
        assert whole - beside <= 1.01 * measures["area"]
        assert measures["area"] <= 1.01 * (whole + areas[(classes != number) & is_beside].sum())
        assert measures["share"] == pytest.approx(measures["area"] / block["area"])
    total = sum(measures["area"] for measures in block["classes"].values())
    assert total == pytest.approx(block["area"])


@pytest.mark.parametrize(
    ("key", "name"),
    [
        ("gaussian_curvature", "gaussian"),
        ("mean_curvature", "mean"),
        ("k1", "k1"),
        ("k2", "k2"),
    ],
)
def test_statistics_are_those_of_the_stored_values(
    key: str, name: str, export: Callable[..., Any]
) -> None:
    obj = add_surface(_wavy)
    bpy.ops.curvature.analyze()
    statistics = export()["objects"][0][key]
    values, weights = stored(obj, f"curvature_{name}").astype(float), _vertex_areas(obj)
    spread = float(np.ptp(values))
    assert statistics["min"] == pytest.approx(values.min(), rel=1e-6)
    assert statistics["max"] == pytest.approx(values.max(), rel=1e-6)
    assert statistics["mean"] == pytest.approx(
        np.average(values, weights=weights), abs=0.01 * spread
    )
    for label, percent in (("p05", 5.0), ("median", 50.0), ("p95", 95.0)):
        expected = _percentile(values, weights, percent)
        assert statistics[label] == pytest.approx(expected, abs=0.02 * spread), label


def test_statistics_are_weighted_by_area(export: Callable[..., Any]) -> None:
    """A plate in large faces beside a dome in small ones: the median is flat."""
    line = np.concatenate([np.linspace(-20.0, -1.0, 8)[:-1], np.linspace(-1.0, 1.0, 17)])
    add_surface(lambda x, _y: np.interp(x, np.linspace(-1, 1, len(line)), line))
    obj = bpy.context.object
    for vertex in obj.data.vertices:
        x = vertex.co.z
        vertex.co.z = -0.25 * max(x, 0.0) ** 2
        vertex.co.x = x
    obj.data.update()
    bpy.ops.curvature.analyze()
    k2 = export()["objects"][0]["k2"]
    assert k2["median"] == pytest.approx(0.0, abs=0.01)
    assert abs(k2["mean"]) < 0.05


def test_regions_are_those_of_the_faces(export: Callable[..., Any]) -> None:
    obj = add_surface(lambda x, _y: -0.25 * np.maximum(x, 0.0) ** 2)
    bpy.ops.curvature.segment(**STRICT)
    (block,) = export()["objects"]
    faces = stored(obj, "curvature_region")
    classes, areas = stored(obj, "curvature_class"), _face_areas(obj)
    assert [region["id"] for region in block["regions"]] == sorted(set(faces.tolist()))
    for region in block["regions"]:
        members = faces == region["id"]
        assert region["faces"] == members.sum()
        assert region["area"] == pytest.approx(areas[members].sum(), rel=0.01)
        assert {CLASSES.index(region["class"])} == set(classes[members].tolist())
    assert sum(c["regions"] for c in block["classes"].values()) == len(block["regions"])
    found = [region["area"] for region in block["regions"]]
    assert found == sorted(found, reverse=True)


@pytest.mark.parametrize(
    ("height", "key", "radius"),
    [
        (plate, "flat", None),
        (barrel, "single_curved", RADIUS),
        (dome, "double_curved_elliptic", RADIUS),
    ],
)
def test_smallest_radius_is_that_of_the_surface(
    height: Callable[..., Any], key: str, radius: float | None, export: Callable[..., Any]
) -> None:
    add_surface(height)
    bpy.ops.curvature.segment(**STRICT)
    (block,) = export()["objects"]
    # A fit over two rings of edges h = 1/8 is off by about (2 h / R)².
    near = pytest.approx(radius, rel=(2 / 8 / RADIUS) ** 2) if radius else None
    assert block["classes"][key]["min_radius"] == near
    assert block["regions"][0]["min_radius"] == near


def test_outline_of_a_single_region_is_the_rim(export: Callable[..., Any]) -> None:
    add_surface(plate)
    bpy.ops.curvature.segment(**STRICT)
    (block,) = export()["objects"]
    assert block["regions"][0]["boundary_length"] == pytest.approx(8.0, rel=1e-6)


def test_models_that_differ_in_a_setting_share_none(export: Callable[..., Any]) -> None:
    add_surface(dome, "One")
    bpy.ops.curvature.segment(panel_size=1.0, deviation=0.01)
    bpy.context.object.select_set(False)
    add_surface(dome, "Two")
    bpy.ops.curvature.segment(panel_size=0.5, deviation=0.01)
    bpy.data.objects["One"].select_set(True)
    document = export()
    assert {block["name"] for block in document["objects"]} == {"One", "Two"}
    assert document["settings"]["panel_size"] is None
    assert document["settings"]["deviation"] == 0.01
    assert {block["panel_size"] for block in document["objects"]} == {1.0, 0.5}


def test_warnings_are_the_sentences_of_the_panel(export: Callable[..., Any]) -> None:
    obj = add_surface(dome)
    obj.data.vertices.add(1)
    bpy.ops.curvature.segment(**STRICT)
    (block,) = export()["objects"]
    assert block["warnings"] == [warning.text for warning in obj.data.curvature.warnings]
    assert len(block["warnings"]) == 1


def test_copy_is_reported_under_the_name_of_its_source(export: Callable[..., Any]) -> None:
    obj = add_surface(dome)
    obj.modifiers.new("Subdivision", "SUBSURF").levels = 1
    bpy.ops.curvature.segment(**STRICT)
    (block,) = export()["objects"]
    assert block["name"] == "Roof"
    assert block["faces"] == 4 * 256
