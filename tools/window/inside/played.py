# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a played scenario left behind, for the tests that judge it."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from PIL import Image


@dataclass(frozen=True)
class Played:
    """What a scenario left behind."""

    folder: Path
    record: dict

    def picture(self, name: str) -> np.ndarray:
        """Return a screenshot as (height, width, 3) integers; differences may be negative."""
        with Image.open(self.folder / f"{name}.png") as image:
            return np.asarray(image.convert("RGB")).astype(int)

    def part(self, name: str, box: tuple[int, int, int, int]) -> np.ndarray:
        """Return a part of a screenshot: x, y, width, height as Blender counts, from below."""
        x, y, width, height = box
        picture = self.picture(name)
        top = picture.shape[0] - y - height
        return picture[max(top, 0) : picture.shape[0] - y, x : x + width]
