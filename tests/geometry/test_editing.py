# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What is changed by hand stays through later runs."""

from __future__ import annotations

import numpy as np
from architectural_curvature.addon.geometry.classification import SurfaceClass
from architectural_curvature.addon.geometry.curvature import estimate_curvature
from architectural_curvature.addon.geometry.editing import (
    assign_class,
    merge_regions,
    split_region,
)
from architectural_curvature.addon.geometry.mesh import mesh_from_polygons
from architectural_curvature.addon.geometry.segmentation import segment
from architectural_curvature.addon.geometry.surface import build_surface
from architectural_curvature.addon.geometry.tolerance import Tolerance
from solids import grid

TOLERANCE = Tolerance(0.5, 0.005)
#: A plate of 8 × 4 squares that bends up into a quarter of a cylinder: 4 columns flat, 4 bent.
BENT = grid(
    lambda u, v: (
        (8 * u, 4 * v, 0.0)
        if u <= 0.5
        else (4 + 3 * np.sin((8 * u - 4) / 3), 4 * v, 3 - 3 * np.cos((8 * u - 4) / 3))
    ),
    (32, 16),
)
SURFACE = build_surface(mesh_from_polygons(*BENT))
CURVATURE = estimate_curvature(SURFACE)
PLAIN = segment(SURFACE, CURVATURE, TOLERANCE)
FREE = np.full(32 * 16, -1)
WHOLE = np.zeros(32 * 16, dtype=np.int64)
COLUMN = np.arange(32 * 16) // 16


def test_without_hands_there_are_two_regions() -> None:
    assert sorted(PLAIN.regions.region_class) == [SurfaceClass.FLAT, SurfaceClass.SINGLE]
    assert (PLAIN.face_class[COLUMN < 16] == SurfaceClass.FLAT).all()


def test_assigned_faces_keep_their_class_and_others_theirs() -> None:
    chosen = (COLUMN >= 3) & (COLUMN < 5)
    locked = assign_class(FREE, chosen, SurfaceClass.ELLIPTIC)
    result = segment(SURFACE, CURVATURE, TOLERANCE, min_area=3.0, locked=locked)
    assert (result.face_class[chosen] == SurfaceClass.ELLIPTIC).all()
    assert (result.face_class[~chosen] == PLAIN.face_class[~chosen]).all()
    freed = assign_class(locked, chosen, SurfaceClass.UNDEFINED)
    assert (freed == FREE).all()


def test_merged_regions_are_one() -> None:
    locked, cuts = merge_regions(
        (FREE, WHOLE),
        PLAIN.regions.face_region,
        PLAIN.face_class,
        np.array([0, 1]),
        SurfaceClass.SINGLE,
    )
    result = segment(SURFACE, CURVATURE, TOLERANCE, locked=locked, cuts=cuts)
    assert result.regions.region_class.tolist() == [SurfaceClass.SINGLE]


def test_a_region_is_split_along_the_selection_and_can_be_merged_again() -> None:
    flat = int(PLAIN.regions.face_region[0])
    cuts = split_region(WHOLE, PLAIN.regions.face_region, flat, COLUMN % 32 < 6)
    parted = segment(SURFACE, CURVATURE, TOLERANCE, cuts=cuts)
    assert parted.regions.count == 3
    assert (parted.face_class == PLAIN.face_class).all()
    region = parted.regions.face_region
    assert len(np.unique(region[COLUMN < 6])) == len(np.unique(region[COLUMN < 16])) - 1 == 1
    locked, healed = merge_regions(
        (FREE, cuts),
        region,
        parted.face_class,
        np.unique(region[COLUMN < 16]),
        SurfaceClass.FLAT,
    )
    again = segment(SURFACE, CURVATURE, TOLERANCE, locked=locked, cuts=healed)
    assert (again.regions.face_region == PLAIN.regions.face_region).all()


def test_what_is_merged_does_not_join_neighbors_of_its_class() -> None:
    """A trough: a quarter of a cylinder, a floor, another quarter."""

    def trough(u: float, v: float) -> tuple[float, float, float]:
        over = 12 * abs(u - 0.5) - 2.0
        x = min(12 * abs(u - 0.5), 2.0) + (3 * np.sin(over / 3) if over > 0 else 0.0)
        z = 3 - 3 * np.cos(over / 3) if over > 0 else 0.0
        return float(np.copysign(x, u - 0.5)), 4 * v, z

    surface = build_surface(mesh_from_polygons(*grid(trough, (48, 16))))
    curvature = estimate_curvature(surface)
    plain = segment(surface, curvature, TOLERANCE)
    found = plain.regions
    assert sorted(found.region_class) == [
        SurfaceClass.FLAT,
        SurfaceClass.SINGLE,
        SurfaceClass.SINGLE,
    ]
    floor = int(np.flatnonzero(found.region_class == SurfaceClass.FLAT)[0])
    side = int(found.face_region[0])
    free, whole = np.full(48 * 16, -1), np.zeros(48 * 16, dtype=np.int64)
    locked, cuts = merge_regions(
        (free, whole),
        found.face_region,
        plain.face_class,
        np.array([floor, side]),
        SurfaceClass.SINGLE,
    )
    merged = segment(surface, curvature, TOLERANCE, locked=locked, cuts=cuts).regions
    assert merged.region_class.tolist() == [SurfaceClass.SINGLE, SurfaceClass.SINGLE]
    assert len(np.unique(merged.face_region[found.face_region == 3 - floor - side])) == 1
