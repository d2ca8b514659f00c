# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Umbilic areas: parts without principal directions, which lines end at.

They are flat and spherical parts, and seams: curves along which the principal curvatures change
places, as where the profile of a vault turns from convex to concave. Beside a seam one of the two
bends of the surface is first the larger and then the smaller one, so that the directions of k1 and
of k2 swap: a line that went on along its own family would turn by 90 degrees.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..groups import connected_groups, sum_by_group
from ..types import Flags, Floats, Indices
from .field import DOUBTFUL, DirectionField
from .transport import Transport
from .triangulation import Triangulation

#: A doubtful zone no larger than this many edges or this share of the diagonal is a point.
_POINT_EDGES, _POINT_SHARE = 1.5, 0.07
#: A zone that reaches this many radii of a point from its middle is none, however narrow.
_LONG = 2.0
#: Strength over the tolerance up to which what touches an area belongs to it: the limit is crossed
#: once, not again at every ripple.
_RIPPLE = 3.0
#: Turn of the deviator along a side, in radians, from which the directions swap there, by 60
#: degrees and more; and from which a side belongs to a seam most of whose sides do.
_SWAP, _BEND = 2.0 * np.pi / 3.0, np.pi / 2.0
#: Radius of a seam over the typical side that crosses it; around umbilic points it is one.
_SEAM = 2.5
#: Sides at an outline or an area that a shorter seam has at least: one at each end.
_THROUGH = 2


@dataclass(frozen=True)
class Areas:
    """Parts without directions.

    Parameters
    ----------
    triangle_area : (t,) int64
        Number of the umbilic area of each triangle, -1 for none.
    count : int
        Number of areas.
    is_void : (s,) bool
        Sectors of areas, whose directions mean nothing.
    zone : (s,) int64
        Number of the small doubtful zone, which holds an umbilic or nothing, of each sector; -1
        elsewhere.
    """

    triangle_area: Indices
    count: int
    is_void: Flags
    zone: Indices


def find_areas(field: DirectionField, transport: Transport) -> Areas:
    """Return the umbilic areas of a field, and the small zones in which it is doubtful.

    Parameters
    ----------
    field : DirectionField
    transport : Transport
        Of its mesh and normals.

    Returns
    -------
    Areas
    """
    mesh = field.mesh
    is_doubtful = (field.confidence <= DOUBTFUL) | ~field.is_defined
    radius = _point_radius(field, is_doubtful)
    group = _sector_groups(mesh, is_doubtful)
    is_void = _grown(field, is_doubtful & _is_large(field, group, radius)[group])
    in_area = is_void[mesh.triangles].any(axis=1)
    seam = _seams(field, transport, is_void, is_doubtful, radius)
    in_area |= seam
    in_area |= _islands(field, in_area)
    is_void[mesh.triangles[in_area & ~seam]] = True
    triangle_area, count = _numbered(mesh, in_area)
    zone = np.unique(group, return_inverse=True)[1]
    is_point = is_doubtful & ~is_void
    is_point[mesh.triangles[in_area]] = False
    return Areas(triangle_area, count, is_void, np.where(is_point, zone.reshape(-1), -1))


def _point_radius(field: DirectionField, is_doubtful: Flags) -> float:
    """Return the radius in meters up to which a zone is taken for a point."""
    diagonal = field.surface.mesh.diagonal
    typical = float(np.median(field.doubt[is_doubtful])) if is_doubtful.any() else field.tolerance
    share = min(typical * diagonal, _POINT_SHARE)
    return max(_POINT_EDGES * field.mesh.edge_length, share * diagonal)


def _sector_groups(mesh: Triangulation, flags: Flags) -> Indices:
    """Return the connected group of every flagged sector; all others are alone, (s,) int64."""
    start, end = mesh.triangles, np.roll(mesh.triangles, -1, axis=1)
    inside = flags[start] & flags[end]
    return connected_groups(np.stack([start[inside], end[inside]], axis=1), mesh.sector_count)


def _is_large(field: DirectionField, group: Indices, radius: float) -> Flags:
    """Return the groups of doubtful sectors that are no points, (g,) bool."""
    mesh = field.mesh
    count = int(group.max(initial=-1)) + 1
    area = sum_by_group(group, field.surface.sector_area, count)
    radii = extent(group, mesh.position, count)
    # Nothing around it says what the directions were: a whole plane between creases.
    is_alone = np.ones(count, dtype=np.bool_)
    at_corner = group[mesh.triangles]
    is_alone[at_corner[(at_corner != at_corner[:, :1]).any(axis=1)]] = False
    return (area > np.pi * radius**2) | (radii > _LONG * radius) | is_alone


def extent(group: Indices, points: Floats, count: int) -> Floats:
    """Return the largest distance of a group's points from their middle, (count,) in meters."""
    members = np.maximum(np.bincount(group, minlength=count), 1)
    middle = np.stack(
        [sum_by_group(group, points[:, axis], count) / members for axis in range(3)], axis=1
    )
    radii = np.zeros(count)
    np.maximum.at(radii, group, np.linalg.norm(points - middle[group], axis=1))
    return radii


