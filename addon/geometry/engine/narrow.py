# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The narrow fit.

A jet of degree 4 at every vertex over its nearest rings, as sharp as the mesh allows.
"""

from __future__ import annotations

import numpy as np

from ..types import AnyArray, Coordinates, Graph, Progress
from .blocks import NarrowFit, empty_fit, fit_into
from .jet_fit import UNDETERMINED, JetOptions
from .recipes import NEAR_RIM, NEAREST, PARABOLOID, RIM, TWO_RINGS, ordinary

#: There heights are measured over the mean plane of what lies around, not over the tangent plane:
#: so the slopes stay small within a neighborhood to one side, and high orders with them.
LEANING = 5
#: A normal is not turned further than this cosine.
FARTHEST = 0.5
#: A fit conditioned worse than this is repeated with one ring more.
WEAK = 25.0
#: At a corner of the rim even four rings are few: a fit conditioned worse than this takes six.
CORNER = 2000.0
#: On a rim of a mesh so coarse that a fit is expected to err by this share, a paraboloid over two
#: rings is tried, and taken if the error it promises, squared, is below this share.
COARSE, COARSE_PROMISE = 0.05, 0.25
#: A fit expected to err by more than this share is tried again with fewer rings.
SHARPEN = 0.01
#: One still expected to err by this share, as on a tube of ten faces, with the nearest ring only.
LOST, LOST_PROMISE = 0.3, 0.25
#: They are taken if the error they promise, squared, is below this share.
PROMISE = 0.5
#: Larger meshes are fine enough without (and time counts).
SMALL = 12_000

#: Part of a fit's predicted variance that is real (measured on noise).
CALIBRATION = 0.4
#: Vertices of a pilot fit.
PILOT = 2000


def narrow_fit(
    coordinates: Coordinates,
    graph: Graph,
    walk: Graph,
    normals: AnyArray,
    rim: AnyArray,
    sound: AnyArray,
    how: tuple[int, JetOptions],
    on_progress: Progress | None = None,
) -> NarrowFit:
    """Fit every sound vertex.

    Parameters
    ----------
    coordinates : three (n,) float64
    graph, walk : (n, n) sparse
        Edges with a full diagonal; the same without the hubs.
    normals : (n, 3) float64
    rim, sound : (n,) bool
    how : (int, JetOptions)
        Rings and fit for vertices away from rims, see `ordinary`.
    """
    fit = empty_fit(normals)
    near = (np.asarray(graph @ rim.astype(np.float32)) > 0) & ~rim
    ring, options = how

    def run(
        mask: AnyArray, count: int, how: JetOptions, on_progress: Progress | None = None
    ) -> None:
        chosen = np.flatnonzero(mask & sound)
        fit_into(fit, coordinates, graph, walk, normals, chosen, count, how, on_progress)

    run(~near & ~rim, ring, options, on_progress)
    weak = (fit.condition > WEAK) & ~near & ~rim
    run(weak, ring + 1, options)
    normals = leaning_normals(graph, normals, near | rim)
    run(near, *NEAR_RIM)
    run(rim, *RIM)
    run(rim & (fit.condition > CORNER), 6, RIM[1])
    promised = CALIBRATION * fit.residual**2 * fit.variance
    coarse = rim & sound & (promised > COARSE**2 * np.maximum(np.abs(fit.k1), np.abs(fit.k2)) ** 2)
    _try(fit, coordinates, graph, walk, normals, np.flatnonzero(coarse), PARABOLOID)
    if len(normals) < SMALL:
        _sharpen(fit, coordinates, graph, walk, normals, np.flatnonzero(sound & ~rim), near)
    return fit


def _try(
    fit: NarrowFit,
    coordinates: Coordinates,
    graph: Graph,
    walk: Graph,
    normals: AnyArray,
    vertices: AnyArray,
    how: tuple[int, JetOptions],
) -> None:
    """Fit chosen vertices otherwise, and keep what promises to err much less."""
    if not len(vertices):
        return
    other = empty_fit(normals)
    fit_into(other, coordinates, graph, walk, normals, vertices, *how)
    before, after = ((each.residual**2 * each.variance)[vertices] for each in (fit, other))
    is_full = other.condition[vertices] < UNDETERMINED
    _copy(fit, other, vertices[(after < COARSE_PROMISE * before) & is_full])


def _copy(fit: NarrowFit, other: NarrowFit, vertices: AnyArray) -> None:
    for name in NarrowFit.__dataclass_fields__:
        getattr(fit, name)[vertices] = getattr(other, name)[vertices]


def leaning_normals(graph: Graph, normals: AnyArray, chosen: AnyArray) -> AnyArray:
    """Return the normals, with the chosen ones replaced by the mean of those around them."""
    if not chosen.any():
        return normals
    leaning = normals
    for _ in range(LEANING):
        leaning = graph @ leaning
    leaning = leaning / np.maximum(np.linalg.norm(leaning, axis=1), 1e-300)[:, None]
    is_near = np.einsum("ij,ij->i", leaning, normals) > FARTHEST
    return np.where((chosen & is_near)[:, None], leaning, normals)


def pilot_fit(
    coordinates: Coordinates, graph: Graph, walk: Graph, normals: AnyArray, usable: AnyArray
) -> NarrowFit | None:
    """Fit some vertices spread over the mesh, to learn whether fitting all is worth while.

    None if there are too few.
    """
    vertices = np.flatnonzero(usable)
    if len(vertices) < SMALL:
        return None
    chosen = vertices[:: len(vertices) // PILOT]
    fit = empty_fit(normals)
    fit_into(
        fit,
        coordinates,
        graph,
        walk,
        normals,
        chosen,
        *ordinary(len(normals), 0.0),
    )
    return NarrowFit(*(getattr(fit, name)[chosen] for name in NarrowFit.__dataclass_fields__))


def ring_mean(walk: Graph, values: AnyArray) -> AnyArray:
    """Return values averaged twice over the neighbors.

    A residual of few points says little alone.
    """
    valence = np.diff(walk.indptr)
    for _ in range(2):
        values = (walk @ values) / valence
    return values


def _sharpen(
    fit: NarrowFit,
    coordinates: Coordinates,
    graph: Graph,
    walk: Graph,
    normals: AnyArray,
    vertices: AnyArray,
    near: AnyArray,
) -> None:
    """Take fewer rings where they promise a smaller error.

    That is so where the shape bends much; noise makes them promise a larger one.
    """
    for share, promise, how in ((SHARPEN, PROMISE, TWO_RINGS), (LOST, LOST_PROMISE, NEAREST)):
        expected = ring_mean(walk, fit.residual**2) * fit.variance
        chosen = vertices[(expected > share**2 * (fit.k1**2 + fit.k2**2))[vertices]]
        if how is NEAREST:  # beside a rim the nearest ring is lopsided
            chosen = chosen[~near[chosen]]
        if not len(chosen):
            return
        other = NarrowFit(*(np.copy(getattr(fit, name)) for name in NarrowFit.__dataclass_fields__))
        fit_into(other, coordinates, graph, walk, normals, chosen, *how)
        promised = ring_mean(walk, other.residual**2) * other.variance
        better = (promised < promise * expected) & (other.condition < WEAK)
        _copy(fit, other, chosen[better[chosen]])
