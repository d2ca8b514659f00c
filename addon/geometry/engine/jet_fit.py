# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fit a polynomial height field over the tangent plane of every vertex.

The local jet of the surface.

References
----------
.. [1] Cazals, Pouget (2005). Estimating differential quantities using polynomial fitting of
       osculating jets. CAGD 22(2).
"""

from __future__ import annotations

from dataclasses import dataclass
from math import comb

import numpy as np

from ..types import AnyArray, Coordinates
from .cholesky import backward, factorize, forward
from .monomials import exponents, moments
from .normals import tangent_frame

#: Neighborhoods are made round before fitting; thinner ones than this are only stretched so far.
THINNEST = 1e-2
#: Squared lengths below this are zero (m²).
TINY = 1e-60
#: The condition of a fit with fewer points than unknowns.
UNDETERMINED = 1e9


@dataclass(frozen=True)
class JetOptions:
    """How to fit.

    Total degree, with or without a constant, weight (r² + softening)^(-falloff/2) in units of the
    RMS radius, ridges.
    """

    degree: int = 4
    constant: bool = False
    falloff: float = 4.0
    softening: float = 0.02
    ridge_high: float = 1e-9
    ridge_low: float = 1e-10


@dataclass
class Jet:
    """Height fields of m fits, each in its own frame at its own origin.

    Attributes
    ----------
    gradient : (2, m), hessian : (3, m)
        z_x, z_y and z_xx, z_xy, z_yy at the origin (1, 1/m).
    first, second, normal : (m, 3)
        The frame.
    residual : (m,)
        Weighted RMS height residual, corrected for the unknowns (m).
    variance : (m,)
        Variance of the Hessian's Frobenius norm for unit variance of the heights (1/m⁴).
    condition : (m,)
        Square root of the variance of the trace in units of the neighborhood: how well the points
        determine it (pure number).
    freedom : (m,)
        Points minus unknowns.
    radius : (m,)
        RMS distance of the neighbors (m).
    coefficients : (p, m) or None
        All unknowns over the stretched coordinates, in meters.
    stretch : (3, m)
        (u, v) = (s0 x + s1 y, s1 x + s2 y), in 1/m.
    """

    gradient: AnyArray
    hessian: AnyArray
    first: AnyArray
    second: AnyArray
    normal: AnyArray
    residual: AnyArray
    variance: AnyArray
    condition: AnyArray
    freedom: AnyArray
    radius: AnyArray
    coefficients: AnyArray | None
    stretch: AnyArray


def fit_jets(
    coordinates: Coordinates,
    table: AnyArray,
    used: AnyArray,
    centers: AnyArray,
    normals: AnyArray,
    options: JetOptions,
    full: bool = False,
) -> Jet:
    """Fit one jet per column of the table.

    Parameters
    ----------
    coordinates : three (n,) float64
        x, y, z of all vertices.
    table : (k, m) int
        Neighbors, padded with the center.
    used : (m,) int
        True entries of each column.
    centers : (m,) int
    normals : (m, 3) float64
        Unit vectors; the heights are measured along them.
    full : bool
        Keep all coefficients.
    """
    first, second = tangent_frame(normals)
    dx, dy, dz = (c[table] - c[centers] for c in coordinates)
    x, y, z = (dx * f[:, 0] + dy * f[:, 1] + dz * f[:, 2] for f in (first, second, normals))
    del dx, dy, dz
    count = np.maximum(used - 1, 1)  # the center itself is in its ring
    xx, xy, yy = (np.einsum("km,km->m", a, b) / count for a, b in ((x, x), (x, y), (y, y)))
    # whitening by the symmetric root of the second moments: it turns with the surface, as a
    # triangular one would not
    mean, gap = (xx + yy) / 2, np.hypot((xx - yy) / 2, xy)
    floor = np.maximum((mean + gap) * THINNEST**2, TINY)
    lift = np.maximum(floor - (mean - gap), 0.0)
    low, high = mean - gap + lift, mean + gap + lift
    root = np.sqrt(low * high)
    divisor = root * np.sqrt(low + high + 2 * root)
    s0, s1, s2 = (yy + lift + root) / divisor, -xy / divisor, (xx + lift + root) / divisor
    scale = np.sqrt(np.maximum(mean, TINY))
    weight = None
    if options.falloff:
        # round in space, not in the stretched coordinates: far points of a long neighborhood count
        # less
        weight = x * x
        weight += y * y
        weight *= 0.5 / scale**2
        weight += options.softening
        np.divide(1.0, weight, out=weight)
        if options.falloff == 4.0:
            weight *= weight
        elif options.falloff != 2.0:
            weight **= options.falloff / 2
        # padding must not count in the sum of weights, or results would depend on the chunk
        weight *= np.arange(len(table))[:, None] < used
    else:
        weight = (np.arange(len(table))[:, None] < used).astype(float)
    weight /= weight.sum(axis=0)
    u = x * s0
    u += y * s1
    y *= s2
    y += x * s1
    x = u
    z /= scale
    basis = exponents(options.degree, options.constant)
    gram, right, height = moments(x, y, z, weight, basis)
    for i, (a, b) in enumerate(basis):
        # weights of Bombieri's norm, which no turn of the frame changes
        gram[i, i] += (options.ridge_high if a + b > 2 else options.ridge_low) / comb(a + b, a)
    factor = factorize(gram)
    reduced = forward(factor, right)
    solved = backward(factor, reduced, len(basis) if full else 5) * scale
    # the minimum found includes the ridge's own penalty, which on clean meshes is larger than the
    # misfit
    explained = (
        np.einsum("pm,pm->m", reduced, reduced)
        + options.ridge_low * (np.sum(solved[-5:] ** 2, axis=0) - 0.5 * solved[-2] ** 2) / scale**2
    )
    freedom = used - (0 if options.constant else 1) - len(basis)
    share = np.maximum(freedom, 1) / np.maximum(used, 1)
    residual = scale * np.sqrt(np.maximum(height - explained, 0) / share)
    cu, cv, cuu, cuv, cvv = solved[-5:]
    cuu, cvv = 2 * cuu, 2 * cvv
    gradient = np.stack([cu * s0 + cv * s1, cu * s1 + cv * s2])
    cross = s0 * s2 + s1 * s1
    hessian = np.stack(
        [
            cuu * s0**2 + 2 * cuv * s0 * s1 + cvv * s1**2,
            cuu * s0 * s1 + cuv * cross + cvv * s1 * s2,
            cuu * s1**2 + 2 * cuv * s1 * s2 + cvv * s2**2,
        ]
    )
    spread = np.einsum("km,km->m", weight, weight)
    last = factor[-3:, -3:]
    zero = np.zeros_like(s0)
    # rows of the map from the unknowns to (z_xx, sqrt 2 z_xy, z_yy)
    functionals = (
        [2 * s0**2, 2 * s0 * s1, 2 * s1**2],
        [np.sqrt(8) * s0 * s1, np.sqrt(2) * cross, np.sqrt(8) * s1 * s2],
        [2 * s1**2, 2 * s1 * s2, 2 * s2**2],
    )
    variance = sum(np.sum(forward(last, np.stack(f)) ** 2, axis=0) for f in functionals) * spread
    flat = forward(last, np.stack([zero + 2, zero, zero + 2]))
    condition = np.sqrt(np.sum(flat**2, axis=0) * spread)
    condition[freedom < 1] = UNDETERMINED
    return Jet(
        gradient,
        hessian,
        first,
        second,
        normals,
        residual,
        variance,
        condition,
        freedom,
        scale,
        solved if full else None,
        np.stack([s0, s1, s2]),
    )


def shape_operator(jet: Jet) -> tuple[AnyArray, AnyArray, AnyArray, AnyArray, AnyArray]:
    """Return k1, k2 (m,), direction_1, direction_2 and normal (m, 3) of jets.

    By the Weingarten map at the tilted tangent plane.

    k > 0 where the surface bends away from the normal.
    """
    p, q = jet.gradient
    form_xx, form_xy, form_yy = 1 + p * p, p * q, 1 + q * q
    area = np.sqrt(form_xx + form_yy - 1)  # sqrt(1 + p² + q²)
    bend_xx, bend_xy, bend_yy = -jet.hessian / area
    # orthonormal basis of the tangent plane: e = T_x / root, f = (T_y - form_xy / form_xx T_x) *
    # root / area
    root = np.sqrt(form_xx)
    a = bend_xx / form_xx
    b = (bend_xy - form_xy / form_xx * bend_xx) / area
    c = (
        (bend_yy - 2 * form_xy / form_xx * bend_xy + (form_xy / form_xx) ** 2 * bend_xx)
        * form_xx
        / area**2
    )
    mean, half = (a + c) / 2, (a - c) / 2
    gap = np.hypot(half, b)
    angle = 0.5 * np.arctan2(b, half)
    normal = (jet.normal - p[:, None] * jet.first - q[:, None] * jet.second) / area[:, None]
    e = (jet.first + p[:, None] * jet.normal) / root[:, None]
    f = np.cross(normal, e)
    direction_1 = np.cos(angle)[:, None] * e + np.sin(angle)[:, None] * f
    return mean + gap, mean - gap, direction_1, np.cross(normal, direction_1), normal
