# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Selection of faces by what they are, and what the user selected."""

from __future__ import annotations

import numpy as np
from bpy.types import Mesh

from ..geometry.types import AnyArray, Flags
from .mesh import corner_edges, corner_vertices, polygon_sizes, positions, read_array

_EDGE_SELECTION = ".select_edge"


def select_faces(mesh: Mesh, is_wanted: Flags, extend: bool) -> int:
    """Select faces with their edges and vertices, and return how many are selected then.

    Parameters
    ----------
    mesh : Mesh
        Not in Edit Mode.
    is_wanted : (m,) bool
    extend : bool
        Whether faces that are selected already stay so.
    """
    if extend:
        is_wanted = is_wanted | read_array(mesh.polygons, "select", np.bool_)
    vertices = np.zeros(len(mesh.vertices), dtype=np.bool_)
    edges = np.zeros(len(mesh.edges), dtype=np.bool_)
    at_corner = np.repeat(is_wanted, polygon_sizes(mesh))
    vertices[corner_vertices(mesh)[at_corner]] = True
    edges[corner_edges(mesh)[at_corner]] = True
    # Blender 5.0 keeps a selection of all edges as one value and crashes when single ones are set.
    if _EDGE_SELECTION in mesh.attributes:
        mesh.attributes.remove(mesh.attributes[_EDGE_SELECTION])
    mesh.vertices.foreach_set("select", vertices)
    mesh.edges.foreach_set("select", edges)
    mesh.polygons.foreach_set("select", is_wanted)
    mesh.update()
    return int(is_wanted.sum())


def selected_vertices(mesh: Mesh) -> tuple[AnyArray, AnyArray]:
    """Return numbers (n,) int64 and coordinates (n, 3) float64 of the selected vertices.

    Parameters
    ----------
    mesh : Mesh
        Not in Edit Mode.
    """
    chosen = np.flatnonzero(read_array(mesh.vertices, "select", np.bool_))
    return chosen, positions(mesh)[chosen].astype(np.float64)
