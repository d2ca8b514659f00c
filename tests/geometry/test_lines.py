# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Traced lines follow the exact ones, end for a reason and cover the surface evenly."""

from __future__ import annotations

import numpy as np
import pytest
from architectural_curvature.addon.geometry.lines.assembly import shifted
from architectural_curvature.addon.geometry.lines.field import ASYMPTOTIC, PRINCIPAL, Family
from architectural_curvature.addon.geometry.lines.layout import trace_evenly
from architectural_curvature.addon.geometry.lines.lines import CurvatureLines, LineEnd
from architectural_curvature.addon.geometry.lines.seeds import make_seeds
from architectural_curvature.addon.geometry.lines.simplification import simplified
from architectural_curvature.addon.geometry.lines.tracer import (
    LineField,
    own_rules,
    trace_from,
)
from architectural_curvature.addon.geometry.lines.tracing import trace
from architectural_curvature.addon.geometry.mesh import mesh_from_polygons
from line_fields import field_of, field_on
from scipy.spatial import cKDTree
from surfaces.catalogue import PATCHES, TORUS_RING, TORUS_TUBE
from surfaces.sampling import sample_patch
from surfaces.spheres import ellipsoid_shape, sample_ellipsoid

AXES = (1.5, 1.2, 1.0)
CLOSED, RIM = LineEnd.CLOSED, LineEnd.RIM


def trace_some(
    lines: LineField, count: int = 8, families: tuple[Family, ...] = PRINCIPAL
) -> CurvatureLines:
    """Trace from the middles of triangles spread over the surface."""
    triangle = np.linspace(0, len(lines.field.mesh.triangles) - 1, count).astype(np.int64)
    return trace_from(lines, triangle, np.full((count, 3), 1.0 / 3.0), families)


def spread(values: np.ndarray, lines: CurvatureLines) -> np.ndarray:
    """Return how much values at the points vary along each line."""
    first = lines.start[:-1]
    return np.maximum.reduceat(values, first) - np.minimum.reduceat(values, first)


@pytest.mark.parametrize("kind", ["regular", "irregular"])
@pytest.mark.parametrize("noise", [0.0, 0.005])
def test_every_line_of_a_torus_closes(kind: str, noise: float) -> None:
    sample = sample_patch(PATCHES["torus"], kind, (100, 40))
    lines = trace_some(field_on(sample, noise))
    assert (lines.ends == CLOSED).all()
    x, y, z = lines.points.T
    turn = np.arctan2(z, np.hypot(x, y) - TORUS_RING)
    around = np.unwrap(np.arctan2(y, x))
    is_first = lines.family == Family.FIRST
    half = 0.5 * sample.longest_edge * (1.0 + 10.0 * noise)
    assert (spread(np.sin(turn), lines)[~is_first] * TORUS_TUBE < half).all()
    # The seam of the angle is no jump of the sine.
    assert (spread(np.sin(around - around[lines.start[:-1]][lines.point_line]), lines)[is_first]
            < half).all()  # fmt: skip


def bumpy_sphere() -> LineField:
    """Return the field of a surface on which lines run together and come back to themselves."""
    sample = sample_ellipsoid((1.0, 1.0, 1.0), "geodesic", 18)
    x, y, z = sample.shape.position.T
    bump = np.sin(3.0 * x + 1.0) * np.sin(4.0 * y) + np.cos(3.0 * z - x)
    position = (1.0 + 0.12 * bump)[:, None] * sample.shape.position
    return field_of(mesh_from_polygons(position, sample.polygons))


def test_a_line_does_not_depend_on_those_traced_with_it() -> None:
    lines = bumpy_sphere()
    triangles = np.linspace(0, len(lines.field.mesh.triangles) - 1, 24).astype(np.int64)
    middle = np.full((len(triangles), 3), 1.0 / 3.0)
    apart = trace_from(lines, triangles, middle, (Family.FIRST,))
    assert apart.count == len(triangles)
    for number in range(0, len(triangles), 4):
        beside = trace_from(
            lines, np.full(len(triangles), triangles[number]), middle, (Family.FIRST,)
        )
        assert beside.count == len(triangles)
        np.testing.assert_allclose(beside.length, apart.length[number], rtol=1e-9)


