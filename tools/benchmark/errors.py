# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""How far estimates are from exact curvature, and their means over surfaces."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .engine import geometry
from .meshes import Case
from .peers import Result

Array = NDArray[np.float64]

#: Measures and the words for them. Errors are RMS over vertices, over the surface's RMS curvature
#: (of K: its square); directions are in degrees, weighted by k1 - k2.
MEASURES = {
    "H": "H inside",
    "K": "K inside",
    "k1": "k1 inside",
    "k2": "k2 inside",
    "H rim": "H on the rim",
    "directions": "directions inside, degrees",
    "classes": "classes right, inside, %",
    "classes developable": "classes right, developable surfaces, %",
}


def errors(case: Case, result: Result) -> dict[str, float]:
    """Return the measures of one estimate; what cannot be measured is missing."""
    exact = {
        "H": 0.5 * (case.k1 + case.k2),
        "K": case.k1 * case.k2,
        "k1": case.k1,
        "k2": case.k2,
    }
    inner = ~case.is_rim
    found: dict[str, float] = {}
    if case.name != "plane":
        for name, values in exact.items():
            scale = case.reference ** (2 if name == "K" else 1)
            found[name] = _rms((result[name] - values)[inner] / scale)
        if case.is_rim.any():
            found["H rim"] = _rms((result["H"] - exact["H"])[case.is_rim] / case.reference)
    gap = np.where(inner, case.k1 - case.k2, 0.0)
    if "direction_1" in result and gap.max() > 0.01 * case.reference:
        found["directions"] = _directions(case, result["direction_1"], gap)
    share = 100.0 * float(np.mean((_classes(case, result) == _classes(case, exact))[inner]))
    found["classes"] = share
    if case.is_developable:
        found["classes developable"] = share
    return found


def averages(rows: list[dict[str, float]]) -> dict[str, float]:
    """Return the means over surfaces: geometric for errors, plain for shares."""
    found: dict[str, float] = {}
    for name in MEASURES:
        values = np.array([row[name] for row in rows if name in row])
        if len(values) and "classes" in name:
            found[name] = float(values.mean())
        elif len(values):
            found[name] = float(np.exp(np.mean(np.log(np.maximum(values, 1e-14)))))
    return found


def _rms(values: Array) -> float:
    return float(np.sqrt(np.mean(values**2)))


def _directions(case: Case, direction: Array, weight: Array) -> float:
    cosine = np.abs(np.einsum("ij,ij->i", direction, case.direction_1))
    sine = np.linalg.norm(np.cross(direction, case.direction_1), axis=1)
    # no direction at all is as wrong as can be
    angle = np.where(cosine + sine > 0.0, np.degrees(np.arctan2(sine, cosine)), 90.0)
    return float(np.sqrt(np.sum(weight * angle**2) / np.sum(weight)))


def _classes(case: Case, curvature: Result | dict[str, Array]) -> NDArray[np.int64]:
    """Return classes for panels of a tenth of the extent and a deviation of a thousandth."""
    extent = float(np.linalg.norm(np.ptp(case.positions, axis=0)))
    everywhere = np.ones(len(case.k1), dtype=np.bool_)
    return geometry("classification").classify(
        curvature["k1"], curvature["k2"], 8.0 * (0.001 * extent) / (0.1 * extent) ** 2, everywhere
    )
