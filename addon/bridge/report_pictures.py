# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of models from four sides, for reports."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from bpy.types import Object

from ..geometry.display.legend import Legend
from ..report.html import Picture
from . import names, picture
from .attributes import show_color_attribute

_SIZE = (1200, 750)
_VIEWS: tuple[tuple[str, picture.Direction], ...] = (
    ("From the front right", picture.FRONT),
    ("From the front left", (-0.75, -0.9, 0.6)),
    ("From the back", (-0.45, 1.0, 0.6)),
    ("From above", (0.0, 0.0, 1.0)),
)


def four_sides(objects: list[Object], legend: Legend | None) -> list[Picture]:
    """Render models in their class colors from four sides, the first with the key.

    Parameters
    ----------
    objects : list of Object
        Segmented mesh objects; not in Edit Mode.
    legend : Legend, optional

    Returns
    -------
    list of Picture

    Raises
    ------
    FileRefusedError
        If the machine lacks what renders.
    """
    pictures = []
    is_plain = not any(names.COLORS["CLASS"] in obj.data.color_attributes for obj in objects)
    with tempfile.TemporaryDirectory() as folder, _class_colors(objects):
        for number, (caption, eye) in enumerate(_VIEWS):
            path = Path(folder) / f"{number}.png"
            key = None if number else legend
            picture.render(objects, key, _SIZE, path, eye, is_plain=is_plain)
            pictures.append(Picture(caption, path.read_bytes()))
    return pictures


@contextmanager
def _class_colors(objects: list[Object]) -> Iterator[None]:
    """Let models show their classes as long as the block runs."""
    colors = names.COLORS["CLASS"]
    shown = [obj.data.color_attributes.active_color_name for obj in objects]
    for obj in objects:
        if colors in obj.data.color_attributes:
            show_color_attribute(obj.data, colors)
    try:
        yield
    finally:
        for obj, name in zip(objects, shown, strict=True):
            if name and name in obj.data.color_attributes:
                show_color_attribute(obj.data, name)
