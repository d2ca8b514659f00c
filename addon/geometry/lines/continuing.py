# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Where lines go on beyond a seam: there the family has changed, but not the course.

Where the profile of a vault turns from convex to concave its lines of one family end, and lines of
the other one begin. Those that begin where the first end make one curve of two, as the designer
drew it.
"""

from __future__ import annotations

import numpy as np

from ..types import Flags, Floats, Indices
from .assembly import shifted
from .field import Family
from .lines import CurvatureLines, LineEnd
from .seeding import course
from .seeds import Seeds, make_seeds
from .tracer import LineField
from .vectors import dot

#: Widest seam, over the side of a triangle, and the number of places at which its far side is
#: looked for.
_WIDEST, _LOOKS = 3.0, 6
#: Least cosine between a line and what goes on from it.
_STRAIGHT = 0.9


def continuing_seeds(
    lines: LineField, placed: CurvatureLines, families: tuple[Family, ...]
) -> Seeds:
    """Return seeds beyond the seams that lines end at.

    Parameters
    ----------
    lines : LineField
    placed : CurvatureLines
        Lines of which some end at areas.
    families : tuple of Family
        Those to go on with.

    Returns
    -------
    Seeds
    """
    line, which = np.nonzero(placed.ends == LineEnd.AREA)
    row = np.where(which == 0, placed.start[line], placed.start[line + 1] - 1)
    place = placed.triangle[row], placed.barycentric[row]
    heading = lines.field.evaluate(*place, placed.family[line])[0]
    # Which way that is, the course of the line shows, though its last step may be a short one.
    outward = np.where(which == 0, -1.0, 1.0) * dot(course(placed)[1][row], heading)
    heading = np.where(outward > 0.0, 1.0, -1.0)[:, None] * heading
    triangle, barycentric, is_there = _beyond(lines, *place, heading)
    end = np.tile(np.flatnonzero(is_there), len(families))
    family = np.repeat(np.array(families, dtype=np.int64), is_there.sum())
    tangent = lines.field.evaluate(triangle[end], barycentric[end], family)[0]
    goes_on = np.abs(dot(tangent, heading[end])) > _STRAIGHT
    end = end[goes_on]
    return make_seeds(triangle[end], barycentric[end], family[goes_on])


def _beyond(
    lines: LineField, triangle: Indices, barycentric: Floats, heading: Floats
) -> tuple[Indices, Floats, Flags]:
    """Return the first places straight ahead that lie beyond an area, and where there are some."""
    found, place = triangle.copy(), barycentric.copy()
    in_area = lines.umbilics.triangle_area >= 0
    is_open = np.ones(len(triangle), dtype=np.bool_)
    step = _WIDEST / _LOOKS * lines.field.mesh.edge_length
    for look in range(1, _LOOKS + 1):
        here = np.flatnonzero(is_open)
        way = np.full(len(here), look * step)
        ahead, there = shifted(lines.field, triangle[here], barycentric[here], heading[here], way)
        is_out = ~in_area[ahead]
        found[here[is_out]], place[here[is_out]] = ahead[is_out], there[is_out]
        is_open[here[is_out]] = False
    return found, place, ~is_open
