# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of every kind and size on exact surfaces, the same at every run."""

from __future__ import annotations

import zlib
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from .engine import surfaces

if TYPE_CHECKING:
    from surfaces.catalogue import Patch
    from surfaces.sampling import Sample

Array = NDArray[np.float64]

#: Kinds of meshes: the base mesh, the noise as a share of the mean edge length, rounding to
#: 32-bit floats as Blender stores them.
KINDS: dict[str, tuple[str, float, bool]] = {
    "regular": ("regular", 0.0, False),
    "alternating": ("alternating", 0.0, False),
    "irregular 4:1": ("irregular", 0.0, False),
    "noise 0.1 %": ("regular", 1e-3, False),
    "noise 1 %": ("regular", 1e-2, False),
    "coarse 30×20": ("coarse", 0.0, False),
    "irregular 4:1, float32": ("irregular", 0.0, True),
}

#: Irregular cells are stretched along the longer side of a patch by this factor.
_STRETCH = 4.0
#: Irregular points move by this share of a cell.
_JITTER = 0.4
_COARSE = (29, 19)
_ELLIPSOIDS = {"sphere": (1.0, 1.0, 1.0), "ellipsoid": (1.0, 0.8, 0.6)}


@dataclass(frozen=True)
class Case:
    """A mesh with what is exact at its vertices; `reference` is the RMS curvature in 1/m."""

    name: str
    positions: Array
    triangles: NDArray[np.int64]
    k1: Array
    k2: Array
    direction_1: Array
    is_rim: NDArray[np.bool_]
    is_developable: bool
    reference: float


def names(*, held_out: bool = False) -> list[str]:
    """Return the names of the surfaces that are measured."""
    if held_out:
        return list(surfaces("held_out").PATCHES)
    return [*_ELLIPSOIDS, *surfaces("catalogue").PATCHES]


def make(name: str, kind: str, count: int) -> Case:
    """Return a triangle mesh of about `count` vertices on a surface."""
    base, noise, rounds = KINDS[kind]
    sample = _ellipsoid(name, base, count) if name in _ELLIPSOIDS else _patch(name, base, count)
    shape, polygons = sample.shape, sample.polygons
    triangles = (
        np.concatenate([polygons[:, [0, 1, 2]], polygons[:, [0, 2, 3]]])
        if (polygons.shape[1] == 4)
        else polygons
    )
    position = shape.position
    if noise:
        edge = position[triangles] - position[np.roll(triangles, 1, axis=1)]
        size = noise * float(np.linalg.norm(edge, axis=2).mean())
        random = np.random.default_rng(zlib.crc32(f"{name} {kind} {count}".encode()))
        position = position + size * random.standard_normal(len(position))[:, None] * shape.normal
    if rounds:
        position = position.astype(np.float32).astype(np.float64)
    reference = float(np.sqrt(np.mean(0.5 * (shape.k1**2 + shape.k2**2))))
    known = (*surfaces("catalogue").DEVELOPABLE, *surfaces("held_out").DEVELOPABLE)
    return Case(
        name=name,
        positions=np.ascontiguousarray(position),
        triangles=np.ascontiguousarray(triangles),
        k1=shape.k1,
        k2=shape.k2,
        direction_1=shape.direction_1,
        is_rim=sample.is_rim,
        is_developable=name in known,
        reference=reference or 1.0 / float(np.linalg.norm(np.ptp(position, axis=0))),
    )


def _ellipsoid(name: str, base: str, count: int) -> Sample:
    kind = "irregular" if base == "irregular" else "geodesic"
    cells = 8 if base == "coarse" else max(2, round(np.sqrt((count - 2) / 10.0)))
    return surfaces("spheres").sample_ellipsoid(_ELLIPSOIDS[name], kind, cells)


def _patch(name: str, base: str, count: int) -> Sample:
    catalogue, held_out = surfaces("catalogue"), surfaces("held_out")
    patch = {**catalogue.PATCHES, **held_out.PATCHES}[name]
    if base == "coarse":
        cells = tuple(n + closed for n, closed in zip(_COARSE, patch.is_closed, strict=True))
        return surfaces("sampling").sample_patch(patch, "regular", cells)
    ratio = _aspect(patch)
    if base == "irregular":
        ratio = ratio / _STRETCH if ratio >= 1.0 else ratio * _STRETCH
    across = max(4, round(float(np.sqrt(count * ratio))))
    cells = (across, max(4, round(count / across)))
    return surfaces("sampling").sample_patch(patch, base, cells, count, _JITTER)


def _aspect(patch: Patch) -> float:
    """Return how much longer a patch is in u than in v."""
    u, v = (
        values.ravel()
        for values in np.meshgrid(np.linspace(*patch.u, 60), np.linspace(*patch.v, 60))
    )
    derivatives = patch.derivatives(u, v)
    along_u, along_v = (np.linalg.norm(derivatives[i], axis=1).mean() for i in (1, 2))
    return float(along_u * (patch.u[1] - patch.u[0]) / (along_v * (patch.v[1] - patch.v[0])))
