# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""CAD meshes: strips of long quads, fans, fillets, vaults and cones, cut at their creases."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from .engine import geometry, tests
from .peers import DEFAULT, METHODS, OURS, completed

Array = NDArray[np.float64]
Solid = tuple[Array, list[list[int]]]
#: Exact k1 at points, and where it is told: not on seams, where the surface has two.
Exact = Callable[[Array, NDArray[np.bool_]], tuple[Array, NDArray[np.bool_]]]

_FILLET = 0.1


def _cylinder(*, capped: bool) -> Solid:
    """Return a cylinder of 64 strips, one quad high."""
    turn = 2.0 * np.pi * np.arange(64) / 64
    ring = np.stack([np.cos(turn), np.sin(turn), 0.0 * turn], axis=1)
    vertices = np.concatenate([ring, ring + [0.0, 0.0, 3.0], [[0.0, 0.0, 0.0], [0.0, 0.0, 3.0]]])
    faces = [[i, (i + 1) % 64, 64 + (i + 1) % 64, 64 + i] for i in range(64)]
    if not capped:
        return vertices[:128], faces
    faces += [[(i + 1) % 64, i, 128] for i in range(64)]
    return vertices, faces + [[64 + i, 64 + (i + 1) % 64, 129] for i in range(64)]


def _fillet(strips: int, along: int) -> Solid:
    """Return two plates at right angles, joined by a quarter of a cylinder."""
    solids = tests("solids")

    def arc(u: float, v: float) -> tuple[float, ...]:
        angle = 0.5 * np.pi * u
        return _FILLET * np.sin(angle), v, _FILLET * (np.cos(angle) - 1.0)

    return solids.joined(
        solids.grid(lambda u, v: (u - 1.0, v, 0.0), (1, along)),
        solids.grid(arc, (strips, along)),
        solids.grid(lambda u, v: (_FILLET, v, -_FILLET - u), (1, along)),
    )


def _cone(around: int, rings: int) -> Solid:
    """Return a cone of radius 1 and height 1.5 with its apex."""
    turn = 2.0 * np.pi * np.arange(around) / around
    parts = [np.array([[0.0, 0.0, 1.5]])]
    for share in np.arange(1, rings + 1) / rings:
        height = np.full(around, 1.5 * (1.0 - share))
        parts.append(np.stack([share * np.cos(turn), share * np.sin(turn), height], axis=1))
    faces = [[0, 1 + i, 1 + (i + 1) % around] for i in range(around)]
    for ring in range(rings - 1):
        a, b = 1 + ring * around, 1 + (ring + 1) * around
        faces += [[a + i, b + i, b + (i + 1) % around, a + (i + 1) % around] for i in range(around)]
    return np.concatenate(parts), faces


def _even(k1: float) -> Exact:
    return lambda points, is_flat: (np.where(is_flat, 0.0, k1), np.ones(len(points), np.bool_))


def _of_fillet(points: Array, _is_flat: NDArray[np.bool_]) -> tuple[Array, NDArray[np.bool_]]:
    inside = (points[:, 0] > 1e-9) & (points[:, 2] > -_FILLET + 1e-9)
    outside = (points[:, 0] < -0.5) | (points[:, 2] < -_FILLET - 0.5)
    return np.where(inside, 1.0 / _FILLET, 0.0), inside | outside


def _of_cone(points: Array, _is_flat: NDArray[np.bool_]) -> tuple[Array, NDArray[np.bool_]]:
    radius = np.hypot(points[:, 0], points[:, 1])
    told = radius > 1e-9
    return np.where(told, 1.5 / np.hypot(1.0, 1.5) / np.where(told, radius, 1.0), 0.0), told


CASES: dict[str, tuple[Callable[[], Solid], Exact]] = {
    "cylinder, 64 strips of one quad": (lambda: _cylinder(capped=False), _even(1.0)),
    "the same with fan caps": (lambda: _cylinder(capped=True), _even(1.0)),
    "fillet of 8 strips, one quad long": (lambda: _fillet(8, 1), _of_fillet),
    "fillet of 8 strips, 20 quads long": (lambda: _fillet(8, 20), _of_fillet),
    "fillet of 4 strips, 5 quads long": (lambda: _fillet(4, 5), _of_fillet),
    "pointed vault, both sides of its crease": (
        lambda: tests("solids").pointed_vault(12),
        _even(0.5),
    ),
    "cone of 10 rings, apex left out": (lambda: _cone(64, 10), _of_cone),
    "cone of 64 triangles, base": (lambda: _cone(64, 1), _of_cone),
    "cone of 16 triangles, base": (lambda: _cone(16, 1), _of_cone),
}
SHOWN = [OURS, "igl r=2", DEFAULT, "igl discrete"]
Rows = dict[str, dict[str, tuple[float, float]]]


def measure(methods: list[str]) -> Rows:
    """Return, per case and method, the largest relative error of k1 and the share of classes."""
    rows: Rows = {}
    for name, (solid, exact) in CASES.items():
        vertices, faces = solid()
        surface = geometry("surface").build_surface(
            geometry("mesh").mesh_from_polygons(vertices, faces)
        )
        points = vertices[surface.sector_vertex]
        planar = geometry("planar")
        is_flat = planar.sectors_of(surface, planar.planar_polygons(surface))
        k1, is_told = exact(points, is_flat)
        rows[name] = {}
        for method in methods:
            if method == OURS:
                curvature = geometry("curvature").estimate_curvature(surface)
                found = {"k1": curvature.k1, "k2": curvature.k2}
            else:
                triangles = np.ascontiguousarray(surface.sector_triangles)
                found = completed(METHODS[method](surface.sector_position, triangles))
            error = np.abs(found["k1"] - k1)[is_told] / k1[is_told].max()
            limit = 0.8 / float(np.linalg.norm(np.ptp(points, axis=0)))
            right = _classes(found["k1"], found["k2"], limit) == _classes(k1, 0.0 * k1, limit)
            rows[name][method] = (float(error.max()), 100.0 * float(right[is_told].mean()))
    return rows


def _classes(k1: Array, k2: Array, limit: float) -> NDArray[np.int64]:
    return geometry("classification").classify(k1, k2, limit, np.ones(len(k1), dtype=np.bool_))


def markdown(rows: Rows) -> str:
    """Return the errors and shares as a table."""
    methods = list(next(iter(rows.values())))
    lines = [
        "| largest error of k1, classes right | " + " | ".join(methods) + " |",
        "|---" * (len(methods) + 1) + "|",
    ]
    for name, row in rows.items():
        cells = " | ".join(f"{row[m][0]:.2g}, {row[m][1]:.0f} %" for m in methods)
        lines.append(f"| {name} | {cells} |")
    return "\n".join(lines)
