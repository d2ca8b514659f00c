# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The object that is analyzed, and the object that carries the results."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass

import bpy
import numpy as np
from bpy.types import Context, Depsgraph, Mesh, Object, Scene

from ..geometry.analysis import Analysis, analyze
from ..geometry.mesh import PolygonMesh
from ..geometry.settings import AnalysisSettings
from ..geometry.types import AnyArray, Floats, Progress
from . import cache
from .collection import discard, link_beside
from .evaluation import evaluated_mesh, evaluated_object
from .frame import meters_from_object
from .mesh import corner_edges, corner_vertices, positions, read_polygon_mesh
from .names import ATTRIBUTES


@dataclass(frozen=True)
class Subject:
    """An analyzed object; nothing of it has been written yet.

    Parameters
    ----------
    source : Object
        What the user models.
    meters_from_object : (3, 3) float64
        From the object's coordinates to meters.
    fingerprint : str
        Changes with everything that the analysis depends on.
    analysis : Analysis
    has_base_topology : bool
        Whether the source's modifiers leave its faces as they are.
    center : (3,) float64
        In the object's coordinates; meters are counted from here.
    """

    source: Object
    meters_from_object: Floats
    fingerprint: str
    analysis: Analysis
    has_base_topology: bool
    center: Floats

    @property
    def mesh(self) -> PolygonMesh:
        """The mesh that was analyzed."""
        return self.analysis.surface.mesh


@dataclass(frozen=True)
class Reading:
    """An object as it was read, not yet analyzed; see `Subject`."""

    source: Object
    meters_from_object: Floats
    fingerprint: str
    mesh: PolygonMesh
    settings: AnalysisSettings
    has_base_topology: bool
    center: Floats

    def analyzed(self, on_progress: Progress | None = None) -> Subject:
        """Analyze what was read, or take the analysis from the cache; does not touch Blender.

        Raises
        ------
        CurvatureError
            If the mesh cannot be analyzed; the sentence says why.
        """
        analysis = cache.find(self.fingerprint)
        if analysis is None:
            analysis = analyze(self.mesh, self.settings, on_progress)
            cache.keep(self.fingerprint, analysis)
        return Subject(
            self.source,
            self.meters_from_object,
            self.fingerprint,
            analysis,
            self.has_base_topology,
            self.center,
        )


def source_of(obj: Object) -> Object:
    """Return the object that an object's results belong to: itself, unless it was made by us."""
    return obj.curvature.source or obj.curvature.companion_of or obj


def users_of(mesh: Mesh) -> list[Object]:
    """Return all objects that share a mesh, and with it its results."""
    return [obj for obj in bpy.data.objects if obj.type == "MESH" and obj.data == mesh]


def carrier_of(obj: Object) -> Object:
    """Return the object that carries the results of an object: a copy of its own, or itself."""
    source = source_of(obj)
    if source.type == "MESH" and source.data.curvature.fingerprint:
        return source
    return _own_copy(source) or source


def selected_subjects(context: Context) -> list[Object]:
    """Return the selected objects to analyze, each mesh and each source once."""
    found: dict[str, Object] = {}
    for obj in [*context.selected_objects, *context.objects_in_mode_unique_data]:
        source = source_of(obj)
        if source.type == "MESH":
            found.setdefault(source.data.name_full, source)
    return list(found.values())


def read_object(
    obj: Object, scene: Scene, depsgraph: Depsgraph, settings: AnalysisSettings
) -> Reading:
    """Read the evaluated mesh of an object.

    Parameters
    ----------
    obj : Object
        A mesh object that is not in Edit Mode.
    scene : Scene
    depsgraph : Depsgraph
    settings : AnalysisSettings

    Returns
    -------
    Reading

    Raises
    ------
    CurvatureError
        If the mesh cannot be analyzed; the sentence says why.
    """
    to_meters = meters_from_object(obj, scene)
    with evaluated_mesh(obj, depsgraph) as mesh:
        polygon_mesh = read_polygon_mesh(mesh, to_meters)
        has_base_topology = _same_topology(mesh, obj.data) and _is_writable(obj.data)
        stored = positions(mesh)
    fingerprint = _fingerprint(stored, polygon_mesh, to_meters, settings)
    ends = np.stack([stored.min(axis=0), stored.max(axis=0)]).astype(np.float64)
    return Reading(
        source=obj,
        meters_from_object=to_meters,
        fingerprint=fingerprint,
        mesh=polygon_mesh,
        settings=settings,
        has_base_topology=has_base_topology,
        center=ends.mean(axis=0),
    )


