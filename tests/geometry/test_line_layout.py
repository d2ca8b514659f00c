# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines cover a surface evenly, narrow parts too, and go on beyond seams."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from architectural_curvature.addon.geometry.curvature import estimate_curvature
from architectural_curvature.addon.geometry.engine.normals import tangent_frame
from architectural_curvature.addon.geometry.errors import InvalidSettingError
from architectural_curvature.addon.geometry.lines.field import PRINCIPAL, Family
from architectural_curvature.addon.geometry.lines.holes import hole_seeds
from architectural_curvature.addon.geometry.lines.layout import trace_evenly
from architectural_curvature.addon.geometry.lines.lines import LineEnd
from architectural_curvature.addon.geometry.lines.samples import Trail, take_samples
from architectural_curvature.addon.geometry.lines.simplification import simplified
from architectural_curvature.addon.geometry.lines.tracer import LineField, build_line_field
from architectural_curvature.addon.geometry.mesh import mesh_from_polygons
from architectural_curvature.addon.geometry.surface import build_surface
from line_fields import field_on
from scipy.spatial import cKDTree
from surfaces.catalogue import PATCHES, Patch
from surfaces.sampling import sample_patch
from surfaces.taylor import cos, sin

RIM = LineEnd.RIM


@pytest.mark.parametrize("name", ["torus", "elliptic paraboloid", "hyperbolic paraboloid"])
def test_lines_are_evenly_spaced_without_holes(name: str) -> None:
    spacing = 0.15
    lines = field_on(sample_patch(PATCHES[name], "irregular", (70, 50)))
    traced = trace_evenly(lines, spacing)
    middle = lines.field.mesh.points(
        np.arange(len(lines.field.mesh.triangles)),
        np.full((len(lines.field.mesh.triangles), 3), 1.0 / 3.0),
    )
    for family in PRINCIPAL:
        chosen = traced.chosen(np.flatnonzero(traced.family == family))
        hole = cKDTree(chosen.points).query(middle)[0]
        assert 2.0 * hole.max() < 2.5 * spacing
        found = cKDTree(chosen.points).query(chosen.points, k=80)
        distance, other = np.asarray(found[0]), np.asarray(found[1])
        line = chosen.point_line
        distance[line[other] == line[:, None]] = np.inf
        nearest = distance.min(axis=1)
        assert ((nearest > 0.5 * spacing) & (nearest < 2.0 * spacing)).mean() >= 0.9


def test_lines_across_a_narrow_strip_are_kept() -> None:
    """A fascia of a third of the spacing needs its lines across as much as any other part."""
    fascia = Patch(lambda u, v: (sin(u), v, -1.0 * cos(u)), (-1.2, 1.2), (0.0, 0.1))
    traced = trace_evenly(field_on(sample_patch(fascia, "regular", (60, 3))), 0.3)
    across = traced.length < 0.2
    assert across.sum() >= 2.4 / 0.3 - 1.0
    assert (traced.ends == RIM).all()


@pytest.mark.parametrize("kind", ["regular", "irregular"])
@pytest.mark.parametrize("around", [0.1, 0.3, 0.7, 1.2, 1.7, 2.6])
def test_rings_of_a_thin_pipe_go_around_once(kind: str, around: float) -> None:
    """A slightly conical pipe, whose girth is a share of the spacing or a few of them."""
    radius = around / (2.0 * np.pi)
    pipe = Patch(
        lambda u, v: (
            radius * (1.0 + 0.02 * v) * cos(u), radius * (1.0 + 0.02 * v) * sin(u), v
        ),
        (0.0, 2.0 * np.pi),
        (0.0, 4.0),
        (True, False),
    )  # fmt: skip
    traced = trace_evenly(field_on(sample_patch(pipe, kind, (24, 40))), 1.0)
    rings = traced.chosen(np.flatnonzero(traced.family == Family.FIRST))
    # One for every spacing of its length.
    assert rings.count == 4
    assert rings.is_closed.all()
    assert (rings.length <= around * 1.09).all()
    assert (rings.length > 0.97 * around).all()


def _torus(tube: float) -> Patch:
    """Return a torus around a ring of radius 1."""
    return Patch(
        lambda u, v: (
            (tube * cos(v) + 1.0) * cos(u),
            (tube * cos(v) + 1.0) * sin(u),
            tube * sin(v),
        ),
        (0.0, 2.0 * np.pi),
        (0.0, 2.0 * np.pi),
        (True, True),
    )


