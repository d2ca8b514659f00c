# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Umbilics: points and areas where the principal curvatures are equal, with their index.

The index is how often the principal directions turn while one walks around. On a closed surface
the indices of all points and areas add up to its Euler characteristic, exactly, because the turns
along sides cancel and what is left of the angles is the total curvature. On a surface with rims
every smooth piece has that sum less the turns of the directions along its outline.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum

import numpy as np

from ..groups import connected_groups, sum_by_group
from ..types import Flags, Floats, Indices
from .areas import Areas, extent
from .calming import half_indices
from .field import WEAK, DirectionField
from .joint_index import with_joint_index
from .linear_zero import Zeros, find_zeros
from .transport import Transport

#: Zeros this many edges from the middle of them all are no point.
_POINT = 3.0
#: Areas that reach no farther than this share of the diagonal from their middle have no room for a
#: line: half of a panel of the usual size.
_ROOM = 1.0 / 40.0


class UmbilicKind(IntEnum):
    """Pattern of the lines around an umbilic, after Darboux."""

    LEMON = 1
    """Index 1/2, one straight line of each family runs into it."""
    MONSTAR = 2
    """Index 1/2, three straight lines of each family run into it."""
    STAR = 3
    """Index -1/2, three lines of each family run into it."""
    OTHER = 4
    """Any other index: several umbilics in one, as at the poles of a surface of revolution."""


@dataclass(frozen=True)
class Umbilics:
    """Umbilic points and areas of a direction field.

    Parameters
    ----------
    position : (u, 3) float64
        Points in the mesh's coordinates, in meters.
    triangle : (u,) int64
        Triangle that holds each point.
    barycentric : (u, 3) float64
        Place in it.
    index : (u,) float64
        Multiples of 1/2, never 0.
    kind : (u,) int64
        Values of `UmbilicKind`.
    rays : (u, 3, 3) float64
        Unit tangents in which lines of the first family leave the point; lines of the second leave
        the opposite way. As many as the kind has, then zeros.
    triangle_area : (t,) int64
        Umbilic area of each triangle, -1 for none.
    area_index : (a,) float64
        Index of each area: the turn of the directions around it, or 0 for an area that reaches a
        rim or a crease, around which one cannot walk. Of these all that are too small for a line
        are one area together: on a mesh with creases everywhere there are hundreds. On a closed
        surface the largest area at a crease has the index of them all, or one without triangles
        for the creases themselves; see `with_joint_index`.
    area_size : (a,) float64
        In m²; 0 for creases.
    """

    position: Floats
    triangle: Indices
    barycentric: Floats
    index: Floats
    kind: Indices
    rays: Floats
    triangle_area: Indices
    area_index: Floats
    area_size: Floats

    @property
    def count(self) -> int:
        """Number of isolated umbilics."""
        return len(self.index)

    @property
    def total_index(self) -> float:
        """Sum of the indices; the Euler characteristic of a closed surface."""
        return float(self.index.sum() + self.area_index.sum())


def find_umbilics(field: DirectionField, transport: Transport, areas: Areas) -> Umbilics:
    """Return the umbilic points and areas of a field.

    Parameters
    ----------
    field : DirectionField
    transport : Transport
    areas : Areas

    Returns
    -------
    Umbilics
    """
    mesh = field.mesh
    index = 0.5 * half_indices(transport, transport.turn(field.deviator))
    triangle_area, area_count = _gathered(field, areas)
    is_inside = triangle_area >= 0
    area_index = sum_by_group(triangle_area[is_inside], index[is_inside], area_count)
    # Around an area that reaches the outline of the surface one cannot walk.
    has_outline: Flags = np.any(mesh.neighbor < 0, axis=1)
    is_open = is_inside & has_outline
    reaches = np.zeros(area_count, dtype=np.bool_)
    reaches[triangle_area[is_open]] = True
    area_index[reaches] = 0.0
    area_size = 0.5 * sum_by_group(
        triangle_area[is_inside], mesh.double_area[is_inside], area_count
    )
    half = np.rint(2.0 * index).astype(np.int64)
    half[is_inside] = 0
    zeros = _grouped(field, find_zeros(field, np.flatnonzero(half)), half, areas.zone)
    area_index, area_size = with_joint_index(
        field.surface.sector_vertex[mesh.triangles],
        (zeros.triangle, zeros.index),
        (triangle_area, 0.5 * np.round(2.0 * area_index), area_size),
        reaches,
        has_outline,
    )
    return Umbilics(
        position=mesh.points(zeros.triangle, zeros.barycentric),
        triangle=zeros.triangle,
        barycentric=zeros.barycentric,
        index=zeros.index,
        kind=_kinds(zeros),
        rays=zeros.rays,
        triangle_area=triangle_area,
        area_index=area_index,
        area_size=area_size,
    )


