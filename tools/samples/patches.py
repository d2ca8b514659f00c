# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of quads from patches of points, welded where they meet."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import pairwise

Point = tuple[float, float, float]
Vertex = tuple[str, str, str]


@dataclass
class Patches:
    """A mesh that grows patch by patch; points that are written alike are one vertex.

    Coordinates are in meters with z up, rounded to a micrometer.
    """

    title: str
    faces: list[tuple[int, ...]] = field(default_factory=list)
    _numbers: dict[Vertex, int] = field(default_factory=dict)

    @property
    def vertices(self) -> list[Vertex]:
        """The vertices in the order of their numbers."""
        return list(self._numbers)

    def add(self, rows: Sequence[Sequence[Point]]) -> None:
        """Add the quads between rows of points.

        Seen from outside, points of a row run upward where following rows lie to the right.
        """
        grid = [[self._number(point) for point in row] for row in rows]
        for left, right in pairwise(grid):
            for low in range(len(left) - 1):
                self.faces.append((left[low], right[low], right[low + 1], left[low + 1]))

    def _number(self, point: Point) -> int:
        # Adding zero turns a negative zero into zero.
        x, y, z = (f"{round(value, 6) + 0.0:.6f}" for value in point)
        return self._numbers.setdefault((x, y, z), len(self._numbers))


def spread(start: float, end: float, count: int) -> list[float]:
    """Return count + 1 evenly spaced numbers from start to end."""
    return [start + (end - start) * step / count for step in range(count + 1)]
