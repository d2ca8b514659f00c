# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The sample models in assets/models, by formula: `python3 dev.py samples`.

The formulas, and what follows from them for the classes, are in assets/README.md. Only the
standard library is used, and coordinates are written to a micrometer, so that every machine makes
the same bytes.
"""

from __future__ import annotations

from pathlib import Path

from .ellipsoid import ellipsoid
from .patches import Patches
from .pavilion import pavilion
from .torus import torus
from .vault import barrel_vault

_SHAPES = {
    "pavilion": pavilion,
    "barrel_vault": barrel_vault,
    "torus": torus,
    "ellipsoid": ellipsoid,
}


def sample_texts() -> dict[str, str]:
    """Return the text of every sample model by the name of its file."""
    return {f"{name}.obj": _text(shape()) for name, shape in _SHAPES.items()}


def write(folder: Path) -> list[Path]:
    """Write the sample models into a folder and return their paths."""
    folder.mkdir(parents=True, exist_ok=True)
    paths = []
    for name, text in sample_texts().items():
        path = folder / name
        path.write_bytes(text.encode("ascii"))
        paths.append(path)
    return paths


def _text(patches: Patches) -> str:
    """Return a model as a Wavefront file with Y up, which is how Blender reads such files."""
    lines = [f"# {patches.title}", "# Meters, Y up. Made by `python3 dev.py samples`."]
    lines += [f"v {x} {z} {_negative(y)}" for x, y, z in patches.vertices]
    lines += ["f " + " ".join(str(vertex + 1) for vertex in face) for face in patches.faces]
    return "\n".join(lines) + "\n"


def _negative(number: str) -> str:
    if number.startswith("-"):
        return number[1:]
    return number if float(number) == 0.0 else f"-{number}"
