# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Drawings as OBJ files with line elements."""

from __future__ import annotations

from .drawing import Drawing


def obj_text(drawing: Drawing) -> str:
    """Return a drawing as OBJ: an object per family, an `l` element per line, z up, in meters."""
    rows = [f"# {drawing.title.encode('ascii', 'replace').decode()}", "# meters, z up"]
    first = 1
    for layer in drawing.layers:
        rows.append(f"o {layer.name.replace(' ', '_')}")
        for line in layer.lines:
            count = len(line.points)
            rows += [f"v {x:.9g} {y:.9g} {z:.9g}" for x, y, z in line.points.tolist()]
            numbers = [str(first + number) for number in range(count)]
            if line.is_closed:
                numbers.append(str(first))
            rows.append(f"l {' '.join(numbers)}")
            first += count
    return "\n".join(rows) + "\n"
