# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Points from which lines are traced."""

from __future__ import annotations

from dataclasses import dataclass, fields

import numpy as np

from ..types import Flags, Floats, Indices


@dataclass(frozen=True)
class Seeds:
    """Where lines start, the most important first.

    Parameters
    ----------
    triangle : (n,) int64
    barycentric : (n, 3) float64
    family : (n,) int64
        Values of `Family`.
    umbilic : (n,) int64
        Umbilic that a line comes from, which then has a forward arm only; -1 for none.
    heading : (n, 3) float64
        Direction of the forward arm, of any length; zero for either.
    """

    triangle: Indices
    barycentric: Floats
    family: Indices
    umbilic: Indices
    heading: Floats

    def __len__(self) -> int:
        """Return the number of seeds."""
        return len(self.triangle)

    def chosen(self, items: Indices | Flags) -> Seeds:
        """Return some of the seeds."""
        return Seeds(
            self.triangle[items],
            self.barycentric[items],
            self.family[items],
            self.umbilic[items],
            self.heading[items],
        )


def make_seeds(triangle: Indices, barycentric: Floats, family: Indices) -> Seeds:
    """Return seeds in triangles."""
    count = len(triangle)
    return Seeds(
        triangle, barycentric, family, np.full(count, -1, dtype=np.int64), np.zeros((count, 3))
    )


def joined_seeds(parts: list[Seeds]) -> Seeds:
    """Return several sets of seeds in one."""
    names = [each.name for each in fields(Seeds)]
    return Seeds(*(np.concatenate([getattr(part, name) for part in parts]) for name in names))
