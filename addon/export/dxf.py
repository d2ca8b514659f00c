# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Drawings as DXF files of release 12, which every CAD program reads.

References
----------
.. [1] Autodesk (1992). AutoCAD Release 12 Customization Manual, chapter 11: Drawing interchange
       and file formats.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from .drawing import Drawing, Layer, Polyline

Tag = tuple[int, str | int | float]

#: Colors by number of AutoCAD that are told apart on black and on white, and their sRGB.
_INDEXED = {
    1: (1.0, 0.0, 0.0),
    3: (0.0, 1.0, 0.0),
    4: (0.0, 1.0, 1.0),
    5: (0.0, 0.0, 1.0),
    6: (1.0, 0.0, 1.0),
    7: (0.0, 0.0, 0.0),
    30: (1.0, 0.5, 0.0),
}
_CLOSED, _SPATIAL, _SPATIAL_VERTEX = 1, 8, 32


def dxf_text(drawing: Drawing) -> str:
    """Return a drawing as DXF: a 3D polyline per line, in meters, on the layer of its family."""
    tags = [
        *_header(drawing),
        *_layer_table(drawing),
        (0, "SECTION"),
        (2, "ENTITIES"),
        *(tag for layer in drawing.layers for line in layer.lines for tag in _line(layer, line)),
        (0, "ENDSEC"),
        (0, "EOF"),
    ]
    return "".join(f"{code:>3}\r\n{_value(value)}\r\n" for code, value in tags)


def _header(drawing: Drawing) -> Iterator[Tag]:
    low, high = drawing.bounds
    yield from ((0, "SECTION"), (2, "HEADER"), (9, "$ACADVER"), (1, "AC1009"))
    for name, corner in (("$EXTMIN", low), ("$EXTMAX", high)):
        yield (9, name)
        yield from zip((10, 20, 30), corner.tolist(), strict=True)
    # Meters; release 12 did not know it, later programs do.
    yield from ((9, "$INSUNITS"), (70, 6), (0, "ENDSEC"))


def _layer_table(drawing: Drawing) -> Iterator[Tag]:
    yield from ((0, "SECTION"), (2, "TABLES"))
    yield from ((0, "TABLE"), (2, "LTYPE"), (70, 1), (0, "LTYPE"), (2, "CONTINUOUS"), (70, 0))
    yield from ((3, "Solid line"), (72, 65), (73, 0), (40, 0.0), (0, "ENDTAB"))
    yield from ((0, "TABLE"), (2, "LAYER"), (70, len(drawing.layers)))
    for layer in drawing.layers:
        yield from ((0, "LAYER"), (2, _name(layer)), (70, 0))
        yield from ((62, _color_number(layer.color)), (6, "CONTINUOUS"))
    yield from ((0, "ENDTAB"), (0, "ENDSEC"))


def _line(layer: Layer, line: Polyline) -> Iterator[Tag]:
    name = _name(layer)
    yield from ((0, "POLYLINE"), (8, name), (66, 1), (10, 0.0), (20, 0.0), (30, 0.0))
    yield (70, _SPATIAL | (_CLOSED if line.is_closed else 0))
    for point in line.points.tolist():
        yield from ((0, "VERTEX"), (8, name))
        yield from zip((10, 20, 30), point, strict=True)
        yield (70, _SPATIAL_VERTEX)
    yield from ((0, "SEQEND"), (8, name))


def _name(layer: Layer) -> str:
    """Return a layer's name as release 12 allows it: capitals, digits, $, - and _, at most 31."""
    return re.sub(r"[^A-Z0-9$_-]", "_", layer.name.upper())[:31]


def _color_number(color: tuple[float, float, float]) -> int:
    def distance(number: int) -> float:
        return sum((a - b) ** 2 for a, b in zip(color, _INDEXED[number], strict=True))

    return min(_INDEXED, key=distance)


def _value(value: str | int | float) -> str:
    return f"{value:.9g}" if isinstance(value, float) else str(value)