def _gathered(field: DirectionField, areas: Areas) -> tuple[Indices, int]:
    """Return the area of every triangle, with small ones at creases in one, and the count."""
    mesh = field.mesh
    inside = np.flatnonzero(areas.triangle_area >= 0)
    area = areas.triangle_area[inside]
    corner = mesh.position[mesh.triangles[inside]].reshape(-1, 3)
    reach = extent(np.repeat(area, 3), corner, areas.count)
    is_small = reach < _ROOM * field.surface.mesh.diagonal
    has_outline = np.zeros(areas.count, dtype=np.bool_)
    has_outline[area[(mesh.neighbor[inside] < 0).any(axis=1)]] = True
    is_scrap = is_small & has_outline
    if not is_scrap.any():
        return areas.triangle_area, areas.count
    number = np.cumsum(~is_scrap) - 1
    number[is_scrap] = number[-1] + 1
    triangle_area = areas.triangle_area.copy()
    triangle_area[inside] = number[area]
    return triangle_area, int((~is_scrap).sum()) + 1


def _grouped(field: DirectionField, zeros: Zeros, half: Indices, zone: Indices) -> Zeros:
    """Return zeros with those that noise cannot tell apart taken together.

    Zeros in one doubtful zone, or in triangles that share a weak corner, with indices that cancel
    are none. Those of a group too large to be a point stay apart.
    """
    triangle = zeros.triangle
    corner = field.mesh.triangles[triangle]
    count = field.mesh.sector_count
    # Sectors, zones and zeros are items of one list, and linked.
    zones = int(zone.max(initial=-1)) + 1
    item = count + zones + np.arange(len(triangle))
    is_weak = field.confidence < WEAK
    meeting = np.where(zone >= 0, count + zone, np.where(is_weak, np.arange(count), -1))[corner]
    zero, place = np.nonzero(meeting >= 0)
    links = np.stack([item[zero], meeting[zero, place]], axis=1)
    group = connected_groups(links, count + zones + len(triangle))[item]
    middle = field.mesh.position[corner].mean(axis=1)
    size = extent(group, middle, count + zones + len(triangle))
    group = np.where(size[group] > _POINT * field.mesh.edge_length, item, group)
    names, number = np.unique(group, return_inverse=True)
    number = number.reshape(-1)
    total = sum_by_group(number, half[triangle].astype(np.float64), len(names))
    # Of a group, the zero of its sign with the least strength around stands for all.
    wrong_sign = half[triangle] * total[number] <= 0.0
    size = field.strength[corner].max(axis=1)
    order = np.lexsort((size, wrong_sign, number))
    first = order[np.flatnonzero(np.diff(number[order], prepend=-1))] if len(order) else order
    chosen = first[total != 0.0]
    return zeros.chosen(chosen, 0.5 * total[total != 0.0])


def _kinds(zeros: Zeros) -> Indices:
    """Return the kind of each zero, (u,) int64."""
    has_three: Flags = (zeros.rays[:, 2] != 0.0).any(axis=1)
    lemon = np.where(has_three, UmbilicKind.MONSTAR, UmbilicKind.LEMON)
    kind = np.where(zeros.index > 0.0, lemon, UmbilicKind.STAR)
    return np.where(np.abs(zeros.index) == 0.5, kind, UmbilicKind.OTHER).astype(np.int64)
