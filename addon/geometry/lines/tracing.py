# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Many lines traced at once from their seeds, forward and backward, until each has a reason to end.

Every line has two arms, which run from its seed in opposite directions. All arms move together,
one triangle at a time; now and then it is looked up which came too close to another line.
"""

from __future__ import annotations

import numpy as np

from ..types import Floats
from .endings import (
    STEP,
    Arms,
    Rules,
    Surroundings,
    end_at_parabolic,
    end_at_sides,
    end_at_umbilics,
)
from .field import DirectionField
from .lines import LineEnd
from .samples import Samples, Trail, joined, no_trail, take_samples
from .seeds import Seeds
from .steps import follow, start_walkers
from .turning import Turns, end_at_seeds
from .umbilics import Umbilics
from .vectors import dot
from .watch import Watch

#: Cosine of the turn after which a place is compared with other lines before its time: around a
#: thin pipe it is not far.
SWERVE = 0.87


def trace(
    field: DirectionField,
    around: Surroundings,
    seeds: Seeds,
    placed: Samples,
    rules: Rules,
    longest: Floats | None = None,
) -> tuple[Arms, Samples]:
    """Trace lines from seeds.

    Parameters
    ----------
    field : DirectionField
    around : Surroundings
        The field's umbilics.
    seeds : Seeds
    placed : Samples
        Lines that are there already.
    rules : Rules
    longest : (n,) float64, optional
        Length in meters at which a line ends, but for the way of some steps.

    Returns
    -------
    state : Arms
    samples : Samples
        All places reached, in the order in which each arm reached them.
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
    first = Trail(
        arm, arc.copy(), seeds.triangle[line], seeds.barycentric[line], heading, walkers.family
    )
    state = Arms(
        end=np.where((seeds.umbilic[line] >= 0) & (arm % 2 == 1), LineEnd.UMBILIC, -1),
        cut=np.full(len(arm), np.inf),
        is_removed=np.zeros(len(seeds), dtype=np.bool_),
        closing=np.zeros(len(seeds), dtype=np.bool_),
        turned=np.full(len(arm), np.inf),
    )
    start, lowest = take_samples(field, first), np.zeros(len(arm))
    parts, sparse = [first, _at_umbilics(field, around.umbilics, seeds, tangent)], [first]
    looked, faced, count = np.zeros(len(arm)), heading.copy(), 0
    watch = Watch(field, placed, rules, state)
    # A line out of an umbilic comes along its ray, to which the field may not keep.
    turns = Turns(field, rules.spacing, first.triangle, _arriving(seeds, heading))
    while len(active := np.flatnonzero(state.end < 0)):
        moving = walkers.chosen(active)
        entry = moving.barycentric
        way, side = follow(field, moving, np.full(len(active), STEP * rules.spacing))
        arc[active] += way
        new = Trail(
            active,
            arc[active],
            moving.triangle.copy(),
            moving.barycentric.copy(),
            moving.heading,
            moving.family,
        )
        parts.append(new)
        is_due = new.arc >= looked[active] + STEP * rules.spacing * (1.0 - 1e-6)
        is_due |= dot(new.heading, faced[active]) < SWERVE
        looked[active[is_due]], faced[active[is_due]] = new.arc[is_due], new.heading[is_due]
        sparse.append(new.chosen(is_due))
        # Without a spacing of their own lines follow every kink: within an edge none is sharp.
        if rules.competes:
            turns.look(entry, way, new, state)
        end_at_seeds(field, start, lowest, new, state, rules)
        end_at_umbilics(field, around, new, state)
        end_at_sides(field, around, moving, side, state, active)
        end_at_parabolic(field, moving, state, active)
        walkers.put(active, moving)
        count += 1
        if count % watch.interval == 0 or not (state.end[active] < 0).any():
            watch.look(joined(sparse), arc)
            sparse = [no_trail()]
            if longest is not None:
                is_long = np.repeat(arc[::2] + arc[1::2] > longest, 2)
                state.end[is_long & (state.end < 0)] = LineEnd.NEIGHBOR
    return state, take_samples(field, joined(parts))


def _arriving(seeds: Seeds, heading: Floats) -> Floats:
    """Return the directions in which arms come to their seeds, (2n, 3)."""
    arriving = heading.copy()
    rays = np.flatnonzero(seeds.umbilic >= 0)
    arriving[2 * rays] = seeds.heading[rays]
    return arriving


def _at_umbilics(field: DirectionField, umbilics: Umbilics, seeds: Seeds, tangent: Floats) -> Trail:
    """Return the umbilics that lines come from as the ends of their backward arms."""
    rays = np.flatnonzero(seeds.umbilic >= 0)
    umbilic = seeds.umbilic[rays]
    corner = field.mesh.position[field.mesh.triangles[seeds.triangle[rays]]]
    seed = np.einsum("nc,ncx->nx", seeds.barycentric[rays], corner) + field.mesh.offset
    return Trail(
        2 * rays + 1,
        np.linalg.norm(umbilics.position[umbilic] - seed, axis=1),
        umbilics.triangle[umbilic],
        umbilics.barycentric[umbilic],
        -tangent[rays],
        seeds.family[rays],
    )
