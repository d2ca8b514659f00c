# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The surface that a polygon mesh stands for: smooth pieces that meet in creases."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from .creases import DEFAULT_CREASE_ANGLE, Edges, find_edges
from .groups import sum_by_group
from .mesh import PolygonMesh
from .polygons import corner_angles, degenerate_polygons, measure_polygons
from .sectors import leading_sectors, smooth_sectors
from .types import Flags, Floats, Indices


@dataclass(frozen=True)
class Surface:
    """A mesh cut along its creases.

    At a crease a vertex has one *sector* per smooth side. Whatever is estimated, averaged or
    traced lives on sectors and never looks across a crease.

    Parameters
    ----------
    mesh : PolygonMesh
        What was cut.
    edges : Edges
        Smooth edges, creases and rims.
    polygon_vector : (m, 3) float64
        Vector areas in m², which point along the normals.
    polygon_area : (m,) float64
        In m².
    is_degenerate : (m,) bool
        Polygons without a usable area.
    corner_sector : (c,) int64
        Sector of every corner.
    sector_vertex : (s,) int64
        Vertex of every sector.
    """

    mesh: PolygonMesh
    edges: Edges
    polygon_vector: Floats
    polygon_area: Floats
    is_degenerate: Flags
    corner_sector: Indices
    sector_vertex: Indices

    @property
    def sector_count(self) -> int:
        """Number of sectors; equal to that of the used vertices where there are no creases."""
        return len(self.sector_vertex)

    @property
    def has_creases(self) -> bool:
        """Whether any vertex has more than one sector."""
        return bool((np.diff(self.sector_vertex) == 0).any())

    @property
    def sector_triangles(self) -> Indices:
        """(t, 3) sectors at the corners of the triangles: the connectivity of the cut mesh."""
        return self.corner_sector[self.mesh.triangle_corner]

    @cached_property
    def sector_position(self) -> Floats:
        """(s, 3) positions of the sectors, from the middle of the bounding box, in meters.

        Centered, so that a model far from the origin loses no digits.
        """
        position = self.mesh.vertices[self.sector_vertex]
        return position - 0.5 * (position.min(axis=0) + position.max(axis=0))

    @cached_property
    def sector_area(self) -> Floats:
        """(s,) the share of the polygons' area that belongs to each sector, in m²."""
        sizes = np.diff(self.mesh.polygon_start)
        share = np.repeat(self.polygon_area / sizes, sizes)
        return sum_by_group(self.corner_sector, share, self.sector_count)

    @cached_property
    def vertex_sector(self) -> Indices:
        """(n,) the sector with the largest angle at each vertex, -1 without faces."""
        leading = np.full(self.mesh.vertex_count, -1, dtype=np.int64)
        leading[self.sector_vertex] = np.arange(self.sector_count)
        # Angles need measuring only where creases give a vertex several sectors.
        several = np.bincount(self.sector_vertex, minlength=self.mesh.vertex_count) > 1
        corners = np.flatnonzero(several[self.mesh.corner_vertex])
        if len(corners):
            vertices = np.flatnonzero(several)
            leading[vertices] = leading_sectors(
                self.sector_vertex,
                self.corner_sector[corners],
                corner_angles(self.mesh, corners),
                self.mesh.vertex_count,
            )[vertices]
        return leading


def build_surface(mesh: PolygonMesh, crease_angle: float = DEFAULT_CREASE_ANGLE) -> Surface:
    """Cut a mesh along its creases.

    Parameters
    ----------
    mesh : PolygonMesh
        Positions in meters.
    crease_angle : float
        Dihedral angle in radians above which an edge is a crease. Edges that are marked sharp,
        have more than two faces, or two faces that disagree in winding are creases in any case.

    Returns
    -------
    Surface
    """
    vectors, areas = measure_polygons(mesh)
    is_degenerate = degenerate_polygons(mesh, areas)
    edges = find_edges(mesh, vectors, is_degenerate, crease_angle)
    corner_sector, sector_vertex = smooth_sectors(mesh, edges.smooth)
    return Surface(
        mesh=mesh,
        edges=edges,
        polygon_vector=vectors,
        polygon_area=areas,
        is_degenerate=is_degenerate,
        corner_sector=corner_sector,
        sector_vertex=sector_vertex,
    )
