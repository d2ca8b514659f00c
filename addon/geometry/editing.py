# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Changes to regions by hand: their faces get a class and stay with it."""

from __future__ import annotations

import numpy as np

from .types import Flags, Indices


def assign_class(locked: Indices, faces: Flags, surface_class: int) -> Indices:
    """Return locked classes with a class set for some faces.

    Parameters
    ----------
    locked : (m,) int64
        Classes given by hand, -1 where the segmentation is free.
    faces : (m,) bool
    surface_class : int
        A `SurfaceClass`; UNDEFINED frees the faces again.

    Returns
    -------
    (m,) int64
        To be given to `segment`.
    """
    return np.where(faces, surface_class, locked).astype(np.int64)


def merge_regions(
    given: tuple[Indices, Indices],
    face_region: Indices,
    face_class: Indices,
    regions: Indices,
    surface_class: int,
) -> tuple[Indices, Indices]:
    """Return locked classes and cuts with which several regions become one, where they touch.

    Parameters
    ----------
    given : pair of (m,) int64
        Locked classes and cuts, as in `assign_class` and `split_region`.
    face_region, face_class : (m,) int64
        Region and class of every polygon, -1 without.
    regions : (r,) int64
        What is merged.
    surface_class : int
        The class of the whole.

    Returns
    -------
    locked, cuts : (m,) int64
        To be given to `segment`. What was cut off of the merged regions before is healed. Where a
        class changes, the whole is a part of its own: nothing else of the new class joins it.
    """
    locked, cuts = given
    chosen = np.isin(face_region, regions)
    part = int(cuts[chosen].min(initial=np.iinfo(np.int64).max)) if chosen.any() else 0
    if (face_class[chosen] != surface_class).any():
        part = int(cuts.max(initial=0)) + 1
    return assign_class(locked, chosen, surface_class), np.where(chosen, part, cuts)


def split_region(cuts: Indices, face_region: Indices, region: int, selected: Flags) -> Indices:
    """Return cuts that part the selected faces of a region from the rest of it.

    Parameters
    ----------
    cuts : (m,) int64
        Parts that regions never reach across, 0 where nobody has cut.
    face_region : (m,) int64
    region : int
    selected : (m,) bool
        Faces of other regions do not count.

    Returns
    -------
    (m,) int64
        To be given to `segment`.
    """
    parted = (face_region == region) & selected
    return np.where(parted, int(cuts.max(initial=0)) + 1, cuts)
