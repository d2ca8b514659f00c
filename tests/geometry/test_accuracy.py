# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""How far curvatures are from exact ones: the one file that knows what the estimator can do.

The error budget of a fit that looks two rings of faces far, so to a distance r, has two terms:

* What it returns is a mean of the curvature within r, so it may differ from the curvature in the
  middle by as much as that varies within r: first order in r. On a mesh that is symmetric around
  every vertex this term cancels to second order.
* A parabola through points of a circle of curvature k at the distance r from its apex has the
  curvature 2 (1 - sqrt(1 - k² r²)) / (k r²), which exceeds k by about k³ r² / 4: second order.
"""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from architectural_curvature.addon.geometry.classification import SurfaceClass
from architectural_curvature.addon.geometry.curvature import Curvature, estimate_curvature
from architectural_curvature.addon.geometry.mesh import mesh_from_polygons
from architectural_curvature.addon.geometry.segmentation import segment
from architectural_curvature.addon.geometry.surface import Surface, build_surface
from architectural_curvature.addon.geometry.tolerance import Tolerance
from numpy.typing import NDArray
from scipy.sparse import coo_array
from surfaces.catalogue import PATCHES, TORUS_RING, TORUS_TUBE
from surfaces.sampling import KINDS, Sample, sample_patch
from surfaces.spheres import SPHERE_KINDS, sample_ellipsoid

#: Faces between a vertex and the rim for it to count as inner: the estimator's two rings.
RINGS = 2

CURVED = [name for name in PATCHES if name != "plane"]
SPHERE, ELLIPSOID = (1.0, 1.0, 1.0), (1.0, 0.8, 0.6)


@cache
def _patch(name: str, kind: str, count: int) -> tuple[Sample, Surface, Curvature]:
    patch = PATCHES[name]
    around = 2 * count if patch.is_closed[0] else count
    return _measured(sample_patch(patch, kind, (around, count)))


def _measured(sample: Sample) -> tuple[Sample, Surface, Curvature]:
    # No crease on purpose: coarse and strongly curved meshes fold by more than 30°.
    mesh = mesh_from_polygons(sample.shape.position, sample.polygons)
    surface = build_surface(mesh, np.pi)
    return sample, surface, estimate_curvature(surface)


def _error(sample: Sample, curvature: Curvature) -> NDArray[np.float64]:
    return np.maximum(
        np.abs(curvature.k1 - sample.shape.k1), np.abs(curvature.k2 - sample.shape.k2)
    )


def _budget(sample: Sample) -> NDArray[np.float64]:
    """Return the largest error at every vertex that the two terms allow."""
    shape, count = sample.shape, len(sample.shape.k1)
    here, there = _neighbors(sample.polygons, count)
    turn = np.einsum("ij,ij->i", shape.direction_1[there], shape.direction_2[here])
    change = np.abs(shape.k1[there] - shape.k1[here]) + np.abs(shape.k2[there] - shape.k2[here])
    # Where the directions turn by an angle a, the twist changes by (k1 - k2) sin a.
    change += (shape.k1 - shape.k2)[there] * np.abs(turn)
    way = np.linalg.norm(shape.position[there] - shape.position[here], axis=1)
    variation, reach, size = np.zeros((3, count))
    np.maximum.at(variation, here, change)
    np.maximum.at(reach, here, way)
    np.maximum.at(size, here, np.maximum(np.abs(shape.k1), np.abs(shape.k2))[there])
    square = np.clip(size * reach, 1e-6, 1.0) ** 2
    return variation + size * (2.0 * (1.0 - np.sqrt(1.0 - square)) / square - 1.0)


def _neighbors(polygons: NDArray[np.int64], count: int) -> NDArray[np.int64]:
    """Return pairs of vertices with at most one vertex between them."""
    sides = polygons.shape[1]
    a, b = np.repeat(polygons, sides, axis=1).ravel(), np.tile(polygons, (1, sides)).ravel()
    ring = coo_array((np.ones(len(a)), (a, b)), (count, count)).tocsr()
    return np.stack((ring @ ring).nonzero()).astype(np.int64)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("name", CURVED)
def test_inner_errors_stay_within_the_budget(name: str, kind: str) -> None:
    sample, _, curvature = _patch(name, kind, 16)
    is_inner = sample.depth(RINGS) >= RINGS
    assert (_error(sample, curvature) <= _budget(sample))[is_inner].all()


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("name", CURVED)
def test_errors_at_rims_stay_within_the_budget(name: str, kind: str) -> None:
    sample, _, curvature = _patch(name, kind, 16)
    assert (_error(sample, curvature) <= _budget(sample)).all()


@pytest.mark.parametrize("axes", [SPHERE, ELLIPSOID])
@pytest.mark.parametrize("kind", SPHERE_KINDS)
def test_errors_on_closed_surfaces_stay_within_the_budget(
    axes: tuple[float, float, float], kind: str
) -> None:
    sample, _, curvature = _measured(sample_ellipsoid(axes, kind, 12))
    assert (_error(sample, curvature) <= _budget(sample)).all()


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("name", CURVED)
def test_errors_fall_as_fast_as_the_budget_when_cells_halve(name: str, kind: str) -> None:
    rms = []
    for count, depth in ((16, 3), (32, 6)):
        sample, _, curvature = _patch(name, kind, count)
        is_inner = sample.depth(depth) >= depth
        rms.append(np.sqrt(np.mean(_error(sample, curvature)[is_inner] ** 2)))
    # The measured order must round to that of the budget: second order, or first where rings are
    # not symmetric. The rulings of the tangent developable meet its grid aslant.
    order = 1 if kind == "irregular" or name == "tangent developable" else 2
    assert np.log2(rms[0] / rms[1]) > order - 0.5


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("name", CURVED)
def test_inner_directions_follow_from_the_budget(name: str, kind: str) -> None:
    # An error e of the second form turns directions by an angle a with sin 2a <= 2 e / (k1 - k2).
    sample, _, curvature = _patch(name, kind, 16)
    shape = sample.shape
    gap = shape.k1 - shape.k2
    is_told = (sample.depth(RINGS) >= RINGS) & (gap > 4.0 * _budget(sample))
    cosine = np.abs(np.einsum("ij,ij->i", curvature.direction_1, shape.direction_1))
    angle = np.arccos(np.clip(cosine, 0.0, 1.0))
    most = 0.5 * np.arcsin(np.clip(2.0 * _budget(sample) / np.maximum(gap, 1e-12), 0.0, 1.0))
    # The normal may be off by the turn of the normal within half a cell.
    tilt = 0.5 * sample.longest_edge * np.maximum(np.abs(shape.k1), np.abs(shape.k2))
    assert (angle <= most + tilt)[is_told].all()


@pytest.mark.parametrize("kind", KINDS)
def test_a_plane_is_flat_exactly(kind: str) -> None:
    _, _, curvature = _patch("plane", kind, 16)
    assert curvature.is_defined.all()
    for values in (curvature.k1, curvature.k2, curvature.direction_1, curvature.direction_2):
        assert not values.any()


@pytest.mark.parametrize(
    ("sample", "euler"),
    [
        (sample_ellipsoid(SPHERE, "geodesic", 8), 2),
        (sample_ellipsoid(ELLIPSOID, "irregular", 12), 2),
        (sample_ellipsoid(ELLIPSOID, "quads", 12), 2),
        (sample_patch(PATCHES["torus"], "regular", (64, 32)), 0),
        (sample_patch(PATCHES["torus"], "irregular", (64, 32)), 0),
    ],
)
def test_gaussian_curvature_adds_up_to_the_topology(sample: Sample, euler: int) -> None:
    sample, surface, curvature = _measured(sample)
    total = (curvature.gaussian * surface.sector_area).sum()
    # An error e of k1 and k2 changes K by up to (|k1| + |k2|) e + e². Faces are smaller than the
    # surface over them by up to the share (k h)² / 8 of a circle's chord, in either direction.
    shape, e = sample.shape, _budget(sample)
    size = np.maximum(np.abs(shape.k1), np.abs(shape.k2))
    share = (size * sample.longest_edge) ** 2 / 4.0
    wrong = (np.abs(shape.k1) + np.abs(shape.k2)) * e + e**2 + np.abs(shape.k1 * shape.k2) * share
    assert abs(total - 2.0 * np.pi * euler) <= (wrong * surface.sector_area).sum()


@pytest.mark.parametrize("kind", ["geodesic", "uv", "irregular", "quads"])
def test_the_total_gaussian_curvature_of_a_closed_surface_is_right_to_a_percent(kind: str) -> None:
    # Faces are smaller than the surface over them by about (k h)² / 8: less than a percent here.
    _, surface, curvature = _measured(sample_ellipsoid(ELLIPSOID, kind, 24))
    total = (curvature.gaussian * surface.sector_area).sum()
    assert total == pytest.approx(4.0 * np.pi, rel=0.01)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("plane", SurfaceClass.FLAT),
        ("barrel vault", SurfaceClass.SINGLE),
        ("cylinder", SurfaceClass.SINGLE),
        ("sphere zone", SurfaceClass.ELLIPTIC),
        ("elliptic paraboloid", SurfaceClass.ELLIPTIC),
        ("hyperbolic paraboloid", SurfaceClass.HYPERBOLIC),
        ("catenoid", SurfaceClass.HYPERBOLIC),
    ],
)
def test_whole_surfaces_get_one_class_up_to_their_rims(
    name: str, kind: str, expected: SurfaceClass
) -> None:
    # Principal curvatures are 0, or at least 0.17 where these surfaces are curved; the limit is
    # 0.05.
    _, surface, curvature = _patch(name, kind, 32)
    classes = segment(surface, curvature, Tolerance(1.0, 0.05 / 8.0)).face_class
    assert (classes == expected).all()


def test_the_shares_of_a_torus_follow_its_formula() -> None:
    sample, surface, curvature = _measured(sample_patch(PATCHES["torus"], "quads", (96, 48)))
    limit = 0.25
    measured = segment(surface, curvature, Tolerance(1.0, limit / 8.0)).classes
    # k2 = cos v / (R + r cos v) reaches +-limit at cos v = limit R / (1 -+ limit r); the area
    # between is 2 pi r (R v + r sin v) to either side.
    dome, saddle = (
        np.arccos(limit * TORUS_RING / (1.0 + sign * limit * TORUS_TUBE)) for sign in (-1, 1)
    )
    ring, tube = TORUS_RING, TORUS_TUBE
    whole = 2.0 * np.pi * ring
    shares = {
        SurfaceClass.ELLIPTIC: 2.0 * (ring * dome + tube * np.sin(dome)) / whole,
        SurfaceClass.HYPERBOLIC: 2.0 * (ring * saddle - tube * np.sin(saddle)) / whole,
    }
    # The slope of k2 over the angle v is at least 0.7 where it crosses the limits, so the budget
    # moves a border by that share of a radian; whole faces move it by up to one of 48 rows. A class
    # has two borders, each v of which is 1 / (2 pi) of the circle, longer by 1 + r / R at most.
    moved = np.median(_budget(sample)) / 0.7 + 2.0 * np.pi / 48.0
    slack = 2.0 * moved / (2.0 * np.pi) * (1.0 + tube / ring)
    for surface_class, share in shares.items():
        assert measured[surface_class].share == pytest.approx(share, abs=slack)
    assert measured[SurfaceClass.FLAT].faces == 0
