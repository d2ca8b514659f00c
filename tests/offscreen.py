# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The viewport drawn without a window: Blender's own drawing, and then the extension's."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager

import bpy
import gpu
import numpy as np
from mathutils import Matrix
from numpy.typing import NDArray

Pixels = NDArray[np.int64]

WIDTH, HEIGHT = 960, 540


def draw_viewport(*overlays: Callable[[], None]) -> list[Pixels]:
    """Return pictures of the viewport seen from above, one per overlay drawn over it.

    Parameters
    ----------
    *overlays : callable
        What a draw handler of a viewport's region would call.

    Returns
    -------
    list of (height, width, 4) int
        sRGB, 0 to 255, the lowest row first.
    """
    pictures: list[Pixels] = []
    # All in one go: every beginning costs seconds without a graphics card.
    _with_gpu(lambda: pictures.extend(_draw(overlay) for overlay in overlays))
    return pictures


@contextmanager
def viewport_context() -> Iterator[None]:
    """Run a block as if a viewport's region called it."""
    window, area, region = _viewport()
    with bpy.context.temp_override(
        window=window, area=area, region=region, scene=bpy.context.scene
    ):
        yield


def _with_gpu(work: Callable[[], None]) -> None:
    """Run something where `gpu` works."""
    if hasattr(gpu, "init"):
        # Blender 5.2 can be asked for it also without a window.
        gpu.init()
        work()
        return
    failures: list[BaseException] = []

    class Engine(bpy.types.RenderEngine):
        """Blender 4.2 to 5.0 have a GPU only while an engine renders that asks for it."""

        bl_idname, bl_label, bl_use_gpu_context = "CURVATURE_TEST", "Test", True

        def render(self, _depsgraph: bpy.types.Depsgraph) -> None:
            try:
                work()
            except BaseException as failure:  # noqa: BLE001 - Blender would only print it.
                failures.append(failure)

    bpy.utils.register_class(Engine)
    scene = bpy.data.scenes.new("Test")
    scene.render.engine = "CURVATURE_TEST"
    scene.render.resolution_x = scene.render.resolution_y = 64
    scene.camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    scene.collection.objects.link(scene.camera)
    try:
        bpy.ops.render.render(scene=scene.name)
    finally:
        bpy.data.scenes.remove(scene)
        bpy.utils.unregister_class(Engine)
    if failures:
        raise failures[0]


def _draw(overlay: Callable[[], None]) -> Pixels:
    _window, area, region = _viewport()
    space = area.spaces.active
    space.overlay.show_overlays = False
    offscreen = gpu.types.GPUOffScreen(WIDTH, HEIGHT)  # pyright: ignore[reportCallIssue]
    # Straight down on the 2 x 2 units of the test models, which fill half of the height.
    view = Matrix.Translation((0.0, 0.0, 10.0)).inverted()
    aspect = WIDTH / HEIGHT
    projection = Matrix.Diagonal((0.5 / aspect, 0.5, -1.0 / 50.0, 1.0))
    offscreen.draw_view3d(
        bpy.context.scene,
        bpy.context.view_layer,
        space,
        region,
        view,
        projection,
        do_color_management=True,
    )
    space.overlay.show_overlays = True
    with offscreen.bind(), gpu.matrix.push_pop(), gpu.matrix.push_pop_projection():
        gpu.matrix.load_matrix(Matrix.Identity(4))
        to_pixels = Matrix.Diagonal((2.0 / WIDTH, 2.0 / HEIGHT, 1.0, 1.0))
        to_pixels.translation = (-1.0, -1.0, 0.0)
        gpu.matrix.load_projection_matrix(to_pixels)
        with viewport_context():
            overlay()
        buffer = gpu.state.active_framebuffer_get().read_color(0, 0, WIDTH, HEIGHT, 4, 0, "UBYTE")
    buffer.dimensions = WIDTH * HEIGHT * 4
    offscreen.free()
    return np.array(buffer, dtype=np.uint8).reshape(HEIGHT, WIDTH, 4).astype(np.int64)


def _viewport() -> tuple[bpy.types.Window, bpy.types.Area, bpy.types.Region]:
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            if area.type == "VIEW_3D":
                region = next(region for region in area.regions if region.type == "WINDOW")
                return window, area, region
    message = "the file has no 3D viewport"
    raise LookupError(message)
