# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Guides: lines of the other family, along which the distances between lines are measured off."""

from __future__ import annotations

import numpy as np

from ..groups import connected_groups, sum_by_group
from ..types import Floats, Indices
from .assembly import shifted
from .field import DirectionField, Family
from .lines import CurvatureLines
from .samples import close_pairs
from .seeding import course, samples_along
from .seeds import Seeds, make_seeds
from .tracer import LineField
from .vectors import dot, unit

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
#: The same of lines that all close, which are worth it: around a fat torus none could otherwise.
_RINGS_CLOSEST, _RINGS_FARTHEST = 0.33, 1.95
#: Share of the places along lines that are no farther apart than what counts as the farthest.
_ALL = 0.98
#: Most of the way between neighbors, over their distance, that may lead along them.
_BESIDE = 0.5
#: How far beside a line its neighbors are looked for, in spacings.
_REACH = 7.0
#: Least number of places on each line.
_PLACES = 12
#: Smallest strength, over that of the typical sector, where guides start.
_STRONG = 0.5


def guide_seeds(lines: LineField, families: tuple[Family, ...]) -> tuple[Seeds, Indices]:
    """Return a seed in the middle of every smooth part, for lines across the families.

    Also the part of every triangle, (t,) int64.
    """
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
    ), part


def measured_seeds(
    field: DirectionField,
    guides: CurvatureLines,
    families: tuple[Family, ...],
    spacing: float,
    scale: Floats,
    fewest: int = 1,
) -> Seeds:
    """Return seeds at even distances along guides.

    Parameters
    ----------
    field : DirectionField
    guides : CurvatureLines
    families : tuple of Family
    spacing : float
        Distance along guides in meters; what comes closest to it without a rest is taken.
    scale : (g,) float64
        By how much to scale that for each guide.
    fewest : int
        Least number of seeds along a guide that has more than one.
    """
    wanted = np.flatnonzero(np.isin(guides.family, [int(ACROSS[family]) for family in families]))
    chosen = guides.chosen(wanted)
    line = chosen.point_line
    arc, _ = course(chosen)
    length = chosen.length
    number = np.maximum(1, np.round(length / spacing))
    number = np.where(number > 1, np.maximum(fewest, np.round(number / scale[wanted])), 1)
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


def balance(
    lines: LineField, crossing: CurvatureLines, spacing: float, share: float
) -> tuple[float, bool]:
    """Return by how much to scale the distances of lines so that they never are close nor far.

    Parameters
    ----------
    lines : LineField
    crossing : CurvatureLines
        Lines of one family side by side, none of which has ended beside another.
    spacing : float
        Between lines, in meters.
    share : float
        Distance along guides at which they start, over that which the scale is for.

    Returns
    -------
    scale : float
        Lines that are at places closer than they may be, or so far apart that others would start
        between them, can do without both where they are scaled by this; 1 where they have to end
        or to start somewhere.
    is_whole : bool
        Whether they all close when they are scaled, and none belongs between them.
    """
    pitch = share * spacing
    # On rings of a thin pipe there must be some places beside each other.
    step = min(0.5 * pitch, float(crossing.length.min(initial=np.inf)) / _PLACES)
    along = samples_along(lines.field, crossing, step, 0)
    sample, other = close_pairs(along, along, pitch, _REACH * pitch, 64)
    apart = along.position[other] - along.position[sample]
    distance = np.sqrt(dot(apart, apart))
    is_beside = along.line[sample] != along.line[other]
    is_beside &= np.abs(dot(apart, along.heading[sample])) < _BESIDE * distance
    sample, other, distance = sample[is_beside], other[is_beside], distance[is_beside]
    # The way around from one to the other, as on the circle that has both normals.
    cosine = dot(unit(along.normal[sample]), unit(along.normal[other]))
    half = np.sqrt(np.clip(0.5 - 0.5 * cosine, 0.0, 1.0))
    around = distance * np.arcsin(half) / np.maximum(half, 1e-9)
    around[half < 1e-9] = distance[half < 1e-9]
    nearest, farther = np.full(len(along), np.inf), np.full(len(along), np.inf)
    np.minimum.at(nearest, sample, distance)
    np.minimum.at(farther, sample, around)
    is_closed = crossing.count > 0 and bool(crossing.is_closed.all())
    if not len(sample):
        return 1.0, is_closed
    least = float(nearest.min()) / pitch
    most = float(np.quantile(farther[np.isfinite(farther)], _ALL)) / pitch
    most = max(most, least)
    if least >= _CLOSEST and most <= _FARTHEST:
        return 1.0, is_closed
    spread = most / max(least, 1e-9)
    if spread <= _FARTHEST / _CLOSEST:
        return float(np.sqrt(_CLOSEST * _FARTHEST / (least * most))), is_closed
    if is_closed and spread <= _RINGS_FARTHEST / _RINGS_CLOSEST:
        return _RINGS_FARTHEST / most, True
    return 1.0, False
