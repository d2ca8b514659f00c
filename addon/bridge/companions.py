# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects that accompany a model: lines, borders, markers and hatching; later runs replace them."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import bpy
import numpy as np
from bpy.types import ID, Object, Scene
from mathutils import Matrix

from ..geometry.lines.field import Family
from ..geometry.types import Floats
from .collection import discard, link_beside
from .material import Color
from .subject import Subject, carrier_of


@dataclass(frozen=True)
class Role:
    """What an object is for: the ending of its name, and its scene-linear color."""

    ending: str
    color: Color


# Colors that no class has: strong ones, as thin lines look darker than they are.
_RED, _BLUE = (0.75, 0.018, 0.012), (0.01, 0.075, 0.7)
_VIOLET, _GREEN = (0.32, 0.015, 0.5), (0.0, 0.25, 0.08)
_BLACK = (0.012, 0.012, 0.014)

ROLES = {
    "LINES_1": Role("Lines 1", _RED),
    "LINES_2": Role("Lines 2", _BLUE),
    "ASYMPTOTIC_1": Role("Asymptotic 1", _VIOLET),
    "ASYMPTOTIC_2": Role("Asymptotic 2", _GREEN),
    "PICKED_LINES_1": Role("Picked Lines 1", _RED),
    "PICKED_LINES_2": Role("Picked Lines 2", _BLUE),
    "PICKED_ASYMPTOTIC_1": Role("Picked Asymptotic 1", _VIOLET),
    "PICKED_ASYMPTOTIC_2": Role("Picked Asymptotic 2", _GREEN),
    "BORDERS": Role("Region Borders", _BLACK),
    "PARABOLIC": Role("Parabolic Curves", (0.0, 0.17, 0.1)),
    "UMBILICS": Role("Umbilics", (0.9, 0.32, 0.0)),
    "HATCHING": Role("Hatching", _BLACK),
}
"""What each companion is for, by the name that is stored with it."""

FAMILY_ROLES = {
    Family.FIRST: "LINES_1",
    Family.SECOND: "LINES_2",
    Family.ASYMPTOTIC_LEFT: "ASYMPTOTIC_1",
    Family.ASYMPTOTIC_RIGHT: "ASYMPTOTIC_2",
}
"""The role of the lines of a family."""


def picked(role: str) -> str:
    """Return the role of lines that were traced one by one."""
    return f"PICKED_{role}"


def companions(source: Object, roles: Iterable[str] = tuple(ROLES)) -> list[Object]:
    """Return the objects that accompany a model, in the order of their roles."""
    found = [each for each in bpy.data.objects if each.curvature.companion_of == source]
    return [each for role in roles for each in found if each.curvature.role == role]


def add_companion(source: Object, carrier: Object, data: ID, role: str, scene: Scene) -> Object:
    """Make an object that stands where a model stands, turned as it is, but with a scale of 1.

    So lines and markers are equally thick in all directions.

    Parameters
    ----------
    source, carrier : Object
        The model, and the object that carries its results.
    data : Curve or Mesh
    role : str
    scene : Scene

    Returns
    -------
    Object
    """
    obj = bpy.data.objects.new(companion_name(source, role), data)
    obj.curvature.companion_of = source
    obj.curvature.role = role
    # What solid viewports show of objects without color attributes while models show theirs.
    obj.color = (*ROLES[role].color, 1.0)
    location, rotation, _ = carrier.matrix_world.decompose()
    obj.matrix_world = Matrix.LocRotScale(location, rotation, None)
    link_beside(source, obj, scene)
    return obj


def companion_name(source: Object, role: str) -> str:
    """Return the name of a companion."""
    return f"{source.name} {ROLES[role].ending}"


def is_outdated(companion: Object) -> bool:
    """Return whether a model was analyzed anew, after a change, since its companion was made."""
    mesh = carrier_of(companion).data
    # Objects that share a mesh share its results, but need not have one scale.
    is_shared = mesh.users - mesh.use_fake_user > 1
    states = {companion.curvature.fingerprint, mesh.curvature.fingerprint}
    return not is_shared and "" not in states and len(states) == 2


def discard_companions(source: Object, roles: Iterable[str] = tuple(ROLES)) -> bool:
    """Remove objects that accompany a model; return whether there were any.

    Where one of them was the active object, the model is instead: there must be something to go on
    with.
    """
    found = companions(source, roles)
    layer = bpy.context.view_layer
    was_active = layer.objects.active in found
    discard(source, found)
    carrier = carrier_of(source)
    if was_active and layer.objects.get(carrier.name) == carrier:
        carrier.select_set(True)
        layer.objects.active = carrier
    return bool(found)


def world_points(subject: Subject, points: Floats) -> Floats:
    """Return places on an analyzed surface in world coordinates, in Blender units.

    Parameters
    ----------
    subject : Subject
    points : (p, 3) float64
        In meters, in the coordinates of the analyzed mesh.
    """
    world = np.array(subject.source.matrix_world, dtype=np.float64)
    return _in_object(subject, points) @ world[:3, :3].T + world[:3, 3]


def analyzed_points(subject: Subject, world_points: Floats) -> Floats:
    """Return places in world coordinates as the analyzed mesh has them, in meters."""
    world = np.array(subject.source.matrix_world, dtype=np.float64)
    in_object = (world_points - world[:3, 3]) @ np.linalg.inv(world[:3, :3]).T
    return (in_object - subject.center) @ subject.meters_from_object


def companion_points(subject: Subject, companion: Object, points: Floats) -> Floats:
    """Return places on an analyzed surface in the coordinates of a companion, (p, 3)."""
    world = np.array(subject.source.matrix_world, dtype=np.float64)
    own = np.array(companion.matrix_world, dtype=np.float64)
    # The large offset of a model far from the origin cancels before anything is rounded.
    offset = world[:3, 3] - own[:3, 3]
    apart = _in_object(subject, points) @ world[:3, :3].T + offset
    return apart @ np.linalg.inv(own[:3, :3]).T


def _in_object(subject: Subject, points: Floats) -> Floats:
    return points @ np.linalg.inv(subject.meters_from_object) + subject.center
