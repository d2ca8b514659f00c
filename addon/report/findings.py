# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a report says about curvature lines and umbilics."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..geometry.lines.field import Family
from ..geometry.lines.lines import CurvatureLines, LineEnd
from ..geometry.lines.umbilics import UmbilicKind, Umbilics
from ..geometry.types import Floats

LINES, ASYMPTOTIC_LINES = "curvature_lines", "asymptotic_lines"
UMBILICS, UMBILIC_AREAS = "umbilics", "umbilic_areas"
FINDINGS = (LINES, ASYMPTOTIC_LINES, UMBILICS, UMBILIC_AREAS)
"""Keys of a block that a segmentation neither makes nor outdates."""

FAMILY_KEYS = {
    Family.FIRST: "family_1",
    Family.SECOND: "family_2",
    Family.ASYMPTOTIC_LEFT: "family_1",
    Family.ASYMPTOTIC_RIGHT: "family_2",
}
"""Names of the families in reports."""


def measure_lines(
    lines: CurvatureLines, families: tuple[Family, ...], along: Floats
) -> dict[str, Any]:
    """Return number, length and every line of each family.

    Parameters
    ----------
    lines : CurvatureLines
    families : tuple of Family
        Those that were traced.
    along : (p,) float64
        A curvature at every point.

    Returns
    -------
    dict
        Ready for JSON; lengths in meters.
    """
    length = lines.length
    found = {}
    for family in families:
        chosen = np.flatnonzero(lines.family == family).tolist()
        found[FAMILY_KEYS[family]] = {
            "count": len(chosen),
            "length": float(length[chosen].sum()),
            "lines": [_line(lines, number, float(length[number]), along) for number in chosen],
        }
    return found


def measure_umbilics(umbilics: Umbilics, position: Floats) -> dict[str, Any]:
    """Return the umbilic points and areas.

    Parameters
    ----------
    umbilics : Umbilics
    position : (u, 3) float64
        Of the points in world coordinates, in meters.

    Returns
    -------
    dict
        Ready for JSON.
    """
    rows = zip(position.tolist(), umbilics.index.tolist(), umbilics.kind.tolist(), strict=True)
    areas = zip(umbilics.area_size.tolist(), umbilics.area_index.tolist(), strict=True)
    return {
        UMBILICS: [
            {"position": place, "index": index, "kind": UmbilicKind(kind).name.lower()}
            for place, index, kind in rows
        ],
        UMBILIC_AREAS: [{"area": size, "index": index} for size, index in areas],
    }


def _line(lines: CurvatureLines, number: int, length: float, along: Floats) -> dict[str, Any]:
    values = along[lines.start[number] : lines.start[number + 1]]
    return {
        "length": length,
        "ends": [LineEnd(end).name.lower() for end in lines.ends[number].tolist()],
        "curvature": {
            "min": float(values.min()),
            "max": float(values.max()),
            "mean": float(values.mean()),
        },
    }
