# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The legend in the viewport."""

from __future__ import annotations

import blf
import bpy
import gpu
from gpu_extras.batch import batch_for_shader

from ..geometry.display.legend import Layout, lay_out
from .content import legend_of

_FONT = 0
_MARGIN = 16.0


def draw_legend() -> None:
    """Draw the legend of the scene into the lower left corner of the region at hand."""
    context = bpy.context
    settings = context.scene.curvature
    if not (settings.show_legend and context.space_data.overlay.show_overlays):
        return
    legend = legend_of(context.scene, context.view_layer.objects.active)
    if legend is None:
        return
    scale = context.preferences.system.ui_scale
    layout = lay_out(legend, scale, _text_width)
    left, bottom = _covered(context)
    _draw(layout, (left + _MARGIN * scale, bottom + _MARGIN * scale))


def _covered(context: bpy.types.Context) -> tuple[float, float]:
    """Return how much of the region the toolbar covers at the left, the redo panel at the bottom.

    Blender draws both over the region, and counts hidden ones as one pixel wide.
    """
    if not context.preferences.system.use_region_overlap:
        return 0.0, 0.0
    regions = {region.type: region for region in context.area.regions if region.width > 1}
    tools, redo = regions.get("TOOLS"), regions.get("HUD")
    return (
        float(tools.width) if tools else 0.0,
        float(redo.y + redo.height - context.region.y) if redo else 0.0,
    )


def _text_width(string: str, size: float) -> float:
    blf.size(_FONT, size)
    return blf.dimensions(_FONT, string)[0]


def _draw(layout: Layout, corner: tuple[float, float]) -> None:
    positions, colors = [], []
    for box in layout.rectangles:
        left, bottom = corner[0] + box.left, corner[1] + box.bottom
        right, top = left + box.width, bottom + box.height
        positions += [(left, bottom), (right, bottom), (right, top)]
        positions += [(left, bottom), (right, top), (left, top)]
        colors += [box.color] * 6
    shader = gpu.shader.from_builtin("SMOOTH_COLOR")
    gpu.state.blend_set("ALPHA")
    batch_for_shader(shader, "TRIS", {"pos": positions, "color": colors}).draw(shader)
    gpu.state.blend_set("NONE")
    for text in layout.texts:
        blf.size(_FONT, text.size)
        blf.color(_FONT, *text.color)
        blf.position(_FONT, corner[0] + text.left, corner[1] + text.bottom, 0.0)
        blf.draw(_FONT, text.string)
