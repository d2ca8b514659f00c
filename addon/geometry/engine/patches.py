# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Smooth a noisy surface by polynomial patches over clusters, and read curvature off them.

A fit over hundreds of vertices varies slowly: it is made once per cluster and evaluated, with its
neighbors' fits, at every vertex (a partition of
unity), instead of once per vertex.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..types import AnyArray, Coordinates
from .clusters import Clusters
from .jet_fit import JetOptions, fit_jets
from .monomials import exponents
from .neighborhoods import padded_table, rings

PATCH = JetOptions(constant=True, falloff=0.0)
#: Table entries (neighbors times fits) worked on at once.
ENTRIES = 120_000
#: Pairs of vertex and patch evaluated at once.
PAIRS = 60_000
#: Most points of one patch; more are thinned evenly, as more could not lower the noise enough to
#: matter.
LARGEST = 6000


@dataclass
class Patches:
    """Fits over m clusters; see `jet_fit.Jet` for the arrays."""

    level: Clusters
    origin: AnyArray
    first: AnyArray
    second: AnyArray
    normal: AnyArray
    stretch: AnyArray
    coefficients: AnyArray
    residual: AnyArray
    variance: AnyArray
    condition: AnyArray
    size: AnyArray
    reach: AnyArray


@dataclass
class Field:
    """Curvature at n vertices as a tensor.

    Attributes
    ----------
    tensor : (6, n)
        xx, yy, zz, xy, xz, yz of a symmetric matrix T with II(e, f) = e·T f for tangent vectors e,
        f (1/m); positive where the surface bends
        away from the normal.
    normals : (n, 3)
    """

    tensor: AnyArray
    normals: AnyArray


