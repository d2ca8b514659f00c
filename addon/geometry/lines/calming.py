# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A direction field without what a mesh is too coarse to tell: pairs of umbilics, kinks.

Two umbilics of opposite index that are a few edges apart cancel: seen from farther away there is
none. Lines between them would turn sharply, whatever becomes of the points themselves, so the
directions around are found anew from those farther out; likewise where directions turn within a
triangle by more than a line can follow.
"""

from __future__ import annotations

import numpy as np

from ..types import Flags, Floats, Indices
from .areas import Areas
from .field import WEAK, DirectionField
from .filling import filled
from .transport import Transport

#: Umbilics of opposite index no farther apart than this many edges cancel, or this many where all
#: directions around are weak.
_NEAR, _NEAR_WEAK = 3.0, 8.0
#: Directions are found anew up to this many edges from a pair, and this share of its distance.
_AROUND, _SHARE = 2.0, 0.5
#: Turn of the deviator along a side, in radians, that no line can follow: directions turn by 45
#: degrees and more.
_KINK = np.pi / 2.0
#: Most rounds; a pair that comes back every time stays.
_ROUNDS = 4


def half_indices(transport: Transport, turn: Floats) -> Floats:
    """Return the index of a field in every triangle, (t,) float64, in halves.

    Parameters
    ----------
    transport : Transport
    turn : (t, 3) float64
        Of the field's deviator along the sides.
    """
    return (turn.sum(axis=1) + 2.0 * transport.excess) / (2.0 * np.pi)


def calmed(field: DirectionField, transport: Transport, areas: Areas) -> DirectionField:
    """Return the field without pairs of umbilics that cancel.

    Parameters
    ----------
    field : DirectionField
    transport : Transport
        Of its mesh and normals.
    areas : Areas

    Returns
    -------
    DirectionField
    """
    for attempt in range(_ROUNDS):
        turn = transport.turn(field.deviator)
        index = np.rint(half_indices(transport, turn)).astype(np.int64)
        index[areas.triangle_area >= 0] = 0
        one, other = _pairs(field, index)
        is_open = _kinks(field, turn, index, areas)
        if len(one):
            is_open |= _around(field, one, other, 1.0 + 0.5 * attempt)
        if not is_open.any():
            break
        field = filled(field, transport, is_open, areas)
    return field


def _kinks(field: DirectionField, turn: Floats, index: Indices, areas: Areas) -> Flags:
    """Return the sectors at sides along which directions turn too much to follow, (s,) bool.

    Umbilics stay where they are: around them directions turn rightly.
    """
    start = field.mesh.triangles
    is_kink = np.abs(turn) > _KINK
    is_kink &= (areas.triangle_area < 0)[:, None]
    is_open = np.zeros(field.mesh.sector_count, dtype=np.bool_)
    is_open[start[is_kink]] = is_open[np.roll(start, -1, axis=1)[is_kink]] = True
    is_open[start[index != 0]] = False
    return is_open


def _pairs(field: DirectionField, index: Indices) -> tuple[Indices, Indices]:
    """Return pairs of triangles with opposite indices that cancel, nearest first."""
    from scipy.spatial import cKDTree

    mesh = field.mesh
    triangle = np.flatnonzero(index)
    is_weak = (field.confidence < WEAK)[mesh.triangles[triangle]].any(axis=1)
    middle = mesh.position[mesh.triangles[triangle]].mean(axis=1)
    sign = np.sign(index[triangle])
    reach = np.where(is_weak, _NEAR_WEAK, _NEAR) * mesh.edge_length
    found: list[tuple[Indices, Indices]] = []
    is_left = np.ones(len(triangle), dtype=np.bool_)
    while True:
        plus, minus = np.flatnonzero(is_left & (sign > 0)), np.flatnonzero(is_left & (sign < 0))
        if not (len(plus) and len(minus)):
            break
        near = cKDTree(middle[minus]).query(middle[plus])
        away, to_minus = np.asarray(near[0]), np.asarray(near[1], dtype=np.int64)
        to_plus = np.asarray(cKDTree(middle[plus]).query(middle[minus])[1], dtype=np.int64)
        mutual: Flags = to_plus[to_minus] == np.arange(len(plus))
        mutual &= away <= np.minimum(reach[plus], reach[minus[to_minus]])
        if not mutual.any():
            break
        one, other = plus[mutual], minus[to_minus[mutual]]
        is_left[one] = is_left[other] = False
        found.append((one, other))
    one = np.concatenate([pair[0] for pair in found] or [np.zeros(0, dtype=np.int64)])
    other = np.concatenate([pair[1] for pair in found] or [np.zeros(0, dtype=np.int64)])
    return triangle[one], triangle[other]


def _around(field: DirectionField, one: Indices, other: Indices, factor: float) -> Flags:
    """Return the sectors around the segments between pairs of triangles, (s,) bool."""
    from scipy.spatial import cKDTree

    mesh = field.mesh
    start = mesh.position[mesh.triangles[one]].mean(axis=1)
    chord = mesh.position[mesh.triangles[other]].mean(axis=1) - start
    length = np.linalg.norm(chord, axis=1)
    radius = factor * np.maximum(_AROUND * mesh.edge_length, _SHARE * length)
    reach = radius + 0.5 * length
    tree, middles = cKDTree(mesh.position), cKDTree(start + 0.5 * chord)
    found = middles.sparse_distance_matrix(tree, float(reach.max()), output_type="ndarray")
    pair, sector = found["i"].astype(np.int64), found["j"].astype(np.int64)
    apart = mesh.position[sector] - start[pair]
    square = np.maximum(length**2, 1e-300)[pair]
    share = np.clip(np.einsum("ix,ix->i", apart, chord[pair]) / square, 0.0, 1.0)
    away = np.linalg.norm(apart - share[:, None] * chord[pair], axis=1)
    # The far side of a thin shell is far away.
    faces = np.einsum("ix,ix->i", field.normal[sector], mesh.frame[one[pair], 2])
    is_open = np.zeros(mesh.sector_count, dtype=np.bool_)
    is_open[sector[(away <= radius[pair]) & (faces > 0.0)]] = True
    is_open[mesh.triangles[np.concatenate([one, other])]] = True
    return is_open
