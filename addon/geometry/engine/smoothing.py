# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Choose, at every vertex, the scale that errs least.

Patches of growing size, judged by bias and variance.

Noise leaves the same residual at every scale; a shape that a polynomial cannot follow leaves one
that grows steeply with the scale. Comparing the
residuals of two scales therefore tells noise from shape, and from both follows the squared error
to expect of every scale.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..types import AnyArray, Coordinates, Graph, Progress
from .clusters import Clusters, coarsen, first_level
from .patches import Patches, blend, fit_patches
from .sparse import pieces

#: Level of clustering and rings of clusters per rung, and about how many points a patch then has:
#: each about doubles the one before.
RUNGS = (
    (0, 3, 37),
    (0, 4, 61),
    (1, 2, 92),
    (1, 3, 185),
    (2, 2, 450),
    (2, 3, 920),
    (3, 2, 2200),
    (3, 3, 4600),
    (4, 2, 10000),
    (4, 3, 22000),
)
#: Rings of the patches that small meshes are probed with for noise.
PROBE = 2
#: The narrow fit's residual may be less than its noise by this factor (squared), where it has few
#: points.
OVERFITTED = 4.0
#: Meshes with more vertices than this climb in larger steps: they have points to spare, and time
#: counts.
MANY = 12_000
#: A rung whose noise is below this share of the curvature ends the climb.
ENOUGH = 0.004
#: Blended patches average each other's noise: the part of a single patch's variance that remains
#: (measured 0.5).
BLENDED = 0.5
#: A misfit of variance b² over n points acts on the curvature like noise of variance n b² times
#: this (measured 0.001 to 0.03; 0.3 on spheres, whose misfit is even).
COHERENCE = 0.03
#: A rung whose noise would exceed this share of the curvature is passed over.
HOPELESS = 0.12
#: Variance of a patch of n points that cover an area A: this / (n A²) (measured on round
#: neighborhoods).
SPREAD = 24500.0
#: No patch has more points than its connected piece over this.
FILLING = 2.2
#: Noise that makes the narrow fit err by less than this share of the curvature is left alone.
WORTH = 0.003
#: From one rung to the next, which has twice the points, a misfit due to shape grows at least by
#: this factor (squared).
GROWTH = 16.0
#: A misfit due to smooth shape grows with the fourth power of the points or more, at a kink of the
#: curvature with the square: taken for growth, the power between them keeps noise apart from both.
STEEP = 3
#: Residual of the narrow fit over the standard deviation of the heights (measured 0.45 to 0.85).
NARROW = 0.75
#: Part of the squared error that the narrow fit's residual predicts when it is due to shape, not
#: noise (measured 1e-6 to 0.1).
NARROW_BIAS = 0.02


@dataclass
class Narrow:
    """The narrow fit at n vertices.

    Variance of k per unit variance of the heights, mean squared residual (smoothed).
    """

    variance: AnyArray
    residual: AnyArray


@dataclass
class Choice:
    """Curvature at n vertices.

    Tensor (6, n), normals (n, 3), expected squared error (n,), rung (n,) or -1 for the narrow fit,
    noise variance (n,).
    """

    tensor: AnyArray
    normals: AnyArray
    error: AnyArray
    rung: AnyArray
    noise: AnyArray


def _ring_mean(patches: Patches, values: AnyArray) -> AnyArray:
    graph = patches.level.graph
    weight = np.minimum(patches.size, 200).astype(float)
    return (graph @ (values * weight)) / (graph @ weight)


def _probe(
    coordinates: Coordinates, level: Clusters, normals: AnyArray
) -> tuple[AnyArray, AnyArray, bool]:
    """Return the squared residual of the smallest patches, and their sizes.

    Where a mesh is coarse, the first rung shows more of the shape than of the noise.
    """
    patches = fit_patches(coordinates, level, PROBE, normals)
    square = patches.residual**2
    free = np.maximum(patches.size - 15, 0).astype(float)
    square = _spread(patches.level.graph, square * free)
    total = _spread(patches.level.graph, free)
    return square / np.maximum(total, 1e-9), patches.size, True


def _spread(graph: Graph, values: AnyArray) -> AnyArray:
    """Sum over the nearest rings."""
    for _ in range(2):
        values = np.asarray(graph @ values)
    return values


