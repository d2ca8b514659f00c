# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The lines through one point, fast enough to follow a mouse, and piece by piece if they are long.

They are those of `tracer.trace_from`.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from dataclasses import field as field_of
from time import perf_counter

import numpy as np

from ..types import Floats
from .assembly import assemble
from .endings import STEP, Arms, close_lines
from .field import Family
from .lines import CurvatureLines, LineEnd
from .samples import Trail, take_samples
from .seeds import make_seeds
from .tracer import LineField, own_rules, usable
from .tracing import SWERVE
from .turning import AROUND, BEHIND, STRAIGHT_ON
from .walking import Ground, Vector, Walker
from .watch import Watch

_ASYMPTOTIC = int(Family.ASYMPTOTIC_LEFT)
#: Numbers remembered of a place: way, triangle, place in it, heading.
_STEP = 8


class PointTracer:
    """Traces the lines through one point after the other.

    What all of them need is looked up when it is made.

    Parameters
    ----------
    lines : LineField
    families : tuple of Family
    """

    def __init__(self, lines: LineField, families: tuple[Family, ...]) -> None:
        self.lines, self.families = lines, families
        self.ground = Ground(lines.field)
        self.rules = own_rules(lines)
        self.around, self.no_samples = lines.own_surroundings, lines.no_samples

    def start(self, triangle: int, place: Floats) -> PointLines:
        """Return the lines through a point, not traced yet: none where there is no direction.

        Parameters
        ----------
        triangle : int
        place : (3,) float64
            Barycentric.
        """
        return PointLines(self, triangle, place)


@dataclass(slots=True)
class _Arm:
    """Half of a line: where it is, all places that it went through, and those for a look.

    `start` and `direction` are those of the seed, `faced` is where it headed at the place looked at
    last, and `lowest` is how far behind its start it has been, as a negative number in meters.
    Places are rows of numbers, one after the other: Python would look through as many tuples now
    and then, which takes longer than to trace a line.
    """

    walker: Walker
    start: Vector
    direction: Vector
    faced: Vector
    lowest: float = 0.0
    arc: float = 0.0
    looked: float = 0.0
    steps: list[float] = field_of(default_factory=list)
    sparse: list[float] = field_of(default_factory=list)


