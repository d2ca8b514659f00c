# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Why traced lines end: sides of the surface, umbilics, parabolic curves, other lines."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..types import Flags, Floats, Indices
from .field import ASYMPTOTIC, DirectionField
from .lines import LineEnd
from .samples import Samples, Trail, close_pairs
from .steps import Walkers, cross
from .umbilics import Umbilics
from .vectors import dot, unit

#: Most way in one step, and about the way between the places that are compared with other lines,
#: over the spacing.
STEP = 0.25
#: Lines of their own closer than this way, over the spacing, are neighbors on the line.
_OWN = 1.5
#: Or if they are no closer than this share of the way between them; half a circle has 0.64.
_BACK = 0.5
#: And if their normals agree up to this cosine.
_FACING = 0.5
#: Lines end within this share of the spacing from an umbilic, where they begin to leave it.
_UMBILIC = 0.25
#: Strength of an asymptotic direction over that of the principal ones where lines end.
PARABOLIC = 0.05
#: Most neighbors that are looked at; more than a line has samples of its own within its reach.
_PARTNERS = 10
#: The same of lines placed before, of which few are in reach.
_PLACED = 3
#: Cosine between the courses of two lines of a family up to which one lies across the other.
_ACROSS = 0.3


@dataclass(frozen=True)
class Rules:
    """When lines end.

    Parameters
    ----------
    spacing : float
        Distance between lines in meters.
    nearest : float
        Distance in meters at which a line ends beside another one, or beside itself.
    competes : bool
        Whether lines end beside others that are traced at the same time.
    tolerance : float
        Share of `nearest` at which a line ends beside another one; beside itself always at all of
        it.
    """

    spacing: float
    nearest: float
    competes: bool
    tolerance: float = 1.0


@dataclass
class Arms:
    """State of 2n arms.

    Parameters
    ----------
    end : (2n,) int64
        `LineEnd` of each arm, -1 while it runs.
    cut : (2n,) float64
        Way in meters at which an arm ends, whatever was reached.
    is_removed : (n,) bool
        Lines that turned out to repeat another one.
    closing : (n,) bool
        Lines whose arms met.
    turned : (2n,) float64
        Way in meters at which an arm came back beside its own line: there it ends, if the line
        does not close.
    """

    end: Indices
    cut: Floats
    is_removed: Flags
    closing: Flags
    turned: Floats


@dataclass(frozen=True)
class Surroundings:
    """The umbilics, and which of them is close to each triangle.

    Parameters
    ----------
    umbilics : Umbilics
    position : (u, 3) float64
        Of the umbilics, from the middle of the bounding box, in meters.
    nearest : (t,) int64
        Closest umbilic of each triangle that has one in reach, else -1.
    reach : float
        In meters.
    """

    umbilics: Umbilics
    position: Floats
    nearest: Indices
    reach: float


def surroundings(field: DirectionField, umbilics: Umbilics, spacing: float) -> Surroundings:
    """Return which umbilics lines may end at."""
    nearest = np.full(len(field.mesh.triangles), -1, dtype=np.int64)
    position = umbilics.position - field.mesh.offset
    reach = _UMBILIC * spacing
    if umbilics.count:
        from scipy.spatial import cKDTree

        middle = field.mesh.position[field.mesh.triangles].mean(axis=1)
        corner = field.mesh.position[field.mesh.triangles[:, 0]]
        radius = 2.0 * np.linalg.norm(middle - corner, axis=1)
        distance, found = cKDTree(position).query(middle)
        nearest = np.where(distance <= reach + radius, found, -1).astype(np.int64)
    return Surroundings(umbilics, position, nearest, reach)


def end_at_sides(
    field: DirectionField,
    around: Surroundings,
    moving: Walkers,
    side: Indices,
    state: Arms,
    active: Indices,
) -> None:
    """Cross into the next triangles; end at rims, creases and umbilic areas.

    Parameters
    ----------
    field : DirectionField
    around : Surroundings
    moving : Walkers
        Changed.
    side : (n,) int64
        Side at which each stands, -1 for none.
    state : Arms
        Changed.
    active : (n,) int64
        Arm of each walker.
    """
    before = moving.triangle.copy()
    is_out = cross(field.mesh, moving, side)
    out = np.flatnonzero(is_out)
    rim = field.mesh.is_rim[before[out], side[out]]
    state.end[active[out]] = np.where(rim, LineEnd.RIM, LineEnd.CREASE)
    in_area = around.umbilics.triangle_area[moving.triangle] >= 0
    state.end[active[in_area & ~is_out]] = LineEnd.AREA


def end_at_parabolic(field: DirectionField, moving: Walkers, state: Arms, active: Indices) -> None:
    """End asymptotic lines where there is no such direction any more."""
    lines = np.flatnonzero(moving.family >= ASYMPTOTIC[0])
    if len(lines):
        strength = field.evaluate(
            moving.triangle[lines], moving.barycentric[lines], moving.family[lines]
        )[2]
        principal = field.evaluate(
            moving.triangle[lines], moving.barycentric[lines], np.ones(len(lines), dtype=np.int64)
        )[2]
        state.end[active[lines[strength <= PARABOLIC * principal]]] = LineEnd.PARABOLIC


