# SPDX-FileCopyrightText: 2026 Architectural Curvature developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Values of options, read from text; wrong ones are refused with what is right."""

from __future__ import annotations

import argparse
import math

from ..geometry.settings import Smoothing


def _number(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise argparse.ArgumentTypeError(f"'{text}' is not a number")
    return value


def positive(text: str) -> float:
    """Return a number above zero."""
    value = _number(text)
    if value <= 0.0:
        raise argparse.ArgumentTypeError(f"must be greater than zero, not {text}")
    return value


def not_negative(text: str) -> float:
    """Return a number of zero or more."""
    value = _number(text)
    if value < 0.0:
        raise argparse.ArgumentTypeError(f"must not be negative: {text}")
    return value


def smoothing(text: str) -> tuple[Smoothing, float]:
    """Return a kind of smoothing and its length in meters: auto, none or a length."""
    if text.lower() in {"auto", "none"}:
        return Smoothing[text.upper()], 0.0
    return Smoothing.LENGTH, positive(text)


def angle(text: str) -> float:
    """Return an angle in degrees."""
    value = _number(text)
    if not 0.0 < value <= 180.0:
        raise argparse.ArgumentTypeError(f"must be above 0 and at most 180 degrees, not {text}")
    return value


def size(text: str) -> tuple[int, int]:
    """Return the width and height of a picture in pixels."""
    parts = text.lower().split("x")
    if len(parts) != 2 or not all(part.isdigit() and 64 <= int(part) <= 16384 for part in parts):
        raise argparse.ArgumentTypeError(f"must be like 1600x1000, each 64 to 16384, not {text}")
    return int(parts[0]), int(parts[1])
