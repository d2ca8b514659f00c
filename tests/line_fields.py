# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Direction fields of samples, with noise where a test wants some."""

from __future__ import annotations

import numpy as np
from architectural_curvature.addon.geometry.curvature import estimate_curvature
from architectural_curvature.addon.geometry.lines.tracer import LineField, build_line_field
from architectural_curvature.addon.geometry.mesh import PolygonMesh, mesh_from_polygons
from architectural_curvature.addon.geometry.surface import build_surface
from surfaces.sampling import Sample


def field_of(mesh: PolygonMesh) -> LineField:
    """Return the direction field of a mesh."""
    surface = build_surface(mesh)
    return build_line_field(surface, estimate_curvature(surface))


def field_on(sample: Sample, noise: float = 0.0) -> LineField:
    """Return the field of a sample moved along its normals, by a share of the mean edge."""
    moves = np.random.default_rng(1).normal(0.0, noise, (len(sample.shape.position), 1))
    position = sample.shape.position + moves * mean_edge(sample) * sample.shape.normal
    return field_of(mesh_from_polygons(position, sample.polygons))


def mean_edge(sample: Sample) -> float:
    """Return the mean length of the sides of a sample's polygons."""
    corner = sample.shape.position[sample.polygons]
    return float(np.linalg.norm(corner - np.roll(corner, -1, axis=1), axis=2).mean())
