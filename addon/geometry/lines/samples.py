# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Points along lines and how close they come to each other."""

from __future__ import annotations

from dataclasses import dataclass, fields, replace
from typing import Self, TypeVar

import numpy as np

from ..types import Flags, Floats, Indices
from .field import DirectionField
from .seeds import Seeds
from .vectors import dot, unit

Kind = TypeVar("Kind", bound="Trail")

#: Least cosine between the normals of places that can be neighbors: the far side of a thin shell is
#: far away, but not that of an edge rounded off.
_SAME_SIDE = -0.5
#: Normals count as positions this many spacings long in the search for neighbors, so that it finds
#: few that are none.
_NORMAL = 0.25
#: Most samples among which the closest one is looked for.
_CANDIDATES = 4
#: Half of the widest gap between lines that all close, in spacings, and the cosine of the angle
#: under which both are seen from a place between them.
_GAP, _OPPOSITE = 1.25, -0.5
#: Families count as positions this many spacings apart.
_FAMILY = 1e3


@dataclass(frozen=True)
class Trail:
    """Places that lines went through, in the order in which they were reached.

    Parameters
    ----------
    arm : (p,) int64
        Half of a line: twice the line's number, one more for the half that ran backward.
    arc : (p,) float64
        Way from the seed in meters.
    triangle : (p,) int64
    barycentric : (p, 3) float64
    heading : (p, 3) float64
        Unit direction in which the place was reached.
    family : (p,) int64
    """

    arm: Indices
    arc: Floats
    triangle: Indices
    barycentric: Floats
    heading: Floats
    family: Indices

    def __len__(self) -> int:
        """Return the number of places."""
        return len(self.arm)

    @property
    def line(self) -> Indices:
        """(p,) line of each place."""
        return self.arm // 2

    @property
    def signed_arc(self) -> Floats:
        """(p,) way along the line, negative behind the seed."""
        return (self.arc * (1 - 2 * (self.arm % 2))).astype(np.float64)

    def chosen(self, items: Indices | Flags) -> Self:
        """Return some of the places: by numbers or flags."""
        # Their values in the order of the fields; to ask for these takes longer than to choose.
        return type(self)(*(values[items] for values in vars(self).values()))


@dataclass(frozen=True)
class Samples(Trail):
    """Places with their positions.

    Parameters
    ----------
    position : (p, 3) float64
        In meters, from the middle of the bounding box.
    normal : (p, 3) float64
        Of any length.
    """

    position: Floats
    normal: Floats

    def keys(self, spacing: float) -> Floats:
        """Return points no closer to each other than the samples are, (p, 7)."""
        direction = _NORMAL * spacing * unit(self.normal)
        family = (_FAMILY * spacing * self.family[:, None]).astype(np.float64)
        return np.concatenate([self.position, direction, family], axis=1)

    def by_line(self) -> Samples:
        """Return the samples with every line for a family: neighbors are those of its own line."""
        return replace(self, family=self.line)


def take_samples(field: DirectionField, trail: Trail) -> Samples:
    """Return places with their positions and normals looked up."""
    corner = field.mesh.triangles[trail.triangle]
    weight = trail.barycentric
    return Samples(
        *(getattr(trail, each.name) for each in fields(Trail)),
        position=np.einsum("nc,ncx->nx", weight, field.mesh.position[corner]),
        normal=np.einsum("nc,ncx->nx", weight, field.normal[corner]),
    )


def seed_samples(field: DirectionField, seeds: Seeds) -> Samples:
    """Return where lines start, each on a line of its own."""
    count = len(seeds)
    return take_samples(
        field,
        Trail(
            2 * np.arange(count),
            np.zeros(count),
            seeds.triangle,
            seeds.barycentric,
            seeds.heading,
            seeds.family,
        ),
    )