@pytest.mark.parametrize("kind", ["regular", "irregular"])
@pytest.mark.parametrize(
    ("tube", "cells", "spacing"),
    [
        (0.05, (160, 12), 0.5),
        (0.1, (110, 20), 0.15),
        (0.4, (90, 36), 0.12),
        (0.45, (90, 40), 0.3),
        (0.3, (90, 28), 0.745),
        (0.6, (80, 48), 0.2),
        (0.6, (80, 48), 0.9),
        (0.7, (72, 50), 0.25),
    ],
)
def test_every_line_laid_out_on_a_torus_closes(
    kind: str, tube: float, cells: tuple[int, int], spacing: float
) -> None:
    """Lines around the tube are up to 5.7 times as far apart outside as inside.

    Up to 2.6 times, half a spacing inside, at which a line would end, is less than 1.7 outside,
    where another one would find room. Around fatter tubes lines may be closer and farther apart.
    """
    close, far = (0.5, 1.7) if tube < 0.5 else (0.33, 2.3)
    sample = sample_patch(_torus(tube), kind, cells)
    surface = build_surface(mesh_from_polygons(sample.shape.position, sample.polygons), np.pi)
    traced = trace_evenly(build_line_field(surface, estimate_curvature(surface)), spacing)
    assert (traced.ends == LineEnd.CLOSED).all()
    around = traced.chosen(np.flatnonzero(traced.family == Family.FIRST))
    assert around.length == pytest.approx(2.0 * np.pi * tube, rel=0.05)
    # Their gaps on the outer equator add up to all of it, and none holds another line.
    assert around.count >= 2.0 * np.pi * (1.0 + tube) / (far * spacing)
    assert around.count <= 2.0 * np.pi * (1.0 - tube) / (close * spacing)


def test_lines_on_every_torus_of_a_model_close() -> None:
    """Each piece has its own distances: here tubes of 0.25 and of 0.6 of the ring."""
    points, polygons, count = [], [], 0
    for number, tube in enumerate((0.25, 0.6)):
        sample = sample_patch(_torus(tube), "irregular", (72, round(72 * tube)))
        points.append(sample.shape.position + [[4.0 * number, 0.0, 0.0]])
        polygons.append(sample.polygons + count)
        count += len(sample.shape.position)
    surface = build_surface(mesh_from_polygons(np.concatenate(points), np.concatenate(polygons)))
    traced = trace_evenly(build_line_field(surface, estimate_curvature(surface)), 0.2)
    assert (traced.ends == LineEnd.CLOSED).all()


def test_lines_on_both_sides_of_a_pipe_keep_half_a_spacing() -> None:
    """On a pipe two spacings around, two lines are as far apart as they can be: across it."""
    girth = 2.0
    radius = girth / (2.0 * np.pi)
    pipe = Patch(
        lambda u, v: (radius * cos(u), radius * sin(u), v),
        (0.0, 2.0 * np.pi),
        (0.0, 6.0),
        (True, False),
    )
    traced = trace_evenly(field_on(sample_patch(pipe, "regular", (24, 60))), 1.0)
    along = traced.chosen(np.flatnonzero(traced.family == Family.SECOND))
    middle = np.array([along.line_points(line).mean(axis=0)[:2] for line in range(along.count)])
    apart = np.linalg.norm(middle[:, None] - middle, axis=2)
    assert apart[~np.eye(along.count, dtype=np.bool_)].min() > 0.5


@pytest.mark.parametrize(("turn", "back"), [(0.5, 0.0), (1.4, 0.0), (1.1, 0.6)])
def test_lines_end_before_a_sharp_turn(turn: float, back: float) -> None:
    """Directions turn by an angle within two edges, where x is 0: by 29 degrees lines follow.

    They may have turned the other way just before, which does not make it less sharp.
    """
    shell = Patch(lambda u, v: (u, v, -0.05 * u * u - 0.01 * v * v), (-1.0, 1.0), (-1.0, 1.0))
    lines = field_on(sample_patch(shell, "regular", (50, 50)))
    field = lines.field
    edge, spacing = 2.0 / 50.0, 0.9
    place = field.mesh.position[:, 0] / edge
    angle = turn * np.clip(0.5 + 0.5 * place, 0.0, 1.0) - back * np.clip(2.5 + place, 0.0, 1.0)
    direction = np.stack([np.cos(angle), np.sin(angle), np.zeros(len(angle))], axis=1)
    axes = tangent_frame(field.normal)
    along, across = (np.einsum("ij,ij->i", direction, axis) for axis in axes)
    turned = LineField(field.with_deviator(0.04 * (along + 1j * across) ** 2), lines.umbilics)
    traced = trace_evenly(turned, spacing, (Family.FIRST,))
    x = traced.points[:, 0]
    first = traced.start[:-1]
    goes_over = np.minimum.reduceat(x, first) < -3.0 * edge
    goes_over &= np.maximum.reduceat(x, first) > 2.0 * edge
    ends_there = (traced.ends == LineEnd.FOLD).any(axis=1)
    is_sharp = turn > 0.25 * np.pi
    assert goes_over.any() == (not is_sharp)
    assert ends_there.any() == is_sharp
    ends = traced.points[np.stack([traced.start[:-1], traced.start[1:] - 1], axis=1)]
    assert np.abs(ends[traced.ends == LineEnd.FOLD][:, 0]).max(initial=0.0) < 2.0 * edge