class PointLines:
    """The lines through one point, as far as there was time to trace them.

    Parameters
    ----------
    tracer : PointTracer
    triangle : int
    place : (3,) float64
    """

    def __init__(self, tracer: PointTracer, triangle: int, place: Floats) -> None:
        lines, families = tracer.lines, tracer.families
        count = len(families)
        seeds = make_seeds(
            np.full(count, triangle, dtype=np.int64),
            np.tile(place, (count, 1)),
            np.array(families, dtype=np.int64),
        )
        seeds = usable(lines, seeds)
        tangent = lines.field.evaluate(seeds.triangle, seeds.barycentric, seeds.family)[0]
        self._tracer = tracer
        self._arms = [
            _started(tracer.ground, triangle, place, sign * heading, family)
            for heading, family in zip(tangent, seeds.family.tolist(), strict=True)
            for sign in (1.0, -1.0)
        ]
        number = len(self._arms)
        self._state = Arms(
            end=np.full(number, -1, dtype=np.int64),
            cut=np.full(number, np.inf),
            is_removed=np.zeros(number // 2, dtype=np.bool_),
            closing=np.zeros(number // 2, dtype=np.bool_),
            turned=np.full(number, np.inf),
        )
        self._ground, self._rules = tracer.ground, tracer.rules
        self._reach = STEP * tracer.rules.spacing
        self._is_rim = lines.field.mesh.is_rim
        self._area = lines.umbilics.triangle_area
        self._around = tracer.around
        self._watch = Watch(lines.field, tracer.no_samples, tracer.rules, self._state)

    @property
    def is_done(self) -> bool:
        """Whether all lines have ended."""
        return not (self._state.end < 0).any()

    def advance(self, seconds: float) -> bool:
        """Go on by a piece, and by more for about this long; return whether all have ended."""
        limit = perf_counter() + seconds
        while not self.is_done:
            self._go_on()
            if perf_counter() > limit:
                break
        return self.is_done

    def lines(self) -> CurvatureLines:
        """Return the lines as far as they are traced; -1 stands for an end that may go on."""
        state, field = self._state, self._tracer.lines.field
        samples = take_samples(field, self._trail([arm.steps for arm in self._arms]))
        # Lines that close are cut where their arms meet, which is not to last while they run.
        so_far = replace(state, end=state.end.copy(), cut=state.cut.copy())
        return assemble(field, so_far, samples, self._tracer.rules, 0.0)

    def _go_on(self) -> None:
        """Let all arms make as many steps as they make between two looks."""
        for number, arm in enumerate(self._arms):
            if self._state.end[number] >= 0:
                continue
            for _ in range(self._watch.interval):
                end = self._step(arm)
                if end is LineEnd.CLOSED:
                    close_lines(self._state, np.array([number // 2]))
                elif end is not None:
                    self._state.end[number] = end
                if end is not None:
                    break
        sparse = self._trail([arm.sparse for arm in self._arms])
        self._watch.look(sparse, np.array([arm.arc for arm in self._arms]))
        for arm in self._arms:
            arm.sparse.clear()

    def _step(self, arm: _Arm) -> LineEnd | None:
        """Make one step; return why the arm ends with it, if it does."""
        ground, walker, reach = self._tracer.ground, arm.walker, self._reach
        way, side = ground.follow(walker, reach)
        arm.arc += way
        step = arm.arc, walker.triangle, *walker.place, *walker.heading
        arm.steps.extend(step)
        if arm.arc >= arm.looked + reach * (1.0 - 1e-6) or _dot(arm.faced, walker.heading) < SWERVE:
            arm.looked, arm.faced = arm.arc, walker.heading
            arm.sparse.extend(step)
        before = walker.triangle
        end = LineEnd.CLOSED if self._comes_around(arm) else None
        if self._leaves_umbilic(arm):
            end = LineEnd.UMBILIC
        if side >= 0 and ground.cross(walker, side):
            end = LineEnd.RIM if self._is_rim[before, side] else LineEnd.CREASE
        elif self._area[walker.triangle] >= 0:
            end = LineEnd.AREA
        if walker.family >= _ASYMPTOTIC and ground.is_parabolic(walker):
            end = LineEnd.PARABOLIC
        return end

    def _comes_around(self, arm: _Arm) -> bool:
        """Return whether an arm has come around to where it started; see `end_at_seeds`."""
        x, y, z = (a - b for a, b in zip(self._ground.position(arm.walker), arm.start, strict=True))
        ahead = _dot((x, y, z), arm.direction)
        arm.lowest = min(arm.lowest, ahead)
        if not 0.0 <= ahead < 0.5 * min(self._rules.spacing, arm.arc):
            return False
        if arm.lowest >= -BEHIND * arm.arc:
            return False
        aside = x * x + y * y + z * z - ahead * ahead
        is_near = aside < min(self._rules.nearest, AROUND * arm.arc) ** 2
        return is_near and _dot(arm.walker.heading, arm.direction) > STRAIGHT_ON

    def _leaves_umbilic(self, arm: _Arm) -> bool:
        """Return whether an arm begins to leave an umbilic that it came close to."""
        around, walker = self._around, arm.walker
        umbilic = around.nearest[walker.triangle]
        if umbilic < 0 or arm.arc <= 2.0 * around.reach:
            return False
        mesh = self._tracer.lines.field.mesh
        position = walker.place @ mesh.position[mesh.triangles[walker.triangle]]
        away = around.position[umbilic] - position
        return bool(np.linalg.norm(away) < around.reach and away @ walker.heading <= 0.0)

    def _trail(self, steps: list[list[float]]) -> Trail:
        """Return the steps of arms in rows."""
        rows = np.array([number for each in steps for number in each]).reshape(-1, _STEP)
        arm = np.repeat(np.arange(len(steps)), [len(each) // _STEP for each in steps])
        family = np.array([arm.walker.family for arm in self._arms], dtype=np.int64)
        triangle = rows[:, 1].astype(np.int64)
        return Trail(arm, rows[:, 0], triangle, rows[:, 2:5], rows[:, 5:], family[arm])


def _started(ground: Ground, triangle: int, place: Floats, heading: Floats, family: int) -> _Arm:
    """Return an arm that stands at its seed."""
    a, b, c = place.tolist()
    x, y, z = course = tuple(heading.tolist())
    first = [0.0, float(triangle), a, b, c, x, y, z]
    walker = Walker(triangle, (a, b, c), course, family)
    start = ground.position(walker)
    return _Arm(walker, start, course, course, steps=first, sparse=first.copy())


def _dot(one: Vector, two: Vector) -> float:
    return one[0] * two[0] + one[1] * two[1] + one[2] * two[2]