def _grown(field: DirectionField, is_core: Flags) -> Flags:
    """Return the sectors of areas with those weak ones around that are connected to them."""
    is_weak = is_core | (field.strength <= _RIPPLE * field.tolerance)
    group = _sector_groups(field.mesh, is_weak)
    has_core = np.zeros(field.mesh.sector_count, dtype=np.bool_)
    has_core[group[is_core]] = True
    return is_weak & has_core[group]


def _seams(
    field: DirectionField,
    transport: Transport,
    is_void: Flags,
    is_doubtful: Flags,
    radius: float,
) -> Flags:
    """Return the triangles between rows of sectors whose directions swap, (t,) bool."""
    mesh = field.mesh
    start, end = mesh.triangles, np.roll(mesh.triangles, -1, axis=1)
    is_open = is_doubtful[start] | is_doubtful[end]
    turn = np.abs(transport.turn(field.deviator))
    is_crossed = ((turn > _BEND) | is_open) & ~(is_void[start] | is_void[end])
    triangle, corner = np.nonzero(is_crossed)
    # The side from corner c to the next lies opposite to corner c + 2.
    beyond = mesh.neighbor[triangle, (corner + 2) % 3]
    inside = beyond >= 0
    links = np.stack([triangle, beyond], axis=1)[inside]
    group = connected_groups(links, len(start))
    ends = mesh.position[start[triangle, corner]], mesh.position[end[triangle, corner]]
    count = int(group.max(initial=-1)) + 1
    radii = extent(group[triangle], 0.5 * (ends[0] + ends[1]), count)
    number = np.bincount(group[triangle], minlength=count)
    length = np.linalg.norm(ends[1] - ends[0], axis=1)
    typical = sum_by_group(group[triangle], length, count) / np.maximum(number, 1)
    # Where directions are doubtful too, it may be a point whose surroundings are resolved.
    has_doubt = (
        sum_by_group(group[triangle], is_open[triangle, corner].astype(np.float64), count) > 0.0
    )
    least = np.where(has_doubt, np.maximum(_SEAM * typical, _LONG * radius), _SEAM * typical)
    # A short one parts a narrow piece from one side to the other.
    is_end = (beyond < 0) | is_void[start[triangle]].any(axis=1)
    through = sum_by_group(group[triangle], is_end.astype(np.float64), count) >= _THROUGH
    # Where noise is all that there is, turns prove nothing.
    is_noise = is_doubtful & (field.uncertainty > field.tolerance)
    is_sure = ~(is_noise[start] | is_noise[end])[triangle, corner]
    through &= sum_by_group(group[triangle], is_sure.astype(np.float64), count) > 0.0
    is_swap = ((turn > _SWAP) | is_open)[triangle, corner]
    swaps = sum_by_group(group[triangle], is_swap.astype(np.float64), count)
    is_whole = ((radii > least) | through) & (swaps > 0.5 * number)
    is_seam = np.zeros(len(start), dtype=np.bool_)
    is_seam[triangle] = is_whole[group[triangle]]
    return is_seam


def _islands(field: DirectionField, in_area: Flags) -> Flags:
    """Return the triangles outside of areas that these leave no room for directions, (t,) bool.

    They are connected parts whose directions are hardly stronger than what does not count.
    """
    mesh = field.mesh
    group, count = _triangle_groups(mesh, ~in_area)
    strength = field.strength[mesh.triangles].max(axis=1)
    strongest = np.zeros(count)
    np.maximum.at(strongest, group, strength)
    touches = np.zeros(count, dtype=np.bool_)
    triangle, side = np.nonzero(mesh.neighbor >= 0)
    is_beside = in_area[mesh.neighbor[triangle, side]]
    touches[group[triangle[is_beside]]] = True
    return ~in_area & (touches & (strongest <= _RIPPLE**2 * field.tolerance))[group]


def _triangle_groups(mesh: Triangulation, flags: Flags) -> tuple[Indices, int]:
    """Return the connected part of flagged triangles that each belongs to, and the count of all."""
    triangle, side = np.nonzero((mesh.neighbor >= 0) & flags[:, None] & flags[mesh.neighbor])
    group = connected_groups(
        np.stack([triangle, mesh.neighbor[triangle, side]], axis=1), len(flags)
    )
    return group, int(group.max(initial=-1)) + 1


def _numbered(mesh: Triangulation, in_area: Flags) -> tuple[Indices, int]:
    """Return the number of the area of every triangle, -1 for none, and how many there are."""
    group, _ = _triangle_groups(mesh, in_area)
    names, number = np.unique(group[in_area], return_inverse=True)
    triangle_area = np.full(len(in_area), -1, dtype=np.int64)
    triangle_area[in_area] = number.reshape(-1)
    return triangle_area, len(names)