def fit_patches(coordinates: Coordinates, level: Clusters, ring: int, normals: AnyArray) -> Patches:
    """Fit a polynomial over the clusters within `ring` steps of each cluster."""
    near = rings(level.graph, level.graph, slice(None), ring)
    rows = (near @ level.members).tocsr()
    direction = near @ (level.members @ normals)
    length = np.linalg.norm(direction, axis=1)
    root_normals = normals[level.roots]
    direction = np.where(
        length[:, None] > 1e-12, direction / np.maximum(length, 1e-12)[:, None], root_normals
    )
    count = len(level.roots)
    p = len(exponents(PATCH.degree, PATCH.constant))
    first, second = np.empty((count, 3)), np.empty((count, 3))
    stretch, coefficients = np.empty((3, count)), np.empty((p, count))
    residual, variance, condition, reach = (np.empty(count) for _ in range(4))
    size = np.diff(rows.indptr)
    order = np.argsort(size, kind="stable")
    position = 0
    while position < count:
        width = min(int(size[order[min(position + 500, count - 1)]]), LARGEST)
        chosen = order[position : position + max(8, ENTRIES // width)]
        position += len(chosen)
        table, used = padded_table(rows, chosen, level.roots[chosen], LARGEST)
        jet = fit_jets(
            coordinates, table, used, level.roots[chosen], direction[chosen], PATCH, full=True
        )
        first[chosen], second[chosen], stretch[:, chosen], coefficients[:, chosen] = (
            jet.first,
            jet.second,
            jet.stretch,
            jet.coefficients,
        )
        residual[chosen], variance[chosen], condition[chosen], reach[chosen] = (
            jet.residual,
            jet.variance,
            jet.condition,
            jet.radius,
        )
    origin = np.stack([c[level.roots] for c in coordinates], axis=1)
    return Patches(
        level,
        origin,
        first,
        second,
        direction,
        stretch,
        coefficients,
        residual,
        variance,
        condition,
        size,
        reach,
    )


def _evaluate(patches: Patches, index: AnyArray, offset: AnyArray) -> tuple[AnyArray, AnyArray]:
    """Return the tensor (6, q) and normal (3, q) of patches at points.

    The points are given by offsets (3, q) from the origins of the patches.
    """
    first, second, normal = (
        np.take(v, index, axis=0).T for v in (patches.first, patches.second, patches.normal)
    )
    x = np.einsum("kq,kq->q", first, offset)
    y = np.einsum("kq,kq->q", second, offset)
    s0, s1, s2 = np.take(patches.stretch, index, axis=1)
    u, v = s0 * x + s1 * y, s1 * x + s2 * y
    c = np.take(patches.coefficients, index, axis=1)
    power_u, power_v = [np.ones_like(u), u], [np.ones_like(u), v]
    for _ in range(PATCH.degree - 2):
        power_u.append(power_u[-1] * u)
        power_v.append(power_v[-1] * v)
    fu, fv, fuu, fuv, fvv = (np.zeros_like(u) for _ in range(5))
    for (a, b), value in zip(exponents(PATCH.degree, PATCH.constant), c, strict=True):
        if a:
            fu += a * value * power_u[a - 1] * power_v[b]
        if b:
            fv += b * value * power_u[a] * power_v[b - 1]
        if a > 1:
            fuu += a * (a - 1) * value * power_u[a - 2] * power_v[b]
        if a and b:
            fuv += a * b * value * power_u[a - 1] * power_v[b - 1]
        if b > 1:
            fvv += b * (b - 1) * value * power_u[a] * power_v[b - 2]
    p, q = fu * s0 + fv * s1, fu * s1 + fv * s2
    inverse = 1 / np.sqrt(1 + p * p + q * q)
    xx = -(fuu * s0 * s0 + 2 * fuv * s0 * s1 + fvv * s1 * s1) * inverse
    xy = -(fuu * s0 * s1 + fuv * (s0 * s2 + s1 * s1) + fvv * s1 * s2) * inverse
    yy = -(fuu * s1 * s1 + 2 * fuv * s1 * s2 + fvv * s2 * s2) * inverse
    a = xx * first + xy * second
    b = xy * first + yy * second
    tensor = np.empty((6, len(u)))
    tensor[:3] = a * first + b * second
    tensor[3] = a[0] * first[1] + b[0] * second[1]
    tensor[4] = a[0] * first[2] + b[0] * second[2]
    tensor[5] = a[1] * first[2] + b[1] * second[2]
    return tensor, (normal - p * first - q * second) * inverse


def blend(patches: Patches, coordinates: Coordinates, vertices: AnyArray) -> Field:
    """Return the curvature field at chosen vertices.

    Each is blended from the patch of its own cluster and those beside it.
    """
    level = patches.level
    graph, owner = level.graph, level.owner
    count = len(vertices)
    # a patch's weight falls to zero a little beyond the roots of the clusters beside it
    row = np.repeat(np.arange(len(level.roots)), np.diff(graph.indptr))
    gap = np.sum((patches.origin[row] - patches.origin[graph.indices]) ** 2, axis=1)
    width = np.maximum.reduceat(gap, graph.indptr[:-1])
    inverse_width = 1 / np.maximum(width, 1e-200)
    tensor, normals = np.empty((6, count)), np.empty((3, count))
    cluster = owner[vertices]
    order = np.argsort(cluster, kind="stable")
    start, length = graph.indptr[cluster[order]], np.diff(graph.indptr)[cluster[order]]
    edges = np.concatenate([[0], np.cumsum(length)])
    position = 0
    while position < count:
        end = max(
            position + 1, int(np.searchsorted(edges, edges[position] + PAIRS, side="right")) - 1
        )
        piece, many = order[position:end], length[position:end]
        first_pair = edges[position:end] - edges[position]
        pairs = int(edges[end]) - int(edges[position])
        slot: AnyArray = np.repeat(start[position:end] - first_pair, many)
        slot += np.arange(pairs)
        index = graph.indices[slot]
        vertex = vertices[np.repeat(piece, many)]
        offset = np.stack([c[vertex] - patches.origin[index, i] for i, c in enumerate(coordinates)])
        fraction = np.einsum("kq,kq->q", offset, offset) * inverse_width[index]
        weight = np.maximum(1 - fraction, 0) ** 2 / patches.variance[index]
        weight += 1e-6 * (index == owner[vertex]) / patches.variance[index]
        part, normal = _evaluate(patches, index, offset)
        total = np.add.reduceat(weight, first_pair)
        tensor[:, piece] = np.add.reduceat(part * weight, first_pair, axis=1) / total
        normals[:, piece] = np.add.reduceat(normal * weight, first_pair, axis=1) / total
        position = end
    normals /= np.maximum(np.linalg.norm(normals, axis=0), 1e-12)
    return Field(tensor, normals.T)
