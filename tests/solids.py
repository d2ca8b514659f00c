# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Small meshes with creases and defects, as vertices and faces."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Faces = list[list[int]]
Solid = tuple[Array, Faces]


def grid(point: Callable[[float, float], tuple[float, ...]], cells: tuple[int, int]) -> Solid:
    """Return quads on a surface with parameters from 0 to 1; normals along d/du × d/dv."""
    nu, nv = cells
    vertices = [point(i / nu, j / nv) for i in range(nu + 1) for j in range(nv + 1)]
    w = nv + 1
    faces = [
        [i * w + j, (i + 1) * w + j, (i + 1) * w + j + 1, i * w + j + 1]
        for i in range(nu)
        for j in range(nv)
    ]
    return np.array(vertices), faces


def joined(*parts: Solid) -> Solid:
    """Return parts as one mesh, welded where they touch."""
    vertices = np.concatenate([part[0] for part in parts])
    offsets = np.cumsum([0, *(len(part[0]) for part in parts)])
    _, first, number = np.unique(
        np.round(vertices, 9) + 0.0, axis=0, return_index=True, return_inverse=True
    )
    number = number.reshape(-1)
    faces = [
        [int(number[offset + vertex]) for vertex in face]
        for (_, part), offset in zip(parts, offsets, strict=False)
        for face in part
    ]
    return vertices[first], faces


def cube(count: int = 4) -> Solid:
    """Return the cube from 0 to 1, each side in count × count quads, normals outward."""

    def near(axis: int) -> Solid:
        return grid(lambda u, v: tuple(np.roll([0.0, v, u], axis)), (count, count))

    def far(axis: int) -> Solid:
        return grid(lambda u, v: tuple(np.roll([1.0, u, v], axis)), (count, count))

    return joined(*(side(axis) for axis in range(3) for side in (near, far)))


def capped_cylinder(radius: float, height: float, around: int, upward: int) -> Solid:
    """Return a closed cylinder along z whose caps are rings of quads around an n-gon."""

    def ring(r: float, z: float, share: float) -> tuple[float, ...]:
        angle = 2.0 * np.pi * share
        return r * np.cos(angle), r * np.sin(angle), z

    wall = grid(lambda u, v: ring(radius, height * v, u), (around, upward))
    parts = [wall]
    inner = 0.5 * radius
    for z, turn in ((0.0, -1.0), (height, 1.0)):

        def annulus(u: float, v: float, z: float = z, turn: float = turn) -> tuple[float, ...]:
            return ring(radius + (inner - radius) * v, z, turn * u)

        middle = np.array([ring(inner, z, turn * k / around) for k in range(around)])
        parts += [grid(annulus, (around, 4)), (middle, [list(range(around))])]
    return joined(*parts)


def pointed_vault(count: int) -> Solid:
    """Return a Gothic vault along y: arcs of radius 2 around x = -1 and x = 1 meet at x = 0.

    Either side is a cylinder with k1 = 1/2; each arc rises over 60°, and so do their normals
    at the ridge include 60°.
    """

    def right(u: float, v: float) -> tuple[float, ...]:
        angle = np.pi / 3.0 * (1.0 - u)
        return 2.0 * np.cos(angle) - 1.0, 3.0 * v, 2.0 * np.sin(angle)

    def left(u: float, v: float) -> tuple[float, ...]:
        angle = np.pi / 3.0 * u
        return 1.0 - 2.0 * np.cos(angle), 3.0 * v, 2.0 * np.sin(angle)

    return joined(grid(right, (count, 2 * count)), grid(left, (count, 2 * count)))
