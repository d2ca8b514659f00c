# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Names of what the extension stores on a mesh; docs/quantities.md describes each."""

from __future__ import annotations

GAUSSIAN = "curvature_gaussian"
MEAN = "curvature_mean"
K1 = "curvature_k1"
K2 = "curvature_k2"
DIRECTION_1 = "curvature_direction_1"
DIRECTION_2 = "curvature_direction_2"
POINT_TYPE = "curvature_point_type"
FACE_CLASS = "curvature_class"
REGION = "curvature_region"
LOCKED = "curvature_locked"
CUT = "curvature_cut"
#: Regions of classes that a change of the model has made stale: their names are still needed.
FORMER_REGION = ".curvature_former_region"

UMBILIC_INDEX = "umbilic_index"
UMBILIC_KIND = "umbilic_kind"

COLORS = {
    "GAUSSIAN": "Gaussian Curvature",
    "MEAN": "Mean Curvature",
    "K1": "Principal Curvature 1",
    "K2": "Principal Curvature 2",
    "CLASS": "Curvature Class",
    "REGION": "Curvature Region",
}
"""Color attribute of every quantity that can be shown."""

CURVATURE_ATTRIBUTES = (GAUSSIAN, MEAN, K1, K2, DIRECTION_1, DIRECTION_2, POINT_TYPE)
CLASS_ATTRIBUTES = (FACE_CLASS, REGION, COLORS["CLASS"], COLORS["REGION"])
EDIT_ATTRIBUTES = (LOCKED, CUT, FORMER_REGION)
ATTRIBUTES = (
    *CURVATURE_ATTRIBUTES,
    FACE_CLASS,
    REGION,
    *EDIT_ATTRIBUTES,
    *COLORS.values(),
)
