# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Drawings as SVG files: the plan, seen from above, at a scale that paper can be printed at."""

from __future__ import annotations

from html import escape

import numpy as np

from ..geometry.types import Floats
from .drawing import Drawing, Layer, Polyline

_MARGIN = 0.03
#: Lines thinner than this share of the drawing would not be seen.
_THINNEST = 0.0008


def svg_text(drawing: Drawing) -> str:
    """Return the plan of a drawing as SVG: one path per line, in a group per family.

    One unit is a meter, and the drawing's size in millimeters is that of the model, so that
    programs which measure paper show true lengths. The y axis of the model points up.
    """
    low, high = drawing.bounds
    size = np.maximum(high - low, 1e-9)[:2]
    margin = _MARGIN * float(size.max())
    # SVG counts y downwards.
    left, top = low[0] - margin, -(high[1] + margin)
    width, height = (size + 2.0 * margin).tolist()
    step = max(float(size.max()) * 1e-6, 1e-9)
    digits = max(0, int(np.ceil(-np.log10(step))))
    groups = "\n".join(
        _group(layer, _THINNEST * max(width, height), digits) for layer in drawing.layers
    )
    return (
        '<?xml version="1.0" encoding="UTF-8"?>\n'
        '<svg xmlns="http://www.w3.org/2000/svg" '
        'xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" '
        f'width="{1000.0 * width:.6g}mm" height="{1000.0 * height:.6g}mm" '
        f'viewBox="{left:.9g} {top:.9g} {width:.9g} {height:.9g}">\n'
        f"<title>{escape(drawing.title)}</title>\n"
        f"<desc>Plan in meters, 1:1</desc>\n{groups}\n</svg>\n"
    )


def _group(layer: Layer, thinnest: float, digits: int) -> str:
    color = "#" + "".join(f"{round(255 * part):02x}" for part in layer.color)
    thickness = max(layer.thickness, thinnest)
    paths = "\n".join(_path(line, digits) for line in layer.lines)
    name = escape(layer.name)
    return (
        f'<g id="{escape(layer.name.lower().replace(" ", "-"))}" inkscape:groupmode="layer" '
        f'inkscape:label="{name}" fill="none" stroke="{color}" stroke-width="{thickness:.6g}" '
        f'stroke-linejoin="round" stroke-linecap="round">\n{paths}\n</g>'
    )


def _path(line: Polyline, digits: int) -> str:
    plan: Floats = line.points[:, :2] * (1.0, -1.0)
    points = " ".join(f"{x:.{digits}f},{y:.{digits}f}" for x, y in plan.tolist())
    return f'<path d="M{points}{"Z" if line.is_closed else ""}"/>'
