# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Traced lines run along the exact principal directions, and stay on the exact lines."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from architectural_curvature.addon.geometry.lines.field import Family
from architectural_curvature.addon.geometry.lines.lines import CurvatureLines
from architectural_curvature.addon.geometry.lines.tracer import (
    LineField,
    trace_from,
)
from architectural_curvature.addon.geometry.mesh import mesh_from_polygons
from line_fields import field_of, field_on, mean_edge
from numpy.typing import NDArray
from surfaces.catalogue import PATCHES, Patch
from surfaces.inversion import nearest_parameters
from surfaces.principal import PRINCIPAL, ellipsoid_zone
from surfaces.sampling import Sample, sample_patch

Array = NDArray[np.float64]

AXES = (1.5, 1.2, 1.0)
#: Cells in u and v, about as long as wide.
CELLS = {
    "ellipsoid": (110, 36),
    "torus": (110, 44),
    "catenoid": (110, 36),
    "elliptic paraboloid": (56, 84),
    "enneper": (68, 68),
    "hyperbolic paraboloid": (68, 68),
}
SURFACES = {"ellipsoid": ellipsoid_zone(AXES), **PATCHES}
#: Lines are traced through as many triangles, spread over the surface.
SEEDS = 12


def sampled(name: str, kind: str) -> Sample:
    """Return a mesh whose cells are about as long as wide, or 4:1."""
    u, v = CELLS[name]
    cells = (2 * u, v // 2) if "4:1" in kind else (u, v)
    return sample_patch(SURFACES[name], kind.split(maxsplit=1)[0], cells)


def trace_some(lines: LineField) -> tuple[CurvatureLines, Array]:
    """Return the lines of both families through the middles of triangles, and these points."""
    triangle = np.linspace(0, len(lines.field.mesh.triangles) - 1, SEEDS + 2)[1:-1].astype(np.int64)
    middle = np.full((SEEDS, 3), 1.0 / 3.0)
    return trace_from(lines, triangle, middle), np.tile(
        lines.field.mesh.points(triangle, middle), (2, 1)
    )


def chords(lines: CurvatureLines) -> tuple[Array, Array, NDArray[np.int64]]:
    """Return middle, direction times length and family of the pieces between points."""
    here = np.flatnonzero(np.diff(lines.point_line) == 0)
    move = lines.points[here + 1] - lines.points[here]
    middle = lines.points[here] + 0.5 * move
    return middle, move, lines.family[lines.point_line[here]]


def directions(patch: Patch, points: Array, family: NDArray[np.int64]) -> tuple[Array, Array]:
    """Return the exact directions of families and of the others at points near a patch."""
    shape = patch.shape(*nearest_parameters(patch, points))
    is_first = (family == Family.FIRST)[:, None]
    one, two = shape.direction_1, shape.direction_2
    return np.where(is_first, one, two), np.where(is_first, two, one)


@pytest.mark.parametrize("noise", [0.0, 0.005])
@pytest.mark.parametrize("kind", ["regular", "irregular 4:1"])
@pytest.mark.parametrize("name", CELLS)
def test_lines_run_along_exact_directions(name: str, kind: str, noise: float) -> None:
    lines = field_on(sampled(name, kind), noise)
    middle, move, family = chords(trace_some(lines)[0])
    along, across = directions(SURFACES[name], middle, family)
    sine, cosine = (np.abs(np.einsum("ij,ij->i", move, each)) for each in (across, along))
    angle = np.degrees(np.arctan2(sine, cosine))
    length = np.linalg.norm(move, axis=1)
    assert np.average(angle, weights=length) <= (2.0 if noise else 0.5)


def confocal_paraboloids(u: Array, v: Array) -> Array:
    """Return which paraboloids confocal to x²/a + y²/b = -2z go through points of it, (2, n).

    They are x²/(a - t) + y²/(b - t) = -2z - t, besides t = 0, where x²/(a(a - t)) + y²/(b(b - t))
    is -1.
    """
    a, b = 1.0 / 0.8, 1.0 / 0.3
    x, y = u**2 / a, v**2 / b
    total = a + b + x + y
    gap = np.sqrt(total**2 - 4.0 * (a * b + b * x + a * y))
    return 0.5 * np.stack([total - gap, total + gap])


def parameters(u: Array, v: Array) -> Array:
    """Return parameters that are themselves constant along principal curvature lines."""
    return np.stack([u, v])


#: Two functions for each surface, one constant along the lines of either family.
CONSTANTS: dict[str, Callable[[Array, Array], Array]] = {
    "torus": parameters,
    "catenoid": parameters,
    "enneper": parameters,
    "elliptic paraboloid": confocal_paraboloids,
    # On z = xy: dx² / (1 + x²) = dy² / (1 + y²).
    "hyperbolic paraboloid": lambda u, v: np.stack(
        [np.arcsinh(u) + np.arcsinh(v), np.arcsinh(u) - np.arcsinh(v)]
    ),
}


def slope(patch: Patch, name: str, u: Array, v: Array, direction: Array) -> Array:
    """Return how fast the two constants change along unit tangents, (2, n) in 1/m."""
    _, by_u, by_v = patch.derivatives(u, v)[:3]
    uu, uv, vv = (
        np.einsum("ij,ij->i", a, b) for a, b in ((by_u, by_u), (by_u, by_v), (by_v, by_v))
    )
    along_u, along_v = (np.einsum("ij,ij->i", direction, a) for a in (by_u, by_v))
    du = (vv * along_u - uv * along_v) / (uu * vv - uv**2)
    dv = (uu * along_v - uv * along_u) / (uu * vv - uv**2)
    step = 1e-5
    after = CONSTANTS[name](u + step * du, v + step * dv)
    return (after - CONSTANTS[name](u - step * du, v - step * dv)) / (2.0 * step)


@pytest.mark.parametrize("kind", ["regular", "irregular 4:1"])
@pytest.mark.parametrize("name", CONSTANTS)
def test_a_line_stays_on_the_exact_one_over_its_whole_run(name: str, kind: str) -> None:
    patch = SURFACES[name]
    sample = sampled(name, kind)
    traced, seeds = trace_some(field_on(sample))
    assert traced.count == 2 * SEEDS
    line = traced.point_line
    start = nearest_parameters(patch, seeds)
    # Of the two constants that one stays which does not change along the line where it starts.
    along, _ = directions(patch, seeds, traced.family)
    kept = np.argmin(np.abs(slope(patch, name, *start, along)), axis=0)
    u, v = nearest_parameters(patch, traced.points)
    _, across = directions(patch, traced.points, traced.family[line])
    rows = kept[line], np.arange(len(line))
    off = CONSTANTS[name](u, v)[rows] - CONSTANTS[name](*start)[kept, np.arange(len(kept))][line]
    turns = np.array([*patch.is_closed])[rows[0]]
    off = np.where(turns, np.angle(np.exp(1j * off)), off)
    away = np.abs(off / slope(patch, name, u, v, across)[rows])
    assert away.max() <= 0.5 * mean_edge(sample)


@pytest.mark.parametrize("kind", ["regular", "alternating"])
@pytest.mark.parametrize("name", PRINCIPAL)
def test_lines_run_along_the_edges_of_principal_quads(name: str, kind: str) -> None:
    """Measured against the edges on both sides of a quad, in proportion to the distance."""
    patch, cells = PRINCIPAL[name], np.array([28, 20])
    sample = sample_patch(patch, kind, (28, 20))
    lines = field_of(mesh_from_polygons(sample.shape.position, sample.polygons))
    middle, move, _ = chords(trace_some(lines)[0])
    place = np.stack(nearest_parameters(patch, middle), axis=1)
    start, end = np.array([patch.u, patch.v]).T
    place = (place - start) / (end - start) * cells
    cell = np.clip(np.floor(place).astype(np.int64), 0, cells - 1)
    share = (place - cell)[:, :, None]
    count = cells + ~np.array(patch.is_closed)
    points = sample.shape.position.reshape(*count, 3)
    (i, j), (ahead, above) = cell.T, ((cell + 1) % count).T
    a, b, c, d = points[i, j], points[ahead, j], points[ahead, above], points[i, above]
    edges = np.stack(
        [
            (1.0 - share[:, 1]) * (b - a) + share[:, 1] * (c - d),
            (1.0 - share[:, 0]) * (d - a) + share[:, 0] * (c - b),
        ],
        axis=1,
    )
    edges /= np.linalg.norm(edges, axis=2)[:, :, None]
    cosine = np.abs(np.einsum("nx,nex->ne", move, edges)).max(axis=1)
    length = np.linalg.norm(move, axis=1)
    is_long = length > 1e-6
    angle = np.degrees(np.arccos(np.clip(cosine[is_long] / length[is_long], 0.0, 1.0)))
    order = np.argsort(angle)
    part = np.cumsum(length[is_long][order]) / length[is_long].sum()
    assert angle[order][np.searchsorted(part, 0.5)] <= 3.0
