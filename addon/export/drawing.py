# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A drawing: polylines on layers, in meters."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..geometry.types import Floats


@dataclass(frozen=True)
class Polyline:
    """Points in meters, (p, 3) float64; a closed line does not repeat its first one."""

    points: Floats
    is_closed: bool


@dataclass(frozen=True)
class Layer:
    """Lines of one kind: a name, an sRGB color (0 to 1), their thickness in meters."""

    name: str
    color: tuple[float, float, float]
    thickness: float
    lines: tuple[Polyline, ...]


@dataclass(frozen=True)
class Drawing:
    """What a file shows, in world coordinates with z up."""

    title: str
    layers: tuple[Layer, ...]

    @property
    def bounds(self) -> tuple[Floats, Floats]:
        """Lowest and highest coordinates; zeros where there are no lines."""
        points = [line.points for layer in self.layers for line in layer.lines]
        if not points:
            return np.zeros(3), np.zeros(3)
        together = np.concatenate(points)
        return together.min(axis=0), together.max(axis=0)