def test_a_line_ends_at_the_longest_way_that_it_may_go() -> None:
    lines = bumpy_sphere()
    triangles = np.linspace(0, len(lines.field.mesh.triangles) - 1, 24).astype(np.int64)
    seeds = make_seeds(
        triangles, np.full((24, 3), 1.0 / 3.0), np.full(24, int(Family.FIRST), dtype=np.int64)
    )
    rules = own_rules(lines)
    # Both arms make eight steps between two looks, of a quarter of the spacing at most.
    more = 2 * 8 * 0.25 * rules.spacing
    is_bound = np.arange(24) % 2 == 0
    ways = []
    for longest in (None, np.where(is_bound, 0.3, np.inf)):
        state, samples = trace(
            lines.field, lines.own_surroundings, seeds, lines.no_samples, rules, longest
        )
        assert (state.end >= 0).all()
        way = np.zeros(48)
        np.maximum.at(way, samples.arm, samples.arc)
        ways.append(way[::2] + way[1::2])
    free, bound = ways
    assert (free[is_bound] > 0.3 + more).any()
    assert (bound[is_bound] < 0.3 + more).all()
    np.testing.assert_allclose(bound[~is_bound], free[~is_bound], rtol=1e-9)


def test_lines_of_an_ellipsoid_lie_on_confocal_quadrics() -> None:
    sample = sample_ellipsoid(AXES, "irregular", 20)
    lines = trace_some(field_on(sample), 10)
    square = np.array(AXES) ** 2
    # The confocal quadrics through a point: roots of the sum of x²/(a² - t) = 1, besides t = 0.
    x = lines.points**2
    x /= (x / square).sum(axis=1)[:, None]
    total = square.sum() - x.sum(axis=1)
    a, b, c = square
    product = a * b + b * c + c * a - x @ np.array([b + c, c + a, a + b])
    gap = np.sqrt(np.maximum(total**2 - 4.0 * product, 0.0))
    small, large = 0.5 * (total - gap), 0.5 * (total + gap)
    is_first = lines.family[lines.point_line] == Family.FIRST
    constant = np.minimum(
        spread(np.where(is_first, small, small), lines),
        spread(np.where(is_first, large, large), lines),
    )
    # How far a step of the parameter is, is at least this far from the umbilics.
    assert np.median(constant) < 0.5 * sample.longest_edge * 0.1
    assert constant.max() < 0.5 * sample.longest_edge


def test_lines_of_an_ellipsoid_run_along_exact_directions() -> None:
    sample = sample_ellipsoid(AXES, "irregular", 20)
    lines = trace_evenly(field_on(sample), 0.2)
    unit = lines.points / np.array(AXES)
    shape = ellipsoid_shape(AXES, unit / np.linalg.norm(unit, axis=1)[:, None])
    line = lines.point_line
    here = np.flatnonzero(np.diff(line) == 0)
    move = lines.points[here + 1] - lines.points[here]
    is_first = (lines.family[line] == Family.FIRST)[:, None]
    exact = np.where(is_first, shape.direction_1, shape.direction_2)
    sign = np.sign(np.einsum("ij,ij->i", exact[here], exact[here + 1]))[:, None]
    normal = shape.normal[here] + shape.normal[here + 1]
    across = np.cross(normal, exact[here] + sign * exact[here + 1])
    across /= np.linalg.norm(across, axis=1)[:, None]
    length = np.linalg.norm(move, axis=1)
    long = length > 1e-6
    sine = np.abs(np.einsum("ij,ij->i", move, across))[long] / length[long]
    angle = np.degrees(np.arcsin(np.minimum(sine, 1.0)))
    assert np.average(angle, weights=length[long]) < 0.5


