# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Formats of drawings by the endings of their files."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from ..report.files import FileRefusedError, written_whole
from .drawing import Drawing
from .dxf import dxf_text
from .svg import svg_text
from .wavefront import obj_text

TEXTS: dict[str, Callable[[Drawing], str]] = {
    ".dxf": dxf_text,
    ".svg": svg_text,
    ".obj": obj_text,
}
"""What makes the text of each format."""


def check_ending(path: Path) -> str:
    """Return the ending of a drawing's name in lower case, or refuse it."""
    ending = path.suffix.lower()
    if ending not in TEXTS:
        raise FileRefusedError(
            f"{path.name}: drawings end in {', '.join(TEXTS)}, not in '{path.suffix}'"
        )
    return ending


def write_drawing(path: Path, drawing: Drawing) -> None:
    """Write a drawing in the format that the ending of its file name stands for.

    Raises
    ------
    FileRefusedError
        If the ending is not known or the folder cannot be written to.
    """
    text = TEXTS[check_ending(path)](drawing)
    with written_whole(path) as temporary:
        temporary.write_bytes(text.encode("utf-8"))
