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
        A `SurfaceClass`, or -1 to free the faces again.

    Returns
    -------
    (m,) int64
    """
    return np.where(faces, surface_class, locked).astype(np.int64)


def merge_regions(
    locked: Indices, face_region: Indices, regions: Indices, surface_class: int
) -> Indices:
    """Return locked classes with several regions given one class, so that neighbors join."""
    return assign_class(locked, np.isin(face_region, regions), surface_class)


def split_region(face_part: Indices, face_region: Indices, region: int, selected: Flags) -> Indices:
    """Return parts with the selected faces of one region cut off from it.

    Parameters
    ----------
    face_part : (m,) int64
        Parts that regions never reach across, 0 where nobody has cut.
    face_region : (m,) int64
    region : int
    selected : (m,) bool

    Returns
    -------
    (m,) int64
    """
    cut = (face_region == region) & selected
    return np.where(cut, int(face_part.max(initial=0)) + 1, face_part)
