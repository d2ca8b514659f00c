# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Classes and regions changed by hand: the selected faces are given one, the rest follows."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from bpy.types import Context, Object

from .bridge import edits, results
from .bridge.edits import Edits
from .bridge.mode import object_mode
from .bridge.segmentation_settings import segmentation_settings_of
from .bridge.subject import carrier_of, source_of
from .geometry import editing
from .geometry.classification import SurfaceClass
from .geometry.errors import CurvatureError
from .geometry.groups import sum_by_group
from .geometry.types import Flags, Floats, Indices
from .steps import Steps
from .tasks import Outcome, segment_objects


@dataclass(frozen=True)
class Target:
    """A segmented model whose faces are selected.

    Parameters
    ----------
    carrier : Object
    found : Edits
        What was given to it by hand before.
    face_class, face_region : (m,) int64
    face_area : (m,) float64
        In square Blender units.
    selected : (m,) bool
    """

    carrier: Object
    found: Edits
    face_class: Indices
    face_region: Indices
    face_area: Floats
    selected: Flags


Change = Callable[[Target], tuple[Indices, Indices]]
"""From a model to its new locked classes and cuts; refuses with a `CurvatureError`."""


@dataclass
class Edited(Outcome):
    """What became of the models of an edit, and how many faces and regions it touched."""

    faces: int = 0
    regions: int = 0
    regions_left: int = 0


@dataclass
class _Plan:
    """What is to be done, known before anything is written."""

    steps: list[tuple[Target, Edits]] = field(default_factory=list)
    refused: list[str] = field(default_factory=list)


def assign_class(surface_class: int) -> Change:
    """Return the change that gives selected faces a class, or frees them where it is undefined."""

    def change(target: Target) -> tuple[Indices, Indices]:
        locked, cuts = edits.with_whole_arrays(target.found, len(target.selected))
        locked = editing.assign_class(locked, target.selected, surface_class)
        # What is free is the segmentation's to decide, cuts included.
        return locked, np.where(target.selected, 0, cuts) if surface_class < 0 else cuts

    return change


def merge_regions(target: Target) -> tuple[Indices, Indices]:
    """Make one of the regions with selected faces, of the class that covers most of them."""
    regions = _selected_regions(target)
    if len(regions) < 2:
        raise CurvatureError("select faces of at least two regions")
    locked, cuts = edits.with_whole_arrays(target.found, len(target.selected))
    of_regions = np.isin(target.face_region, regions)
    # Undefined faces have no region.
    areas = sum_by_group(
        target.face_class[of_regions], target.face_area[of_regions], len(SurfaceClass)
    )
    return editing.merge_regions(
        (locked, cuts), target.face_region, target.face_class, regions, int(np.argmax(areas))
    )


def split_regions(target: Target) -> tuple[Indices, Indices]:
    """Part the selected faces from the rest of their regions."""
    locked, cuts = edits.with_whole_arrays(target.found, len(target.selected))
    rest = set(target.face_region[~target.selected].tolist())
    partial = [region for region in _selected_regions(target).tolist() if region in rest]
    if not partial:
        raise CurvatureError("select some faces of a region, but not all of them")
    for region in partial:
        cuts = editing.split_region(cuts, target.face_region, region, target.selected)
    return locked, cuts


def edit_objects(context: Context, objects: list[Object], change: Change) -> Steps[Edited]:
    """Change the models whose faces are selected, segment them again, and show the result.

    Parameters
    ----------
    context : Context
    objects : list of Object
        Mesh objects; modes are left for the time of the work.
    change : callable

    Returns
    -------
    Steps of Edited
    """
    outcome = Edited()
    with object_mode(context):
        plan = _plan(objects, change)
        outcome.refused += plan.refused
        for target, given in plan.steps:
            yield from _apply(context, target, given, outcome)
    if not plan.steps and not outcome.refused:
        outcome.refused.append("Select faces first, in Edit Mode or by class or region")
    return outcome


def _plan(objects: list[Object], change: Change) -> _Plan:
    plan = _Plan()
    for obj in objects:
        try:
            target = _target(obj)
            if target is not None:
                plan.steps.append((target, edits.changed(target.found, *change(target))))
        except CurvatureError as error:
            plan.refused.append(f"{obj.name}: {error}")
    return plan


def _target(obj: Object) -> Target | None:
    """Return what is selected on the object that carries the results, None where nothing is."""
    carrier = carrier_of(obj)
    mesh = carrier.data
    selected = edits.selected_faces(carrier)
    if not selected.any():
        return None
    if not mesh.curvature.is_segmented:
        raise CurvatureError("there are no regions: press Segment first")
    found = edits.stored_edits(mesh)
    face_class = edits.read_classes(mesh)
    if found.topology != edits.topology_of(mesh) or found.face_region is None or face_class is None:
        raise CurvatureError("the faces have changed: press Segment first")
    return Target(carrier, found, face_class, found.face_region, edits.face_areas(mesh), selected)


def _apply(context: Context, target: Target, given: Edits, outcome: Edited) -> Steps[None]:
    """Segment a model again as it was, but for the edits."""
    mesh, source = target.carrier.data, source_of(target.carrier)
    done = yield from segment_objects(
        context,
        [source],
        results.settings_of(mesh),
        segmentation_settings_of(mesh),
        given=given,
    )
    outcome.carriers += done.carriers
    outcome.refused += done.refused
    for carrier in done.carriers:
        outcome.faces += int(target.selected.sum())
        outcome.regions += len(_selected_regions(target))
        after = edits.stored_edits(carrier.data).face_region
        touched = np.isin(target.face_region, _selected_regions(target))
        outcome.regions_left += 0 if after is None else len(np.unique(after[touched]))


def _selected_regions(target: Target) -> Indices:
    found = np.unique(target.face_region[target.selected])
    return found[found >= 0]
