# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A rendered picture of models with their legend."""

from __future__ import annotations

import ctypes.util
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import bpy
import numpy as np
from bpy.types import Object, Scene

from ..geometry.display.colormap import linear_from_srgb
from ..geometry.display.legend import LIGHT, Layout, Legend, lay_out
from ..geometry.types import AnyArray, Floats
from ..report.files import FileRefusedError, written_whole
from .companions import companions
from .mesh import positions
from .subject import source_of

Direction = tuple[float, float, float]

FRONT: Direction = (0.55, -1.0, 0.6)
"""Where the eye is, seen from the model: in front, to the right, above."""

_MARGIN = 1.12
_BACKGROUND = (0.96, 0.96, 0.95)
_LEGEND_MARGIN = 24
#: Size in pixels of a picture in which the legend has its natural size.
_NATURAL_HEIGHT = 750.0
_NATURAL_WIDTH = 1000.0


def render(
    objects: list[Object],
    legend: Legend | None,
    size: tuple[int, int],
    path: Path,
    eye: Direction = FRONT,
    *,
    is_plain: bool = False,
) -> None:
    """Render objects in their curvature colors, framed, with the legend in the lower left corner.

    Their lines, umbilics and hatching are shown with them.

    Parameters
    ----------
    objects : list of Object
        Mesh objects whose active color attributes are shown.
    legend : Legend, optional
    size : (int, int)
        Width and height in pixels.
    path : Path
        PNG file.
    eye : (float, float, float)
        Direction from the model to the eye.
    is_plain : bool
        Whether to show the models without their colors.

    Raises
    ------
    FileRefusedError
        If the file cannot be written, or the machine lacks what renders.
    """
    _check_graphics(path)
    scale = min(size[1] / _NATURAL_HEIGHT, size[0] / _NATURAL_WIDTH)
    margin = round(_LEGEND_MARGIN * scale)
    with written_whole(path) as temporary:
        key = np.zeros((0, 0, 4))
        if legend is not None:
            key = _draw_legend(legend, scale, temporary)
        with _scene("Curvature Picture", size) as scene:
            lines = [each for obj in objects for each in companions(source_of(obj))]
            for shown in [*objects, *lines]:
                scene.collection.objects.link(shown)
            _aim_camera(scene, objects, eye, key.shape[1] + margin if legend else 0)
            _shade_model(scene)
            if is_plain:
                scene.display.shading.color_type = "MATERIAL"
            picture = _render(scene, temporary)
        pixels = _over(np.array([*_BACKGROUND, 1.0]), picture)
        _paste(pixels, key, margin)
        _save(pixels, temporary)


def _check_graphics(path: Path) -> None:
    """Refuse before Blender aborts: without EGL it cannot render on a screenless Linux."""
    if sys.platform == "linux" and ctypes.util.find_library("EGL") is None:
        raise FileRefusedError(
            f"{path}: pictures need the system library libEGL: on Debian, apt-get install libegl1"
        )


@contextmanager
def _scene(name: str, size: tuple[int, int]) -> Iterator[Scene]:
    """Give an empty scene with an orthographic camera; it is gone afterwards, with the camera."""
    scene = bpy.data.scenes.new(name)
    data = bpy.data.cameras.new(name)
    camera = bpy.data.objects.new(name, data)
    scene.collection.objects.link(camera)
    scene.camera = camera
    data.type = "ORTHO"
    render = scene.render
    render.engine = "BLENDER_WORKBENCH"
    render.resolution_x, render.resolution_y = size
    render.resolution_percentage = 100
    render.film_transparent = True
    render.image_settings.file_format = "PNG"
    render.image_settings.color_mode = "RGBA"
    # Colors have to come out as the legend has them, whatever film look is set.
    scene.view_settings.view_transform = "Standard"
    scene.display.render_aa = "16"
    try:
        yield scene
    finally:
        bpy.data.scenes.remove(scene)
        bpy.data.objects.remove(camera)
        bpy.data.cameras.remove(data)


def _shade_model(scene: Scene) -> None:
    shading = scene.display.shading
    shading.light = "STUDIO"
    # The most even of Blender's studio lights: colors stay close to those of the legend.
    shading.studio_light = "paint.sl"
    shading.color_type = "VERTEX"
    shading.show_cavity = True
    shading.cavity_type = "SCREEN"
    shading.curvature_ridge_factor = 0.4
    shading.curvature_valley_factor = 0.4
    shading.show_object_outline = True
    shading.object_outline_color = (0.2, 0.2, 0.2)
    shading.show_specular_highlight = False


