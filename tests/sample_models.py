# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What is exact about the sample models, from the formulas in assets/README.md.

Every function returns points spread over the surface: where they are (z up), the principal
curvatures there without order, and the area that each stands for.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from surfaces.spheres import ellipsoid_shape

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Points:
    """Points of a surface: position (n, 3), two curvatures and area, (n,) each."""

    position: Array
    one: Array
    other: Array
    area: Array

    def classes(self, limit: float) -> NDArray[np.int64]:
        """Return 0 flat, 1 single-curved, 2 dome, 3 saddle at a limit of curvature."""
        big = (np.abs(self.one) > limit).astype(np.int64) + (np.abs(self.other) > limit)
        return np.where(big < 2, big, np.where(self.one * self.other > 0.0, 2, 3))

    def shares(self, limit: float) -> Array:
        """Return the shares of the four classes."""
        return np.bincount(self.classes(limit), self.area, 4) / self.area.sum()

    @property
    def smallest_radius(self) -> float:
        """Radius of the strongest bend."""
        return float(1.0 / np.maximum(np.abs(self.one), np.abs(self.other)).max())


def read_obj(path: Path) -> tuple[Array, list[list[int]]]:
    """Return vertices with z up and faces of a Wavefront file with Y up."""
    lines = [line.split() for line in path.read_text(encoding="ascii").splitlines()]
    vertices = np.array([line[1:] for line in lines if line[0] == "v"], dtype=float)
    faces = [[int(word) - 1 for word in line[1:]] for line in lines if line[0] == "f"]
    return np.stack([vertices[:, 0], -vertices[:, 2], vertices[:, 1]], axis=1), faces


def _middles(start: float, end: float, count: int) -> Array:
    return start + (end - start) * (np.arange(count) + 0.5) / count


def ellipsoid() -> Points:
    """Half axes 9, 6 and 4 m."""
    axes = np.array([9.0, 6.0, 4.0])
    z, turn = np.meshgrid(_middles(-1, 1, 400), _middles(0, 2 * np.pi, 800))
    ring = np.sqrt(1.0 - z**2)
    unit = np.stack([ring * np.cos(turn), ring * np.sin(turn), z], axis=2).reshape(-1, 3)
    shape = ellipsoid_shape((9.0, 6.0, 4.0), unit)
    # Cells of equal area on the sphere grow by the determinant times the normal's stretch.
    grown = axes.prod() * np.linalg.norm(unit / axes, axis=1)
    return Points(shape.position, shape.k1, shape.k2, grown * 4.0 * np.pi / len(unit))


def torus() -> Points:
    """Radii 6 and 2.5 m."""
    ring, tube = 6.0, 2.5
    u, v = (
        a.ravel() for a in np.meshgrid(_middles(0, 2 * np.pi, 800), _middles(0, 2 * np.pi, 800))
    )
    far = ring + tube * np.cos(v)
    position = np.stack([far * np.cos(u), far * np.sin(u), tube * np.sin(v)], axis=1)
    area = tube * far * (2.0 * np.pi / 800) ** 2
    return Points(position, np.full(len(u), 1.0 / tube), np.cos(v) / far, area)


def barrel_vault() -> Points:
    """Half a cylinder of 12 m between two quarters of a sphere, radius 5 m."""
    radius, length = 5.0, 12.0
    x, turn = (a.ravel() for a in np.meshgrid(_middles(-6, 6, 400), _middles(0, np.pi, 400)))
    wall = np.stack([x, radius * np.cos(turn), radius * np.sin(turn)], axis=1)
    step = radius * np.pi * length / len(x)
    z, around = (a.ravel() for a in np.meshgrid(_middles(0, 1, 300), _middles(0, 2 * np.pi, 600)))
    ring = np.sqrt(1.0 - z**2)
    dome = radius * np.stack([ring * np.cos(around), ring * np.sin(around), z], axis=1)
    dome[:, 0] += np.where(dome[:, 0] > 0.0, 0.5, -0.5) * length
    bent = np.concatenate([np.zeros(len(x)), np.full(len(z), 1.0 / radius)])
    area = np.repeat([step, 2.0 * np.pi * radius**2 / len(z)], [len(x), len(z)])
    return Points(np.concatenate([wall, dome]), np.full(len(bent), 1.0 / radius), bent, area)


# The pavilion: see its table in assets/README.md.
PLAN = ((6.0, 0.0), (9.0, -1 / 7.5), (2.0, 0.0), (25.0, 1 / 7.5), (4.0, 0.0))
SLOPE = np.radians(80.0)
FOOT, EAVES, WALL, COURT, KERB, FASCIA = 2.0, 3.6, 1.8, 2.4, 0.4, 0.6
OVERHANG = {0: 0.55, 4: 0.5}
_STEP = 0.04


def pavilion() -> Points:
    """Kerb, forecourt, foot, wall, eaves, roof and fascia along lines and arcs."""
    parts = [part for number in range(len(PLAN)) for part in _along_plan(number)]
    return Points(*(np.concatenate(arrays) for arrays in zip(*parts, strict=True)))


def _along_plan(number: int) -> Iterator[tuple[Array, Array, Array, Array]]:
    length, turn = PLAN[number]
    station = _middles(0.0, length, round(length / _STEP))
    for out, height, lean, bend, area in _profile(_roof(number, station)):
        stretch = 1.0 + turn * out
        slide, grown = _slide(number, station, height)
        position = _placed(number, station, out, height, slide)
        # A normal that leans out by an angle turns with the plan by its sine.
        across = turn * np.sin(lean) / stretch + 0.0 * out
        yield (
            position.reshape(-1, 3),
            np.broadcast_to(bend, out.shape).ravel(),
            across.ravel(),
            (area * stretch * grown * length / len(station)).ravel(),
        )
    yield _fascia(number, station)


