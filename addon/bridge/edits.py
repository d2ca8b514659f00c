# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What users gave to a model by hand, which later runs keep: classes, cuts and names of regions."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass, replace

import numpy as np
from bpy.types import Mesh, Object

from ..geometry.matching import carry_names
from ..geometry.segmentation import Segmentation
from ..geometry.types import AnyArray, Floats, Indices
from . import names
from .attributes import read_attribute, remove_attributes, write_attribute
from .mesh import corner_vertices, polygon_starts, read_array
from .region_list import region_names, write_names
from .subject import Reading, Subject, carrier_of


@dataclass(frozen=True)
class Edits:
    """What users gave to the faces of a mesh by hand.

    Parameters
    ----------
    topology : str
        Changes with the faces' corners; nothing fits a mesh of another topology.
    locked : (m,) int64 or None
        Classes given by hand, -1 where free; None where all are.
    cuts : (m,) int64 or None
        Parts that no region reaches across; None where nothing was cut.
    face_region : (m,) int64 or None
        The regions that the names belong to.
    region_names : tuple of str
    warnings : tuple of str
        What was lost.
    """

    topology: str
    locked: Indices | None = None
    cuts: Indices | None = None
    face_region: Indices | None = None
    region_names: tuple[str, ...] = ()
    warnings: tuple[str, ...] = ()


def topology_of(mesh: Mesh) -> str:
    """Return what changes with the faces and their corners, but not with positions."""
    return _digest(corner_vertices(mesh), polygon_starts(mesh))


def read_edits(reading: Reading | Subject) -> Edits:
    """Return the edits of a model that fit it as it is now, with a warning where they do not.

    Parameters
    ----------
    reading : Reading or Subject
        The model as it is now.
    """
    carrier, mesh = carrier_of(reading.source), reading.mesh
    topology = _digest(mesh.corner_vertex, mesh.polygon_start)
    found = stored_edits(carrier.data)
    if found.topology == topology:
        return found
    lost = [
        name
        for name, values in (("classes given by hand", found.locked), ("splits", found.cuts))
        if values is not None
    ]
    # Blender carries the regions along where faces of the mesh itself are added or deleted.
    is_carried = reading.has_base_topology and carrier == reading.source
    region = found.face_region if is_carried else None
    is_fitting = region is not None and len(region) == mesh.polygon_count
    return Edits(
        topology=topology,
        face_region=region if is_fitting else None,
        region_names=found.region_names if is_fitting else (),
        warnings=(
            (f"{' and '.join(lost)} were dropped, for the faces of the model have changed",)
            if lost
            else ()
        ),
    )


def stored_edits(mesh: Mesh) -> Edits:
    """Return the edits on a mesh, whether its faces have changed since or not."""
    name = names.REGION if mesh.curvature.is_segmented else names.FORMER_REGION
    return Edits(
        topology=mesh.curvature.topology,
        locked=_read(mesh, names.LOCKED),
        cuts=_read(mesh, names.CUT),
        face_region=_read(mesh, name),
        region_names=tuple(region_names(mesh)),
    )


def write_edits(mesh: Mesh, edits: Edits) -> None:
    """Write edits to a mesh that they fit.

    Names of regions are kept for the next segmentation where the classes at hand are stale.
    """
    for name, values, nothing in (
        (names.LOCKED, edits.locked, -1),
        (names.CUT, edits.cuts, 0),
    ):
        if values is None or (values == nothing).all():
            remove_attributes(mesh, (name,))
        else:
            write_attribute(mesh, name, "FACE", "INT", values)
    mesh.curvature.topology = edits.topology
    if not mesh.curvature.is_segmented and edits.face_region is not None:
        write_attribute(mesh, names.FORMER_REGION, "FACE", "INT", edits.face_region)
        write_names(mesh, edits.region_names)


def names_after(edits: Edits, segmentation: Segmentation, areas: AnyArray) -> list[str]:
    """Return the names of new regions, those of the old ones where they continue them."""
    after = segmentation.regions.face_region
    before = np.full(len(after), -1) if edits.face_region is None else edits.face_region
    return carry_names(list(edits.region_names), before, after, areas)


def with_whole_arrays(edits: Edits, face_count: int) -> tuple[Indices, Indices]:
    """Return locked classes and cuts of every face, also where there are none yet."""
    locked, cuts = edits.locked, edits.cuts
    return (
        np.full(face_count, -1, dtype=np.int64) if locked is None else locked,
        np.zeros(face_count, dtype=np.int64) if cuts is None else cuts,
    )


def changed(edits: Edits, locked: Indices, cuts: Indices) -> Edits:
    """Return edits with other locked classes and cuts."""
    return replace(
        edits,
        locked=locked if (locked >= 0).any() else None,
        cuts=cuts if cuts.any() else None,
    )


def read_classes(mesh: Mesh) -> Indices | None:
    """Return the class of every face, None where there is none."""
    return _read(mesh, names.FACE_CLASS)


def face_areas(mesh: Mesh) -> Floats:
    """Return the area of every face in square Blender units, without the object's scale."""
    return read_array(mesh.polygons, "area", np.float32).astype(np.float64)


def selected_faces(carrier: Object) -> AnyArray:
    """Return which faces of a carrier are selected, (m,) bool; not in Edit Mode."""
    return read_array(carrier.data.polygons, "select", np.bool_)


def _read(mesh: Mesh, name: str) -> Indices | None:
    values = read_attribute(mesh, name)
    return None if values is None else values.astype(np.int64)


def _digest(*arrays: AnyArray) -> str:
    digest = hashlib.blake2b(digest_size=16)
    for array in arrays:
        digest.update(np.ascontiguousarray(array, np.int32).data)
    return digest.hexdigest()
