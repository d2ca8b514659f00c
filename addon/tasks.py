# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What operators and commands do with many objects: analyze, segment, clear."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

from bpy.types import Context, Object

from .bridge import cache, display, results
from .bridge.edits import Edits, read_edits
from .bridge.material import show as show_material
from .bridge.mode import object_mode
from .bridge.outlines import discard_outlines
from .bridge.separation import discard_parts
from .bridge.subject import (
    Subject,
    discard_carrier,
    prepare_carrier,
    read_subject,
    reveal_carrier,
    source_of,
    users_of,
)
from .geometry.analysis import Analysis
from .geometry.errors import CurvatureError
from .geometry.segmentation import segment
from .geometry.settings import AnalysisSettings, SegmentationSettings
from .geometry.tolerance import Tolerance, resolve_tolerance
from .geometry.types import Progress


@dataclass
class Outcome:
    """What became of the objects of a task.

    `carriers` have the results, `analyses` are those by the names of their meshes; `refused` says
    for each of the others what is wrong with it.
    """

    carriers: list[Object] = field(default_factory=list)
    analyses: dict[str, Analysis] = field(default_factory=dict)
    refused: list[str] = field(default_factory=list)

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
    on_progress: Progress | None = None,
) -> Outcome:
    """Measure the curvature of objects and show it.

    Parameters
    ----------
    context : Context
    objects : list of Object
        Mesh objects; modes are left for the time of the work.
    settings : AnalysisSettings
    panel : SegmentationSettings
        Decides which points count as flat or parabolic.
    on_progress : callable, optional

    Returns
    -------
    Outcome
    """

    def write(subject: Subject) -> Object:
        edits, tolerance = read_edits(subject), _tolerance(subject, panel)
        return _write_analysis(context, subject, settings, tolerance, edits)

    with object_mode(context):
        outcome = _for_each(context, objects, settings, write, on_progress)
        _show(context, outcome, ("GAUSSIAN", "MEAN", "K1", "K2"))
    return outcome


def segment_objects(
    context: Context,
    objects: list[Object],
    settings: AnalysisSettings,
    panel: SegmentationSettings,
    on_progress: Progress | None = None,
    given: Edits | None = None,
) -> Outcome:
    """Segment objects into classes and regions, and show the classes.

    What is missing or stale of the analysis is measured first.

    Parameters
    ----------
    context : Context
    objects : list of Object
        Mesh objects; modes are left for the time of the work.
    settings : AnalysisSettings
    panel : SegmentationSettings
    on_progress : callable, optional
    given : Edits, optional
        In place of those that the objects have.

    Returns
    -------
    Outcome
    """

    def write(subject: Subject) -> Object:
        analysis, tolerance = subject.analysis, _tolerance(subject, panel)
        edits = given or read_edits(subject)
        segmentation = segment(
            analysis.surface,
            analysis.curvature,
            tolerance,
            panel.min_area,
            edits.locked,
            edits.cuts,
        )
        carrier = _write_analysis(context, subject, settings, tolerance, edits)
        results.write_segmentation(subject, carrier, segmentation, panel, edits)
        display.write_class_colors(carrier.data, context.scene.curvature)
        return carrier

    with object_mode(context):
        outcome = _for_each(context, objects, settings, write, on_progress)
        _show(context, outcome, ("CLASS", "REGION"))
    return outcome


def clear_objects(context: Context, objects: list[Object]) -> int:
    """Remove everything that was stored on or made for objects; return how many had anything."""
    with object_mode(context):
        cleared = sum([_clear(context, obj) for obj in objects])
        display.refresh(context, context.scene)
    return cleared


def _for_each(
    context: Context,
    objects: list[Object],
    settings: AnalysisSettings,
    write: Callable[[Subject], Object],
    on_progress: Progress | None,
) -> Outcome:
    """Measure and write one object after the other; a refusal stops only its own object."""
    outcome = Outcome()
    for number, obj in enumerate(objects):

        def advance(share: float, before: int = number) -> None:
            if on_progress:
                on_progress((before + share) / len(objects))

        try:
            subject = read_subject(
                obj, context.scene, context.evaluated_depsgraph_get(), settings, advance
            )
            carrier = write(subject)
            outcome.carriers.append(carrier)
            outcome.analyses[carrier.data.name_full] = subject.analysis
        except CurvatureError as error:
            outcome.refused.append(f"{obj.name}: {error}")
        advance(1.0)
    return outcome


def _write_analysis(
    context: Context,
    subject: Subject,
    settings: AnalysisSettings,
    tolerance: Tolerance,
    edits: Edits,
) -> Object:
    _drop_results_elsewhere(context, subject)
    carrier = prepare_carrier(subject, context.scene, context.evaluated_depsgraph_get())
    if not results.is_current(carrier.data, subject):
        results.write_curvature(subject, carrier, settings, edits)
        display.write_curvature_colors(carrier.data, subject.analysis, context.scene.curvature)
    results.write_point_types(carrier.data, subject.analysis, tolerance)
    reveal_carrier(context, subject.source, carrier)
    return carrier


def _drop_results_elsewhere(context: Context, subject: Subject) -> None:
    """Drop what an earlier run left where the results do not belong any more."""
    source = subject.source
    if subject.has_base_topology:
        discard_carrier(context, source)
    elif source.data.library is None:
        results.clear_results(source.data)


def _tolerance(subject: Subject, panel: SegmentationSettings) -> Tolerance:
    return resolve_tolerance(
        panel.panel_size, panel.deviation, subject.analysis.surface.mesh.diagonal
    )


def _show(context: Context, outcome: Outcome, quantities: tuple[str, ...]) -> None:
    """Show the quantity at hand if it is of the kind that was made, else the first of it."""
    if not outcome.carriers:
        return
    settings = context.scene.curvature
    # Setting the quantity recolors every model, also where it stays the same.
    with cache.trusted(outcome.analyses):
        settings.quantity = settings.quantity if settings.quantity in quantities else quantities[0]


def _clear(context: Context, obj: Object) -> bool:
    source = source_of(obj)
    for user in users_of(source.data):
        show_material(user, False)
    had_results = results.clear_results(source.data) if source.data.library is None else False
    had_parts = [discard_parts(source), discard_outlines(source)]
    had_copy = discard_carrier(context, source)
    return had_results or had_copy or any(had_parts)
