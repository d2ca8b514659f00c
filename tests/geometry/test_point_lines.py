# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines under the mouse are those that are traced otherwise, only sooner."""

from __future__ import annotations

import time
from collections.abc import Iterator

import numpy as np
import pytest
from architectural_curvature.addon.geometry.lines.field import ASYMPTOTIC, PRINCIPAL, Family
from architectural_curvature.addon.geometry.lines.lines import CurvatureLines, LineEnd
from architectural_curvature.addon.geometry.lines.point_lines import PointTracer
from architectural_curvature.addon.geometry.lines.tracer import LineField, trace_from
from architectural_curvature.addon.geometry.mesh import mesh_from_polygons
from line_fields import field_of, field_on
from solids import capped_cylinder
from surfaces.catalogue import PATCHES
from surfaces.sampling import sample_patch

SHAPES = ("torus", "waves", "monkey saddle", "hyperbolic paraboloid")


def _seeds(lines: LineField, count: int) -> list[tuple[int, np.ndarray]]:
    random = np.random.default_rng(3)
    triangle = random.integers(0, len(lines.field.mesh.triangles), count).tolist()
    return list(zip(triangle, random.dirichlet((1.0, 1.0, 1.0), count), strict=True))


def _both(
    lines: LineField, families: tuple[Family, ...], count: int
) -> Iterator[tuple[CurvatureLines, CurvatureLines]]:
    """Yield the lines through some places, as under the mouse and as traced otherwise."""
    tracer = PointTracer(lines, families)
    for triangle, place in _seeds(lines, count):
        pointed = tracer.start(triangle, place)
        assert pointed.advance(np.inf)
        yield pointed.lines(), trace_from(lines, np.array([triangle]), place[None], families)


@pytest.mark.parametrize("name", SHAPES)
@pytest.mark.parametrize("families", [PRINCIPAL, ASYMPTOTIC, PRINCIPAL[1:]])
def test_lines_are_those_of_all_others(name: str, families: tuple[Family, ...]) -> None:
    lines = field_on(sample_patch(PATCHES[name], "irregular", (40, 40)), 0.01)
    found = 0
    for one, other in _both(lines, families, 12):
        np.testing.assert_array_equal(one.family, other.family)
        np.testing.assert_array_equal(one.ends, other.ends)
        np.testing.assert_array_equal(one.start, other.start)
        # Both round in another order, and a line passes its error on.
        np.testing.assert_allclose(one.points, other.points, atol=1e-9)
        found += one.count
    assert found


def test_lines_end_at_creases_and_areas() -> None:
    lines = field_of(mesh_from_polygons(*capped_cylinder(1.0, 2.0, 32, 8)))
    ends = set()
    for one, other in _both(lines, PRINCIPAL, 40):
        # On a regular mesh lines run through vertices, where rounding decides on the way; where a
        # line closes it leaves out up to a tenth of an edge.
        np.testing.assert_array_equal(one.ends, other.ends)
        edge = lines.field.mesh.edge_length
        np.testing.assert_allclose(one.length, other.length, atol=0.1 * edge)
        ends.update(one.ends.ravel().tolist())
    assert ends == {LineEnd.CLOSED, LineEnd.CREASE}
    flat = np.flatnonzero(lines.umbilics.triangle_area >= 0)
    pointed = PointTracer(lines, PRINCIPAL).start(int(flat[0]), np.full(3, 1.0 / 3.0))
    assert pointed.advance(0.0)
    assert pointed.lines().count == 0


def test_lines_grow_piece_by_piece() -> None:
    lines = field_on(sample_patch(PATCHES["torus"], "irregular", (200, 80)))
    (triangle, place), *_ = _seeds(lines, 1)
    pointed = PointTracer(lines, PRINCIPAL).start(triangle, place)
    lengths = []
    while not pointed.advance(0.0):
        lengths.append(pointed.lines().length.sum())
    assert len(lengths) > 3
    assert lengths == sorted(lengths)
    whole = trace_from(lines, np.array([triangle]), place[None]).length.sum()
    assert lengths[0] < 0.5 * whole
    assert pointed.lines().length.sum() == pytest.approx(whole)


def test_a_moment_is_enough_for_one_place() -> None:
    lines = field_on(sample_patch(PATCHES["waves"], "irregular", (150, 150)))
    tracer = PointTracer(lines, PRINCIPAL)
    spent = np.zeros(2)
    for triangle, place in _seeds(lines, 6):
        start = time.process_time()
        pointed = tracer.start(triangle, place)
        pointed.advance(np.inf)
        pointed.lines()
        middle = time.process_time()
        trace_from(lines, np.array([triangle]), place[None])
        spent += middle - start, time.process_time() - middle
    # It is four times as fast; half of that is left to the machine.
    assert spent[0] < 0.5 * spent[1]
