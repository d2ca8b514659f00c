# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Principal curvatures at every vertex of a mesh of smooth sectors."""

from __future__ import annotations

import numpy as np

from ..progress import part_of
from ..types import AnyArray, Progress
from .blocks import NarrowFit
from .developable import apexes, refine_developable, without
from .estimate import (
    EXACT,
    FALLBACK,
    SINGULAR,
    TRUSTED,
    UNDEFINED,
    Estimate,
    adopt,
    blank,
)
from .jet_fit import UNDETERMINED
from .narrow import CALIBRATION, narrow_fit, pilot_fit, ring_mean
from .neighborhoods import adjacency, edges_and_rim, without_hubs
from .normals import TriangleGeometry, angle_sums, first_normals
from .recipes import ordinary
from .smoothing import NARROW, Narrow, choose_scale, smooth_at

#: Noise is worth smoothing where it would change the curvature by more than this share, and where
#: this share of the vertices says so.
TRIGGER, COMMON = 0.003, 0.02
#: A fit of degree 4 over two rings errs by this times the noise over the area of a vertex.
ROUNDING_LAW = 2.3
#: A narrow fit expected to err by this share of the curvature it finds is not made at all.
HOPELESS = 0.25


def estimate_curvature(
    positions: AnyArray,
    triangles: AnyArray,
    *,
    rounding_step: float = 0.0,
    smoothing: str | float = "AUTO",
    on_progress: Progress | None = None,
) -> Estimate:
    """Return the curvature at every vertex of triangles that form smooth sectors.

    A height field of degree 4 is fitted over the nearest rings; where its residual tells of noise,
    patches of growing size compete, and the one
    that errs least wins. Time grows as n log n.

    Parameters
    ----------
    positions : (s, 3) float64
        In meters, centered. Sectors are cut along creases beforehand: nothing here looks across a
        missing edge.
    triangles : (t, 3) int
        Indices of sectors, counter-clockwise seen from outside. Zero-area triangles, unused
        vertices and separate pieces are allowed.
    rounding_step : float
        The step to which coordinates were rounded before (m), as by float32 storage; 0 if none.
    smoothing : "AUTO", "NONE" or float
        Choose the scale by noise; never smooth; or take everything below this length (m) for noise.
    on_progress : callable, optional
        Receives the share of the work that is done; may raise to stop it.

    Returns
    -------
    Estimate
        Finite everywhere.

    References
    ----------
    .. [1] Cazals, Pouget (2005). Estimating differential quantities using polynomial fitting of
           osculating jets. CAGD 22(2).
    .. [2] Goldfeather, Interrante (2004). A novel cubic-order algorithm for approximating
           principal direction vectors. ACM TOG 23(1).
    """
    count = len(positions)
    x, y, z = (np.ascontiguousarray(positions[:, i], dtype=float) for i in range(3))
    coordinates = (x, y, z)
    geometry = TriangleGeometry(coordinates, triangles)
    low, high, rim = edges_and_rim(triangles, count)
    graph = adjacency(low, high, count)
    del low, high
    walk = without_hubs(graph)
    normals, unfolded = first_normals(geometry, count)
    sound = np.einsum("ij,ij->i", normals, normals) > 0.5
    angles = angle_sums(geometry, count)
    defect = np.where(rim | (angles == 0), 0.0, 2 * np.pi - angles)
    area = 0.5 * geometry.double_area.sum() / max(int(sound.sum()), 1)
    del geometry
    extent = float(np.linalg.norm(np.ptp(positions, axis=0))) if count else 0.0
    apex = apexes(defect, graph) & sound
    open_graph, open_walk, edge = graph, walk, rim
    if apex.any():
        open_graph, open_walk = without(graph, apex), without(walk, apex)
        edge = (rim | (np.asarray(graph @ apex.astype(np.float32)) > 0)) & ~apex
    usable = sound & ~apex
    rounding = rounding_step / np.sqrt(12)
    how = ordinary(count, ROUNDING_LAW * rounding * extent / max(area, 1e-300))
    defect_without_apex = np.where(apex, 0.0, defect)
    tolerance = 8 * rounding_step / max(area, 1e-300) ** 0.5
    # the order of vertices must not matter, so neither may it for the clusters: angle sums are as
    # good as random numbers where there is noise
    scramble = (angles * 9973.0) % 1.0
    quality = np.where(sound, TRUSTED, UNDEFINED).astype(np.int8)
    quality[apex] = SINGULAR
    result = Estimate(
        k1=np.zeros(count),
        k2=np.zeros(count),
        direction_1=np.zeros((count, 3)),
        direction_2=np.zeros((count, 3)),
        normals=normals.copy(),
        quality=quality,
        error=np.zeros(count),
        noise=np.zeros(count),
    )

    def narrow(mask: AnyArray) -> Narrow:
        """Fit chosen vertices, store what was found and return it for the choice of scale."""
        fit = narrow_fit(
            coordinates,
            open_graph,
            open_walk,
            normals,
            edge,
            mask,
            how,
            part_of(on_progress, 0.15, 0.6),
        )
        exact = refine_developable(
            fit,
            coordinates,
            triangles,
            graph,
            walk,
            normals,
            defect_without_apex,
            unfolded,
            rim,
            mask,
            tolerance,
        )
        fit.variance[exact | apex] = 0
        square = np.maximum(ring_mean(walk, fit.residual**2), rounding**2)
        quality[mask & (fit.condition > UNDETERMINED / 2)] = FALLBACK
        quality[exact] = EXACT
        for name in ("k1", "k2", "direction_1", "direction_2", "normals"):
            getattr(result, name)[mask] = getattr(fit, name)[mask]
        result.error[mask] = np.sqrt(CALIBRATION * square * fit.variance)[mask]
        result.noise[mask] = np.sqrt(square)[mask]
        return Narrow(CALIBRATION * fit.variance, square)

    wide = part_of(on_progress, 0.6, 1.0)
    pilot = (
        pilot_fit(coordinates, open_graph, open_walk, normals, usable)
        if smoothing == "AUTO"
        else None
    )
    if pilot is not None and _is_hopeless(pilot, extent):
        result.roughness = float(np.median(pilot.residual)) / NARROW
        blind = Narrow(
            np.full(count, np.inf), np.full(count, float(np.median(pilot.residual)) ** 2)
        )
        choice = choose_scale(
            coordinates, open_walk, normals, blind, area, _reference(pilot, extent), scramble, wide
        )
        changed = (choice.rung >= 0) & usable
        if (usable & ~changed).any():
            narrow(usable & ~changed)
        adopt(result, choice, changed)
    else:
        fitted = narrow(usable)
        if usable.any():
            result.roughness = float(np.median(result.noise[usable])) / NARROW
        reference = _reference(result, extent, usable)
        # near rims fits err more without any noise
        inner = usable & ~edge
        noisy = (result.error > TRIGGER * reference)[inner if inner.any() else usable]
        if usable.any() and smoothing != "NONE" and (smoothing != "AUTO" or noisy.mean() > COMMON):
            if smoothing == "AUTO":
                choice = choose_scale(
                    coordinates, open_walk, normals, fitted, area, reference, scramble, wide
                )
            else:
                choice = smooth_at(
                    coordinates, open_walk, normals, fitted, area, float(smoothing), scramble
                )
            adopt(result, choice, (choice.rung >= 0) & usable)
    blank(result, extent)
    return result


def _reference(
    values: Estimate | NarrowFit, extent: float, usable: AnyArray | slice = slice(None)
) -> float:
    """Return the curvature that errors are compared with.

    The median, and no less than the inverse of the extent (1/m).
    """
    bend = np.maximum(np.abs(values.k1), np.abs(values.k2))[usable]
    return float(np.hypot(np.median(bend) if len(bend) else 0.0, 1 / max(extent, 1e-60)))


def _is_hopeless(pilot: NarrowFit, extent: float) -> bool:
    """Return whether the narrow fit would drown in noise, so that only patches can help."""
    expected = np.sqrt(CALIBRATION * pilot.variance) * pilot.residual
    # the pilot's own curvature is noise too: most of it is not there
    return bool(np.quantile(expected, 0.1) > HOPELESS * _reference(pilot, extent))
