# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Results on a mesh: attributes for every vertex and face, and a summary beside them."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
from bpy.types import Mesh, Object

from ..geometry.analysis import Analysis
from ..geometry.classification import SurfaceClass
from ..geometry.criterion import Criterion, classify_by
from ..geometry.segmentation import Segmentation
from ..geometry.settings import AnalysisSettings, SegmentationSettings, Smoothing
from ..geometry.types import AnyArray, Floats
from ..report.findings import FINDINGS
from ..report.measures import measure_object
from . import names
from .attributes import remove_attributes, write_attribute
from .comparison import comparison_of, keep_previous
from .criteria import write_criterion
from .edits import Edits, names_after, write_edits
from .numbers import as_typed, as_typed_angle
from .outlines import outline_blocks
from .region_list import region_names, with_names, write_regions
from .segmentation_settings import write_segmentation_settings
from .subject import Subject


def write_curvature(
    subject: Subject, carrier: Object, settings: AnalysisSettings, edits: Edits
) -> None:
    """Write curvatures and directions of an analysis to the carrier's mesh.

    Classes of an earlier state of the model go; those of the same analysis stay.

    Parameters
    ----------
    subject : Subject
    carrier : Object
        Has the topology of the analyzed mesh.
    settings : AnalysisSettings
        What the analysis was made with.
    edits : Edits
        What the model had before.
    """
    mesh, analysis = carrier.data, subject.analysis
    curvature = analysis.curvature
    at_vertex = analysis.surface.vertex_sector
    for name, values in (
        (names.GAUSSIAN, curvature.gaussian),
        (names.MEAN, curvature.mean),
        (names.K1, curvature.k1),
        (names.K2, curvature.k2),
    ):
        write_attribute(mesh, name, "POINT", "FLOAT", _on_vertices(values, at_vertex))
    for name, directions in (
        (names.DIRECTION_1, curvature.direction_1),
        (names.DIRECTION_2, curvature.direction_2),
    ):
        in_object = _directions_in_object(directions, subject.meters_from_object)
        write_attribute(mesh, name, "POINT", "FLOAT_VECTOR", _on_vertices(in_object, at_vertex))
    results = mesh.curvature
    if results.fingerprint != subject.fingerprint:
        results.report = ""
        remove_attributes(mesh, names.CLASS_ATTRIBUTES)
        _forget_classes(mesh)
    results.fingerprint = subject.fingerprint
    results.crease_angle = settings.crease_angle
    results.flip_normals = settings.flip_normals
    results.smoothing = settings.smoothing.name
    results.smoothing_length = settings.smoothing_length
    if not results.is_segmented:
        _write_summary(mesh, subject, measure_object(analysis), edits.warnings)
    write_edits(mesh, edits)


def settings_of(mesh: Mesh) -> AnalysisSettings:
    """Return the settings that the results of a mesh were made with."""
    results = mesh.curvature
    return AnalysisSettings(
        crease_angle=as_typed_angle(results.crease_angle),
        flip_normals=results.flip_normals,
        smoothing=Smoothing[results.smoothing],
        smoothing_length=as_typed(results.smoothing_length),
    )


def is_current(mesh: Mesh, subject: Subject) -> bool:
    """Return whether a mesh carries the curvatures of exactly this analysis already."""
    return mesh.curvature.fingerprint == subject.fingerprint and all(
        name in mesh.attributes for name in names.CURVATURE_ATTRIBUTES
    )


def write_point_types(mesh: Mesh, analysis: Analysis, criterion: Criterion) -> None:
    """Write whether each vertex is flat, parabolic, elliptic or hyperbolic by a criterion."""
    curvature = analysis.curvature
    types = classify_by(curvature.k1, curvature.k2, criterion, curvature.is_defined)
    at_vertex = analysis.surface.vertex_sector
    values = np.where(at_vertex >= 0, types[at_vertex], SurfaceClass.UNDEFINED)
    write_attribute(mesh, names.POINT_TYPE, "POINT", "INT", values)


