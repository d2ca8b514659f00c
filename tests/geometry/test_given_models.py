# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Known models that are not ours to ship, where ARCHITECTURAL_CURVATURE_MODELS names their folder.

The fandisk is a part of machined planes, cylinders and blends that research measures itself by.
"""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
import pytest
from architectural_curvature.addon.geometry.analysis import Analysis, analyze
from architectural_curvature.addon.geometry.classification import SurfaceClass
from architectural_curvature.addon.geometry.criterion import resolve_criterion
from architectural_curvature.addon.geometry.lines.field import PRINCIPAL
from architectural_curvature.addon.geometry.lines.layout import trace_evenly
from architectural_curvature.addon.geometry.lines.simplification import simplified
from architectural_curvature.addon.geometry.mesh import PolygonMesh, mesh_from_polygons
from architectural_curvature.addon.geometry.segmentation import Segmentation, segment
from architectural_curvature.addon.geometry.settings import AnalysisSettings, SegmentationSettings
from line_fields import field_of

VARIABLE = "ARCHITECTURAL_CURVATURE_MODELS"


def _model(name: str) -> PolygonMesh:
    folder = os.environ.get(VARIABLE)
    path = Path(folder or ".", f"{name}.obj")
    if folder is None or not path.is_file():
        pytest.skip(f"{VARIABLE} names no folder with {path.name}")
    rows = [line.split() for line in path.read_text(encoding="utf-8").splitlines()]
    points = np.array([[float(word) for word in row[1:4]] for row in rows if row[:1] == ["v"]])
    faces = [[int(word.split("/")[0]) - 1 for word in row[1:]] for row in rows if row[:1] == ["f"]]
    return mesh_from_polygons(points, faces)


def _segmented(
    name: str, panel_size: float, deviation: float
) -> tuple[PolygonMesh, Analysis, Segmentation]:
    mesh = _model(name)
    analysis = analyze(mesh, AnalysisSettings(crease_angle=np.radians(30.0)))
    criterion = resolve_criterion(SegmentationSettings(panel_size, deviation), mesh.diagonal)
    return mesh, analysis, segment(analysis.surface, analysis.curvature, criterion)


def test_the_largest_plane_of_the_fandisk_is_one_flat_region() -> None:
    mesh, analysis, found = _segmented("fandisk", 0.1, 0.001)
    area = analysis.surface.polygon_area
    vector = analysis.surface.polygon_vector
    normal = vector / np.linalg.norm(vector, axis=1)[:, None]
    offset = np.einsum("ij,ij->i", normal, mesh.vertices[mesh.corner_vertex[0::3]])
    planes = np.round(np.column_stack([normal, offset]) / 2e-3).astype(np.int64)
    _, plane = np.unique(planes, axis=0, return_inverse=True)
    largest = plane == np.bincount(plane, area).argmax()
    # What is published of this mesh.
    assert area[largest].sum() / area.sum() == pytest.approx(0.245, abs=0.001)
    (region,) = np.unique(found.regions.face_region[largest])
    inside = found.regions.face_region == region
    assert (found.face_class[inside] == SurfaceClass.FLAT).all()
    assert area[inside].sum() == pytest.approx(area[largest].sum(), rel=0.01)


def test_the_fandisk_is_of_planes_and_cylinders_but_for_its_blends() -> None:
    _, _, found = _segmented("fandisk", 0.1, 0.001)
    share = {kind: measure.share for kind, measure in found.classes.items()}
    assert share[SurfaceClass.FLAT] + share[SurfaceClass.SINGLE] > 0.98
    assert found.classes[SurfaceClass.FLAT].regions >= 12


def test_every_hexagon_of_the_arch_has_a_class() -> None:
    mesh, _, found = _segmented("hex_arch_ngons", 0.2, 0.002)
    assert mesh.polygon_count == 259
    assert (found.face_class >= SurfaceClass.FLAT).all()
    # A shell of positive curvature.
    assert not (found.face_class == SurfaceClass.HYPERBOLIC).any()


@pytest.mark.parametrize(("name", "parts"), [("elephant_with_holes", 80), ("bunny_closed_38k", 20)])
def test_no_line_turns_sideways(name: str, parts: int) -> None:
    """Folds as narrow as a triangle, and bumps with umbilics everywhere."""
    lines = field_of(_model(name))
    spacing = lines.field.surface.mesh.diagonal / parts
    traced = simplified(trace_evenly(lines, spacing), 0.002 * spacing)
    move = np.diff(traced.points, axis=0)
    turn = np.einsum("ij,ij->i", move[1:], move[:-1])
    length = np.linalg.norm(move, axis=1)
    line = traced.point_line
    inside = (line[2:] == line[:-2]) & (length[1:] * length[:-1] > 0.0)
    cosine = turn[inside] / (length[1:] * length[:-1])[inside]
    assert cosine.min() > np.cos(np.radians(60.0))


def test_both_families_of_a_hypar_are_as_dense() -> None:
    """In its corners lines are short, and have none straight beside them."""
    lines = field_of(_model("hypar_quads"))
    traced = trace_evenly(lines, lines.field.surface.mesh.diagonal / 40.0)
    first, second = (int((traced.family == family).sum()) for family in PRINCIPAL)
    assert abs(first - second) < 0.3 * first


@pytest.mark.parametrize(
    ("name", "panel_size", "expected"),
    [("barrel_vault_tri", 0.2, SurfaceClass.SINGLE), ("hypar_quads", 1.0, SurfaceClass.HYPERBOLIC)],
)
def test_a_surface_of_one_kind_is_one_region(
    name: str, panel_size: float, expected: SurfaceClass
) -> None:
    # Curvatures of 1 and 0.24 1/m, which are above the limits of 0.4 and 0.016 1/m.
    _, _, found = _segmented(name, panel_size, 0.002)
    assert (found.face_class == expected).all()
    assert found.regions.count == 1