def _aim_camera(scene: Scene, objects: list[Object], eye: Direction, reserved: int) -> None:
    """Let the camera see the objects, right of so many columns of pixels."""
    points = np.concatenate([_world_positions(obj) for obj in objects])
    back = np.array(eye) / np.linalg.norm(eye)
    # Seen straight from above, the picture's upper side is the model's back.
    right = np.cross([0.0, 0.0, 1.0], back) if any(eye[:2]) else np.array([1.0, 0.0, 0.0])
    right /= np.linalg.norm(right)
    axes = np.stack([right, np.cross(back, right), back], axis=1)
    seen = points @ axes
    low, high = seen.min(axis=0), seen.max(axis=0)
    extent = np.maximum(high - low, 1e-9)
    width, height = scene.render.resolution_x, scene.render.resolution_y
    free = max(width - reserved, width // 2)
    # The scale of an orthographic camera is the length of the picture's longer side.
    per_pixel = _MARGIN * max(extent[0] / free, extent[1] / height)
    depth = max(float(extent[2]), per_pixel * width)
    matrix = np.eye(4)
    matrix[:3, :3] = axes
    center = (low + high) / 2.0
    center[0] -= 0.5 * (width - free) * per_pixel
    center[2] = high[2] + depth
    matrix[:3, 3] = axes @ center
    scene.camera.matrix_world = matrix.T
    scene.camera.data.ortho_scale = per_pixel * max(width, height)
    scene.camera.data.clip_start = 0.1 * depth
    scene.camera.data.clip_end = 4.0 * depth


def _world_positions(obj: Object) -> Floats:
    world = np.array(obj.matrix_world)
    return positions(obj.data) @ world[:3, :3].T + world[:3, 3]


def _render(scene: Scene, temporary: Path) -> AnyArray:
    scene.render.filepath = str(temporary)
    bpy.ops.render.render(write_still=True, scene=scene.name)
    image = bpy.data.images.load(str(temporary))
    width, height = image.size
    pixels = np.empty(width * height * 4, dtype=np.float32)
    image.pixels.foreach_get(pixels)
    bpy.data.images.remove(image)
    return pixels.reshape(height, width, 4)


def _draw_legend(legend: Legend, scale: float, temporary: Path) -> AnyArray:
    """Return a legend as pixels, (height, width, 4), the lowest row first."""
    with _scene("Curvature Legend", (64, 64)) as scene, _Lettering(scene) as lettering:
        layout = lay_out(legend, scale, lettering.measure, LIGHT)
        width, height = int(np.ceil(layout.width)), int(np.ceil(layout.height))
        scene.render.resolution_x, scene.render.resolution_y = width, height
        scene.camera.data.ortho_scale = max(width, height)
        scene.camera.location = (width / 2.0, height / 2.0, 10.0)
        scene.display.shading.light = "FLAT"
        scene.display.shading.color_type = "OBJECT"
        lettering.write(layout)
        letters = _render(scene, temporary)
    paper = np.zeros((height, width, 4))
    for box in layout.rectangles:
        rows = slice(round(box.bottom), round(box.bottom + box.height))
        columns = slice(round(box.left), round(box.left + box.width))
        paper[rows, columns] = _over(paper[rows, columns], np.array(box.color))
    return _over(paper, letters)


class _Lettering:
    """Texts as Blender's text objects, which every Blender can render without a window."""

    def __init__(self, scene: Scene) -> None:
        self._scene = scene
        self._objects: list[Object] = []
        self._widths: dict[str, float] = {}

    def __enter__(self) -> _Lettering:
        return self

    def __exit__(self, *_arguments: object) -> None:
        for obj in self._objects:
            curve = obj.data
            bpy.data.objects.remove(obj)
            bpy.data.curves.remove(curve)

    def measure(self, string: str, size: float) -> float:
        """Return the width of a text; widths grow with the size."""
        if string not in self._widths:
            obj = self._add(string, 1.0)
            self._scene.view_layers[0].update()
            self._widths[string] = float(obj.dimensions.x)
            obj.hide_render = True
        return self._widths[string] * size

    def write(self, layout: Layout) -> None:
        """Add the texts of a layout to the scene."""
        for text in layout.texts:
            obj = self._add(text.string, text.size)
            obj.location = (text.left, text.bottom, 0.0)
            obj.color = (*linear_from_srgb(np.array(text.color[:3])), text.color[3])

    def _add(self, string: str, size: float) -> Object:
        curve = bpy.data.curves.new("Curvature Text", "FONT")
        curve.body, curve.size = string, size
        obj = bpy.data.objects.new("Curvature Text", curve)
        self._scene.collection.objects.link(obj)
        self._objects.append(obj)
        return obj


def _over(below: AnyArray, above: AnyArray) -> AnyArray:
    """Return colors with straight alpha laid over others."""
    alpha = above[..., 3:]
    total = alpha + below[..., 3:] * (1.0 - alpha)
    color = above[..., :3] * alpha + below[..., :3] * below[..., 3:] * (1.0 - alpha)
    return np.concatenate([color / np.maximum(total, 1e-9), total], axis=-1)


def _paste(pixels: AnyArray, legend: AnyArray, margin: int) -> None:
    height = min(legend.shape[0], pixels.shape[0] - margin)
    width = min(legend.shape[1], pixels.shape[1] - margin)
    place = np.s_[margin : margin + height, margin : margin + width]
    pixels[place] = _over(pixels[place], legend[:height, :width])


def _save(pixels: AnyArray, path: Path) -> None:
    height, width = pixels.shape[:2]
    image = bpy.data.images.new(path.stem, width, height, alpha=True)
    image.pixels.foreach_set(pixels.astype(np.float32).ravel())
    image.filepath_raw = str(path)
    image.file_format = "PNG"
    image.save()
    bpy.data.images.remove(image)