def prepare_carrier(subject: Subject, scene: Scene, depsgraph: Depsgraph) -> Object:
    """Return the object to write the results to, and make or update the copy where one is needed.

    Parameters
    ----------
    subject : Subject
    scene : Scene
    depsgraph : Depsgraph

    Returns
    -------
    Object
        The source, or an object named `<name> Curvature` that carries the evaluated geometry and
        stands where the source stands.
    """
    source = subject.source
    copy = _own_copy(source)
    if subject.has_base_topology:
        return source
    if copy is not None and copy.data.curvature.fingerprint == subject.fingerprint:
        copy.matrix_world = source.matrix_world
        return copy
    with evaluated_object(source, depsgraph) as evaluated:
        mesh = bpy.data.meshes.new_from_object(
            evaluated, preserve_all_data_layers=True, depsgraph=depsgraph
        )
    mesh.name = f"{source.name} Curvature"
    for name in ATTRIBUTES:
        if name in mesh.attributes:
            mesh.attributes.remove(mesh.attributes[name])
    if copy is None:
        copy = bpy.data.objects.new(f"{source.name} Curvature", mesh)
        copy.curvature.source = source
        link_beside(source, copy, scene)
    else:
        replaced = copy.data
        copy.data = mesh
        if not replaced.users:
            bpy.data.meshes.remove(replaced)
    copy.matrix_world = source.matrix_world
    return copy


def reveal_carrier(context: Context, source: Object, carrier: Object) -> None:
    """Hide a source behind the copy that carries its results, and select the copy instead."""
    if carrier == source:
        return
    objects = context.view_layer.objects
    was_active = objects.active == source
    # Either may lie in a collection that is excluded from the view layer.
    if objects.get(source.name) == source:
        source.select_set(False)
        source.hide_set(True)
    if objects.get(carrier.name) == carrier:
        carrier.hide_set(False)
        carrier.select_set(True)
        if was_active:
            objects.active = carrier


def discard_carrier(context: Context, source: Object) -> bool:
    """Remove the copy that carries the results of a source; return whether there was one."""
    copy = _own_copy(source)
    if copy is None:
        return False
    was_active = context.view_layer.objects.active == copy
    discard(source, [copy])
    if source.name in context.view_layer.objects:
        source.hide_set(False)
        source.select_set(True)
        if was_active:
            context.view_layer.objects.active = source
    return True


def _own_copy(source: Object) -> Object | None:
    return next(
        (
            obj
            for obj in bpy.data.objects
            if obj.type == "MESH" and obj.curvature.source == source and obj != source
        ),
        None,
    )


def _same_topology(one: Mesh, other: Mesh) -> bool:
    counts = [(len(m.vertices), len(m.edges), len(m.polygons), len(m.loops)) for m in (one, other)]
    return counts[0] == counts[1] and all(
        np.array_equal(read(one), read(other)) for read in (corner_vertices, corner_edges)
    )


def _is_writable(mesh: Mesh) -> bool:
    return mesh.library is None


def _fingerprint(
    coordinates: AnyArray, mesh: PolygonMesh, to_meters: Floats, settings: AnalysisSettings
) -> str:
    digest = hashlib.blake2b(repr(settings).encode(), digest_size=16)
    for array in (
        _without_rounding(to_meters),
        coordinates,
        mesh.corner_vertex.astype(np.int32),
        mesh.polygon_start.astype(np.int32),
        mesh.corner_edge.astype(np.int32),
        mesh.edge_is_sharp,
    ):
        digest.update(np.ascontiguousarray(array).data)
    return digest.hexdigest()


def _without_rounding(matrix: Floats) -> Floats:
    """Return a matrix with five digits, so that turning an object does not count as a change.

    Blender keeps the product of rotation and scale with seven digits.
    """
    noise = 1e-6 * np.abs(matrix).max()
    return np.array([float(f"{x:.5g}") if abs(x) > noise else 0.0 for x in matrix.ravel()])
