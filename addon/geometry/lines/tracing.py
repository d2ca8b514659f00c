# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Many lines traced at once from their seeds, forward and backward, until each has a reason to end.

Every line has two arms, which run from its seed in opposite directions. All arms move together,
one triangle at a time; now and then it is looked up which came too close to another line.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..types import Flags, Floats, Indices
from .field import ASYMPTOTIC, DirectionField
from .lines import LineEnd
from .samples import Samples, close_pairs, join_samples, take_samples
from .steps import cross, follow, start_walkers
from .umbilics import Umbilics

#: Most way in one step, and between two looks at other lines, over the spacing.
_STEP = 0.25
#: Least number of steps between two looks.
_LOOK = 8
#: Lines of their own closer than this way, over the spacing, are neighbors on the line.
_OWN = 1.5
#: Lines end at this share of the spacing from an umbilic, and run into it from half of that.
_UMBILIC = 0.25
#: Strength of an asymptotic direction over that of the principal ones where lines end.
_PARABOLIC = 1e-3
#: Most neighbors that are looked at; more than a line has samples of its own within its reach.
_PARTNERS = 10


@dataclass(frozen=True)
class Seeds:
    """Where lines start, the most important first.

    Parameters
    ----------
    triangle : (n,) int64
    barycentric : (n, 3) float64
    family : (n,) int64
        Values of `Family`.
    umbilic : (n,) int64
        Umbilic that a line comes from, which then has a forward arm only; -1 for none.
    heading : (n, 3) float64
        Direction of the forward arm, of any length; zero for either.
    """

    triangle: Indices
    barycentric: Floats
    family: Indices
    umbilic: Indices
    heading: Floats

    def __len__(self) -> int:
        """Return the number of seeds."""
        return len(self.triangle)

    def chosen(self, items: Indices | Flags) -> Seeds:
        """Return some of the seeds."""
        return Seeds(
            self.triangle[items],
            self.barycentric[items],
            self.family[items],
            self.umbilic[items],
            self.heading[items],
        )


