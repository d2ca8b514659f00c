# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Legends are laid out so that everything can be read, at any scale and with any texts."""

from __future__ import annotations

from dataclasses import replace
from itertools import combinations, pairwise

import numpy as np
import pytest
from architectural_curvature.addon.geometry.display.colormap import ColorMap, srgb_ramp
from architectural_curvature.addon.geometry.display.legend import (
    DARK,
    LIGHT,
    ClassKey,
    ColorBar,
    Layout,
    Legend,
    Rectangle,
    Text,
    lay_out,
    tick_label,
)

COLORS = ((0.9, 0.9, 0.8), (0.3, 0.7, 0.9), (0.9, 0.6, 0.0))

LEGENDS: dict[str, Legend] = {
    "bar": ColorBar("Gaussian Curvature", "1/m²", ColorMap.COOL_WARM, 0.25),
    "bar with notes": ColorBar("K", "1/m²", ColorMap.SPECTRUM, 1e-5, ("2 % clipped", "a note")),
    "bar with a long note": ColorBar("K", "1/m²", ColorMap.SPECTRUM, 3e5, ("note " * 20,)),
    "key": ClassKey(
        "Curvature Class", tuple((c, f"Class {i}", "3 %") for i, c in enumerate(COLORS))
    ),
    "key with notes": ClassKey("Class", ((COLORS[0], "Flat", "100.0 %"),), ("a note", "another")),
    "key with long names": ClassKey(
        "C", ((COLORS[0], "Flat " * 9, "1 %"), (COLORS[1], "S", "99 %"))
    ),
}
SCALES = (1.0, 1.5, 2.0)

all_legends = pytest.mark.parametrize("name", LEGENDS)
all_scales = pytest.mark.parametrize("scale", SCALES)


def _measure(string: str, size: float) -> float:
    return 0.6 * size * len(string)


def _layout(name: str, scale: float = 1.0) -> Layout:
    return lay_out(LEGENDS[name], scale, _measure)


def _box(text: Text) -> Rectangle:
    """The box of a text: letters without what hangs below the line."""
    return Rectangle(
        text.left, text.bottom, _measure(text.string, text.size), 0.72 * text.size, text.color
    )


def _overlap(a: Rectangle, b: Rectangle) -> bool:
    return (
        min(a.left + a.width, b.left + b.width) - max(a.left, b.left) > 1e-6
        and min(a.bottom + a.height, b.bottom + b.height) - max(a.bottom, b.bottom) > 1e-6
    )


@all_scales
@all_legends
def test_texts_overlap_neither_each_other_nor_boxes(name: str, scale: float) -> None:
    layout = _layout(name, scale)
    texts = [_box(text) for text in layout.texts]
    assert not any(_overlap(a, b) for a, b in combinations(texts, 2))
    _, *boxes = layout.rectangles
    assert not any(_overlap(text, box) for text in texts for box in boxes)


@all_scales
@all_legends
def test_everything_lies_on_the_paper_which_is_drawn_first(name: str, scale: float) -> None:
    layout = _layout(name, scale)
    paper, *boxes = layout.rectangles
    assert (paper.left, paper.bottom) == (0.0, 0.0)
    assert (paper.width, paper.height) == (layout.width, layout.height)
    for box in (*boxes, *(_box(text) for text in layout.texts)):
        assert box.left >= 0.0
        assert box.bottom >= 0.0
        assert box.left + box.width <= layout.width + 1e-9
        assert box.bottom + box.height <= layout.height + 1e-9


@all_legends
def test_scaling_a_legend_scales_all_of_it(name: str) -> None:
    one, two = _layout(name), _layout(name, 2.0)
    assert (two.width, two.height) == pytest.approx((2.0 * one.width, 2.0 * one.height))
    for a, b in zip(one.rectangles, two.rectangles, strict=True):
        assert (b.left, b.bottom, b.width, b.height) == pytest.approx(
            (2.0 * a.left, 2.0 * a.bottom, 2.0 * a.width, 2.0 * a.height)
        )
    for a, b in zip(one.texts, two.texts, strict=True):
        assert (b.left, b.bottom, b.size) == pytest.approx((2 * a.left, 2 * a.bottom, 2 * a.size))


def _downward(layout: Layout) -> list[str]:
    return [t.string for t in sorted(layout.texts, key=lambda t: (-round(t.bottom, 6), t.left))]


def test_a_bar_reads_from_title_over_high_and_low_to_notes() -> None:
    assert _downward(_layout("bar with notes")) == [
        "K (1/m²)",
        "1.0e-05",
        "5.0e-06",
        "0",
        "−5.0e-06",
        "−1.0e-05",
        "2 % clipped",
        "a note",
    ]


def test_a_key_reads_row_by_row_in_the_given_order() -> None:
    assert _downward(_layout("key")) == [
        "Curvature Class",
        *("Class 0", "3 %", "Class 1", "3 %", "Class 2", "3 %"),
    ]


def test_the_swatch_of_a_row_stands_beside_its_name() -> None:
    layout = _layout("key")
    for color, name, _ in LEGENDS["key"].rows:  # pyright: ignore[reportAttributeAccessIssue]
        (text,) = (text for text in layout.texts if text.string == name)
        (swatch,) = (box for box in layout.rectangles if box.color == (*color, 1.0))
        assert swatch.left + swatch.width < text.left
        assert swatch.bottom < text.bottom < swatch.bottom + swatch.height


def test_shares_are_flush_right() -> None:
    layout = _layout("key with long names")
    ends = [t.left + _measure(t.string, t.size) for t in layout.texts if t.string.endswith(" %")]
    assert len(ends) == 2
    assert ends[0] == pytest.approx(ends[1])


def test_the_steps_of_a_bar_are_the_color_map_without_gaps() -> None:
    layout = _layout("bar")
    _, _, *steps = layout.rectangles
    for low, high in pairwise(steps):
        assert high.bottom == pytest.approx(low.bottom + low.height)
    expected = srgb_ramp(ColorMap.COOL_WARM, len(steps))
    np.testing.assert_allclose([step.color[:3] for step in steps], expected)


def test_ticks_stand_at_their_values() -> None:
    layout = _layout("bar")
    _, _, *steps = layout.rectangles
    low, high = steps[0].bottom, steps[-1].bottom + steps[-1].height
    heights = sorted(t.bottom for t in layout.texts if t.string != "Gaussian Curvature (1/m²)")
    # Baselines are lowered by one and the same share of the letters' height.
    np.testing.assert_allclose(np.diff(heights), (high - low) / 4.0)
    middle = heights[2] + 0.35 * layout.texts[1].size
    assert middle == pytest.approx(0.5 * (low + high))


def test_themes_change_colors_and_nothing_else() -> None:
    dark, light = (lay_out(LEGENDS["key"], 1.0, _measure, theme) for theme in (DARK, LIGHT))
    assert dark.rectangles[0].color == DARK.paper
    assert light.rectangles[0].color == LIGHT.paper
    assert [replace(t, color=DARK.ink) for t in dark.texts] == [
        replace(t, color=DARK.ink) for t in light.texts
    ]


@pytest.mark.parametrize(
    ("value", "label"),
    [
        (0.0, "0"),
        (0.125, "0.125"),
        (-0.125, "−0.125"),
        (1.0, "1"),
        (1234.0, "1.23e+03"),
        (0.00099, "9.9e-04"),
        (-25000.0, "−2.5e+04"),
    ],
)
def test_ticks_are_short_and_have_a_true_minus(value: float, label: str) -> None:
    assert tick_label(value) == label
