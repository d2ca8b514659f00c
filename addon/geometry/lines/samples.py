# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Points along lines and how close they come to each other."""

from __future__ import annotations

from dataclasses import dataclass, fields

import numpy as np

from ..types import Floats, Indices
from .field import DirectionField

#: Normals count as positions this many spacings long: the far side of a thin shell is far away.
_NORMAL = 0.5
#: Families count as positions this many spacings apart.
_FAMILY = 1e3


@dataclass(frozen=True)
class Samples:
    """Points of lines in the order in which they were reached.

    Parameters
    ----------
    arm : (p,) int64
        Half of a line: twice the line's number, one more for the half that ran backward.
    arc : (p,) float64
        Way from the seed in meters.
    triangle : (p,) int64
    barycentric : (p, 3) float64
    position : (p, 3) float64
        In meters, from the middle of the bounding box.
    normal : (p, 3) float64
        Of any length.
    heading : (p, 3) float64
        Unit direction in which the point was reached.
    family : (p,) int64
    """

    arm: Indices
    arc: Floats
    triangle: Indices
    barycentric: Floats
    position: Floats
    normal: Floats
    heading: Floats
    family: Indices

    def __len__(self) -> int:
        """Return the number of points."""
        return len(self.arm)

    @property
    def line(self) -> Indices:
        """(p,) line of each point."""
        return self.arm // 2

    @property
    def signed_arc(self) -> Floats:
        """(p,) way along the line, negative behind the seed."""
        return np.where(self.arm % 2 == 0, self.arc, -self.arc)

    def chosen(self, items: object) -> Samples:
        """Return some of the points: by numbers or flags."""
        return Samples(*(getattr(self, each.name)[items] for each in fields(self)))

    def keys(self, spacing: float) -> Floats:
        """Return points whose distance is that of the samples on their surface, (p, 7)."""
        size = np.sqrt((self.normal**2).sum(axis=1) + 1e-300)[:, None]
        return np.concatenate(
            [
                self.position,
                _NORMAL * spacing * self.normal / size,
                _FAMILY * spacing * self.family[:, None],
            ],
            axis=1,
        )


def take_samples(
    field: DirectionField,
    arm: Indices,
    arc: Floats,
    triangle: Indices,
    barycentric: Floats,
    heading: Floats,
    family: Indices,
) -> Samples:
    """Return samples with their positions and normals looked up."""
    corner = field.mesh.triangles[triangle]
    return Samples(
        arm=arm.copy(),
        arc=arc.copy(),
        triangle=triangle.copy(),
        barycentric=barycentric.copy(),
        position=np.einsum("nc,ncx->nx", barycentric, field.mesh.position[corner]),
        normal=np.einsum("nc,ncx->nx", barycentric, field.normal[corner]),
        heading=heading.copy(),
        family=family.copy(),
    )


def join_samples(parts: list[Samples]) -> Samples:
    """Return several sets of samples in one."""
    return Samples(
        *(np.concatenate([getattr(part, each.name) for part in parts]) for each in fields(Samples))
    )


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