def _profile(roof: Array) -> Iterator[tuple[Array, Array, Array, float, Array]]:
    """Yield offset outward, height, lean of the normal, bend and width, (stations, points)."""
    ones = np.ones((len(roof), 1))

    def strip(
        width: float | Array, out: Array, height: Array, lean: Array, bend: float
    ) -> tuple[Array, Array, Array, float, Array]:
        count = np.asarray(out).shape[-1]
        return ones * out, ones * height, ones * lean, bend, ones * width / count

    def many(width: float) -> Array:
        return _middles(0.0, 1.0, round(width / _STEP))

    start = FOOT * np.sin(SLOPE)
    low = KERB + FOOT * (1.0 - np.cos(SLOPE))
    t = many(KERB)
    yield strip(KERB, start + COURT + 0 * t, KERB * t, 0.5 * np.pi + 0 * t, 0.0)
    t = many(COURT)
    yield strip(COURT, start + COURT * t, KERB + 0 * t, 0 * t, 0.0)
    t = many(FOOT * SLOPE) * SLOPE
    yield strip(
        FOOT * SLOPE, start - FOOT * np.sin(t), KERB + FOOT * (1 - np.cos(t)), t, -1.0 / FOOT
    )
    t = many(WALL) * WALL
    yield strip(WALL, -t * np.cos(SLOPE), low + t * np.sin(SLOPE), SLOPE + 0 * t, 0.0)
    t = many(EAVES * SLOPE) * SLOPE
    out = EAVES * (np.sin(t) - np.sin(SLOPE)) - WALL * np.cos(SLOPE)
    top = low + WALL * np.sin(SLOPE)
    yield strip(EAVES * SLOPE, out, top + EAVES * (np.cos(t) - np.cos(SLOPE)), t, 1.0 / EAVES)
    t = many(roof.max())
    yield strip(roof[:, None], INNER - roof[:, None] * t, HEIGHT + 0 * t, 0 * t, 0.0)


INNER = -WALL * np.cos(SLOPE) - EAVES * np.sin(SLOPE)
"""Offset at which the roof begins."""

HEIGHT = KERB + (FOOT + EAVES) * (1.0 - np.cos(SLOPE)) + WALL * np.sin(SLOPE)


def _roof(number: int, station: Array) -> Array:
    t = np.minimum(1.0, (sum(length for length, _ in PLAN[:number]) + station) / 15.0)
    return 5.0 - 2.8 * t**3 * (10.0 - 15.0 * t + 6.0 * t * t)


def _slide(number: int, station: Array, height: Array) -> tuple[Array, Array]:
    """Return how far points slide along the free lines, and how that stretches them."""
    lean, length = OVERHANG.get(number, 0.0), PLAN[number][0]
    rise = np.maximum(0.0, height - KERB)
    place = station[:, None] / length
    return lean * rise * (place - 1.0 if number == 0 else place), 1.0 + lean * rise / length


def _placed(number: int, station: Array, out: Array, height: Array, slide: Array) -> Array:
    x, y, heading = 0.0, 0.0, np.radians(35.0)
    for length, turn in PLAN[:number]:
        x, y, heading = _moved(x, y, heading, length, turn)
    x, y, heading = (
        np.reshape(a, (-1, 1))
        for a in np.broadcast_arrays(*_moved(x, y, heading, station, PLAN[number][1]))
    )
    return np.stack(
        [
            x + out * np.sin(heading) + slide * np.cos(heading),
            y - out * np.cos(heading) + slide * np.sin(heading),
            height + 0.0 * out,
        ],
        axis=2,
    )


def _moved(x: float, y: float, heading: float, way: float | Array, turn: float) -> tuple:
    if turn == 0.0:
        return x + way * np.cos(heading), y + way * np.sin(heading), heading
    end = heading + way * turn
    return (
        x + (np.sin(end) - np.sin(heading)) / turn,
        y - (np.cos(end) - np.cos(heading)) / turn,
        end,
    )


def _fascia(number: int, station: Array) -> tuple[Array, Array, Array, Array]:
    """Return the strip below the roof's edge, bent as that curve is, by differences along it."""
    t = np.linspace(0.0, PLAN[number][0], len(station) + 1)
    out = INNER - _roof(number, t)[:, None]
    height = HEIGHT - _middles(0.0, FASCIA, round(FASCIA / _STEP))
    slide, _ = _slide(number, t, height)
    position = _placed(number, t, out + 0.0 * height, height + 0.0 * out, slide)
    way = np.diff(position, axis=0)
    length = np.linalg.norm(way, axis=2)
    angle = np.unwrap(np.arctan2(way[..., 1], way[..., 0]), axis=0)
    bend = np.gradient(angle, axis=0) / length
    middle = 0.5 * (position[1:] + position[:-1])
    area = length * FASCIA / height.size
    return middle.reshape(-1, 3), bend.ravel(), 0.0 * bend.ravel(), area.ravel()


MODELS = {
    "pavilion": pavilion,
    "barrel_vault": barrel_vault,
    "torus": torus,
    "ellipsoid": ellipsoid,
}
