# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Primitives fitted to points of a surface: a first guess from normals, then least squares."""

from __future__ import annotations

import numpy as np

from ..types import Floats
from .shapes import Kind, Primitive, frame_of

#: Steps of least squares; from a good guess three are enough.
_STEPS = 8
#: Tukey's weights vanish at this many standard deviations: 95 % efficient for normal noise.
_TUKEY = 4.685
#: Standard deviations per median of the absolute value, of normal noise.
_MEDIAN = 1.4826
#: Share of its diagonal that keeps a system solvable.
_LEAST_DAMPING = 1e-10
#: A step that changes lengths by no more than this share of the scatter of heights is the last.
_DONE = 0.01
#: Where heights scatter by this much more than is of use, a step must gain more than a percent.
_HOPELESS, _GAIN = 3.0, 0.99
#: The most curved surface that is still one, as a share of the points' extent: less is noise.
_SMALLEST = 1e-3


def first_guesses(kind: Kind, points: Floats, normals: Floats) -> list[Primitive]:
    """Return primitives of a kind that may describe points, to be refined.

    Parameters
    ----------
    kind : Kind
    points : (n, 3) float64
    normals : (n, 3) float64
        Unit normals of the surface, as good as they are known.

    Returns
    -------
    list of Primitive

    References
    ----------
    .. [1] Pottmann, Randrup (1998). Rotational and helical surface approximation for reverse
           engineering. Computing 60.
    """
    middle = points.mean(axis=0)
    local = points - middle
    scale = float(np.sqrt((local * local).sum(axis=1).mean())) or 1.0
    if kind is Kind.PLANE:
        _, vectors = np.linalg.eigh(local.T @ local)
        return [Primitive(kind, middle, frame_of(vectors[:, 0]), ())]
    if kind is Kind.SPHERE:
        center, radius = _center(local / scale)
        return [Primitive(kind, middle + scale * center, np.eye(3), (scale * radius,))]
    guesses: list[Primitive] = []
    for axis, through in _axes(local / scale, normals):
        origin, frame = middle + scale * through, frame_of(axis)
        x, y, z = ((points - origin) @ frame.T).T
        # The origin goes along the axis to where the points are.
        origin = origin + z.mean() * frame[2]
        rho, z = np.hypot(x, y), z - z.mean()
        if kind is Kind.CYLINDER:
            sizes: tuple[float, ...] = (float(rho.mean()),)
        elif kind is Kind.CONE:
            slope = float((z * (rho - rho.mean())).sum() / max((z * z).sum(), 1e-300))
            sizes = (float(rho.mean()), float(np.arctan(slope)))
        else:
            center, radius = _center(np.stack([rho, z], axis=1) / scale)
            origin = origin + scale * center[1] * frame[2]
            sizes = (float(scale * center[0]), scale * radius)
        guesses.append(Primitive(kind, origin, frame, sizes))
    return guesses


def refine(primitive: Primitive, points: Floats, floor: float, most: float = np.inf) -> Primitive:
    """Return the primitive of the same kind nearest to points, outliers disregarded.

    Parameters
    ----------
    primitive : Primitive
        A good guess.
    points : (n, 3) float64
    floor : float
        Heights in meters below which nothing is to be gained; above 0.
    most : float
        Standard deviation of heights in meters above which nothing is of use: what stays far above
        it is not refined to the end.

    Returns
    -------
    Primitive

    References
    ----------
    .. [1] Lukács, Martin, Marshall (1998). Faithful least-squares fitting of spheres, cylinders,
           cones and tori for reliable segmentation. ECCV.
    """
    extent = float(np.linalg.norm(np.ptp(points, axis=0)))
    damping = _LEAST_DAMPING
    height, by = primitive.derivatives(points)
    for _ in range(_STEPS):
        scatter = max(_MEDIAN * _median(np.abs(height)), floor)
        share = _tukey(height, scatter)
        square = np.einsum("nd,nd->d", by, by) / len(points)
        scale = np.sqrt(np.maximum(square, 1e-24 * square.mean()))
        scale[scale <= 0.0] = 1.0
        columns = by / scale
        weighted: Floats = (share * share)[:, None] * columns
        system: Floats = columns.T @ weighted
        system.flat[:: len(scale) + 1] += damping * len(points)
        right: Floats = weighted.T @ height
        change = np.asarray(-np.linalg.solve(system, right), dtype=np.float64)
        changed = primitive.changed(change / scale)
        if changed.sizes and abs(changed.sizes[-1]) < _SMALLEST * extent * (
            changed.kind is not Kind.CONE
        ):
            break
        new_height, new_by = changed.derivatives(points)
        new_cost, cost = _cost(_tukey(new_height, scatter)), _cost(share)
        if new_cost <= cost:
            if scatter > _HOPELESS * most and new_cost > _GAIN * cost:
                break
            primitive, height, by = changed, new_height, new_by
            damping = max(0.1 * damping, _LEAST_DAMPING)
            if np.abs(change).max() <= _DONE * scatter:
                break
        else:
            damping = max(1e3 * damping, 1e-6)
    return primitive


def _median(values: Floats) -> float:
    """Return the median; without the checks of numpy's, which cost more than finding it."""
    half = len(values) // 2
    if len(values) % 2:
        return float(np.partition(values, half)[half])
    ordered = np.partition(values, [half - 1, half])
    return 0.5 * float(ordered[half - 1] + ordered[half])


def _tukey(height: Floats, scatter: float) -> Floats:
    """Return the roots of Tukey's weights."""
    share = height / (_TUKEY * scatter)
    share *= share
    return np.maximum(1.0 - share, 0.0)


def _cost(share: Floats) -> float:
    """Return what Tukey's weights minimize, up to a factor, given their roots."""
    return float((1.0 - share * share * share).sum())


def _center(points: Floats) -> tuple[Floats, float]:
    """Return center and radius of the circle or sphere through points: |p|² = 2 c p + d."""
    square = (points * points).sum(axis=1)
    system: Floats = np.concatenate([2.0 * points, np.ones((len(points), 1))], axis=1)
    solution = np.asarray(np.linalg.lstsq(system, square, rcond=1e-12)[0], dtype=np.float64)
    center = solution[:-1]
    return center, float(np.sqrt(max(float(solution[-1] + center @ center), 1e-12)))


def _axes(points: Floats, normals: Floats) -> list[tuple[Floats, Floats]]:
    """Return directions and points of lines that all normals about meet, best first.

    A rotation with velocity a + c x p keeps the surface where (a + c x p) n = 0: the linear
    complex with least residual under |c| = 1.
    """
    moment = np.asarray(np.cross(points, normals), dtype=np.float64)
    slide: Floats = normals.T @ normals
    slide += (1e-6 * float(np.trace(slide)) + 1e-12) * np.eye(3)
    mixed: Floats = moment.T @ normals
    lever = np.asarray(np.linalg.solve(slide, mixed.T), dtype=np.float64)
    _, vectors = np.linalg.eigh(moment.T @ moment - mixed @ lever)
    found: list[tuple[Floats, Floats]] = []
    for number in (0, 1):
        axis = np.asarray(vectors[:, number], dtype=np.float64)
        found.append((axis, np.asarray(np.cross(axis, -lever @ axis), dtype=np.float64)))
    return found