def test_lines_of_a_catenoid_end_at_the_rim_or_close() -> None:
    lines = trace_some(field_on(sample_patch(PATCHES["catenoid"], "irregular", (70, 30))))
    is_closed = (lines.ends == CLOSED).all(axis=1)
    assert (is_closed | (lines.ends == RIM).all(axis=1)).all()
    assert is_closed.sum() == 8
    ends = lines.points[np.stack([lines.start[:-1], lines.start[1:] - 1], axis=1)[~is_closed]]
    assert np.abs(ends[..., 2]) == pytest.approx(1.0, abs=1e-9)


def test_families_cross_at_right_angles() -> None:
    lines = field_on(sample_patch(PATCHES["waves"], "irregular", (50, 50)))
    traced = trace_evenly(lines, 0.2)
    place = traced.triangle, traced.barycentric
    ones = np.ones(len(traced.points), dtype=np.int64)
    first = lines.field.evaluate(*place, int(Family.FIRST) * ones)[0]
    second = lines.field.evaluate(*place, int(Family.SECOND) * ones)[0]
    assert np.abs(np.einsum("ij,ij->i", first, second)).max() < 1e-9


@pytest.mark.parametrize("kind", ["regular", "irregular"])
def test_closed_lines_go_around_once_and_never_back(kind: str) -> None:
    """Where the arms of a line meet both may have crossed a side at the same place."""
    traced = trace_evenly(field_on(sample_patch(PATCHES["catenoid"], kind, (110, 40))), 0.12)
    rings = traced.chosen(np.flatnonzero(traced.is_closed))
    assert rings.count > 10
    for number in range(rings.count):
        x, y, _ = rings.line_points(number).T
        turn = np.angle(np.exp(1j * np.diff(np.arctan2(y, x), append=np.arctan2(y[0], x[0]))))
        assert (turn * np.sign(turn.sum()) > 0.0).all()
        assert abs(turn.sum()) == pytest.approx(2.0 * np.pi)


def test_no_line_crosses_a_crease() -> None:
    """Two vaults that meet at a sharp valley: a line that reaches it ends there."""
    turn = np.linspace(0.4, np.pi - 0.4, 25)
    along = np.linspace(0.0, 2.0, 15)
    profile = np.concatenate(
        [
            np.stack([-np.cos(turn) - np.cos(0.4), np.sin(turn)], axis=1),
            np.stack([-np.cos(turn) + np.cos(0.4), np.sin(turn)], axis=1)[1:],
        ]
    )
    count = len(profile)
    position = np.concatenate(
        [np.column_stack([profile[:, 0], np.full(count, y), profile[:, 1]]) for y in along]
    )
    i, j = (index.ravel() for index in np.indices((len(along) - 1, count - 1)))
    corner = i * count + j
    quads = np.stack([corner, corner + 1, corner + count + 1, corner + count], axis=1)
    traced = trace_evenly(field_of(mesh_from_polygons(position, quads)), 0.2)
    assert (traced.ends == LineEnd.CREASE).any()
    x = traced.points[:, 0]
    first = traced.start[:-1]
    assert (np.minimum.reduceat(x, first) * np.maximum.reduceat(x, first) > -1e-9).all()


def test_lines_end_at_flat_parts() -> None:
    """A vault that runs out tangentially into a plane, all smooth."""
    turn = np.linspace(0.0, 0.5 * np.pi, 20)
    straight = np.linspace(0.0, 1.0, 11)[1:]
    profile = np.concatenate(
        [
            np.stack([-np.cos(turn), np.sin(turn)], axis=1),
            np.stack([straight, np.ones(10)], axis=1),
        ]
    )
    along = np.linspace(0.0, 1.5, 16)
    count = len(profile)
    position = np.concatenate(
        [np.column_stack([profile[:, 0], np.full(count, y), profile[:, 1]]) for y in along]
    )
    i, j = (index.ravel() for index in np.indices((len(along) - 1, count - 1)))
    corner = i * count + j
    quads = np.stack([corner, corner + 1, corner + count + 1, corner + count], axis=1)
    lines = field_of(mesh_from_polygons(position, quads))
    traced = trace_evenly(lines, 0.15)
    assert len(lines.umbilics.area_index) == 1
    assert (traced.ends == LineEnd.AREA).any()
    assert traced.points[:, 0].max() < 0.3


