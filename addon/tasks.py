# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What operators and commands do with many objects: analyze, segment, clear."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial
from typing import TypeVar

from bpy.types import Context, Mesh, Object

from .bridge import cache, display, results
from .bridge.companions import discard_companions
from .bridge.criteria import preset_of
from .bridge.edits import Edits, read_edits
from .bridge.material import show as show_material
from .bridge.mode import object_mode
from .bridge.outlines import shown_outlines, write_outline
from .bridge.separation import discard_parts
from .bridge.subject import (
    Reading,
    Subject,
    discard_carrier,
    prepare_carrier,
    read_object,
    reveal_carrier,
    source_of,
    users_of,
)
from .geometry.criterion import Criterion, resolve_criterion
from .geometry.errors import CurvatureError
from .geometry.outlines.outline import OutlineSettings, trace_outline
from .geometry.outlines.polylines import Polylines
from .geometry.progress import part_of
from .geometry.segmentation import Segmentation, segment
from .geometry.settings import AnalysisSettings, SegmentationSettings
from .geometry.types import Progress
from .steps import Steps, Work

Found = TypeVar("Found")

#: The share of a segmentation's time that the analysis takes.
_ANALYSIS = 0.7


@dataclass
class Outcome:
    """What became of the objects of a task.

    `carriers` have the results; `refused` says for each of the others what is wrong with it;
    `remarks` what a user would not expect; `note` says in words what was found.
    """

    carriers: list[Object] = field(default_factory=list)
    refused: list[str] = field(default_factory=list)
    remarks: list[str] = field(default_factory=list)
    note: str = ""

    @property
    def meshes(self) -> list[Mesh]:
        """The meshes of the carriers."""
        return [each.data for each in self.carriers if isinstance(each.data, Mesh)]

    @property
    def warnings(self) -> list[str]:
        """Every warning, with the name of its object."""
        return [
            f"{source_of(carrier).name}: {warning.text}"
            for carrier in self.carriers
            for warning in carrier.data.curvature.warnings
        ]


def analyze_objects(
    context: Context,
    objects: list[Object],
    settings: AnalysisSettings,
    panel: SegmentationSettings,
) -> Steps[Outcome]:
    """Measure the curvature of objects and show it.

    Parameters
    ----------
    context : Context
    objects : list of Object
        Mesh objects; modes are left for the time of the work.
    settings : AnalysisSettings
    panel : SegmentationSettings
        Decides which points count as flat or parabolic.

    Returns
    -------
    Steps of Outcome
    """

    def compute(reading: Reading, on_progress: Progress) -> Subject:
        return reading.analyzed(on_progress)

    def write(subject: Subject) -> Object:
        return write_analysis(context, subject, settings, criterion_of(subject, panel))

    with object_mode(context):
        outcome = yield from for_each(context, objects, settings, compute, write)
        _show(context, outcome, ("GAUSSIAN", "MEAN", "K1", "K2"))
    return outcome


def segment_objects(
    context: Context,
    objects: list[Object],
    settings: AnalysisSettings,
    panel: SegmentationSettings,
    given: Edits | None = None,
) -> Steps[Outcome]:
    """Segment objects into classes and regions, and show the classes.

    What is missing or stale of the analysis is measured first.

    Parameters
    ----------
    context : Context
    objects : list of Object
        Mesh objects; modes are left for the time of the work.
    settings : AnalysisSettings
    panel : SegmentationSettings
    given : Edits, optional
        In place of those that the objects have.

    Returns
    -------
    Steps of Outcome
    """
    preset = preset_of(context.scene, panel)
    edits: dict[str, Edits] = {}
    shown: dict[str, list[OutlineSettings]] = {}

    def prepare(reading: Reading) -> None:
        source = reading.source
        edits[source.name_full] = given or read_edits(reading)
        # Curves of the regions before would lie among other regions afterwards.
        shown[source.name_full] = shown_outlines(source)

    def compute(
        reading: Reading, on_progress: Progress
    ) -> tuple[Subject, Segmentation, list[Polylines]]:
        subject = reading.analyzed(part_of(on_progress, 0.0, _ANALYSIS))
        analysis, given_by_hand = subject.analysis, edits[reading.source.name_full]
        segmentation = segment(
            analysis.surface,
            analysis.curvature,
            criterion_of(subject, panel),
            panel.min_area,
            given_by_hand.locked,
            given_by_hand.cuts,
            part_of(on_progress, _ANALYSIS, 1.0),
        )
        regions, criterion = segmentation.regions.face_region, segmentation.criterion
        wanted = shown[reading.source.name_full]
        return (
            subject,
            segmentation,
            [trace_outline(analysis, regions, criterion, s) for s in wanted],
        )

    def write(found: tuple[Subject, Segmentation, list[Polylines]]) -> Object:
        subject, segmentation, traced = found
        own, wanted = edits[subject.source.name_full], shown[subject.source.name_full]
        carrier = write_analysis(context, subject, settings, segmentation.criterion, own)
        results.write_segmentation(subject, carrier, segmentation, panel, own, preset)
        display.write_class_colors(carrier.data, context.scene.curvature)
        for curves, outline in zip(traced, wanted, strict=True):
            write_outline(subject, carrier, curves, outline, context.scene)
        return carrier

    with object_mode(context):
        outcome = yield from for_each(context, objects, settings, compute, write, prepare)
        _show(context, outcome, ("CLASS", "REGION"))
    return outcome


