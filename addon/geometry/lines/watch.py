# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A look, now and then, at which arms came too close to a line, and which get nowhere."""

from __future__ import annotations

import numpy as np

from ..types import Floats
from .endings import Arms, Rules, end_at_neighbors
from .field import DirectionField
from .lines import LineEnd
from .samples import Samples, Trail, joined, no_trail, take_samples

#: Least number of steps between two looks at other lines.
_LOOK = 8
#: Steps of one arm that cost as much as a look does.
_FEW = 128
#: Way between two looks, over the side of a triangle or the spacing, below which an arm is stuck.
_SLOWEST = 0.02


class Watch:
    """Compares where arms have come since the last look with all lines.

    Parameters
    ----------
    field : DirectionField
    placed : Samples
        Lines that are there already.
    rules : Rules
    state : Arms
        Changed by every look.

    Attributes
    ----------
    interval : int
        Steps that all arms make between two looks.
    """

    def __init__(self, field: DirectionField, placed: Samples, rules: Rules, state: Arms) -> None:
        count = len(state.end)
        self.interval = max(
            _LOOK, int(rules.spacing / field.mesh.edge_length), _FEW // max(count, 1)
        )
        self._field, self._placed, self._rules, self._state = field, placed, rules, state
        self._before, self._is_new = np.zeros(count), True
        self._seen = take_samples(field, no_trail())

    def look(self, sparse: Trail, arc: Floats) -> None:
        """End arms that are stuck, or beside others.

        Parameters
        ----------
        sparse : Trail
            Places reached since the last look.
        arc : (2n,) float64
            Way of every arm in meters.
        """
        recent = take_samples(self._field, sparse)
        self._seen = joined([self._seen, recent])
        state = self._state
        step = min(self._rules.spacing, self._field.mesh.edge_length)
        is_slow = arc - self._before < _SLOWEST * step
        if not self._is_new:
            state.end[(state.end < 0) & is_slow] = LineEnd.FOLD
        self._before, self._is_new = arc.copy(), False
        end_at_neighbors(recent, self._seen, self._placed, state, self._rules)
