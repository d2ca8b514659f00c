# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers as users typed them."""

from __future__ import annotations

import math


def as_typed(value: float) -> float:
    """Return a number that Blender kept with 32 bits as its user typed it.

    Seven digits turn 0.004999999888 into 0.005; more digits than that 32 bits cannot tell apart.
    """
    return float(f"{value:.7g}")


def as_typed_angle(value: float) -> float:
    """Return an angle that Blender kept with 32 bits, at most pi: seven digits of pi exceed it."""
    return min(as_typed(value), math.pi)