def clear_objects(context: Context, objects: list[Object]) -> int:
    """Remove everything that was stored on or made for objects; return how many had anything."""
    with object_mode(context):
        cleared = sum([_clear(context, obj) for obj in objects])
        display.refresh(context, context.scene)
    return cleared


def for_each(
    context: Context,
    objects: list[Object],
    settings: AnalysisSettings,
    compute: Callable[[Reading, Progress], Found],
    write: Callable[[Found], Object],
    prepare: Callable[[Reading], None] | None = None,
) -> Steps[Outcome]:
    """Read and compute one object after the other, then write all; in Object Mode.

    A refusal stops only its own object. Whoever cancels finds everything as it was.
    """
    outcome = Outcome()
    computed: list[Found] = []
    for number, obj in enumerate(objects):
        try:
            reading = read_object(obj, context.scene, context.evaluated_depsgraph_get(), settings)
            if prepare is not None:
                prepare(reading)
            found = yield Work(
                partial(compute, reading), number / len(objects), (number + 1) / len(objects)
            )
            computed.append(found)
        except CurvatureError as error:
            outcome.refused.append(f"{obj.name}: {error}")
    outcome.carriers += [write(found) for found in computed]
    return outcome


def write_analysis(
    context: Context,
    subject: Subject,
    settings: AnalysisSettings,
    criterion: Criterion,
    edits: Edits | None = None,
) -> Object:
    """Write an analysis where it is not stored yet, and return the object that carries it."""
    _drop_results_elsewhere(context, subject)
    carrier = prepare_carrier(subject, context.scene, context.evaluated_depsgraph_get())
    if not results.is_current(carrier.data, subject):
        results.write_curvature(subject, carrier, settings, edits or read_edits(subject))
        display.write_curvature_colors(carrier.data, subject.analysis, context.scene.curvature)
    results.write_point_types(carrier.data, subject.analysis, criterion)
    reveal_carrier(context, subject.source, carrier)
    return carrier


def _drop_results_elsewhere(context: Context, subject: Subject) -> None:
    """Drop what an earlier run left where the results do not belong any more."""
    source = subject.source
    if subject.has_base_topology:
        discard_carrier(context, source)
    elif source.data.library is None:
        results.clear_results(source.data)


def criterion_of(subject: Subject, panel: SegmentationSettings) -> Criterion:
    """Return the criterion for a model, with defaults where the user gave no sizes."""
    return resolve_criterion(panel, subject.analysis.surface.mesh.diagonal)


def _show(context: Context, outcome: Outcome, quantities: tuple[str, ...]) -> None:
    """Show the quantity at hand if it is of the kind that was made, else the first of it."""
    if not outcome.carriers:
        return
    settings = context.scene.curvature
    # Setting the quantity recolors every model, also where it stays the same.
    written = {mesh.name_full: mesh.curvature.fingerprint for mesh in outcome.meshes}
    with cache.trusted(written):
        settings.quantity = settings.quantity if settings.quantity in quantities else quantities[0]


def _clear(context: Context, obj: Object) -> bool:
    source = source_of(obj)
    for user in users_of(source.data):
        show_material(user, False)
    had_results = results.clear_results(source.data) if source.data.library is None else False
    had_parts = [discard_parts(source), discard_companions(source)]
    had_copy = discard_carrier(context, source)
    return had_results or had_copy or any(had_parts)