def joined(parts: list[Kind]) -> Kind:
    """Return several sets of places or samples in one."""
    kind = type(parts[0])
    names = [each.name for each in fields(kind)]
    return kind(*(np.concatenate([getattr(part, name) for part in parts]) for name in names))


def no_trail() -> Trail:
    """Return no places."""
    none = np.zeros(0, dtype=np.int64)
    return Trail(none, np.zeros(0), none, np.zeros((0, 3)), np.zeros((0, 3)), none)


def close_pairs(
    samples: Samples, others: Samples, spacing: float, reach: float, count: int
) -> tuple[Indices, Indices]:
    """Return pairs of samples closer than a distance.

    Parameters
    ----------
    samples, others : Samples
    spacing : float
        Between lines, in meters.
    reach : float
        Largest distance in meters.
    count : int
        Most partners of each sample, the closest ones.

    Returns
    -------
    sample, other : (q,) int64
    """
    sample, other, away = _searched(samples, others, spacing, reach, count)
    is_close = away < reach
    return sample[is_close], other[is_close]


def distances(samples: Samples, others: Samples, spacing: float, reach: float) -> Floats:
    """Return the distance to the closest of other samples, inf beyond a reach, (p,) in meters."""
    sample, _, away = _searched(samples, others, spacing, reach, _CANDIDATES)
    distance = np.full(len(samples), np.inf)
    np.minimum.at(distance, sample, np.where(away < reach, away, np.inf))
    return distance


def are_between(samples: Samples, rings: Samples, spacing: float) -> Flags:
    """Return the samples with one of two lines on either side of them, (p,) bool.

    Parameters
    ----------
    samples : Samples
    rings : Samples
        Of the lines.
    spacing : float
        In meters. Lines farther away than somewhat more do not count.
    """
    sample, other, away = _searched(samples, rings, spacing, _GAP * spacing, 4 * _CANDIDATES)
    is_close = away < _GAP * spacing
    sample, other, away = sample[is_close], other[is_close], away[is_close]
    first = np.lexsort((away, sample))
    first = first[np.flatnonzero(np.diff(sample[first], prepend=-1))]
    nearest = np.full(len(samples), -1, dtype=np.int64)
    nearest[sample[first]] = other[first]
    closest = nearest[sample]
    one = rings.position[closest] - samples.position[sample]
    two = rings.position[other] - samples.position[sample]
    cosine = dot(unit(one), unit(two))
    is_across = (cosine < _OPPOSITE) & (rings.line[closest] != rings.line[other])
    found = np.zeros(len(samples), dtype=np.bool_)
    found[sample[is_across]] = True
    return found


def _searched(
    samples: Samples, others: Samples, spacing: float, reach: float, count: int
) -> tuple[Indices, Indices, Floats]:
    """Return pairs on the same side of the surface and their distances in space."""
    if not (len(samples) and len(others)):
        return np.zeros(0, dtype=np.int64), np.zeros(0, dtype=np.int64), np.zeros(0)
    from scipy.spatial import cKDTree

    tree = cKDTree(others.keys(spacing), balanced_tree=False, compact_nodes=False)
    number = min(count, len(others))
    # Keys of neighbors differ by their normals too: by as much as normals on one side can.
    bound = np.hypot(reach, _NORMAL * spacing * np.sqrt(2.0 - 2.0 * _SAME_SIDE))
    found = tree.query(samples.keys(spacing), k=number, distance_upper_bound=bound)[1]
    found = np.asarray(found, dtype=np.int64).reshape(-1, number)
    sample, column = np.nonzero(found < len(others))
    other = found[sample, column]
    one, two = samples.normal[sample], others.normal[other]
    length = np.sqrt(dot(one, one) * dot(two, two))
    is_beside = dot(one, two) >= _SAME_SIDE * length
    sample, other = sample[is_beside].astype(np.int64), other[is_beside]
    apart = samples.position[sample] - others.position[other]
    return sample, other, np.sqrt(dot(apart, apart))