def make_seeds(triangle: Indices, barycentric: Floats, family: Indices) -> Seeds:
    """Return seeds in triangles."""
    count = len(triangle)
    return Seeds(
        triangle, barycentric, family, np.full(count, -1, dtype=np.int64), np.zeros((count, 3))
    )


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
    """

    spacing: float
    nearest: float
    competes: bool


@dataclass
class Arms:
    """State of 2n arms.

    Parameters
    ----------
    samples : Samples
        All points reached, seeds included.
    end : (2n,) int64
        `LineEnd` of each arm, -1 while it runs.
    cut : (2n,) float64
        Way in meters at which an arm ends, whatever was reached.
    is_removed : (n,) bool
        Lines that turned out to repeat another one.
    closing : (n,) bool
        Lines whose arms met.
    """

    samples: Samples
    end: Indices
    cut: Floats
    is_removed: Flags
    closing: Flags


def trace(
    field: DirectionField, umbilics: Umbilics, seeds: Seeds, placed: Samples, rules: Rules
) -> Arms:
    """Trace lines from seeds.

    Parameters
    ----------
    field : DirectionField
    umbilics : Umbilics
        Of the field.
    seeds : Seeds
    placed : Samples
        Lines that are there already.
    rules : Rules

    Returns
    -------
    Arms
    """
    arm = np.arange(2 * len(seeds))
    line = arm // 2
    tangent = field.evaluate(seeds.triangle, seeds.barycentric, seeds.family)[0]
    turned = np.einsum("nx,nx->n", tangent, seeds.heading) < 0.0
    tangent = np.where(turned[:, None], -tangent, tangent)
    heading = np.where((arm % 2 == 0)[:, None], 1.0, -1.0) * tangent[line]
    walkers = start_walkers(
        seeds.triangle[line], seeds.barycentric[line], heading, seeds.family[line]
    )
    arc = np.zeros(len(arm))
    first = take_samples(
        field, arm, arc, walkers.triangle, walkers.barycentric, heading, walkers.family
    )
    state = Arms(
        samples=first,
        end=np.where((seeds.umbilic[line] >= 0) & (arm % 2 == 1), LineEnd.UMBILIC, -1),
        cut=np.full(len(arm), np.inf),
        is_removed=np.zeros(len(seeds), dtype=np.bool_),
        closing=np.zeros(len(seeds), dtype=np.bool_),
    )
    closeness = _near_umbilics(field, umbilics, rules)
    parts, sparse = [first, _at_umbilics(field, umbilics, seeds, tangent)], [first]
    looked = np.zeros(len(arm))
    looks = max(_LOOK, int(rules.spacing / field.mesh.edge_length))
    count, seen = 0, first.chosen(arm < 0)
    while True:
        active = np.flatnonzero(state.end < 0)
        if not len(active):
            break
        moving = walkers.chosen(active)
        reach = np.full(len(active), _STEP * rules.spacing)
        way, side = follow(field, moving, reach)
        arc[active] += way
        new = take_samples(
            field, active, arc[active], moving.triangle, moving.barycentric, moving.heading,
            moving.family,
        )  # fmt: skip
        parts.append(new)
        is_due = new.arc >= looked[active] + _STEP * rules.spacing * (1.0 - 1e-6)
        looked[active[is_due]] = new.arc[is_due]
        sparse.append(new.chosen(is_due))
        _end_at_sides(field, umbilics, moving, side, state, active)
        _end_at_umbilics(umbilics, closeness, new, state, rules)
        _end_at_parabolic(field, moving, state, active)
        walkers.put(active, moving)
        count += 1
        if count % looks == 0 or not (state.end[active] < 0).any():
            recent = join_samples(sparse)
            seen = join_samples([seen, recent])
            sparse = []
            _end_at_neighbors(recent, seen, placed, state, rules)
    state.samples = join_samples(parts)
    return state


def _at_umbilics(
    field: DirectionField, umbilics: Umbilics, seeds: Seeds, tangent: Floats
) -> Samples:
    """Return the umbilics that lines come from as the ends of their backward arms."""
    rays = np.flatnonzero(seeds.umbilic >= 0)
    umbilic = seeds.umbilic[rays]
    corner = field.mesh.position[field.mesh.triangles[seeds.triangle[rays]]]
    seed = np.einsum("nc,ncx->nx", seeds.barycentric[rays], corner) + field.mesh.offset
    return take_samples(
        field,
        2 * rays + 1,
        np.linalg.norm(umbilics.position[umbilic] - seed, axis=1),
        umbilics.triangle[umbilic],
        umbilics.barycentric[umbilic],
        -tangent[rays],
        seeds.family[rays],
    )


def _end_at_sides(
    field: DirectionField,
    umbilics: Umbilics,
    moving: object,
    side: Indices,
    state: Arms,
    active: Indices,
) -> None:
    """Cross into the next triangles and end at rims, creases and umbilic areas."""
    from .steps import Walkers

    assert isinstance(moving, Walkers)
    before = moving.triangle.copy()
    is_out = cross(field.mesh, moving, side)
    out = np.flatnonzero(is_out)
    rim = field.mesh.is_rim[before[out], side[out]]
    state.end[active[out]] = np.where(rim, LineEnd.RIM, LineEnd.CREASE)
    in_area = umbilics.triangle_area[moving.triangle] >= 0
    state.end[active[in_area & ~is_out]] = LineEnd.AREA


def _end_at_parabolic(
    field: DirectionField, moving: object, state: Arms, active: Indices
) -> None:
    """End asymptotic lines where there is no such direction any more."""
    from .steps import Walkers

    assert isinstance(moving, Walkers)
    lines = np.flatnonzero(moving.family >= ASYMPTOTIC[0])
    if len(lines):
        strength = field.evaluate(
            moving.triangle[lines], moving.barycentric[lines], moving.family[lines]
        )[2]
        principal = field.evaluate(
            moving.triangle[lines], moving.barycentric[lines], np.ones(len(lines), dtype=np.int64)
        )[2]
        state.end[active[lines[strength <= _PARABOLIC * principal]]] = LineEnd.PARABOLIC


def _near_umbilics(
    field: DirectionField, umbilics: Umbilics, rules: Rules
) -> tuple[Indices, Floats, float]:
    """Return the closest umbilic of every triangle that has one in reach, and what reach is."""
    nearest = np.full(len(field.mesh.triangles), -1, dtype=np.int64)
    position = umbilics.position - field.mesh.offset
    reach = _UMBILIC * rules.spacing
    if umbilics.count:
        from scipy.spatial import cKDTree

        middle = field.mesh.position[field.mesh.triangles].mean(axis=1)
        corner = field.mesh.position[field.mesh.triangles[:, 0]]
        radius = 2.0 * np.linalg.norm(middle - corner, axis=1)
        distance, found = cKDTree(position).query(middle)
        nearest = np.where(distance <= reach + radius, found, -1).astype(np.int64)
    return nearest, position, reach


def _end_at_umbilics(
    umbilics: Umbilics,
    closeness: tuple[Indices, Floats, float],
    new: Samples,
    state: Arms,
    rules: Rules,
) -> None:
    """End lines where they begin to leave an umbilic that they came close to."""
    nearest, position, reach = closeness
    if not umbilics.count:
        return
    umbilic = nearest[new.triangle]
    near = np.flatnonzero((umbilic >= 0) & (new.arc > 2.0 * reach))
    away = position[umbilic[near]] - new.position[near]
    is_close = np.linalg.norm(away, axis=1) < reach
    is_leaving = np.einsum("nx,nx->n", away, new.heading[near]) <= 0.0
    state.end[new.arm[near[is_close & is_leaving]]] = LineEnd.UMBILIC


def _end_at_neighbors(
    recent: Samples, seen: Samples, placed: Samples, state: Arms, rules: Rules
) -> None:
    """End arms that came too close to lines placed before, to others traced now, or to itself."""
    sample, _ = close_pairs(recent, placed, rules.spacing, rules.nearest, 1)
    _cut(state, recent.arm[sample], recent.arc[sample])
    sample, other = close_pairs(recent, seen, rules.spacing, rules.nearest, _PARTNERS)
    one, two = recent.chosen(sample), seen.chosen(other)
    is_kept = (two.arc <= state.cut[two.arm]) & (one.arc <= state.cut[one.arm])
    is_own = one.line == two.line
    is_apart = np.abs(one.signed_arc - two.signed_arc) > _OWN * rules.spacing
    _meet_itself(state, one, two, is_kept & is_own & is_apart)
    if rules.competes:
        _meet_others(state, one, two, is_kept & ~is_own)


def _meet_itself(state: Arms, one: Samples, two: Samples, flags: Flags) -> None:
    """Close lines whose arms ran past each other, end arms that came back beside their line."""
    one, two = one.chosen(flags), two.chosen(flags)
    apart = one.position - two.position
    ahead = np.einsum("nx,nx->n", apart, two.heading)
    opposite = np.einsum("nx,nx->n", one.heading, two.heading) < 0.0
    is_meeting = (one.arm != two.arm) & opposite
    state.closing[one.line[is_meeting & (ahead <= 0.0)]] = True
    state.end[np.repeat(2 * np.flatnonzero(state.closing), 2).reshape(-1, 2) + [0, 1]] = (
        LineEnd.CLOSED
    )
    _cut(state, one.arm[~is_meeting], one.arc[~is_meeting])


def _meet_others(state: Arms, one: Samples, two: Samples, flags: Flags) -> None:
    """End the less important of two arms that run beside each other, drop it if they meet."""
    one, two = one.chosen(flags), two.chosen(flags)
    is_first = one.line > two.line
    loser_arm = np.where(is_first, one.arm, two.arm)
    loser_arc = np.where(is_first, one.arc, two.arc)
    apart = one.position - two.position
    along = np.abs(np.einsum("nx,nx->n", apart, one.heading))
    is_head_on = along > 0.8 * np.linalg.norm(apart, axis=1)
    opposite = np.einsum("nx,nx->n", one.heading, two.heading) < 0.0
    state.is_removed[loser_arm[is_head_on & opposite] // 2] = True
    gone = np.flatnonzero(state.is_removed)
    state.end[np.concatenate([2 * gone, 2 * gone + 1])] = LineEnd.NEIGHBOR
    _cut(state, loser_arm[~is_head_on], loser_arc[~is_head_on])


def _cut(state: Arms, arm: Indices, arc: Floats) -> None:
    """End arms beside a neighbor."""
    closer = arc < state.cut[arm]
    np.minimum.at(state.cut, arm[closer], arc[closer])
    state.end[arm[closer]] = LineEnd.NEIGHBOR
