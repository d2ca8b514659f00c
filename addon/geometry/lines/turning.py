# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines that turn: sharply, where they end, or around to where they started, where they close."""

from __future__ import annotations

import numpy as np

from ..types import Floats
from .endings import Arms, Rules, close_lines
from .field import DirectionField
from .lines import LineEnd
from .samples import Samples, Trail
from .vectors import cross, dot

#: Most turn of a line within about this share of the spacing, in radians. Around an umbilic that it
#: passes at the distance above it turns by 0.6.
_LATELY, _SHARP = 0.15, 0.75
#: An arm comes around to its start if it goes the same way there but for this cosine, misses it by
#: less than this share of its way, and was behind it by more than this share.
STRAIGHT_ON, AROUND, BEHIND = 0.5, 0.1, 0.01


def end_at_turns(
    normal: Floats, before: Floats, way: Floats, new: Trail, state: Arms, rules: Rules
) -> None:
    """End lines before they turn sharply: there the mesh does not show how they go on.

    Parameters
    ----------
    normal : (n, 3) float64
        Of the triangles that the arms moved through.
    before : (n, 3) float64
        Their headings before they moved.
    way : (n,) float64
        How far they moved in meters.
    new : Trail
        Where they are now.
    state : Arms
        Changed.
    rules : Rules
    """
    left = dot(cross(before, new.heading), normal)
    turn = np.arctan2(left, dot(before, new.heading))
    lately = np.exp(-way / (_LATELY * rules.spacing))
    bend = lately * state.bend[new.arm] + turn
    state.bend[new.arm] = bend
    # Close to where both arms started, what the other one has turned belongs to the same turn.
    window = 2.0 * _LATELY * rules.spacing
    other = np.where(new.arc < window, state.bend[new.arm ^ 1], 0.0)
    is_sharp = (np.abs(bend) > _SHARP) | (np.abs(bend - other) > _SHARP)
    arm = new.arm[is_sharp]
    state.end[arm] = LineEnd.FOLD
    state.cut[arm] = np.minimum(state.cut[arm], (new.arc - way)[is_sharp])


def end_at_seeds(
    field: DirectionField, first: Samples, lowest: Floats, new: Trail, state: Arms, rules: Rules
) -> None:
    """Close lines of which an arm has come around to where it started.

    A ring around a thin pipe is passed many times between two looks at other lines.

    Parameters
    ----------
    field : DirectionField
    first : Samples
        Where the arms started.
    lowest : (2n,) float64
        How far behind its start each arm has been, seen in the direction it started in, as a
        negative number in meters. Changed.
    new : Trail
        Where the arms are now.
    state : Arms
        Changed.
    rules : Rules
    """
    seed = first.chosen(new.arm)
    corner = field.mesh.position[field.mesh.triangles[new.triangle]]
    apart = np.einsum("nc,ncx->nx", new.barycentric, corner) - seed.position
    ahead = dot(apart, seed.heading)
    lowest[new.arm] = np.minimum(lowest[new.arm], ahead)
    is_past = (ahead >= 0.0) & (ahead < 0.5 * rules.spacing) & (ahead < 0.5 * new.arc)
    is_past &= lowest[new.arm] < -BEHIND * new.arc
    passed = np.flatnonzero(is_past & (dot(new.heading, seed.heading) > STRAIGHT_ON))
    aside = apart[passed] - ahead[passed, None] * seed.heading[passed]
    near = np.minimum(rules.nearest, AROUND * new.arc[passed])
    passed = passed[dot(aside, aside) < near**2]
    close_lines(state, np.unique(new.arm[passed] // 2))
