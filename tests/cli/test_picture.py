# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The picture shows the model in its colors, framed, with the legend."""

from __future__ import annotations

import struct
from collections.abc import Callable
from pathlib import Path
from typing import Any

import bpy
import numpy as np
import pytest
from models import add_surface, barrel, dome, plate, saddle

CLASSES = {"flat": plate, "single": barrel, "elliptic": dome, "hyperbolic": saddle}
TOLERANCE = ("--panel-size", 1.0, "--deviation", 0.01)


@pytest.fixture
def pixels(
    command: Callable[..., Any], save: Callable[..., Any], tmp_path: Path
) -> Callable[..., np.ndarray]:
    """Render what is in the scene, and return sRGB 0 to 255, the lowest row first."""

    def render(*arguments: object, size: tuple[int, int] = (640, 400)) -> np.ndarray:
        path = tmp_path / "out.png"
        ended = command(
            "segment",
            save("model.blend"),
            "--image",
            path,
            "--image-size",
            f"{size[0]}x{size[1]}",
            "--overwrite",
            *TOLERANCE,
            *arguments,
        )
        assert ended.status == 0, ended.err
        assert _png_size(path) == size
        image = bpy.data.images.load(str(path))
        values = np.array(tuple(image.pixels), dtype=float).reshape(size[1], size[0], 4)
        bpy.data.images.remove(image)
        return 255.0 * values

    return render


def _png_size(path: Path) -> tuple[int, int]:
    header = path.read_bytes()[:24]
    assert header.startswith(b"\x89PNG\r\n\x1a\n")
    return struct.unpack(">II", header[16:24])


def _hue(color: np.ndarray) -> np.ndarray:
    """Return a color without its brightness, which light on the model changes."""
    return color / np.linalg.norm(color, axis=-1, keepdims=True)


def _class_color(name: str) -> np.ndarray:
    linear = np.array(getattr(bpy.context.scene.curvature, f"color_{name}"))
    return 255.0 * np.where(
        linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1.0 / 2.4) - 0.055
    )


def test_models_and_legend_have_the_colors_of_the_classes(pixels: Callable) -> None:
    for number, (name, height) in enumerate(CLASSES.items()):
        add_surface(height, name).location.x = 2.5 * number
    picture = pixels()
    for name in CLASSES:
        color = _class_color(name)
        exact = np.abs(picture[..., :3] - color).max(axis=-1) < 3.0
        assert exact[:, :200].sum() > 20, f"{name} is not in the legend"
        lit = np.abs(_hue(picture[..., :3]) - _hue(color)).max(axis=-1) < 0.05
        is_colored = np.ptp(color) > 30.0
        assert lit[:, 200:].sum() > (500 if is_colored else 0), f"{name} is not on the models"


def test_model_is_framed(pixels: Callable) -> None:
    """It fills the picture right of the legend and touches no side."""
    add_surface(saddle).location = (1000.0, -300.0, 40.0)
    picture = pixels()[..., :3]
    background = picture[-1, -1]
    is_model = (np.abs(picture - background) > 12.0).any(axis=-1)
    is_model[:, :200] = False
    rows, columns = np.nonzero(is_model)
    height, width = is_model.shape
    assert rows.min() > 0
    assert rows.max() < height - 1
    assert columns.max() < width - 1
    assert np.ptp(rows) > 0.4 * height or np.ptp(columns) > 0.4 * width


@pytest.mark.parametrize("size", [(600, 200), (64, 64)])
def test_picture_has_the_asked_size(size: tuple[int, int], pixels: Callable) -> None:
    add_surface(dome)
    picture = pixels(size=size)
    assert np.ptp(picture[..., :3]) > 60.0, "the picture is blank"


def test_color_bar_shows_the_asked_quantity(pixels: Callable) -> None:
    add_surface(lambda x, y: 0.3 * np.sin(2.5 * x) * np.cos(2.5 * y))
    picture = pixels("--quantity", "MEAN")
    red_minus_blue = picture[..., 0] - picture[..., 2]
    for columns in (np.s_[:, :200], np.s_[:, 200:]):
        assert (red_minus_blue[columns] > 60).sum() > 100
        assert (red_minus_blue[columns] < -60).sum() > 100


def test_rendering_leaves_the_scene_as_it_was(pixels: Callable) -> None:
    add_surface(dome)
    before = [len(kind) for kind in (bpy.data.scenes, bpy.data.cameras, bpy.data.curves)]
    pixels()
    assert [len(kind) for kind in (bpy.data.scenes, bpy.data.cameras, bpy.data.curves)] == before
    assert not [image for image in bpy.data.images if image.source == "FILE"]
