# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Legends as rectangles and texts, for the viewport and for rendered pictures alike."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from .colormap import ColorMap, srgb_ramp

Color = tuple[float, float, float, float]
Measure = Callable[[str, float], float]
"""Returns the width of a text at a size, both in pixels."""

_TEXT = 12.0
_TITLE = 13.0
_LINE = 19.0
_PADDING = 12.0
_SWATCH = 14.0
_GAP = 8.0
_BAR_HEIGHT = 168.0
_BAR_WIDTH = 18.0
_BAR_STEPS = 64


@dataclass(frozen=True)
class Theme:
    """sRGB colors of a legend's paper, its texts and the frames of its boxes."""

    paper: Color
    ink: Color
    faint_ink: Color
    frame: Color


DARK = Theme(
    (0.09, 0.09, 0.09, 0.72),
    (0.95, 0.95, 0.95, 1.0),
    (0.72, 0.72, 0.72, 1.0),
    (0.0, 0.0, 0.0, 0.45),
)
"""For viewports, whatever is behind."""

LIGHT = Theme(
    (1.0, 1.0, 1.0, 0.85), (0.12, 0.12, 0.12, 1.0), (0.38, 0.38, 0.38, 1.0), (0.0, 0.0, 0.0, 0.6)
)
"""For pictures on light paper."""


@dataclass(frozen=True)
class ColorBar:
    """Legend of a quantity: a color map from -limit to +limit with marks."""

    title: str
    unit: str
    color_map: ColorMap
    limit: float
    notes: tuple[str, ...] = ()


@dataclass(frozen=True)
class ClassKey:
    """Legend of classes: (sRGB color, name, share as text) per row."""

    title: str
    rows: tuple[tuple[tuple[float, float, float], str, str], ...]
    notes: tuple[str, ...] = ()


Legend = ColorBar | ClassKey


@dataclass(frozen=True)
class Rectangle:
    """A box in pixels from the legend's lower left corner, in one sRGB color."""

    left: float
    bottom: float
    width: float
    height: float
    color: Color


@dataclass(frozen=True)
class Text:
    """A line of text; (left, bottom) is where its baseline starts."""

    left: float
    bottom: float
    size: float
    string: str
    color: Color


@dataclass(frozen=True)
class Layout:
    """A legend laid out: what to draw, in drawing order, and its size in pixels."""

    width: float
    height: float
    rectangles: tuple[Rectangle, ...]
    texts: tuple[Text, ...]


def lay_out(legend: Legend, scale: float, measure: Measure, theme: Theme = DARK) -> Layout:
    """Return the places of a legend's parts.

    Parameters
    ----------
    legend : ColorBar or ClassKey
    scale : float
        Pixels per unit of layout; 1 on an ordinary screen.
    measure : callable
        Width of a text at a size, both in pixels.
    theme : Theme

    Returns
    -------
    Layout
    """
    if isinstance(legend, ColorBar):
        return _lay_out_bar(legend, scale, measure, theme)
    return _lay_out_key(legend, scale, measure, theme)


def tick_label(value: float) -> str:
    """Return a curvature as short as three significant digits allow, with a true minus sign."""
    text = f"{abs(value):.3g}" if 1e-3 <= abs(value) < 1e4 or value == 0 else f"{abs(value):.1e}"
    return f"\u2212{text}" if value < 0 else text


def _lay_out_bar(bar: ColorBar, scale: float, measure: Measure, theme: Theme) -> Layout:
    values = [bar.limit * step / 2.0 for step in range(-2, 3)]
    labels = [tick_label(value) for value in values]
    title = f"{bar.title} ({bar.unit})"
    width = max(
        measure(title, _TITLE * scale),
        (_BAR_WIDTH + _GAP) * scale + max(measure(label, _TEXT * scale) for label in labels),
        *(measure(note, _TEXT * scale) for note in bar.notes),
        0.0,
    )
    bottom = (_PADDING + _LINE * len(bar.notes) + _GAP) * scale
    step = _BAR_HEIGHT * scale / _BAR_STEPS
    left = _PADDING * scale
    boxes = [_frame(left, bottom, _BAR_WIDTH * scale, _BAR_HEIGHT * scale, scale, theme)]
    boxes += [
        Rectangle(left, bottom + i * step, _BAR_WIDTH * scale, step, (red, green, blue, 1.0))
        for i, (red, green, blue) in enumerate(srgb_ramp(bar.color_map, _BAR_STEPS).tolist())
    ]
    texts = [
        Text(
            left + (_BAR_WIDTH + _GAP) * scale,
            bottom + _BAR_HEIGHT * scale * i / 4.0 - 0.35 * _TEXT * scale,
            _TEXT * scale,
            label,
            theme.ink,
        )
        for i, label in enumerate(labels)
    ]
    top = bottom + (_BAR_HEIGHT + _GAP + 4.0) * scale
    return _finish(boxes, texts, title, bar.notes, width, top, scale, theme)


def _lay_out_key(key: ClassKey, scale: float, measure: Measure, theme: Theme) -> Layout:
    name_width = max(measure(name, _TEXT * scale) for _, name, _ in key.rows)
    share_width = max(measure(share, _TEXT * scale) for _, _, share in key.rows)
    width = max(
        (_SWATCH + 2.0 * _GAP) * scale + name_width + share_width + _GAP * scale,
        measure(key.title, _TITLE * scale),
        *(measure(note, _TEXT * scale) for note in key.notes),
        0.0,
    )
    left = _PADDING * scale
    bottom = (_PADDING + _LINE * len(key.notes) + (_GAP if key.notes else 0.0)) * scale
    boxes: list[Rectangle] = []
    texts: list[Text] = []
    for i, (color, name, share) in enumerate(reversed(key.rows)):
        base = bottom + i * _LINE * scale
        side = _SWATCH * scale
        boxes += [
            _frame(left, base, side, side, scale, theme),
            Rectangle(left, base, side, side, (*color, 1.0)),
        ]
        baseline = base + 2.5 * scale
        texts += [
            Text(left + (_SWATCH + _GAP) * scale, baseline, _TEXT * scale, name, theme.ink),
            Text(
                left + width - measure(share, _TEXT * scale),
                baseline,
                _TEXT * scale,
                share,
                theme.ink,
            ),
        ]
    top = bottom + (len(key.rows) * _LINE + 4.0) * scale
    return _finish(boxes, texts, key.title, key.notes, width, top, scale, theme)


def _frame(
    left: float, bottom: float, width: float, height: float, line: float, theme: Theme
) -> Rectangle:
    return Rectangle(
        left - line, bottom - line, width + 2.0 * line, height + 2.0 * line, theme.frame
    )


def _finish(
    boxes: Sequence[Rectangle],
    texts: Sequence[Text],
    title: str,
    notes: Sequence[str],
    width: float,
    top: float,
    scale: float,
    theme: Theme,
) -> Layout:
    """Add the title above, the notes below and the paper behind."""
    left = _PADDING * scale
    total_width = width + 2.0 * left
    height = top + (_TITLE + _PADDING) * scale
    lines = [Text(left, top, _TITLE * scale, title, theme.ink)]
    lines += [
        Text(left, (_PADDING + 3.0 + _LINE * i) * scale, _TEXT * scale, note, theme.faint_ink)
        for i, note in enumerate(reversed(notes))
    ]
    paper = Rectangle(0.0, 0.0, total_width, height, theme.paper)
    return Layout(total_width, height, (paper, *boxes), (*lines, *texts))
