# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Points along lines and how close they come to each other."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Self, TypeVar

import numpy as np

from ..types import Flags, Floats, Indices
from .field import DirectionField
from .seeds import Seeds
from .vectors import unit

Kind = TypeVar("Kind", bound="Trail")

#: Normals count as positions this many spacings long: the far side of a thin shell is far away.
_NORMAL = 0.5
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
        return type(self)(*(getattr(self, each.name)[items] for each in fields(self)))


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
        """Return points whose distance is that of the samples on their surface, (p, 7)."""
        direction = _NORMAL * spacing * unit(self.normal)
        family = (_FAMILY * spacing * self.family[:, None]).astype(np.float64)
        return np.concatenate([self.position, direction, family], axis=1)


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
    if not (len(samples) and len(others)):
        return np.zeros(0, dtype=np.int64), np.zeros(0, dtype=np.int64)
    from scipy.spatial import cKDTree

    tree = cKDTree(others.keys(spacing), balanced_tree=False, compact_nodes=False)
    number = min(count, len(others))
    found = tree.query(samples.keys(spacing), k=number, distance_upper_bound=reach)[1]
    found = np.asarray(found, dtype=np.int64).reshape(-1, number)
    sample, column = np.nonzero(found < len(others))
    return sample.astype(np.int64), found[sample, column]


def distances(samples: Samples, others: Samples, spacing: float, reach: float) -> Floats:
    """Return the distance to the closest of other samples, inf beyond a reach, (p,) in meters."""
    if not (len(samples) and len(others)):
        return np.full(len(samples), np.inf)
    from scipy.spatial import cKDTree

    tree = cKDTree(others.keys(spacing), balanced_tree=False, compact_nodes=False)
    found = tree.query(samples.keys(spacing), k=1, distance_upper_bound=reach)[0]
    return np.asarray(found, dtype=np.float64)
