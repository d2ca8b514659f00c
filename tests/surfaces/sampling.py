# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes on exact surfaces: of even, alternating or irregular triangles, or of quads."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import Delaunay

from .catalogue import Patch
from .forms import Shape
from .taylor import Array

Indices = NDArray[np.int64]

KINDS = ("regular", "alternating", "irregular", "quads")

_JITTER = 0.3
"""Share of a cell's size by which irregular points are moved, at most, to either side."""


@dataclass(frozen=True)
class Sample:
    """A mesh with what is exact at its vertices.

    Parameters
    ----------
    shape : Shape
        One point per vertex; its positions are the mesh's.
    polygons : (m, 3) or (m, 4) int64
        Counter-clockwise seen from where the normals point to.
    """

    shape: Shape
    polygons: Indices

    @property
    def is_rim(self) -> NDArray[np.bool_]:
        """(n,) vertices on edges with one polygon."""
        ends = np.stack([self.polygons, np.roll(self.polygons, -1, axis=1)], axis=-1)
        edges, uses = np.unique(np.sort(ends.reshape(-1, 2), axis=1), axis=0, return_counts=True)
        flags = np.zeros(len(self.shape.position), dtype=np.bool_)
        flags[edges[uses == 1]] = True
        return flags

    @property
    def longest_edge(self) -> float:
        """Length of the longest side of a polygon."""
        corner = self.shape.position[self.polygons]
        return float(np.linalg.norm(corner - np.roll(corner, -1, axis=1), axis=2).max())

    def depth(self, most: int) -> Indices:
        """Return the number of polygons between every vertex and the rim, (n,), at most `most`."""
        depth = np.where(self.is_rim, 0, most)
        for _ in range(most):
            lowest = np.min(depth[self.polygons], axis=1)
            np.minimum.at(depth, self.polygons, lowest[:, None] + 1)
        return depth


def sample_patch(
    patch: Patch, kind: str, cells: tuple[int, int], seed: int = 0, jitter: float = _JITTER
) -> Sample:
    """Return a mesh on a parametrized surface, welded where the surface closes.

    Parameters
    ----------
    patch : Patch
    kind : str
        One of `KINDS`. Irregular meshes have points moved about and Delaunay triangles.
    cells : (int, int)
        Number of cells in u and v; each holds a quad or two triangles.
    seed : int
        Of the irregular points.
    jitter : float
        Share of a cell's size by which irregular points are moved, at most, to either side.
    """
    count = [number + (not closed) for number, closed in zip(cells, patch.is_closed, strict=True)]
    i, j = (index.ravel() for index in np.indices(count))
    place = np.stack([i, j], axis=1).astype(np.float64)
    if kind == "irregular":
        place += _jitter(place, cells, patch.is_closed, seed, jitter)
        polygons = _delaunay(place, cells, patch.is_closed)
    else:
        polygons = _grid(cells, count, kind)
    if patch.is_flipped:
        polygons = polygons[:, ::-1]
    share = place / np.array(cells)
    shape = patch.shape(
        patch.u[0] + share[:, 0] * (patch.u[1] - patch.u[0]),
        patch.v[0] + share[:, 1] * (patch.v[1] - patch.v[0]),
    )
    return Sample(shape, np.ascontiguousarray(polygons))


def split_quads(quads: Indices, alternates: NDArray[np.bool_]) -> Indices:
    """Return the triangles of quads, which are cut by their other diagonal where it alternates."""
    turned = np.where(alternates[:, None], np.roll(quads, -1, axis=1), quads)
    return turned[:, [[0, 1, 2], [0, 2, 3]]].reshape(-1, 3)


def _grid(cells: tuple[int, int], count: list[int], kind: str) -> Indices:
    i, j = (index.ravel() for index in np.indices(cells))
    ahead, above = (i + 1) % count[0], (j + 1) % count[1]
    width = count[1]
    quads = np.stack(
        [i * width + j, ahead * width + j, ahead * width + above, i * width + above], axis=1
    ).astype(np.int64)
    if kind == "quads":
        return quads
    return split_quads(quads, ((i + j) % 2 == 1) & (kind == "alternating"))


def _jitter(
    place: Array, cells: tuple[int, int], is_closed: tuple[bool, bool], seed: int, most: float
) -> Array:
    """Return small moves, which keep the points of open sides on them and corners in place."""
    moves = np.random.default_rng(seed).uniform(-most, most, place.shape)
    on_side = ((place == 0.0) | (place == np.array(cells))) & ~np.array(is_closed)
    moves[on_side] = 0.0
    moves[on_side.all(axis=1)] = 0.0
    return moves


def _delaunay(place: Array, cells: tuple[int, int], is_closed: tuple[bool, bool]) -> Indices:
    """Return Delaunay triangles of points in a rectangle whose closed sides are glued."""
    margin = 4.0
    turns = [(-1, 0, 1) if closed else (0,) for closed in is_closed]
    points, owner = [], []
    for turn in np.stack(np.meshgrid(*turns), axis=-1).reshape(-1, 2):
        copy = place + turn * np.array(cells)
        near = ((copy > -margin) & (copy < np.array(cells) + margin)).all(axis=1)
        points.append(copy[near])
        owner.append(np.flatnonzero(near))
    position = np.concatenate(points)
    triangles = Delaunay(position).simplices
    side = position[triangles[:, 1:]] - position[triangles[:, :1]]
    area = side[:, 0, 0] * side[:, 1, 1] - side[:, 0, 1] * side[:, 1, 0]
    triangles = np.where(area[:, None] > 0.0, triangles, triangles[:, ::-1])
    # Of a triangle's copies the one with its middle inside counts; flat ones lie along open sides.
    middle = position[triangles].mean(axis=1)
    is_inside = ((middle >= 0.0) & (middle < np.array(cells)))[:, is_closed].all(axis=1)
    return np.concatenate(owner)[triangles[is_inside & (np.abs(area) > 1e-9)]].astype(np.int64)
