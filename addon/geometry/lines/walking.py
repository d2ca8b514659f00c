# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""One walker at a time over triangles, in plain numbers: for a few lines ten times as fast as rows.

These are the steps of `steps.follow` and `steps.cross`, and a test holds them together.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from math import acos, atan2, cos, hypot, inf, pi, sin, sqrt

from .endings import PARABOLIC
from .field import STEEPEST, DirectionField, Family
from .steps import GRAZING, LEAST, NUDGE, STRAIGHT, STUCK, TURN

Vector = tuple[float, float, float]

#: Triangles whose numbers are kept: lines under a mouse run through the same ones again.
_KEPT = 30_000
_FIRST = int(Family.FIRST)
#: What is distinct of a packed row, whose first nine numbers are a symmetric matrix.
_DISTINCT = [0, 1, 2, 4, 5, 8, 9, 10, 11, 12]


@dataclass(frozen=True, slots=True)
class Tile:
    """What walkers need to know of one triangle; see `Triangulation` and `DirectionField`.

    Parameters
    ----------
    place : nine float
        Positions of the corners in meters.
    gradient : nine float
    along, flat : vector
        First and last row of the frame.
    corners : three times ten float
        The deviator as a symmetric matrix (xx, xy, xz, yy, yz, zz), the normal, and the mean
        curvature.
    neighbor, neighbor_side : three int
    """

    place: tuple[float, ...]
    gradient: tuple[float, ...]
    along: tuple[float, ...]
    flat: tuple[float, ...]
    corners: tuple[tuple[float, ...], ...]
    neighbor: tuple[int, ...]
    neighbor_side: tuple[int, ...]


@dataclass(slots=True)
class Walker:
    """A point that moves over triangles.

    Parameters
    ----------
    triangle : int
    place : vector
        Barycentric.
    heading : vector
        Unit vector into which it moved last.
    family : int
        A value of `Family`.
    idle : int
        Steps in succession without progress.
    """

    triangle: int
    place: Vector
    heading: Vector
    family: int
    idle: int = 0


class Ground:
    """The triangles of a field as walkers need them.

    Parameters
    ----------
    field : DirectionField
    """

    def __init__(self, field: DirectionField) -> None:
        self._field = field
        # They are computed for all triangles when first asked for.
        self._gradient, self._frame = field.mesh.gradient, field.mesh.frame
        self._shortest = 1e-9 * field.mesh.edge_length
        self.tile = lru_cache(_KEPT)(self._tile)
        self._corner = lru_cache(_KEPT)(self._packed)

    def follow(self, walker: Walker, reach: float) -> tuple[float, int]:
        """Move a walker along the field, as `steps.follow` does; return way and side reached."""
        tile, start = self.tile(walker.triangle), walker.place
        heading, family = walker.heading, walker.family
        guess = _rate(tile, heading)
        free = _exit(start, guess)[0]
        length = min(free, reach)
        middle = _moved(start, 0.5 * length, guess)
        tangent, course = _directions(tile, middle, family, heading)
        cosine = tangent[0] * heading[0] + tangent[1] * heading[1] + tangent[2] * heading[2]
        is_short = reach < free
        if cosine < STRAIGHT and length > 0.0:
            is_short = True
            length *= max(TURN / acos(max(-1.0, min(cosine, 1.0))), LEAST)
            middle = _moved(start, 0.5 * length, guess)
            tangent, course = _directions(tile, middle, family, heading)
        rate = _rate(tile, course)
        way, side = _exit(start, rate)
        if length > 0.0 and way < GRAZING * length:
            way, side, rate = 0.5 * length, -1, guess
        elif is_short and length < way:
            way, side = length, -1
        walker.place = _on_side(_moved(start, way, rate), side)
        walker.heading = tangent
        self._unstick(walker, way)
        return way, side

    def cross(self, walker: Walker, side: int) -> bool:
        """Move a walker at a side into the triangle beyond it; return whether there is none."""
        tile = self.tile(walker.triangle)
        beyond, new = tile.neighbor[side], tile.neighbor_side[side]
        if beyond < 0:
            return True
        after = [0.0, 0.0, 0.0]
        after[(new + 1) % 3] = walker.place[(side + 2) % 3]
        after[(new + 2) % 3] = walker.place[(side + 1) % 3]
        walker.triangle, walker.place = beyond, (after[0], after[1], after[2])
        return False

    def position(self, walker: Walker) -> Vector:
        """Return where a walker stands, as the positions of the field's mesh."""
        a, b, c = walker.place
        x, y, z, p, q, r, u, v, w = self.tile(walker.triangle).place
        return a * x + b * p + c * u, a * y + b * q + c * v, a * z + b * r + c * w

    def is_parabolic(self, walker: Walker) -> bool:
        """Return whether a walker stands where asymptotic lines end; see `end_at_parabolic`."""
        _, _, _, bend, twist, mean = _shape(self.tile(walker.triangle), walker.place)
        saddle = bend * bend + twist * twist - mean * mean
        return sqrt(max(saddle, 0.0)) <= PARABOLIC * hypot(twist, bend)

    def _unstick(self, walker: Walker, way: float) -> None:
        walker.idle = 0 if way > self._shortest else walker.idle + 1
        if walker.idle > STUCK:
            a, b, c = (NUDGE / 3.0 + (1.0 - NUDGE) * each for each in walker.place)
            walker.place = a, b, c
            walker.idle = STUCK // 2

    def _tile(self, triangle: int) -> Tile:
        mesh, corner = self._field.mesh, self._corner
        one, two, three = mesh.triangles[triangle].tolist()
        frame = self._frame[triangle]
        return Tile(
            tuple(mesh.position[mesh.triangles[triangle]].ravel().tolist()),
            tuple(self._gradient[triangle].ravel().tolist()),
            tuple(frame[0].tolist()),
            tuple(frame[2].tolist()),
            (corner(one), corner(two), corner(three)),
            tuple(mesh.neighbor[triangle].tolist()),
            tuple(mesh.neighbor_side[triangle].tolist()),
        )

    def _packed(self, sector: int) -> tuple[float, ...]:
        return tuple(self._field.packed[sector, _DISTINCT].tolist())