def test_lines_do_not_follow_normals_that_are_none_of_their_triangles() -> None:
    """Between narrow folds a fit may see a triangle from behind or from its edge."""
    shell = Patch(lambda u, v: (u, v, -0.2 * u * u - 0.02 * v * v), (-1.0, 1.0), (-1.0, 1.0))
    sample = sample_patch(shell, "irregular", (40, 40))
    surface = build_surface(mesh_from_polygons(sample.shape.position, sample.polygons))
    curvature = estimate_curvature(surface)
    chance = np.random.default_rng(2)
    astray = chance.choice(len(curvature.normal), len(curvature.normal) // 50, replace=False)
    normal = curvature.normal.copy()
    normal[astray] = -0.7 * normal[astray] + [[0.6, 0.4, 0.0]]
    normal[astray] /= np.linalg.norm(normal[astray], axis=1)[:, None]
    lines = build_line_field(surface, replace(curvature, normal=normal))
    traced = simplified(trace_evenly(lines, 0.1), 0.002 * 0.1)
    assert not (traced.ends == LineEnd.FOLD).any()
    move = np.diff(traced.points, axis=0)
    move /= np.linalg.norm(move, axis=1)[:, None]
    inside = np.diff(traced.point_line, n=2) == 0
    inside &= np.diff(traced.point_line)[1:] == 0
    cosine = np.einsum("ij,ij->i", move[1:], move[:-1])[inside]
    assert cosine.min() > np.cos(np.radians(20.0))


def test_a_hole_is_found_wherever_it_is_in_large_triangles() -> None:
    """Triangles two spacings wide: the middle of none is in a hole around one of their corners."""
    sample = sample_patch(PATCHES["hyperbolic paraboloid"], "regular", (4, 4))
    lines = field_on(sample)
    spacing = 0.25
    mesh = lines.field.mesh
    grid = np.linspace(0.0, 1.0, 21)
    one, two = (axis.ravel() for axis in np.meshgrid(grid, grid))
    inside = one + two <= 1.0 + 1e-9
    weight = np.stack([one, two, 1.0 - one - two], axis=1)[inside]
    count = len(mesh.triangles)
    triangle = np.repeat(np.arange(count), len(weight))
    weight = np.tile(weight, (count, 1))
    place = mesh.points(triangle, weight)
    far = np.linalg.norm(place, axis=1) > 1.4 * spacing
    zero = np.zeros(int(far.sum()))
    trail = Trail(
        zero.astype(np.int64), zero, triangle[far], weight[far], np.zeros((len(zero), 3)),
        np.full(len(zero), int(Family.FIRST)),
    )  # fmt: skip
    seeds = hole_seeds(lines, take_samples(lines.field, trail), (Family.FIRST,), spacing)
    found = mesh.points(seeds.triangle, seeds.barycentric)
    assert len(found)
    assert np.linalg.norm(found, axis=1).max() < 0.45 * spacing
    middle = mesh.points(np.arange(count), np.full((count, 3), 1.0 / 3.0))
    assert np.linalg.norm(middle, axis=1).min() > 0.45 * spacing


def test_lines_go_on_beyond_seams() -> None:
    """On z = sin(2x) / 3 lines across the waves change their family where these turn over."""
    waves = Patch(lambda u, v: (u, v, sin(2.0 * u) / 3.0), (-2.2, 2.2), (-1.0, 1.0))
    traced = trace_evenly(field_on(sample_patch(waves, "regular", (60, 24))), 0.25)
    ends = traced.points[np.stack([traced.start[:-1], traced.start[1:] - 1], axis=1)]
    at_seam = traced.ends == LineEnd.AREA
    place, family = ends[at_seam], np.repeat(traced.family[:, None], 2, axis=1)[at_seam]
    # As many lines as fit side by side, at each side of three seams.
    assert len(place) == 2 * 3 * round(2.0 / 0.25)
    for number in range(len(place)):
        beyond = place[family != family[number]] - place[number]
        nearest = np.argmin(np.linalg.norm(beyond, axis=1))
        assert abs(beyond[nearest, 0]) < 0.25
        assert abs(beyond[nearest, 1]) < 1e-3


def test_whoever_hears_of_the_progress_can_stop_the_work() -> None:
    class StopError(Exception):
        pass

    heard: list[float] = []

    def stop(share: float) -> None:
        heard.append(share)
        if len(heard) == 3:
            raise StopError

    lines = field_on(sample_patch(PATCHES["waves"], "irregular", (30, 30)))
    with pytest.raises(StopError):
        trace_evenly(lines, 0.1, on_progress=stop)
    assert len(heard) == 3
    assert heard == sorted(set(heard))


def test_same_input_gives_the_same_lines() -> None:
    lines = field_on(sample_patch(PATCHES["waves"], "irregular", (30, 30)))
    a, b = trace_evenly(lines, 0.3), trace_evenly(lines, 0.3)
    assert (a.points == b.points).all()
    assert (a.ends == b.ends).all()


@pytest.mark.parametrize("spacing", [0.0, -1.0, np.nan, np.inf])
def test_spacing_must_be_a_length(spacing: float) -> None:
    lines = field_on(sample_patch(PATCHES["waves"], "regular", (8, 8)))
    with pytest.raises(InvalidSettingError, match="spacing must be greater than zero"):
        trace_evenly(lines, spacing)