def end_at_umbilics(field: DirectionField, around: Surroundings, new: Trail, state: Arms) -> None:
    """End lines where they begin to leave an umbilic that they came close to."""
    if not around.umbilics.count:
        return
    umbilic = around.nearest[new.triangle]
    near = np.flatnonzero((umbilic >= 0) & (new.arc > 2.0 * around.reach))
    if not len(near):
        return
    corner = field.mesh.position[field.mesh.triangles[new.triangle[near]]]
    position = np.einsum("nc,ncx->nx", new.barycentric[near], corner)
    away = around.position[umbilic[near]] - position
    is_close = np.linalg.norm(away, axis=1) < around.reach
    is_leaving = np.einsum("nx,nx->n", away, new.heading[near]) <= 0.0
    state.end[new.arm[near[is_close & is_leaving]]] = LineEnd.UMBILIC


def end_at_neighbors(
    recent: Samples, seen: Samples, placed: Samples, state: Arms, rules: Rules
) -> None:
    """End arms that came too close to lines placed before, to others traced now, or to itself."""
    if len(placed):
        reach = rules.tolerance * rules.nearest
        sample, other = close_pairs(recent, placed, rules.spacing, reach, _PLACED)
        sample = sample[_side_by_side(recent.chosen(sample), placed.chosen(other))]
        _cut(state, recent.arm[sample], recent.arc[sample], rules)
    if rules.competes:
        sample, other = close_pairs(recent, seen, rules.spacing, rules.nearest, _PARTNERS)
    else:
        # Lines that run together must not hide a line from itself, nor slow down the search.
        seen = seen.chosen(np.isin(seen.line, recent.line))
        sample, other = close_pairs(
            recent.by_line(), seen.by_line(), rules.spacing, rules.nearest, _PARTNERS
        )
    one, two = recent.chosen(sample), seen.chosen(other)
    is_kept = (two.arc <= state.cut[two.arm]) & (one.arc <= state.cut[one.arm])
    is_kept &= _side_by_side(one, two)
    is_own = one.line == two.line
    is_apart = far_along(one, two, rules.spacing)
    _meet_itself(state, one, two, is_kept & is_own & is_apart, rules)
    if rules.competes:
        apart = one.position - two.position
        is_close = dot(apart, apart) < (rules.tolerance * rules.nearest) ** 2
        _meet_others(state, one, two, is_kept & ~is_own & is_close, rules)


def _side_by_side(one: Samples, two: Samples) -> Flags:
    """Return pairs that are neighbors, (n,) bool: beyond a seam the family lies across."""
    return np.abs(np.einsum("nx,nx->n", one.heading, two.heading)) > _ACROSS


def far_along(one: Samples, two: Samples, spacing: float) -> Flags:
    """Return pairs of samples of one line between which there is much of it, (n,) bool.

    More than a while, or much more than their distance: around a thin pipe it is not far. Neither
    is what lies on its other side, where the line is on its way back.
    """
    way = np.abs(one.signed_arc - two.signed_arc)
    apart = np.linalg.norm(one.position - two.position, axis=1)
    is_facing = dot(unit(one.normal), unit(two.normal)) > _FACING
    return is_facing & ((way > _OWN * spacing) | (apart < _BACK * way))


def _meet_itself(state: Arms, one: Samples, two: Samples, flags: Flags, rules: Rules) -> None:
    """Close lines whose arms ran past each other, end arms that came back beside their line."""
    one, two = one.chosen(flags), two.chosen(flags)
    apart = one.position - two.position
    ahead = np.einsum("nx,nx->n", apart, two.heading)
    opposite = np.einsum("nx,nx->n", one.heading, two.heading) < 0.0
    is_meeting = (one.arm != two.arm) & opposite
    close_lines(state, one.line[is_meeting & (ahead <= 0.0)])
    arm, arc = one.arm[~is_meeting], one.arc[~is_meeting]
    np.minimum.at(state.turned, arm, np.maximum(arc - STEP * rules.spacing, 0.0))
    is_open = ~state.closing[arm // 2]
    _cut(state, arm[is_open], arc[is_open], rules)


def close_lines(state: Arms, line: Indices) -> None:
    """End both arms of lines that met themselves.

    Parameters
    ----------
    state : Arms
        Changed.
    line : (n,) int64
    """
    state.closing[line] = True
    state.end[np.concatenate([2 * line, 2 * line + 1])] = LineEnd.CLOSED


def _meet_others(state: Arms, one: Samples, two: Samples, flags: Flags, rules: Rules) -> None:
    """End the less important of two arms that run beside each other, drop it if they meet."""
    one, two = one.chosen(flags), two.chosen(flags)
    is_first = one.line > two.line
    loser_arm = np.where(is_first, one.arm, two.arm)
    loser_arc = np.where(is_first, one.arc, two.arc)
    apart = one.position - two.position
    along = np.abs(np.einsum("nx,nx->n", apart, one.heading))
    is_head_on = along > 0.8 * np.linalg.norm(apart, axis=1)
    is_head_on &= np.einsum("nx,nx->n", one.heading, two.heading) < 0.0
    state.is_removed[loser_arm[is_head_on] // 2] = True
    gone = np.flatnonzero(state.is_removed)
    state.end[np.concatenate([2 * gone, 2 * gone + 1])] = LineEnd.NEIGHBOR
    _cut(state, loser_arm[~is_head_on], loser_arc[~is_head_on], rules)


def _cut(state: Arms, arm: Indices, arc: Floats, rules: Rules) -> None:
    """End arms beside a neighbor: a step before the place that turned out to be too close."""
    arc = np.maximum(arc - STEP * rules.spacing, 0.0)
    closer = arc < state.cut[arm]
    np.minimum.at(state.cut, arm[closer], arc[closer])
    state.end[arm[closer]] = LineEnd.NEIGHBOR