def _directions(tile: Tile, place: Vector, family: int, heading: Vector) -> tuple[Vector, Vector]:
    """Return tangent and course as `DirectionField.evaluate` does, turned as to go on as before."""
    (nx, ny, nz), (x, y, z), (u, v, w), bend, twist, mean = _shape(tile, place)
    angle = 0.5 * atan2(twist, bend)
    if family != _FIRST:
        angle += _turn(family, hypot(twist, bend), mean)
    cosine, sine = cos(angle), sin(angle)
    x, y, z = cosine * x + sine * u, cosine * y + sine * v, cosine * z + sine * w
    if x * heading[0] + y * heading[1] + z * heading[2] < 0.0:
        x, y, z = -x, -y, -z
    p, q, r = tile.flat
    lift, cosine = x * p + y * q + z * r, nx * p + ny * q + nz * r
    if cosine < STEEPEST:
        p, q, r = x - lift * p, y - lift * q, z - lift * r
    else:
        lift /= cosine
        p, q, r = x - lift * nx, y - lift * ny, z - lift * nz
    size = sqrt(p * p + q * q + r * r + 1e-300)
    return (x, y, z), (p / size, q / size, r / size)


def _shape(tile: Tile, place: Vector) -> tuple[Vector, Vector, Vector, float, float, float]:
    """Return normal, two tangents, the deviator's parts along and between them, mean curvature."""
    a, b, c = place
    rows = zip(*tile.corners, strict=True)
    xx, xy, xz, yy, yz, zz, nx, ny, nz, mean = [a * p + b * q + c * r for p, q, r in rows]
    size = sqrt(nx * nx + ny * ny + nz * nz + 1e-300)
    nx, ny, nz = nx / size, ny / size, nz / size
    x, y, z = tile.along
    off = x * nx + y * ny + z * nz
    x, y, z = x - off * nx, y - off * ny, z - off * nz
    size = sqrt(x * x + y * y + z * z + 1e-300)
    x, y, z = x / size, y / size, z / size
    u, v, w = ny * z - nz * y, nz * x - nx * z, nx * y - ny * x
    p, q, r = xx * x + xy * y + xz * z, xy * x + yy * y + yz * z, xz * x + yz * y + zz * z
    twist = u * p + v * q + w * r
    bend = 0.5 * (x * p + y * q + z * r)
    p, q, r = xx * u + xy * v + xz * w, xy * u + yy * v + yz * w, xz * u + yz * v + zz * w
    bend -= 0.5 * (u * p + v * q + w * r)
    return (nx, ny, nz), (x, y, z), (u, v, w), bend, twist, mean


def _turn(family: int, strength: float, mean: float) -> float:
    """Return the angle from the direction of k1 to that of another family."""
    if family == Family.SECOND:
        return 0.5 * pi
    turn = 0.5 * acos(max(-1.0, min(-mean / max(strength, 1e-300), 1.0)))
    return -turn if family == Family.ASYMPTOTIC_RIGHT else turn


def _exit(start: Vector, rate: Vector) -> tuple[float, int]:
    """Return how far it is to the triangle's side, and which side it is."""
    one = start[0] / -rate[0] if rate[0] < 0.0 else inf
    two = start[1] / -rate[1] if rate[1] < 0.0 else inf
    three = start[2] / -rate[2] if rate[2] < 0.0 else inf
    if one <= two and one <= three:
        return one, 0
    return (two, 1) if two <= three else (three, 2)


def _on_side(place: Vector, side: int) -> Vector:
    """Return barycentric coordinates without rounding: inside, and zero for the side reached."""
    a, b, c = place
    a = a if side != 0 and a > 0.0 else 0.0
    b = b if side != 1 and b > 0.0 else 0.0
    c = c if side != 2 and c > 0.0 else 0.0
    total = a + b + c
    return a / total, b / total, c / total


def _rate(tile: Tile, course: Vector) -> Vector:
    """Return how fast the barycentric coordinates change along a course."""
    a, b, c, d, e, f, g, h, i = tile.gradient
    x, y, z = course
    return a * x + b * y + c * z, d * x + e * y + f * z, g * x + h * y + i * z


def _moved(start: Vector, way: float, rate: Vector) -> Vector:
    return start[0] + way * rate[0], start[1] + way * rate[1], start[2] + way * rate[2]