def test_asymptotic_lines_of_a_hyperbolic_paraboloid_are_its_rulings() -> None:
    sample = sample_patch(PATCHES["hyperbolic paraboloid"], "irregular", (40, 40))
    traced = trace_some(field_on(sample), 9, ASYMPTOTIC)
    assert (traced.ends == RIM).all()
    straying = np.minimum(spread(traced.points[:, 0], traced), spread(traced.points[:, 1], traced))
    assert straying.max() < 0.5 * sample.longest_edge


def test_asymptotic_lines_of_a_torus_end_at_its_parabolic_circles() -> None:
    traced = trace_evenly(
        field_on(sample_patch(PATCHES["torus"], "irregular", (90, 40))), 0.2, ASYMPTOTIC
    )
    assert traced.count
    ends = traced.points[np.stack([traced.start[:-1], traced.start[1:] - 1], axis=1)]
    at_curve = ends[traced.ends == LineEnd.PARABOLIC]
    assert len(at_curve)
    assert np.abs(np.abs(at_curve[:, 2]) - TORUS_TUBE).max() < 0.1 * TORUS_TUBE
    assert np.hypot(traced.points[:, 0], traced.points[:, 1]).max() < TORUS_RING + 0.1 * TORUS_TUBE


def test_lines_do_not_depend_on_where_the_model_lies() -> None:
    sample = sample_patch(PATCHES["waves"], "irregular", (30, 30))
    far = np.array([4e5, -2e5, 300.0])
    one = field_of(mesh_from_polygons(sample.shape.position, sample.polygons))
    other = field_of(mesh_from_polygons(sample.shape.position + far, sample.polygons))
    a, b = trace_some(one, 6), trace_some(other, 6)
    assert (a.ends == b.ends).all()
    assert a.length == pytest.approx(b.length, rel=1e-3)


def test_a_single_triangle_and_a_plane_have_no_lines() -> None:
    plane = field_on(sample_patch(PATCHES["plane"], "regular", (8, 8)))
    assert trace_evenly(plane, 0.2).count == 0
    assert trace_some(plane).count == 0
    triangle = field_of(mesh_from_polygons(np.eye(3), [[0, 1, 2]]))
    assert trace_evenly(triangle, 0.1).count == 0


def test_simplified_lines_stay_within_the_tolerance() -> None:
    lines = trace_some(field_on(sample_patch(PATCHES["torus"], "irregular", (60, 30))), 4)
    few = simplified(lines, 0.01)
    assert (few.ends == lines.ends).all()
    assert len(few.points) < 0.5 * len(lines.points)
    # Between two points at a time, which no chord is longer than, the line is searched finely.
    for line in range(lines.count):
        corner = few.line_points(line)
        share = np.linspace(0.0, 1.0, 200)[:, None, None]
        fine = (1.0 - share) * corner + share * np.roll(corner, -1, axis=0)
        away = cKDTree(fine.reshape(-1, 3)).query(lines.line_points(line))[0]
        assert np.max(away) < 0.0101


def test_places_move_along_the_sides_that_they_lie_on() -> None:
    """There a rounding error points out of both triangles: they went to and fro for ever."""
    lines = field_on(sample_patch(PATCHES["waves"], "irregular", (40, 40)))
    field, mesh = lines.field, lines.field.mesh
    triangle, side = np.nonzero(mesh.neighbor >= 0)
    corner = mesh.position[mesh.triangles[triangle]]
    rows = np.arange(len(triangle))
    along = corner[rows, (side + 2) % 3] - corner[rows, (side + 1) % 3]
    place = np.full((len(rows), 3), 0.5)
    place[rows, side] = 0.0
    way = 0.3 * np.linalg.norm(along, axis=1)
    found = shifted(field, triangle, place, along, way)
    moved = mesh.points(*found) - mesh.points(triangle, place)
    assert moved == pytest.approx(0.3 * along, abs=1e-9)
