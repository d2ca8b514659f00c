# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Exact developables and cone points: what the angle defect of a mesh says at once.

A mesh of flat strips (a cylinder, a fillet, a cone as CAD programs tessellate them) has no angle
defect inside, to rounding: noise never leaves
that. There the nearest ring is exact across the strips, while wider fits mix a fillet with the
flat beside it. A vertex whose defect stands
out from its neighbors' is the apex of a cone: no tangent plane, and no fit may lean on it.
"""

from __future__ import annotations

import numpy as np

from ..types import AnyArray, Coordinates, Graph
from .blocks import NarrowFit, fit_into
from .jet_fit import JetOptions
from .strips import Strips, strips_at

#: Angle defects below this are rounding (radians).
NO_DEFECT = 1e-5
#: An apex has at least this defect (radians) and this many times the mean of its neighbors'.
APEX_DEFECT, APEX_CONTRAST = 0.15, 8.0
#: A fit expected to err by more than this share is replaced where the mesh is developable.
DOUBTFUL = 0.005
#: A fit that errs by this share, or is conditioned like this, does not even know its directions;
#: on a rim fits look worse than they are.
USELESS, USELESS_RIM = 0.2, 1.0
UNCONDITIONED = 1e5
#: Cosine by which a strip's ruling and the straight direction of a fit of use must agree.
ALIGNED = 0.98
#: Folds are read where they exceed the angles of rounding by this factor.
READABLE = 100.0
ONE_RING = JetOptions(degree=2, falloff=0.0, ridge_low=1e-7)


def apexes(defect: AnyArray, graph: Graph) -> AnyArray:
    """Return a mask of cone points: their defect stands out from their neighbors'."""
    size = np.abs(defect)
    around = (graph @ size - size) / np.maximum(np.diff(graph.indptr) - 1, 1)
    return (size > APEX_DEFECT) & (size > APEX_CONTRAST * around)


def without(graph: Graph, vertices: AnyArray) -> Graph:
    """Return the graph with chosen vertices cut off from all others."""
    if not vertices.any():
        return graph
    keep = ~vertices
    row: AnyArray = np.repeat(np.arange(int(graph.shape[0])), np.diff(graph.indptr))
    linked = (keep[row] & keep[graph.indices]) | (row == graph.indices)
    result = graph.copy()
    result.data = linked.astype(graph.data.dtype)
    result.eliminate_zeros()
    return result


def refine_developable(
    fit: NarrowFit,
    coordinates: Coordinates,
    triangles: AnyArray,
    graph: Graph,
    walk: Graph,
    normals: AnyArray,
    defect: AnyArray,
    unfolded: AnyArray,
    rim: AnyArray,
    sound: AnyArray,
    tolerance: float,
) -> AnyArray:
    """Replace doubtful fits of exactly developable vertices.

    The circle across the strips takes their place; the osculating paraboloid of the nearest ring
    where there are no strips and the fit is useless.

    Parameters
    ----------
    unfolded : (n,) bool
        Vertices with triangles in one plane only.
    graph : sparse
        With apexes: the apex lies on the rulings of its neighbors, and helps them.
    tolerance : float
        Defects below this are rounding (radians).

    Returns
    -------
    (n,) bool
        The vertices that were replaced; their residual is 0, as nothing is left to smooth.
    """
    curved = np.abs(defect) > max(tolerance, NO_DEFECT)
    # three rings: on a rim nothing nearer may have a defect to show
    near = curved.astype(np.float32)
    for _ in range(3):
        near = (np.asarray(walk @ near) > 0).astype(np.float32)
    flat_around = near == 0
    # an apex beside it does not make a vertex less developable
    expected = 0.63 * fit.residual * np.sqrt(fit.variance)
    curvature = np.maximum(np.abs(fit.k1), np.abs(fit.k2))
    useless = expected > np.where(rim, USELESS_RIM, USELESS) * curvature
    useless |= fit.condition > UNCONDITIONED
    doubtful = expected > DOUBTFUL * curvature
    chosen = flat_around & doubtful & sound
    # a fit over few positions across the rulings does not know how little it knows
    chosen |= flat_around & unfolded & sound & ~rim
    vertices = np.flatnonzero(chosen | (flat_around & useless & sound))
    if not len(vertices):
        return np.zeros(len(defect), bool)
    strips = strips_at(coordinates, triangles, vertices, READABLE * tolerance)
    # where only one fold is seen, at a corner of the rim, it may be a diagonal and no ruling
    straight = np.where(
        (np.abs(fit.k1) >= np.abs(fit.k2))[:, None], fit.direction_2, fit.direction_1
    )[vertices]
    agrees = np.abs(np.einsum("ij,ij->i", straight, strips.ruling)) > ALIGNED
    strips.is_found &= agrees | useless[vertices]
    # a rim along a ruling has no fold either
    strips.is_flat &= ~rim[vertices]
    strips.is_found &= doubtful[vertices]
    chosen[vertices] = strips.is_found | strips.is_flat
    rest = np.flatnonzero(flat_around & useless & sound & ~chosen)
    fit_into(fit, coordinates, graph, walk, normals, rest, 1, ONE_RING)
    _take(fit, vertices[strips.is_found], strips)
    plain = vertices[strips.is_flat]
    fit.k1[plain], fit.k2[plain] = 0, 0
    chosen[rest] = True
    fit.residual[chosen] = 0
    return chosen


def _take(fit: NarrowFit, vertices: AnyArray, strips: Strips) -> None:
    """Store the curvature of strips."""
    found = strips.is_found
    bend, ruling, normal = strips.bend[found], strips.ruling[found], strips.normal[found]
    # r x n, so that the second direction is n times the first
    across = np.cross(ruling, normal)
    is_outward = (bend >= 0)[:, None]
    fit.k1[vertices], fit.k2[vertices] = np.maximum(bend, 0), np.minimum(bend, 0)
    fit.direction_1[vertices] = np.where(is_outward, across, ruling)
    fit.direction_2[vertices] = np.cross(normal, fit.direction_1[vertices])
    fit.normals[vertices] = normal