def write_segmentation(
    subject: Subject,
    carrier: Object,
    segmentation: Segmentation,
    settings: SegmentationSettings,
    edits: Edits,
    preset: dict[str, str],
) -> None:
    """Write classes, regions and their measures to the carrier's mesh.

    Parameters
    ----------
    subject : Subject
    carrier : Object
        Carries the curvatures of the same analysis.
    segmentation : Segmentation
    settings : SegmentationSettings
        What was asked for, to be asked for again after an edit.
    edits : Edits
        What went into the segmentation, and the regions before.
    preset : dict
        Name and source of the preset that the criterion is of; see `preset_of`.
    """
    mesh, results = carrier.data, carrier.data.curvature
    region_list = names_after(edits, segmentation, subject.analysis.surface.polygon_area)
    remove_attributes(mesh, (names.FORMER_REGION,))
    write_segmentation_settings(mesh, settings)
    results.outlines.clear()
    write_attribute(mesh, names.FACE_CLASS, "FACE", "INT", segmentation.face_class)
    write_attribute(mesh, names.REGION, "FACE", "INT", segmentation.regions.face_region)
    keep_previous(mesh, {kind: each.area for kind, each in segmentation.classes.items()})
    results.is_segmented = True
    write_criterion(mesh, segmentation)
    results.criterion_preset = preset["criterion_preset"]
    results.criterion_source = preset["criterion_source"]
    results.classes.clear()
    for surface_class, measure in segmentation.classes.items():
        row = results.classes.add()
        row.surface_class = surface_class.name
        row.area, row.share = measure.area, measure.share
        row.faces, row.regions = measure.faces, measure.regions
        row.min_radius = measure.min_radius or 0.0
    write_edits(mesh, edits)
    write_regions(mesh, segmentation, region_list)
    block = measure_object(subject.analysis, segmentation)
    block |= {key: text for key, text in preset.items() if text}
    block["regions"] = with_names(block["regions"], region_list)
    _write_summary(mesh, subject, block | comparison_of(mesh), edits.warnings)


def read_report(obj: Object) -> dict[str, Any] | None:
    """Return what was measured on an object's mesh, None where nothing was."""
    results = obj.data.curvature
    if not results.report:
        return None
    block = json.loads(results.report)
    if "regions" in block:
        block["regions"] = with_names(block["regions"], region_names(obj.data))
    return block | outline_blocks(obj.data)


def add_findings(mesh: Mesh, findings: dict[str, Any], outdated: tuple[str, ...] = ()) -> None:
    """Add what was found on an analyzed mesh to its report, and drop what is outdated."""
    block = json.loads(mesh.curvature.report)
    kept = {key: value for key, value in block.items() if key not in outdated}
    mesh.curvature.report = json.dumps({**kept, **findings}, allow_nan=False)


def clear_results(mesh: Mesh) -> bool:
    """Remove every attribute and summary of ours from a mesh; return whether there was any."""
    removed = remove_attributes(mesh, names.ATTRIBUTES)
    results = mesh.curvature
    had_results = bool(removed or results.fingerprint)
    results.fingerprint = results.report = results.topology = results.segmentation = ""
    _forget_classes(mesh)
    results.previous.clear()
    results.warnings.clear()
    return had_results


def _findings(mesh: Mesh) -> dict[str, Any]:
    """Return what was added to the report of the same analysis, which goes on holding."""
    text = mesh.curvature.report
    block = json.loads(text) if text else {}
    return {key: block[key] for key in FINDINGS if key in block}


def _forget_classes(mesh: Mesh) -> None:
    results = mesh.curvature
    keep_previous(mesh, {})
    results.is_segmented = False
    results.region_count = 0
    results.classes.clear()
    results.regions.clear()
    results.outlines.clear()


def _write_summary(
    mesh: Mesh, subject: Subject, block: dict[str, Any], warnings: tuple[str, ...]
) -> None:
    sentences = (*warnings, *subject.analysis.warnings, *_undefined_warning(subject.analysis))
    sentences += _sharing_warning(subject.source)
    results = mesh.curvature
    block = {
        "name": subject.source.name,
        "source": "",
        **block,
        **_findings(mesh),
        "warnings": list(sentences),
    }
    results.warnings.clear()
    for sentence in sentences:
        results.warnings.add().text = sentence
    results.report = json.dumps(block, allow_nan=False)


def _undefined_warning(analysis: Analysis) -> tuple[str, ...]:
    count = int((~analysis.curvature.is_defined).sum())
    if not count:
        return ()
    return (
        f"{count} of {analysis.surface.sector_count} places have no tangent plane, such as the tip "
        "of a cone, or no faces with an area, and are left undefined",
    )


def _sharing_warning(source: Object) -> tuple[str, ...]:
    users = source.data.users - source.data.use_fake_user
    if users < 2:
        return ()
    return (
        f"the mesh is shared by {users} objects: all show the results at the scale of this one",
    )


def _on_vertices(values: AnyArray, at_vertex: AnyArray) -> AnyArray:
    """Return the leading sectors' values, zero for vertices without faces."""
    rows = values[at_vertex]
    rows[at_vertex < 0] = 0.0
    return rows


def _directions_in_object(directions: Floats, meters_from_object: Floats) -> Floats:
    turned = directions @ np.linalg.inv(meters_from_object)
    length = np.linalg.norm(turned, axis=1, keepdims=True)
    return np.divide(turned, length, out=np.zeros_like(turned), where=length > 0.0)
