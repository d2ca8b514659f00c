# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Guides: lines of the other family, along which the distances between lines are measured off."""

from __future__ import annotations

import numpy as np

from ..groups import connected_groups, sum_by_group
from .assembly import shifted
from .field import DirectionField, Family
from .lines import CurvatureLines
from .samples import close_pairs
from .seeding import course, samples_along
from .seeds import Seeds, make_seeds
from .tracer import LineField
from .vectors import dot

#: The family that crosses each one.
ACROSS = {
    Family.FIRST: Family.SECOND,
    Family.SECOND: Family.FIRST,
    Family.ASYMPTOTIC_LEFT: Family.ASYMPTOTIC_RIGHT,
    Family.ASYMPTOTIC_RIGHT: Family.ASYMPTOTIC_LEFT,
}
#: Lines no closer and no farther apart than this, over the spacing, neither end beside each other
#: nor leave room for others.
_CLOSEST, _FARTHEST = 0.53, 1.65
#: Most of the way between neighbors, over their distance, that may lead along them.
_BESIDE = 0.5
#: How far beside a line its neighbors are looked for, in spacings.
_REACH = 5.0
#: Smallest strength, over that of the typical sector, where guides start.
_STRONG = 0.5


def guide_seeds(lines: LineField, families: tuple[Family, ...]) -> Seeds:
    """Return a seed in the middle of every smooth part, for lines across the families."""
    field, mesh = lines.field, lines.field.mesh
    strength = field.strength
    if min(families) >= Family.ASYMPTOTIC_LEFT:
        strength = np.sqrt(np.maximum(strength**2 - field.mean**2, 0.0))
    strength = strength[mesh.triangles].min(axis=1)
    is_open = (lines.umbilics.triangle_area < 0) & (strength > 0.0)
    joined = (mesh.neighbor >= 0) & is_open[:, None] & is_open[mesh.neighbor]
    triangle, side = np.nonzero(joined)
    part = connected_groups(
        np.stack([triangle, mesh.neighbor[triangle, side]], axis=1), len(is_open)
    )
    count = int(part.max(initial=-1)) + 1
    area = sum_by_group(part, mesh.double_area, count)
    middle = mesh.position[mesh.triangles].mean(axis=1)
    center = (
        np.stack(
            [sum_by_group(part, mesh.double_area * middle[:, axis], count) for axis in range(3)],
            axis=1,
        )
        / np.maximum(area, 1e-300)[:, None]
    )
    typical = sum_by_group(part, mesh.double_area * strength, count) / np.maximum(area, 1e-300)
    away = np.linalg.norm(middle - center[part], axis=1)
    is_weak = strength < _STRONG * typical[part]
    order = np.lexsort((away, is_weak, part))
    first = order[np.flatnonzero(np.diff(part[order], prepend=-1))]
    # Only the largest parts: what is small is filled without a guide.
    first = first[is_open[first]]
    first = first[np.argsort(-area[part[first]])][:50]
    across = sorted({int(ACROSS[family]) for family in families})
    return make_seeds(
        np.tile(first, len(across)),
        np.full((len(first) * len(across), 3), 1.0 / 3.0),
        np.repeat(np.array(across, dtype=np.int64), len(first)),
    )


def measured_seeds(
    field: DirectionField,
    guides: CurvatureLines,
    families: tuple[Family, ...],
    spacing: dict[int, float],
) -> Seeds:
    """Return seeds at even distances along guides.

    Parameters
    ----------
    field : DirectionField
    guides : CurvatureLines
    families : tuple of Family
    spacing : dict
        Distance along guides in meters, by their family; what comes closest to it without a rest
        is taken.
    """
    wanted = np.isin(guides.family, [int(ACROSS[family]) for family in families])
    chosen = guides.chosen(np.flatnonzero(wanted))
    line = chosen.point_line
    arc, _ = course(chosen)
    length = chosen.length
    aim = np.array([spacing[int(family)] for family in chosen.family])
    number = np.maximum(1, np.round(length / aim))
    # On a guide from rim to rim the outer lines keep half a spacing to the rims.
    margin = np.where(chosen.is_closed, 0.0, 0.5)[line]
    pitch = (length / number)[line]
    step = arc / pitch + margin
    is_first = np.diff(line, prepend=-1) != 0
    is_due = (np.diff(np.floor(step), prepend=0.0) > 0.0) & ~is_first
    here = np.flatnonzero(is_due | (is_first & chosen.is_closed[line]))
    # Seeds lie between the points of guides, which may be far apart.
    before = np.where(is_first[here], here, here - 1)
    due = (np.floor(step) - margin)[here] * pitch[here]
    way = np.where(is_first[here], 0.0, np.maximum(due - arc[before], 0.0))
    across = np.zeros(1 + max(Family), dtype=np.int64)
    for one, other in ACROSS.items():
        across[one] = other
    triangle, barycentric = shifted(
        field,
        chosen.triangle[before],
        chosen.barycentric[before],
        chosen.points[here] - chosen.points[before],
        way,
    )
    return make_seeds(triangle, barycentric, across[chosen.family[line[here]]])


def balance(lines: LineField, crossing: CurvatureLines, spacing: float) -> float:
    """Return by how much to scale the distances of lines so that they never are close nor far.

    Parameters
    ----------
    lines : LineField
    crossing : CurvatureLines
        Lines of one family side by side, none of which has ended beside another.
    spacing : float
        Between lines, in meters.

    Returns
    -------
    float
        Lines that are at places closer than they may be, or so far apart that others would start
        between them, can do without both where they are scaled by this; 1 where they have to end
        or to start somewhere.
    """
    along = samples_along(lines.field, crossing, 0.5 * spacing, 0)
    sample, other = close_pairs(along, along, spacing, _REACH * spacing, 48)
    apart = along.position[other] - along.position[sample]
    distance = np.sqrt(dot(apart, apart))
    is_beside = along.line[sample] != along.line[other]
    is_beside &= np.abs(dot(apart, along.heading[sample])) < _BESIDE * distance
    nearest = np.full(len(along), np.inf)
    np.minimum.at(nearest, sample[is_beside], distance[is_beside])
    nearest = nearest[np.isfinite(nearest)]
    if not len(nearest):
        return 1.0
    least, most = float(nearest.min()) / spacing, float(nearest.max()) / spacing
    is_even = least >= _CLOSEST and most <= _FARTHEST
    if is_even or most / max(least, 1e-9) > _FARTHEST / _CLOSEST:
        return 1.0
    return float(np.sqrt(_CLOSEST * _FARTHEST / (least * most)))