def choose_scale(
    coordinates: Coordinates,
    graph: Graph,
    normals: AnyArray,
    narrow: Narrow,
    area: float,
    reference: float,
    scramble: AnyArray,
    on_progress: Progress | None = None,
) -> Choice:
    """Climb the ladder of scales and keep the best rung of every vertex.

    Parameters
    ----------
    area : float
        Area per vertex (m²).
    reference : float
        The curvature that errors are compared with (1/m).
    scramble : (n,)
        Priorities for the clustering.
    on_progress : callable, optional
    """
    count = len(scramble)
    noise = np.zeros(count)
    # a patch must not be most of its piece, and what other pieces allow is nothing to a piece
    piece = pieces(graph)
    room = np.bincount(piece)[piece] / FILLING
    level, depth = first_level(graph), 0
    before, reached, is_probed = narrow.residual / NARROW**2, np.full(count, RUNGS[0][2]), False
    if count <= MANY:
        before, reached, is_probed = _probe(coordinates, level, normals)
    typical = float(np.median(before))
    ladder: list[tuple[int, Patches, AnyArray]] = []
    for rung, (wanted, ring, points) in enumerate(RUNGS):
        if on_progress:
            on_progress(rung / len(RUNGS))
        if count > MANY and ring != 2:
            continue
        last = rung + 2 >= len(RUNGS) or points > room.max()
        if (
            BLENDED * typical * SPREAD / (points**3 * area**2) > (HOPELESS * reference) ** 2
            and not last
        ):
            continue
        while depth < wanted:
            level, depth = coarsen(level, scramble), depth + 1
        patches = fit_patches(coordinates, level, ring, normals)
        square = _ring_mean(patches, patches.residual**2)
        now = square[level.owner]
        # no growth: all of it is noise; growth as of a misfit: none of it
        size = patches.size[level.owner]
        if rung or is_probed:  # the first rung reaches no further than the narrow fit
            # near rims, and in small pieces, patches hardly grow, and neither would a misfit
            growth = np.clip((size / reached) ** STEEP, 1.0, GROWTH) - 1
            found = before - np.maximum(now - before, 0) / np.maximum(growth, 1.0)
            is_told = (growth >= 1) & (points <= room)
            noise = np.maximum(noise, np.where(is_told, np.clip(found, 0, now), 0))
        ladder.append((rung, patches, square))
        before, reached = now, size
        typical = float(np.median(np.where(noise > 0, noise, now)))
        found = BLENDED * typical * float(np.median(patches.variance))
        if (
            last
            or (len(ladder) > 1 and found < (ENOUGH * reference) ** 2)
            or (rung and np.mean(now > 4 * noise) > 0.97)
        ):
            break
    share = np.minimum(noise * NARROW**2 / np.maximum(narrow.residual, 1e-300), OVERFITTED)
    error = narrow.residual * narrow.variance * (share + NARROW_BIAS * np.maximum(1 - share, 0))
    # smoothing is for noise only: where the shape is what a narrow fit cannot follow, a wide one
    # follows it less
    is_noisy = noise > (WORTH * reference) ** 2 / np.maximum(narrow.variance, 1e-300)
    chosen = np.full(count, -1)
    for place, (rung, patches, square) in enumerate(ladder):
        owner = patches.level.owner
        many = np.bincount(owner, minlength=len(square))
        own_noise = np.bincount(owner, noise, minlength=len(square)) / many
        free = np.maximum(patches.size - 15, 1)
        excess = np.maximum(square - own_noise * (1 + np.sqrt(0.5 / free)), 0)
        expected = patches.variance * (
            BLENDED * np.minimum(own_noise, square) + COHERENCE * patches.size * excess
        )
        expected[(patches.condition > 30) | (patches.size < 20)] = np.inf
        candidate = expected[owner]
        better = is_noisy & (candidate < error) & ((rung == 0) | (RUNGS[rung][2] <= room))
        chosen[better] = place
        error[better] = candidate[better]
    result = Choice(np.zeros((6, count)), np.zeros((count, 3)), error, np.full(count, -1), noise)
    for place, (rung, patches, _) in enumerate(ladder):
        vertices = np.flatnonzero(chosen == place)
        if len(vertices):
            field = blend(patches, coordinates, vertices)
            result.tensor[:, vertices] = field.tensor
            result.normals[vertices] = field.normals
            result.rung[vertices] = rung
    return result


def smooth_at(
    coordinates: Coordinates,
    graph: Graph,
    normals: AnyArray,
    narrow: Narrow,
    area: float,
    length: float,
    scramble: AnyArray,
) -> Choice:
    """Take everything below a length for noise.

    Patches whose radius is that length, at every vertex.

    A length below the narrow fit's own reach changes nothing; one beyond a quarter of the mesh is
    cut to the widest rung that fits.
    """
    count = len(scramble)
    result = Choice(
        np.zeros((6, count)),
        np.zeros((count, 3)),
        narrow.residual * narrow.variance,
        np.full(count, -1),
        narrow.residual.copy(),
    )
    wanted = np.pi * length**2 / max(area, 1e-300)
    if wanted < RUNGS[0][2] / 1.5:
        return result
    fitting = [rung for rung in range(len(RUNGS)) if FILLING * RUNGS[rung][2] <= count] or [0]
    rung = min(fitting, key=lambda r: abs(np.log(RUNGS[r][2] / wanted)))
    depth, ring, _ = RUNGS[rung]
    level = first_level(graph)
    for _ in range(depth):
        level = coarsen(level, scramble)
    patches = fit_patches(coordinates, level, ring, normals)
    owner = level.owner
    vertices = np.flatnonzero((patches.size >= 20)[owner] & (patches.condition < 1e3)[owner])
    if len(vertices):
        field = blend(patches, coordinates, vertices)
        result.tensor[:, vertices], result.normals[vertices] = field.tensor, field.normals
        result.rung[vertices] = rung
        result.noise[vertices] = patches.residual[owner[vertices]] ** 2
        result.error[vertices] = BLENDED * (patches.variance * patches.residual**2)[owner[vertices]]
    return result
