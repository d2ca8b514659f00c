# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sheets that are developable almost everywhere and still no single-curved area."""

from __future__ import annotations

import numpy as np

from composites.composite import Array, Integers, quads


def zigzag_sheet(lines: int, fold: float, cells: int) -> tuple[Array, Integers]:
    """Return a square sheet of side 2 in triangles, folded along zigzag lines.

    Parameters
    ----------
    lines : int
        Points along a side.
    fold : float
        Slope of the folded facets.
    cells : int
        Folds along a side.
    """
    size = 2.0
    x = np.linspace(0, size, lines)
    x, y = (a.ravel() for a in np.meshgrid(x, x, indexing="ij"))

    def zigzag(along: Array) -> Array:
        return size / cells * np.abs((along * cells / size) % 2 - 1)

    q = quads(lines, lines)
    triangles = np.concatenate([q[:, [0, 1, 2]], q[:, [0, 2, 3]]])
    return np.stack([x, y, fold * zigzag(x + 0.35 * zigzag(y))], axis=1), triangles
