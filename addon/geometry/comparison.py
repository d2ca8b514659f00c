# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Two segmentations side by side: what a design change did to the areas."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .classification import SurfaceClass
from .groups import sum_by_group
from .types import Floats, Indices


@dataclass(frozen=True)
class ClassChange:
    """Area of one class in m² and its share, before and after, and the number of regions."""

    area: tuple[float, float]
    share: tuple[float, float]
    regions: tuple[int, int]

    @property
    def gain(self) -> float:
        """Area in m² that the class has won, negative if it has lost."""
        return self.area[1] - self.area[0]


def class_areas(face_class: Indices, areas: Floats) -> Floats:
    """Return the area of every class in m², (5,) in the order of `SurfaceClass`."""
    classes = list(SurfaceClass)
    return sum_by_group(face_class - classes[0], areas, len(classes))


def compare(
    before: tuple[Floats, Indices], after: tuple[Floats, Indices]
) -> dict[SurfaceClass, ClassChange]:
    """Return what changed from one segmentation to another, of the same mesh or not.

    Parameters
    ----------
    before, after : pair of (5,) float64 and (5,) int64
        Areas in m² and numbers of regions per class, in the order of `SurfaceClass`.

    Returns
    -------
    dict
        One `ClassChange` per class.
    """
    totals = [float(np.sum(areas)) or 1.0 for areas, _ in (before, after)]
    return {
        surface_class: ClassChange(
            area=(float(before[0][i]), float(after[0][i])),
            share=(float(before[0][i]) / totals[0], float(after[0][i]) / totals[1]),
            regions=(int(before[1][i]), int(after[1][i])),
        )
        for i, surface_class in enumerate(SurfaceClass)
    }
