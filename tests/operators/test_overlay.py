# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The viewport shows the models in their colors, and the legend over them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import bpy
import gpu
import numpy as np
import pytest
from architectural_curvature.addon import overlay
from architectural_curvature.addon.overlay import legend
from models import STRICT, add_surface, barrel, dome, plate, saddle
from offscreen import HEIGHT, WIDTH, Pixels, draw_viewport, viewport_context

CLASSES = {"flat": plate, "single": barrel, "elliptic": dome, "hyperbolic": saddle}


@pytest.fixture(autouse=True)
def _window(monkeypatch: pytest.MonkeyPatch) -> None:
    """A file with a viewport and nothing in it, at the scale that a screen has."""
    bpy.ops.wm.read_homefile(use_empty=False, use_factory_startup=True)
    for obj in list(bpy.data.objects):
        bpy.data.objects.remove(obj)
    monkeypatch.setattr(legend, "bpy", SimpleNamespace(context=_OnScreen()))


class _OnScreen:
    """Blender's context, but for the scale of the interface, which is 0 without a window."""

    preferences = SimpleNamespace(system=SimpleNamespace(ui_scale=1.0, use_region_overlap=False))

    def __getattr__(self, name: str) -> object:
        return getattr(bpy.context, name)


def _nothing() -> None:
    """Draw no overlay."""


def _shade_flat() -> None:
    """Let the viewport show colors as they are, without light."""
    with viewport_context():
        bpy.context.space_data.shading.light = "FLAT"


def _class_color(name: str) -> np.ndarray:
    """Return the color of a class on screen, sRGB 0 to 255."""
    linear = np.array(getattr(bpy.context.scene.curvature, f"color_{name}"))
    return 255.0 * np.where(
        linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1.0 / 2.4) - 0.055
    )


def _has_color(pixels: Pixels, color: np.ndarray) -> np.ndarray:
    return np.abs(pixels[..., :3] - color).max(axis=-1) <= 6.0


def test_classes_are_seen_on_the_models_and_explained_in_the_legend() -> None:
    """Four models in the four quarters of a square of half the height of the picture."""
    for number, (name, height) in enumerate(CLASSES.items()):
        obj = add_surface(height, name)
        obj.scale = (0.5, 0.5, 0.5)
        obj.location = (number % 2 - 0.5, number // 2 - 0.5, 0.0)
    bpy.context.view_layer.update()
    bpy.ops.curvature.segment(**STRICT)
    _shade_flat()
    states = []

    def draw_between_looks() -> None:
        states.append((gpu.state.blend_get(), gpu.state.line_width_get()))
        legend.draw_legend()
        states.append((gpu.state.blend_get(), gpu.state.line_width_get()))

    before, after = draw_viewport(_nothing, draw_between_looks)
    assert states[0] == states[1], "drawing must leave the GPU's state as it was"

    eighth = HEIGHT // 8
    for number, name in enumerate(CLASSES):
        column = WIDTH // 2 + (2 * (number % 2) - 1) * eighth
        row = HEIGHT // 2 + (2 * (number // 2) - 1) * eighth
        window = before[row - 20 : row + 20, column - 20 : column + 20]
        assert _has_color(window, _class_color(name)).mean() > 0.95, name

    is_drawn = (before != after).any(axis=-1)
    rows, columns = np.nonzero(is_drawn)
    assert rows.min() < 20, "the legend stands at the bottom"
    assert columns.min() < 20, "the legend stands at the left"
    assert rows.max() < HEIGHT // 2
    assert columns.max() < WIDTH // 2
    key = after[is_drawn]
    for name in CLASSES:
        assert _has_color(key, _class_color(name)).sum() > 100, name
    assert (key[:, :3].min(axis=-1) > 200).sum() > 200, "light letters"


def test_values_are_seen_on_the_model_and_explained_by_a_color_bar() -> None:
    add_surface(lambda x, y: 0.3 * np.sin(2.5 * x) * np.cos(2.5 * y))
    bpy.ops.curvature.analyze()
    bpy.ops.curvature.show(quantity="MEAN")
    _shade_flat()
    before, after = draw_viewport(_nothing, legend.draw_legend)

    model = before[HEIGHT // 4 : -HEIGHT // 4, WIDTH // 3 : -WIDTH // 3]
    red_minus_blue = model[..., 0] - model[..., 2]
    assert (red_minus_blue > 60).sum() > 2000
    assert (red_minus_blue < -60).sum() > 2000

    bar = np.where((before != after).any(axis=-1), after[..., 0] - after[..., 2], 0)
    rows_of_red = np.nonzero((bar > 80).any(axis=1))[0]
    rows_of_blue = np.nonzero((bar < -80).any(axis=1))[0]
    # Cool to Warm: blue below for negative curvature, red above for positive.
    assert len(rows_of_red) > 20
    assert len(rows_of_blue) > 20
    assert rows_of_blue.max() < rows_of_red.min()


@pytest.fixture
def drawn(monkeypatch: pytest.MonkeyPatch) -> list[object]:
    """The layouts that reach the GPU."""
    layouts: list[object] = []
    monkeypatch.setattr(legend, "_draw", lambda layout, _corner: layouts.append(layout))
    return layouts


def _switch_off() -> None:
    bpy.context.scene.curvature.show_legend = False


def _show_nothing() -> None:
    bpy.ops.curvature.show(quantity="NONE")


def _hide_overlays() -> None:
    with viewport_context():
        bpy.context.space_data.overlay.show_overlays = False


def _clear() -> None:
    bpy.ops.curvature.clear()


@pytest.mark.parametrize("hide", [_switch_off, _show_nothing, _hide_overlays, _clear])
def test_legend_goes_when_it_is_not_wanted(hide: Callable[..., Any], drawn: list[object]) -> None:
    add_surface(dome)
    bpy.ops.curvature.segment(**STRICT)
    with viewport_context():
        legend.draw_legend()
    assert len(drawn) == 1
    hide()
    with viewport_context():
        legend.draw_legend()
    assert len(drawn) == 1


def test_legend_is_drawn_in_a_loaded_file(tmp_path: Path, drawn: list[object]) -> None:
    add_surface(dome)
    bpy.ops.curvature.segment(**STRICT)
    file = str(tmp_path / "design.blend")
    bpy.ops.wm.save_as_mainfile(filepath=file)
    bpy.ops.wm.open_mainfile(filepath=file, load_ui=True)
    assert overlay.is_enabled()
    with viewport_context():
        legend.draw_legend()
    assert len(drawn) == 1


def test_handler_is_there_once_however_often_it_is_enabled() -> None:
    assert overlay.is_enabled()
    overlay.enable()
    overlay.enable()
    assert len(overlay._handles) == 1
    overlay.disable()
    overlay.disable()
    assert not overlay.is_enabled()
    overlay.enable()
    assert overlay.is_enabled()
