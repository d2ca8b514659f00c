# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A pavilion: a profile of lines and arcs that is led along a plan of lines and arcs.

Forecourt, wall and roof flow into each other; kerb and fascia meet them in creases. As the profile
stays in the plane across the plan's curve, this is a moulding surface after Monge: profiles and
plan parallels are its lines of curvature, and the quads between them are planar.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import ceil, cos, radians, sin

from .patches import Patches, Point, spread

PLAN = ((6.0, 0.0), (9.0, -1 / 7.5), (2.0, 0.0), (25.0, 1 / 7.5), (4.0, 0.0))
"""Length in meters and curvature in 1/m, left turns positive, of the plan's lines and arcs."""

START_HEADING = radians(35.0)

SLOPE = radians(80.0)
"""Of the wall."""

FOOT_RADIUS = 2.0
EAVES_RADIUS = 3.6
WALL = 1.8
COURT = 2.4
KERB = 0.4
FASCIA = 0.6
"""In meters, as what follows."""

ROOF = (5.0, 2.2)
"""Depth of the roof at the start and from the end of the first bend on."""

OVERHANG = (0.55, 0.5)
"""Of the free ends, per meter of height."""

_EDGE = 0.35

_Profile = list[tuple[float, float]]


def pavilion() -> Patches:
    """Return the pavilion, standing on the plane z = 0."""
    patches = Patches("Pavilion: lines and arcs along lines and arcs")
    strips: list[list[list[Point]]] = [[] for _ in _profile(ROOF[0])]
    for station, x, y, heading in _stations():
        for strip, profile in zip(strips, _profile(roof_depth(station)), strict=True):
            strip.append([_placed(station, x, y, heading, *point) for point in profile])
    for strip in strips:
        patches.add(strip)
    return patches


def roof_depth(station: float) -> float:
    """Return the depth of the roof, which narrows smoothly up to the end of the first bend."""
    t = min(1.0, station / (PLAN[0][0] + PLAN[1][0]))
    return ROOF[0] + (ROOF[1] - ROOF[0]) * t**3 * (10.0 - 15.0 * t + 6.0 * t * t)


def _stations() -> Iterator[tuple[float, float, float, float]]:
    """Yield length from the start, place and heading along the plan's curve."""
    station, x, y, heading = 0.0, 0.0, 0.0, START_HEADING
    for number, (length, curvature) in enumerate(PLAN):
        for way in spread(0.0, length, ceil(length / _EDGE))[min(number, 1) :]:
            yield station + way, *_moved(x, y, heading, way, curvature)
        x, y, heading = _moved(x, y, heading, length, curvature)
        station += length


def _moved(
    x: float, y: float, heading: float, way: float, curvature: float
) -> tuple[float, float, float]:
    if curvature == 0.0:
        return x + way * cos(heading), y + way * sin(heading), heading
    end = heading + way * curvature
    return (
        x + (sin(end) - sin(heading)) / curvature,
        y - (cos(end) - cos(heading)) / curvature,
        end,
    )


def _profile(roof: float) -> list[_Profile]:
    """Return kerb, forecourt, foot, wall, eaves, roof and fascia from outside to inside.

    Each is a row of points: distance outward from the foot of the wall, and height.
    """
    foot = [
        (FOOT_RADIUS * (sin(SLOPE) - sin(a)), KERB + FOOT_RADIUS * (1.0 - cos(a)))
        for a in spread(0.0, SLOPE, ceil(FOOT_RADIUS * SLOPE / _EDGE))
    ]
    edge = foot[0][0] + COURT
    top = _along(foot[-1], (-WALL * cos(SLOPE), WALL * sin(SLOPE)))
    eaves = [
        (
            top[0] - EAVES_RADIUS * (sin(SLOPE) - sin(a)),
            top[1] + EAVES_RADIUS * (cos(a) - cos(SLOPE)),
        )
        for a in spread(SLOPE, 0.0, ceil(EAVES_RADIUS * SLOPE / _EDGE))
    ]
    end = _along(eaves[-1], (-roof, 0.0))
    return [
        _line((edge, 0.0), (edge, KERB), 2),
        _line((edge, KERB), foot[0], ceil(COURT / _EDGE)),
        foot,
        _line(foot[-1], top, ceil(WALL / _EDGE)),
        eaves,
        _line(eaves[-1], end, ceil(sum(ROOF) / 2.0 / _EDGE)),
        _line(end, _along(end, (0.0, -FASCIA)), 2),
    ]


def _along(point: tuple[float, float], way: tuple[float, float]) -> tuple[float, float]:
    return point[0] + way[0], point[1] + way[1]


def _line(start: tuple[float, float], end: tuple[float, float], count: int) -> _Profile:
    return list(zip(spread(start[0], end[0], count), spread(start[1], end[1], count), strict=True))


def _placed(
    station: float, x: float, y: float, heading: float, outward: float, height: float
) -> Point:
    """Return the point of a profile; those of the free lines' profiles slide along them."""
    rest = sum(length for length, _ in PLAN) - station
    slide = OVERHANG[1] * max(0.0, 1.0 - rest / PLAN[-1][0])
    slide -= OVERHANG[0] * max(0.0, 1.0 - station / PLAN[0][0])
    slide *= max(0.0, height - KERB)
    return (
        x + outward * sin(heading) + slide * cos(heading),
        y - outward * cos(heading) + slide * sin(heading),
        height,
    )
