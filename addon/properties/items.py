# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What users choose from: identifier, name, tooltip, number."""

from __future__ import annotations

from ..geometry.display.palette import CLASS_NAMES
from ..geometry.settings import CriterionKind, Smoothing

QUANTITY_ITEMS = (
    ("GAUSSIAN", "Gaussian Curvature", "Product of the principal curvatures, in 1/m²", 0),
    ("MEAN", "Mean Curvature", "Average of the principal curvatures, in 1/m", 1),
    ("K1", "Principal Curvature 1", "The larger principal curvature by signed value, in 1/m", 2),
    ("K2", "Principal Curvature 2", "The smaller principal curvature by signed value, in 1/m", 3),
    ("CLASS", "Class", "Flat, single-curved, dome or saddle at the panel's tolerance", 4),
    ("REGION", "Region", "Connected areas of one class, each in a color of its own", 5),
    ("NONE", "None", "The model without curvature colors", 6),
)

CLASS_ITEMS = tuple(
    (surface_class.name, name, f"Faces of the class {name.lower()}", int(surface_class) + 1)
    for surface_class, name in CLASS_NAMES.items()
)

CRITERION_ITEMS = (
    ("PANEL", CriterionKind.PANEL.value, "A panel may deviate from the surface by a distance", 0),
    ("RADIUS", CriterionKind.RADIUS.value, "A material bends no tighter than a radius", 1),
    ("RAW", CriterionKind.RAW.value, "Limits of |K| and |H|, for those who want them", 2),
)

CRITERION_FIELDS = {
    "PANEL": ("panel_size", "deviation"),
    "RADIUS": ("smallest_radius", "panel_size"),
    "RAW": ("gaussian_limit", "mean_limit", "panel_size"),
}
"""Settings that matter to a criterion, in the order in which panels show them."""

OUTLINE_ITEMS = (
    ("BORDERS", "Region Borders", "Where regions meet one another or a crease", 0),
    ("PARABOLIC", "Parabolic Curves", "Where domes turn into saddles: Gaussian curvature is 0", 1),
)

SMOOTHING_ITEMS = (
    ("AUTO", Smoothing.AUTO.value, "Measure the noise, and smooth no more than it asks for", 0),
    ("NONE", Smoothing.NONE.value, "Take every detail of the surface for real", 1),
    ("LENGTH", Smoothing.LENGTH.value, "Take detail below a length for noise", 2),
)

LINE_KIND_ITEMS = (
    ("PRINCIPAL", "Principal", "Lines along the directions of k1 and k2, at right angles", 0),
    ("ASYMPTOTIC", "Asymptotic", "Lines without normal curvature, in saddle-shaped parts", 1),
)

FAMILY_ITEMS = (
    ("BOTH", "Both", "The lines of both families", 0),
    ("FIRST", "First", "Along k1, the larger curvature by signed value, or the left asymptote", 1),
    ("SECOND", "Second", "Along k2, the smaller curvature, or the right asymptote", 2),
)

TONE_ITEMS = (
    ("SHADE", "Shade", "More strokes where less light falls", 0),
    ("CURVATURE", "Curvature", "More strokes where the surface bends more", 1),
)
